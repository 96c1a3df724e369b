# SPDX-License-Identifier: MIT
"""Claims of pictures and generated pages."""
import re
import shlex

import inputs
from kinds import Figure, Page, Unrepeated
from pixels import sheet
from readers import front_of, pictures_of_passes

MAKE = "docs/pictures/make "
OTHER_DEVICE = "rounding differs between devices: single pixels at silhouettes show the other surface"


def made(what, file):
    """Maker of a picture by docs/pictures/make, in the folder `pictures` of this run."""
    def make(bench):
        folder = bench.folder("pictures")
        if what == "passes":
            pictures_of_passes(bench)
        else:
            bench.run(bench.root / "docs/pictures/make", "-o", folder, what)
        return folder / file
    return make


def picture(id, what, file, seconds, **more):
    name = "docs/pictures/" + file
    noted = lambda bench: inputs.of_pictures(bench.folder("pictures") / "inputs.json").get(name)  # noqa: E731
    return Figure(id, MAKE + what, seconds, more.pop("because", OTHER_DEVICE), file=name, make=made(what, file), inputs=noted,
                  **more)


def captured(name):
    """Claim of the figure that a shipped capture makes."""
    def make(bench):
        folder = bench.folder(name)
        bench.run("strobe", "capture", f"scripts/captures/{name}.lua", "-o", folder)
        return folder / f"{name}.png"
    return Figure(name, f"./strobe capture scripts/captures/{name}.lua -o FOLDER", 55, OTHER_DEVICE,
                  file=f"docs/pictures/{name}.png", make=make, compare="pixels", share=0.002, step=2,
                  inputs=lambda bench: inputs.of_source(bench.root, bench.folder(name) / "manifest.json"))


PASSES = ("visibility.hit", "depth", "normal", "velocity", "tile_light_visibility.light_visibility", "shade.color",
          "tile_velocities.velocities", "mask", "revealed", "revealed_depth", "tile_max.longest", "neighbour_max.dominant",
          "classify_cells.moved", "color")
# Parts of screenshots of the window without panels, which show times: x, y, width, height.
MIDDLE, ABOVE = (380, 254, 640, 358), (380, 88, 640, 358)


def picture_of(bench, experiment, point):
    """Picture of a point: from the sweep of this run, otherwise rendered by the command in the results."""
    if experiment in bench.fresh:
        return bench.fresh[experiment] / "points" / (point["key"] + ".png")
    file = bench.folder("points") / (point["key"] + ".png")
    words = shlex.split(point["command"])
    bench.run(*words[:words.index("-o")], "-o", file)
    return file


def crops(experiment, rows, regions, border=2):
    """Claim of a sheet of crops of points' pictures, magnified two times. `rows`: a list of points per row, as
    arguments of Results.point. `regions`: a region (x, y, width, height) per row."""
    def make(bench):
        results = bench.results(experiment)
        points = rows(bench) if callable(rows) else [[results.point(**at) for at in row] for row in rows]
        pictures = [[picture_of(bench, experiment, point) for point in row] for row in points]
        return sheet(pictures, regions, 2, border, bench.folder("sheets") / f"{experiment}.png")
    return Figure("figure_" + experiment, "./strobe render ... for each point, by the commands in result.json", 120,
                  "256 colours, dithered: means over 8x8 pixels are compared", file=f"experiments/{experiment}/{experiment}.png",
                  make=make, compare="pixels", share=0.01, step=12, block=8,
                  inputs=lambda bench: inputs.of_source(bench.root, bench.results(experiment).file))


def columns(shot, arms, **more):
    """One row: points of a shot at the same values, one point per arm."""
    return [{"shot": shot, "arm": arm, **more} for arm in arms]


def front(bench):
    """One row: the committed front of `everything` in the order of time, then truth."""
    results = bench.committed("everything")
    points = [point for _, _, point in front_of(results, "ms_ratio", "rmse", "inner")]
    return [points + [next(results.points(role="truth"))[1]]]


def exhibits():
    """One row per complaint: an arm with the artefact, an arm without it, and truth."""
    plain = [("wheel", "layers, straight paths", BEST), ("silhouette", "Bevy", BEST),
             ("halo", "McGuire 2012", BEST), ("glass", "McGuire 2012", BEST), ("sky", "no vectors", BEST),
             ("short", "UE4-style, limit 0.05", BEST), ("shadow", "McGuire 2012", BEST), ("chase", "McGuire 2012", BEST),
             ("drive", "McGuire 2012", BEST), ("skin", "no vectors", BEST)]
    rows = {shot: columns(shot, (wrong, mended, "ground truth"), case="as it is") for shot, wrong, mended in plain}
    rows["rate"] = [{"shot": "share", "arm": BEST, "rate": 144}, {"shot": "seconds", "arm": BEST, "rate": 144},
                    {"shot": "seconds", "arm": "ground truth", "rate": 24}]
    rows["jump"] = columns("jump", ("McGuire 2012, last frame's path", "McGuire 2012", "ground truth"), cut=False)
    rows["followed"] = [{"shot": "followed", "arm": BEST, "follow": "nothing"}, {"shot": "followed", "arm": BEST, "follow": "car"},
                        {"shot": "followed", "arm": "ground truth", "follow": "car"}]
    order = ("wheel", "silhouette", "halo", "glass", "sky", "rate", "jump", "followed", "short", "shadow", "chase", "drive",
             "skin")
    return [rows[name] for name in order]


