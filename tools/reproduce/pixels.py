# SPDX-License-Identifier: MIT
"""Pixels of PNG files, and sheets of crops, by ImageMagick."""
import subprocess

from bench import Failed, Missing


def magick(*words):
    try:
        end = subprocess.run([str(word) for word in words], capture_output=True)
    except FileNotFoundError as error:
        raise Missing("ImageMagick (the package imagemagick) is missing") from error
    if end.returncode:
        raise Failed(end.stderr.decode(errors="replace").strip().splitlines()[-1])
    return end.stdout


def pixels_of(file, region=None, block=1):
    """Width, height, and three bytes per pixel. `region` (x, y, width, height) selects a part of the picture. Pixels
    are means over squares with a side of `block` pixels."""
    crop = ["-crop", "{2}x{3}+{0}+{1}".format(*region), "+repage"] if region else []
    mean = ["-scale", f"{100 / block}%"] if block > 1 else []
    data = magick("convert", file, *crop, *mean, "-depth", "8", "ppm:-")
    head = data.split(b"\n", 3)  # P6, size, 255, pixels
    width, height = map(int, head[1].split())
    return width, height, head[3]


def differing_share(a, b, step):
    """Share of the pixels with a channel that differs by more than `step`, and the size as text."""
    if a[:2] != b[:2]:
        return 1.0, f"{a[0]}x{a[1]} and {b[0]}x{b[1]}"
    count = sum(1 for i in range(0, len(a[2]), 3)
                if a[2][i:i + 3] != b[2][i:i + 3] and max(abs(a[2][i + c] - b[2][i + c]) for c in range(3)) > step)
    return count / (a[0] * a[1]), f"{a[0]}x{a[1]}"


def sheet(rows, crops, scale, border, file):
    """Writes a sheet of crops on white. `rows`: a list of picture files per row. `crops`: one (x, y, width, height) per
    row. `scale`: magnification. `border`: space around each crop, px."""
    cells = []
    for row, (x, y, width, height) in zip(rows, crops):
        for picture in row:
            cells += ["(", picture, "-crop", f"{width}x{height}+{x}+{y}", "+repage", "-scale", f"{100 * scale}%", ")"]
    magick("montage", *cells, "-tile", f"{len(rows[0])}x{len(rows)}", "-geometry", f"+{border}+{border}",
           "-background", "white", "-strip", file)
    return file
