# SPDX-License-Identifier: MIT
"""Claims of docs/derivations.md: numbers that the oracle tests print, and pictures of the living room."""
import json

from bench import Failed
from kinds import Numbers
from readers import printed, table_rows

ORACLE, GATHER, LAYERED = "test_oracle", "Gather.*", "LayeredGather.*"


def lines(test, name, pick=None):
    def read(bench):
        values = printed(bench, ORACLE, test, name)
        return [values[i] for i in pick] if pick else values
    return read


def columns(bench, test, *names):
    """Values of several names, interleaved row by row."""
    parts = [printed(bench, ORACLE, test, name) for name in names]
    return [value for row in zip(*parts) for value in row]


def guertin(bench):
    truth = printed(bench, ORACLE, GATHER, "centred")[::4]
    parts = [printed(bench, ORACLE, GATHER, name) for name in ("guertin_one", "guertin_two", "edited")]
    return [value for row in zip(truth, *parts) for value in row]


def one_sided(bench):
    """Rows: truth and filter at the leading edge, truth and filter at the trailing edge."""
    values = printed(bench, ORACLE, GATHER, "one_sided")
    truth, filtered = values[::2], values[1::2]
    return truth[:4] + filtered[:4] + truth[4:] + filtered[4:]


def invented(bench):
    values = printed(bench, ORACLE, GATHER, "invented")
    return values[::2] + values[1::2]


def striped(bench):
    """Per row: displacement of the background; then for harsh and gentle stripes, rms and largest error of the mask
    `own`, and of the mask `relative`."""
    harsh, gentle = (printed(bench, ORACLE, LAYERED, name) for name in ("harsh", "gentle"))
    backs = [0, 6, 12, 20, -12, -12, 20, 20, -12, -20]
    rows = []
    for i, back in enumerate(backs):
        rows += [back] + harsh[4 * i:4 * i + 4] + gentle[4 * i:4 * i + 4]
    return rows


def rendered(bench, stripes, case, column):
    """rms and largest error in one cell of the tables that the tests RenderLayers print."""
    bench.need(bench.program.parent / "tests" / ORACLE, why="the tests are not built: ./strobe test -N builds them")
    text = bench.run(bench.program.parent / "tests" / ORACLE, "--gtest_filter=RenderLayers.*Table")
    head = next((line for line in text.splitlines() if line.startswith(f"| {stripes}:")), "")
    cells = [cell.strip() for cell in head.strip("|").split("|")]
    table = text[text.index(head):] if head else ""
    for row in table_rows(table.split("\n| gentle:" if stripes == "harsh" else "\n[")[0]):
        if row[0] == case:
            return [float(part) for part in row[cells.index(column)].split("/")]
    raise Failed(f"RenderLayers prints no {stripes} {case} {column}")


OWN, RELATIVE = "own N=32", "relative N=32"


def rendered_layers(bench):
    cell = lambda *at: rendered(bench, *at)  # noqa: E731
    return [cell("harsh", "20, 6", RELATIVE)[0], cell("harsh", "20, 12", RELATIVE)[0],
            *cell("harsh", "20, -12", OWN), cell("harsh", "6, -20", OWN)[0], *cell("gentle", "20, -12", OWN)]


def seed_linear(bench):
    return [rendered(bench, stripes, "12, -12", "letter, even weights")[0] for stripes in ("harsh", "gentle")]


def correlated(bench):
    """`layered` and `in_gather` print equal values, within 1e-3; the values of `layered` are returned for both."""
    values = printed(bench, ORACLE, "RenderReveal.CompositesOnCorrelatedStripes", "correlated")
    layered, in_gather, over = values[:2], values[2:4], values[4:]
    if max(abs(a - b) for a, b in zip(layered, in_gather)) > 1e-3:
        raise Failed("layered and in_gather differ")
    return layered + over


# --- the living room, and stripes in a picture

LAYERS = "tools/reproduce/layers.lua"


def layer_errors(*wanted):
    """RMSE of each pair of `wanted`: arm, region."""
    def read(bench):
        results = bench.swept(LAYERS, "layers")
        return [results.value("rmse", region, arm=arm) for arm, region in wanted]
    return read


def reveal_counter(bench, name, *settings):
    """A counter of the pass `ray_reveal` in a picture of the living room."""
    file = bench.folder("room") / ("_".join(("room",) + settings) + ".exr")
    sets = [word for setting in settings for word in ("--set", setting)]
    bench.run("strobe", "render", "hybrid_layered", "--scene", "living_room", "--size", "320x180", *sets, "-o", file)
    return json.loads(file.with_suffix(".record.json").read_text())["counters"]["ray_reveal." + name]


def room_cap(bench):
    masked = bench.swept(LAYERS, "layers").value("masked", arm="layered")
    return [reveal_counter(bench, "capped", "advance=origin_kept"), masked]


PROGRAM = "build/tests/test_oracle --gtest_filter="


def gather(id, reader, test=GATHER):
    return Numbers(id, PROGRAM + test, 2, "closed forms in double precision", read=reader)


def layers(id, reader):
    return Numbers(id, PROGRAM + "'RenderLayers.*Table'", 30, "one time sample in one pixel", read=reader, places=1)


DERIVED = [
    gather("centred_filters", lines(GATHER, "centred")),
    gather("before_rounding", lambda b: printed(b, ORACLE, GATHER, "before_rounding") +
           [printed(b, ORACLE, GATHER, "centred")[4 * 4 + 2]]),
    gather("guertin_filters", guertin),
    gather("one_sided", one_sided),
    gather("invented_background", invented),
    gather("mirrored_weights", lines(GATHER, "mirror")),
    gather("perfect_layers", lines(LAYERED, "perfect_layers"), LAYERED),
    gather("striped_layers", striped, LAYERED),
    gather("no_harvest", lines(LAYERED, "no_harvest"), LAYERED),
    gather("one_way", lines(LAYERED, "one_way", (0, 1)), LAYERED),
    layers("rendered_layers", rendered_layers),
    layers("rendered_best", lambda bench: rendered(bench, "harsh", "0, 20", "hybrid_layered")),
    layers("rendered_seed_linear", seed_linear),
    Numbers("correlated", PROGRAM + "RenderReveal.CompositesOnCorrelatedStripes", 10, "one time sample in one pixel",
            read=correlated, places=1),
    *[Numbers(id, "./strobe sweep tools/reproduce/layers.lua -o FOLDER", 30,
              "rounding differs between devices: single pixels at silhouettes show the other surface", read=reader,
              tolerance=0.02) for id, reader in (
        ("rendered_own_edge", layer_errors(("seed_linear, own edge", "whole"), ("seed_linear", "whole"))),
        ("room_composites", layer_errors(*[(arm, region) for arm in ("layered", "in_gather", "alpha_over")
                                           for region in ("whole", "hidden")])),
        ("room_cap", room_cap),
        ("room_cap_error", layer_errors(("capped", "hidden"), ("layered", "hidden"))))],
]