BEST = "adaptive"
EXHIBITS_REGIONS = [(x, y, 144, 81) for x, y in ((90, 64), (100, 62), (60, 70), (100, 30), (60, 20), (90, 70), (150, 60), (60, 70),
                                                 (60, 70), (50, 50), (85, 80), (20, 60), (85, 15))]
ROOM, ROOM_WIDE, CARD = (148, 72, 72, 64), (120, 60, 100, 90), (164, 48, 72, 64)
OVER = ("over, McGuire", "over, Guertin", "over, Jimenez", "over, uniform", "in gather", "layered", "ground truth")
ENDS = ("no rays", "luminance", "geometry", "instance", "motion", "ground truth")
MASKS = ("no rays", "paper", "relative", "moving", "ground truth")
EDGES = ("no rays", "sobel", "laplacian", "canny", "plane", "silhouette", "id", "ground truth")
READINGS = ("McGuire 2012", "UE4-style", "as written", "+ passes over its own instance", "+ even weights",
            "+ instance ends the ray", "ground truth")
SPEEDS = ("no blur", "McGuire 2012", "UE4-style", "hybrid", BEST, "ground truth")
RANGES = ("no blur", "McGuire 2012", "Jimenez 2014", "hybrid", "hybrid_layered", "hybrid_layered, split", BEST,
          "ground truth")

SHEETS = [
    crops("composites", [columns(shot, OVER, samples=16) for shot in ("still", "against", "vase")],
          [(132, 0, 72, 64), (132, 0, 72, 64), ROOM]),
    crops("termination", [columns(shot, ENDS) for shot in ("vase", "equal", "textured", "parts", "alike", "nodes", "posts")],
          [ROOM] + [CARD] * 5 + [(140, 60, 72, 64)]),
    crops("mask_relative", [columns(shot, MASKS) for shot in ("vase", "against", "tracking")],
          [ROOM, (148, 0, 72, 64), (120, 72, 72, 64)]),
    crops("readings", [columns(shot, READINGS) for shot in ("plain", "vase")], [(112, 52, 72, 64), ROOM]),
    crops("sampling_range", [columns(shot, RANGES, anchor="centre") for shot in ("vase", "back")],
          [ROOM, (128, 60, 72, 64)]),
    crops("edge_detectors", [columns(shot, EDGES, depth=0.05) for shot in ("vase", "near")], [ROOM, (176, 64, 72, 64)]),
    crops("exposure_and_speed", [columns(shot, SPEEDS, speed=26, exposure=1) for shot in ("object", "tracking")],
          [(140, 72, 88, 64), (178, 72, 88, 64)]),
    crops("everything", front, [ROOM_WIDE], 4),
    crops("exhibits", lambda bench: [[bench.results("exhibits").point(**at) for at in row] for row in exhibits()],
          EXHIBITS_REGIONS),
    crops("shading_under_motion", [columns(shot, ("no blur", "McGuire 2012", BEST, "ground truth", "truth, light in motion"))
                                   for shot in ("lamp", "shadow", "gloss")],
          [(180, 70, 130, 110), (80, 62, 130, 110), (100, 20, 130, 110)]),
    crops("samples", [[{"shot": "vase", "arm": arm, "samples": samples, "tile": 20} for samples in (4, 16, 64)] +
                      [{"shot": "vase", "arm": "ground truth", "samples": 64, "tile": 20}]
                      for arm in ("McGuire 2012", "UE4-style", BEST)], [ROOM_WIDE] * 3, 4),
]

FIGURES = [
    captured("figure1"),
    captured("figure2"),
    picture("figure_rooms", "rooms", "rooms.svg", 2, compare="titles", because="Graphviz versions differ in layout"),
    picture("figure_cells", "cells", "cells.png", 2, compare="pixels", share=0.002, step=2),
    picture("figure_frame", "frame", "frame.svg", 2, compare="titles", because="Graphviz versions differ in layout"),
    *[picture("figure_pass_" + name.replace(".", "_"), "passes", f"passes/{name}.png", 40, compare="pixels", share=0.002,
              step=2) for name in PASSES],
    *[picture("figure_window_" + name, "window", f"live-{name}.png", 70, compare="pixels", share=0.01, step=8,
              region=region, because="without the panels, which show times")
      for name, region in (("compare", MIDDLE), ("inspect", MIDDLE), ("problem", MIDDLE), ("sweep", ABOVE))],
    picture("figure_demo", "demo", "demo.png", 200, compare="pixels", share=0.002, step=2),
    Page("stability_page", "./strobe stability --write FILE", 60, "counts of cases", file="docs/stability.md",
         words=("stability",), part="mcguire2012", full_seconds=1500),
    Page("extreme_cases_page", "./strobe stability --extremes --write FILE", 600, "counts of cases",
         file="docs/extreme-cases.md", words=("stability", "--extremes"), full_seconds=600),
    Unrepeated("figure_report", because="a screenshot in a browser of the report of experiments/composites, with a chart "
               "of times; 2026-11-29, llvmpipe on two cores", file="docs/pictures/report.png"),
    Unrepeated("mutations_page", because="build/strobe_mutate --seed 1 --count 120 --write FILE takes hours; made at "
               "5d06a84, 2026-11-21, llvmpipe on two cores", file="tools/mutate/mutations.md"),
] + SHEETS
