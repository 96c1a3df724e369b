# SPDX-License-Identifier: MIT
"""Readers of claims: functions that read numbers from results and from the output of commands."""
import json
import re
import statistics
import time

from bench import Failed, Results

HOME_TOOLS = "tools/reproduce/"


def values_of(experiment, wanted):
    """Reader of the values at `wanted`: tuples of shot, arm, measure, region and, optionally, a dict of axes."""
    def read(bench):
        results = bench.results(experiment)
        return [results.value(measure, region, shot=shot, arm=arm, **(more[0] if more else {}))
                for shot, arm, measure, region, *more in wanted]
    return read


# --- real scenes

REAL_SHOTS = ("living_room", "pot", "mug", "lamp", "bowl")
REAL_ARMS = ("no blur", "McGuire 2012", "UE4-style", "hybrid (text)", "hybrid", "adaptive")


def real_inner(results, shot, arm):
    return results.value("rmse", "inner", shot=shot, arm=arm, anchor="end")


def real_rows(with_ratios):
    """Rows of the table of real scenes."""
    def read(bench):
        results, row = bench.results("real_scenes"), []
        for shot in REAL_SHOTS:
            row += [real_inner(results, shot, arm) for arm in REAL_ARMS]
            own, floor = row[-1], real_inner(results, shot, "truth, 16 samples")
            baseline = min(real_inner(results, shot, arm) for arm in REAL_ARMS[1:3])
            row += [floor] + ([own / baseline, own / floor] if with_ratios else [])
        return row
    return read


def frame_ratios(bench):
    """Smallest and largest ratio over the scenes: frame time of adaptive / frame time of McGuire 2012."""
    results = bench.results("real_scenes")
    ratios = [results.value("ms", shot=shot, arm="adaptive", anchor="end") /
              results.value("ms", shot=shot, arm="McGuire 2012", anchor="end") for shot in REAL_SHOTS]
    return [min(ratios), max(ratios)]


METHODS = ("no blur", "McGuire 2012", "Guertin 2014", "Jimenez 2014", "UE4-style", "UE5-style", "Bevy", "HDRP", "EEVEE, 4 steps",
           "Lee 2024", "Oberberger 2022", "hybrid", "hybrid_layered", "accumulation", "adaptive, quality 0.1",
           "adaptive, quality 0.4", "adaptive, quality 0.7", "truth, 1024 samples")
KINDS_OF_MOTION = ("mover", "turning", "entering", "camera")


def methods_table(bench):
    """Rows of the table of all methods: milliseconds at both sizes (means over the shots with a static camera), milliseconds
    with a moving camera, then PSNR, SSIM, FLIP of each shot."""
    results, rows = bench.results("methods"), []
    static = [shot for shot in KINDS_OF_MOTION if shot != "camera"]
    for arm in METHODS:
        for size in ("1280x720", "1920x1080"):
            rows.append(statistics.fmean(results.value("ms", shot=shot, arm=arm, picture=size) for shot in static))
        rows.append(results.value("ms", shot="camera", arm=arm, picture="1280x720"))
        for shot in KINDS_OF_MOTION:
            rows += [results.value(measure, "whole", shot=shot, arm=arm, picture="1280x720") for measure in ("psnr", "ssim", "flip")]
    return rows


def moving_camera_ratios(bench):
    """Smallest and largest ratio with moving cameras: frame time of adaptive / frame time of McGuire 2012."""
    results = bench.results("all_moves")
    ratios = [results.value("ms_ratio", shot=shot, arm="adaptive, quality 0.4") for shot in ("tracking", "parallax", "chase")]
    return [min(ratios), max(ratios)]


def rays_held(bench):
    test = bench.program.parent / "tests" / "test_oracle"
    bench.need(test, why="the tests are not built: ./strobe test -N builds them")
    text = bench.run(test, "--gtest_filter=RenderRays*", environment={"STROBE_RAYS": "2500000"})
    rows = re.findall(r"^\w+, (?:pipeline|bvh|Embree): (\d+) rays, (\d+) tied, (\d+) bordering, (\d+) others", text, re.M)
    return [float(number) for row in rows for number in row]


