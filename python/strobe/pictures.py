# SPDX-License-Identifier: MIT
"""Pictures: rendering, comparison, files."""
from __future__ import annotations

import itertools
import json
import math
import os
import tempfile
from pathlib import Path
from typing import Any, Mapping

import numpy as np

from .program import StrobeError, call, words_of

File = str | os.PathLike[str]


class Picture(dict[str, np.ndarray]):
    """Images of a picture by the name of the output ("color", "depth", "velocity") or tap ("gather_raster.color").

    Each is an array of height x width x channels, float32 or uint32.
    record: the run record, with all settings and the hash of each image.
    """

    record: dict[str, Any]


def render(pipeline: str, *, sets: Mapping[str, Any] | None = None, **options: Any) -> Picture:
    """Renders a picture.

    pipeline: name of a pipeline, or a .lua file. sets: parameters, {"samples": 8, "gather_raster.jitter": "ign"}.
    options: long options of `strobe render`: scene="living_room", size=(320, 180), exposure=0.5 (frame intervals),
    move={"vase": (0.1, 0, 0)}, tap=["gather_raster.color"], out="picture.exr".

    Returns images of height x width x channels, rows from the top: "color" R G B A, linear; "depth", metres, inf for
    the sky; "velocity" x right, y down, pixels per exposure; "normal", world space; "id" uint32, 0 for the sky.
    """
    with tempfile.TemporaryDirectory(prefix="strobe-") as folder:
        words = words_of({**options, "set": dict(sets or {}), "arrays": folder, "json": True})
        found = call("render", *words, str(pipeline))
        picture = Picture({file.stem: np.load(file) for file in sorted(Path(folder).glob("*.npy"))})
    picture.record = found
    return picture


def compare(test: File | Picture | np.ndarray, reference: File | Picture | np.ndarray,
            **options: Any) -> dict[str, Any]:
    """Error metrics of a picture against a reference.

    test, reference: .exr or .png files, pictures of `render`, or arrays of height x width x 3 or 4, linear.
    options: long options of `strobe compare`, such as mask="mask.png".

    Returns numbers by name: "rmse", "mse", "relmse" of linear colour; "psnr" in dB, inf for equal pictures; "ssim";
    "ldr_flip", "hdr_flip" (0: equal, 1: largest difference). None: not measured.
    """
    with tempfile.TemporaryDirectory(prefix="strobe-") as folder:
        files = [_file(one, Path(folder) / f"{i}.exr") for i, one in enumerate((test, reference))]
        numbers = call("compare", *words_of({**options, "json": True}), *files)
    return {name: math.inf if value == "inf" else value for name, value in numbers.items()}


def _file(picture: File | np.ndarray | Picture, file: Path) -> str:
    """Name of the picture's file; an array is written to `file`."""
    picture = picture["color"] if isinstance(picture, Mapping) else picture
    if not isinstance(picture, np.ndarray):
        return os.fspath(picture)
    import OpenImageIO as oiio

    height, width, channels = picture.shape
    output = oiio.ImageOutput.create(str(file))
    output.open(str(file), oiio.ImageSpec(width, height, channels, oiio.FLOAT))
    output.write_image(np.ascontiguousarray(picture, np.float32))
    output.close()
    return str(file)


def record(file: File) -> dict[str, Any]:
    """Run record of a picture: the shot, values of all parameters, hashes of all inputs and outputs, warnings.

    file: the picture, with NAME.record.json beside it, or the record itself.
    """
    path = Path(file)
    if path.suffix != ".json":
        path = path.with_suffix(".record.json")
    return json.loads(path.read_text(encoding="utf-8"))


# Layers of channels without a prefix, and of the prefix N. Order of the channels of a layer.
_LAYERS = {"R": "color", "G": "color", "B": "color", "A": "color", "Z": "depth", "N": "normal", "geometry": "id"}
_ORDER = ["R", "G", "B", "A", "X", "Y", "Z", "W", "id", "geometry"]


def read_exr(file: File) -> dict[str, np.ndarray]:
    """Layers of an OpenEXR file of Strobe (docs/exr.md), by the names that `render` gives to the images.

    Returns arrays of height x width x channels, rows from the top, float32 or uint32.
    """
    import OpenImageIO as oiio

    source = oiio.ImageInput.open(os.fspath(file))
    if not source:
        raise StrobeError(f"cannot read '{os.fspath(file)}': {oiio.geterror()}")
    channels: dict[str, list[tuple[int, np.ndarray]]] = {}
    part = 0
    while source.seek_subimage(part, 0):
        spec = source.spec()
        kinds = [str(kind) for kind in spec.channelformats] or [str(spec.format)] * spec.nchannels
        for is_uint, run in itertools.groupby(range(spec.nchannels), lambda c: kinds[c].startswith("uint")):
            numbers = list(run)
            kind = oiio.UINT if is_uint else oiio.FLOAT
            values = np.asarray(source.read_image(part, 0, numbers[0], numbers[-1] + 1, kind))
            values = values.reshape(spec.height, spec.width, len(numbers))
            for number, name in enumerate(spec.channelnames[numbers[0]:numbers[-1] + 1]):
                prefix, _, last = name.rpartition(".")
                layer = _LAYERS.get(prefix or last, prefix or last)
                place = _ORDER.index(last) if last in _ORDER else len(_ORDER)
                channels.setdefault(layer, []).append((place, values[..., number]))
        part += 1
    source.close()
    return {layer: np.stack([one for _, one in sorted(found, key=lambda entry: entry[0])], axis=-1)
            for layer, found in channels.items()}