# --- runs on a GPU

def gpu_times(bench, file="bench"):
    """Median times of a saved run, ms: {(method, width): {pass: time}}; the key "" has the frame."""
    shots = json.loads((bench.root / f"docs/gpu/h200/{file}.json").read_text())["shots"]
    return {(shot["method"], shot["width"]): {"": statistics.median(shot["ms"])} |
            {one["name"]: statistics.median(one["ms"]) for one in shot["passes"]} for shot in shots}


def gpu_frames(bench):
    times = gpu_times(bench)
    methods = ("none", "mcguire2012", "ue4", "guertin2014", "jimenez2014", "hybrid:preset=seed")
    return [times[method, width][""] for method in methods for width in (960, 1920, 3840)]


def gpu_published(bench):
    times = gpu_times(bench)
    return [times["hybrid:preset=seed", 1920][""] / times["mcguire2012", 1920][""]]


def gpu_kitchen(bench):
    times = gpu_times(bench, "kitchen")
    return [times[method, 1920][""] for method in ("none", "mcguire2012", "hybrid:preset=seed")]


def gpu_passes(bench):
    mcguire = gpu_times(bench)["mcguire2012", 1920]
    return [mcguire["visibility"], mcguire["gather"]]


def gpu_by_rays(bench):
    times = gpu_times(bench, "visibility_by_rays")
    return [times[method, 1920][""] for method in ("none_rays", "none")]


def gpu_pairs(bench):
    """Pairs of times of frames ("") or passes: with another choice, and as shipped. The data of the GPU has the names
    that passes had then: `mask_tile_motions` is `tile_velocities` now."""
    now = gpu_times(bench)
    pairs = [("clears_by_driver", "hybrid:preset=seed", ""), ("one_invocation_per_tile", "hybrid", "mask_tile_motions"),
             ("one_invocation_per_tile", "hybrid", "tile_max"), ("pipeline", "none", "")]
    return [run[method, 1920][name] for file, method, name in pairs for run in (gpu_times(bench, file), now)]


def gpu_reload(bench):
    """Seconds to compile after the edit of one pass and of a library, and to build the graph."""
    edits = {edit["edited"]: edit for edit in json.loads((bench.root / "docs/gpu/h200/reload.json").read_text())["reload"]}
    one, many = edits["shader of one pass"], edits["shader library of 23 passes"]
    return [one["compile_ms"] / 1000, many["compile_ms"] / 1000, one["build_ms"] / 1000]


# --- output of tests and commands

def printed(bench, program, test, name):
    """Numbers of the lines "NAME: a b c" that a test prints."""
    bench.need(bench.program.parent / "tests" / program, why="the tests are not built: ./strobe test -N builds them")
    text = bench.run(bench.program.parent / "tests" / program, f"--gtest_filter={test}")
    found = [line.split(": ", 1)[1].split() for line in text.splitlines() if line.startswith(name + ": ")]
    if not found:
        raise Failed(f"{test} prints no line '{name}: ...'")
    return [float(word) for words in found for word in words]


def lines_of(program, test, name):
    return lambda bench: printed(bench, program, test, name)


def table_rows(text):
    """Cells of the rows of a Markdown table, without the header and the line below it."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in text.splitlines()
            if line.startswith("|")]
    return [row for row in rows[1:] if not re.fullmatch(r"[-: ]+", row[0] or "-")]


def block_files(text):
    """Files that a page contains as blocks "```lua passes/edge/x.lua": {path: text}."""
    return dict(re.findall(r"^```\w+ ([^\s:]+)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))


def tutorial_row(bench):
    """Follows docs/your-own-edge-detector.md in a project and sweeps its experiment."""
    page = (bench.root / "docs/your-own-edge-detector.md").read_text()
    project = bench.out / "detectors"
    if not (project / "strobe.project.lua").exists():
        bench.run("strobe", "new", project)
    for file, text in block_files(page).items():
        (project / file).parent.mkdir(parents=True, exist_ok=True)
        (project / file).write_text(text)
    bench.run("strobe", "sweep", "experiments/detectors.lua", "-o", "out/detectors", cwd=project)
    results = Results(project / "out/detectors/result.json", fresh=True)
    return [results.value("rmse", "inner", arm=arm)
            for arm in ("McGuire 2012", "canny", "sobel", "dilation", "id", "plane")]


def caught_mutants(bench):
    text = (bench.root / "tools/mutate/mutations.md").read_text()
    found = re.search(r"\*\*(\d+) of (\d+) caught", text)
    return [float(found.group(1)), float(found.group(2))]


def timed(bench, *words, **more):
    begin = time.monotonic()
    bench.run(*words, **more)
    return time.monotonic() - begin


# --- precision

PRECISION_ROWS = (
    ("hybrid", ({}, {"velocity_format": "fp16"}, {"color_format": "fp16"}, {"both": "fp16"},
                {"depth_encoding": "reversed"})),
    ("McGuire 2012", ({}, {"velocity_format": "fp16"}, {"color_format": "fp16"}, {"depth_encoding": "reversed"},
                      {"depth_encoding": "inverse"}, {"depth_encoding": "unorm24"})),
    ("Guertin 2014", ({}, {"velocity_format": "fp16"}, {"color_format": "fp16"}, {"depth_encoding": "unorm24"})),
    ("Jimenez 2014", ({}, {"velocity_format": "fp16"}, {"color_format": "fp16"}, {"depth_encoding": "unorm24"})),
)
DEFAULTS = {"velocity_format": "fp32"}


def precise(results, shot, arm, at):
    values = results.point(shot=shot, arm=arm, **(at or DEFAULTS))["values"]
    return {name: values[name].get("whole", values[name].get("all")) for name in ("bytes", "change_rms", "change", "rmse")}


def precision_room(bench):
    results, row = bench.results("precision"), []
    for arm, settings in PRECISION_ROWS:
        for at in settings:
            values = precise(results, "living_room", arm, at)
            row += [values["bytes"]] + ([values["change_rms"], values["change"]] if at else []) + [values["rmse"]]
    return row


def precision_oracles(bench):
    results, row = bench.results("precision"), []
    for shot in ("textured_bar", "quad_2d", "wedge"):
        for arm in ("hybrid", "McGuire 2012"):
            for at in ({"velocity_format": "fp16"}, {"color_format": "fp16"}):
                values = precise(results, shot, arm, at)
                row += [values["change_rms"], values["change"], values["rmse"],
                        precise(results, shot, arm, {})["rmse"]]
    return row


def precision_color(bench):
    return [precise(bench.results("precision"), "living_room", "hybrid", {"color_format": "fp16"})["change_rms"]]


def precision_color_error(bench):
    """Largest change of an error by half-precision colours, per cent of the error."""
    results = bench.results("precision")
    return [max(100 * abs(precise(results, shot, arm, {"color_format": "fp16"})["rmse"] /
                          precise(results, shot, arm, {})["rmse"] - 1)
                for shot in ("living_room", "textured_bar", "quad_2d", "wedge") for arm, _ in PRECISION_ROWS)]


def precision_color_saving(bench):
    results = bench.results("precision")
    return [100 - 100 * precise(results, "living_room", "hybrid", {"color_format": "fp16"})["bytes"] /
            precise(results, "living_room", "hybrid", {})["bytes"]]


def precision_velocity_largest(bench):
    return [precise(bench.results("precision"), "living_room", "hybrid", {"velocity_format": "fp16"})["change"]]


# --- everything, tuning

def front_of(results, x, y, region):
    """Pareto front of two costs, sorted by x: tuples of x, y, point."""
    found, best = [], float("inf")
    points = [(point["values"][x]["all"], point["values"][y][region], point) for _, point in results.points()
              if x in point["values"]]
    for at in sorted(points, key=lambda one: one[:2]):
        if at[1] < best:
            best = at[1]
            found.append(at)
    return found


def everything_front(bench):
    """Error and time of each point of the committed front. The times of a new run would select other points."""
    return [value for x, y, _ in front_of(bench.committed("everything"), "ms_ratio", "rmse", "inner") for value in (y, x)]


def tuned(what):
    def read(bench):
        results = bench.swept(HOME_TOOLS + "tuned.lua", "tuned")
        rmse = {(arm, region): results.value("rmse", region, arm=arm) for arm in ("as given", "preset", "other")
                for region in ("inner", "whole")}
        cost = {arm: results.value("own_ratio", arm=arm) for arm in ("preset", "other")}
        ratio = lambda arm, region: rmse[arm, region] / rmse["as given", region]  # noqa: E731
        return {"inner": [ratio("preset", "inner"), rmse["preset", "inner"], rmse["as given", "inner"]],
                "inner_ratio": [ratio("preset", "inner")], "whole": [ratio("preset", "whole")],
                "other": [ratio("other", "whole"), ratio("other", "inner")], "other_whole": [ratio("other", "whole")],
                "other_inner": [ratio("other", "inner")], "cost": [cost["preset"]], "other_cost": [cost["other"]]}[what]
    return read


def tuning(words):
    """Maker of results by `strobe tune`."""
    def make(bench):
        preset = bench.folder("tune") / "living_room.lua"
        bench.run("strobe", "tune", *words, "-o", preset, codes=(0, 1))
        return Results(bench.out / "tune/living_room/result.json", fresh=True)
    return make


# --- values that depend on the machine

RELOAD_COLUMNS = ("watch_ms", "evaluate_ms", "compile_ms", "build_ms", "first_frame_ms", "later_frame_ms", "added_ms")


def reload_data(bench):
    return json.loads(bench.run("strobe", "bench", "reload", "hybrid", "--json"))["reload"]


def reload_rows(bench):
    return [edit[column] for edit in reload_data(bench) for column in RELOAD_COLUMNS]


def reload_added(bench):
    """Smallest and largest added time, ms: for edits of scripts, then for edits of shaders."""
    shaders, scripts = [], []
    for edit in reload_data(bench):
        (shaders if edit["edited"].startswith("shader") else scripts).append(edit["added_ms"])
    return [min(scripts), max(scripts), min(shaders), max(shaders)]


def pictures_of_passes(bench):
    """Output of `docs/pictures/make passes`. The pictures are in the folder `passes`."""
    return bench.run(bench.root / "docs/pictures/make", "-o", bench.folder("pictures"), "passes")


def shares(bench):
    return {node: float(share) for node, share in re.findall(r"^(\w+) ([\d.]+) %$", pictures_of_passes(bench), re.M)}


def pass_shares(bench):
    share = shares(bench)
    alone = ("shade", "visibility", "composite", "tile_light_visibility", "gbuffer", "ray_reveal", "mask", "tile_velocities",
             "tile_max")
    alike = (("mask_ids", "revealed_bounds"),
             ("mask_bounds", "cull_candidates", "gather_candidates", "classify_cells", "neighbour_max"))
    return [share[node] for node in alone] + [max(share[node] for node in nodes) for nodes in alike]


def tile_pass_share(bench):
    share = shares(bench)
    return [sum(share[node] for node in ("tile_velocities", "gather_candidates", "tile_max", "neighbour_max"))]


def frames_at_rest(bench):
    """Frame times of adaptive and of the accumulation buffer / frame time of McGuire 2012, medians over the rounds:
    with a moving pot in the country kitchen, then with the moving vase in the living room."""
    pot = ["--scene", bench.shared_scenes() / "country_kitchen/country_kitchen.glb", "--move", "Mesh080_SteelPot=0.4,0,-0.195"]
    ratios = []
    for shot in pot, ["--scene", "living_room"]:
        bench_of = json.loads(bench.run(bench.program, "bench", "frames", "adaptive", "accumulation", "mcguire2012", *shot,
                                        "--size", "960x540", "--rounds", "9", "--json"))
        ms = {one["method"]: one["ms"] for one in bench_of["shots"]}
        for method in "adaptive", "accumulation":
            ratios.append(statistics.median(a / b for a, b in zip(ms[method], ms["mcguire2012"])))
    return ratios


def shadow_rays_left(bench):
    """Per cent of the shadow rays of the living room that are traced if whole tiles are tested first."""
    rays = []
    for shafts in ("true", "false"):
        record = json.loads(bench.run(bench.program, "render", "none", "--size", "960x540", "--set",
                                      f"tile_light_visibility.per_tile={shafts}", "-o", bench.folder("shafts") / f"{shafts}.exr",
                                      "--json"))
        rays.append(sum(count for name, count in record["counters"].items() if name.startswith("shade.rays_")))
    return [100 * rays[0] / rays[1]]


def live_rate(bench):
    """Frames per second of the playing window, from the added time of 40 more frames."""
    rates = []
    for size in ("160x90", "320x180", "480x270"):
        spent = []
        for frames in (10, 50):
            drive = bench.folder("live") / f"{frames}.drive"
            drive.write_text(f"wait 5\nplay on\nwait {frames}\nquit\n")
            spent.append(timed(bench, "xvfb-run", "-a", "-s", "-screen 0 1400x900x24 -noreset", bench.program, "live", "adaptive",
                               "--scene", "living_room", "--size", size, "--drive", drive, "--out", bench.folder("live")))
        rates.append(40 / (spent[1] - spent[0]))
    return rates


def thousand_points(bench):
    """Seconds of drawing, measuring and keeping, and their sum, as reported by a sweep of 1,000 points."""
    folder = bench.out / "thousand"
    words = ["strobe", "sweep", HOME_TOOLS + "thousand.lua", "-o", folder]
    bench.run(*words)
    errors = bench.last.stderr
    found = re.search(r"([\d.]+) drawing, ([\d.]+) measuring, ([\d.]+) keeping", errors)
    if not found:
        raise Failed("the sweep reports no times, so run it again: remove " + str(folder))
    parts = [float(part) for part in found.groups()]
    return parts + [sum(parts)]


def build_minutes(bench):
    """Minutes of the build of a clean clone without tests, of the tests, and of the demo."""
    clone, environment = bench.out / "clone", {"CCACHE_DISABLE": "1"}
    bench.run("git", "clone", "-q", bench.root, clone)
    build = timed(bench, "cmake", "--preset", "release", "-S", clone, "-B", clone / "build", environment=environment)
    build += timed(bench, "ninja", "-C", clone / "build", "strobe_program", environment=environment)
    bench.run("cmake", "-B", clone / "build", "-DSTROBE_TESTS=ON", environment=environment)
    bench.run("ninja", "-C", clone / "build", environment=environment)
    tests = timed(bench, "ctest", "--test-dir", clone / "build", "-j", "2", codes=(0, 8))
    demo = timed(bench, clone / "build/strobe", "demo", "-o", bench.folder("demo_timed"))
    return [build / 60, tests / 60, demo / 60]


def edits_report(bench):
    report = bench.out / "edits.md"
    test = bench.program.parent / "tests" / "test_session"
    bench.need(test, why="the tests are not built: ./strobe test -N builds them")
    bench.run(test, "--gtest_filter=Edits*", environment={
        "STROBE_EDITS": "1000", "STROBE_EDITS_DRAWN": "1000", "STROBE_EDITS_REPORT": str(report)})
    return report.read_text()


def random_edits(bench):
    return [float(cell) for row in table_rows(edits_report(bench)) for cell in row[1:]]


def random_edits_time(bench):
    return [float(re.search(r"(\d+) s in all", edits_report(bench)).group(1))]
