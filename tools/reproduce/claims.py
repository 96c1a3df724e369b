# SPDX-License-Identifier: MIT
"""Claims: every figure and measured number of the pages, with an id, the command that makes it again, a reader for the
output of the command, the tolerance with its reason, and the approximate seconds on two cores without a graphics card.

Numbers that a page takes from an experiment are compared with the results of the experiment: the committed results or,
without --smoke, the results of this run. The claims `experiment_...` make the results again.
"""
from pathlib import Path

import readers as read
from derived import DERIVED
from figures import FIGURES
from kinds import Experiment, History, Numbers

OTHER_DEVICE = "rounding differs between devices: single pixels at silhouettes show the other surface"
TIMES = "times depend on the machine: reported, not judged"


def sweep(name):
    folder = f"experiments/{name}"
    if (Path(__file__).parents[2] / folder / "strobe.project.lua").exists():
        return f"cd {folder}; strobe sweep {name}.lua -o FOLDER"
    return f"./strobe sweep {folder}/{name}.lua -o FOLDER"


def experiment(name, few, seconds, full_seconds, **more):
    return Experiment(f"experiment_{name}", sweep(name), seconds, OTHER_DEVICE, name=name, few=few,
                      file=f"experiments/{name}/{name}.lua", full_seconds=full_seconds, tolerance=0.02, **more)


def of_results(id, name, reader, **more):
    because = more.pop("because", OTHER_DEVICE)
    return Numbers(id, sweep(name), 1, because, read=reader, sources=(name,), **{"tolerance": 0.02, **more})


def history(id, because, date, revision):
    return History(id, because=because, date=date, device="llvmpipe on two cores", revision=revision)


EXPERIMENTS = [
    experiment("any_object", "shot=door", 60, 900),
    experiment("not_required", "", 80, 80),
    experiment("all_moves", "shot=vase", 40, 110),
    experiment("curves", "shot=pendulum", 30, 60),
    experiment("sub_pixel", "speed=3,samples=16", 20, 60),
    experiment("peers", "shot=enters", 40, 60),
    experiment("exhibits", "shot=jump", 40, 400),
    experiment("shading_under_motion", "shot=lamp", 50, 240),
    experiment("adaptive", "shot=enters", 60, 360),
    experiment("adaptive_design", "shot=enters", 60, 720),
    experiment("error_estimate", "shot=crowd", 20, 60),
    experiment("methods", "shot=turning", 120, 1000),
    experiment("ue5", "shot=crossing", 40, 90),
    experiment("samples", "samples=4", 50, 400),
    experiment("composites", "shot=still,samples=16", 50, 1200),
    experiment("edge_detectors", "shot=near,depth=0.05", 50, 1200),
    experiment("everything", "arm=McGuire 2012", 50, 900),
    experiment("exposure_and_speed", "shot=object,speed=26,exposure=0.5", 50, 1500),
    experiment("extremes", "shot=passage,scale=1", 50, 3600),
    experiment("mask_relative", "shot=bar", 50, 900),
    experiment("precision", "shot=wedge", 50, 400),
    experiment("readings", "shot=plain", 50, 900),
    experiment("real_scenes", "", 180, 180, shared=True),
    experiment("hits_tried", "shot=cells_9,cap=8", 50, 600),
    experiment("tracing", "shot=cells,backend=bvh", 60, 650),
    experiment("truth", "shot=plain,samples=16", 100, 1100),
    experiment("sampling_range", "shot=thin,anchor=end", 50, 900),
    experiment("termination", "shot=plain", 50, 900),
]

TUNE = ["adaptive", "--scene", "living_room", "--size", "320x180", "--anchor", "end", "--budget-ratio", "0.5", "--cost", "own"]
EXPERIMENTS.append(Experiment(
    "experiment_tune_living_room", "./strobe tune " + " ".join(TUNE) + " -o FILE", 900,
    OTHER_DEVICE + "; times decide which points are tried: points of both runs are compared", name="tune/living_room",
    make=read.tuning(TUNE), tolerance=0.02))

MEASURED = [
    of_results("readme_real_scenes", "real_scenes", read.real_rows(False)),
    of_results("real_scenes_inner", "real_scenes", read.real_rows(True)),
    of_results("readme_frame_time", "real_scenes", read.frame_ratios, tolerance=0.25),
    of_results("methods_table", "methods", read.methods_table, tolerance=0.25),
    of_results("frame_time", "real_scenes", read.frame_ratios, tolerance=0.25),
    of_results("readme_moving_camera", "all_moves", read.moving_camera_ratios, tolerance=0.25),
    of_results("moving_camera", "all_moves", read.moving_camera_ratios, tolerance=0.25),
    of_results("precision_room", "precision", read.precision_room),
    of_results("precision_oracles", "precision", read.precision_oracles),
    of_results("precision_color", "precision", read.precision_color),
    of_results("precision_color_error", "precision", read.precision_color_error, places=1),
    of_results("precision_color_saving", "precision", read.precision_color_saving),
    of_results("precision_velocity_largest", "precision", read.precision_velocity_largest),
    of_results("everything_front", "everything", read.everything_front),
    Numbers("shadow_rays_left", "./strobe render none --size 960x540, with tile_light_visibility.per_tile and without", 3,
            "other tracing backends do not test whole tiles", read=read.shadow_rays_left, tolerance=0.02),
    Numbers("tutorial_detectors", "./strobe sweep experiments/detectors.lua -o FOLDER", 45, OTHER_DEVICE,
            read=read.tutorial_row, tolerance=0.02),
    *[Numbers(id, "committed: docs/gpu/h200", 1, "made on another machine", read=reader)
      for id, reader in (("gpu_frames", read.gpu_frames), ("gpu_published", read.gpu_published),
                         ("gpu_kitchen", read.gpu_kitchen), ("gpu_passes", read.gpu_passes),
                         ("gpu_by_rays", read.gpu_by_rays), ("gpu_pairs", read.gpu_pairs), ("gpu_reload", read.gpu_reload))],
    History("gpu_rounding", because="needs such a GPU", date="2026-11-26", device="NVIDIA H200", revision="8f25415"),
    History("gpu_verify", because="needs such a GPU", date="2026-11-26", device="NVIDIA H200", revision="b89ed81"),
    Numbers("mutants_caught", "committed: tools/mutate/mutations.md", 1, "read from the page that the tool wrote",
            read=read.caught_mutants),
]

TUNED = [
    Numbers(id, "./strobe sweep tools/reproduce/tuned.lua -o FOLDER", 40, because, read=reader, **more)
    for id, reader, because, more in (
        ("tuned_inner", read.tuned("inner"), OTHER_DEVICE, {"tolerance": 0.02}),
        ("tuned_whole", read.tuned("whole"), OTHER_DEVICE, {"tolerance": 0.02}),
        ("tuned_cost", read.tuned("cost"), TIMES, {"asserted": False}),
        ("tuned_other", read.tuned("other"), OTHER_DEVICE, {"tolerance": 0.02}),
        ("tuned_other_cost", read.tuned("other_cost"), TIMES, {"asserted": False}),
        ("tune_answer", read.tuned("inner_ratio"), OTHER_DEVICE, {"tolerance": 0.02}),
        ("tune_answer_whole", read.tuned("whole"), OTHER_DEVICE, {"tolerance": 0.02}),
        ("tune_answer_cost", read.tuned("cost"), TIMES, {"asserted": False}),
        ("tune_answer_other_cost", read.tuned("other_cost"), TIMES, {"asserted": False}),
        ("tune_answer_other", read.tuned("other_whole"), OTHER_DEVICE, {"tolerance": 0.02}),
        ("tune_answer_other_inner", read.tuned("other_inner"), OTHER_DEVICE, {"tolerance": 0.02}),
    )
]

OF_A_MACHINE = [
    Numbers("reload_table", "./strobe bench reload hybrid", 90, TIMES, read=read.reload_rows, asserted=False),
    Numbers("reload_added", "./strobe bench reload hybrid", 90, TIMES, read=read.reload_added, asserted=False),
    Numbers("pass_shares", "docs/pictures/make passes", 40, TIMES, read=read.pass_shares, asserted=False),
    Numbers("tile_pass_share", "docs/pictures/make passes", 40, TIMES, read=read.tile_pass_share, asserted=False),
    Numbers("frames_at_rest", "./strobe bench frames adaptive accumulation mcguire2012 --size 960x540", 60, TIMES,
            read=read.frames_at_rest, asserted=False),
    Numbers("live_rate", "xvfb-run ./strobe live adaptive --size WxH --drive FILE", 50, TIMES, read=read.live_rate,
            asserted=False),
    Numbers("sweep_seconds", "./strobe sweep tools/reproduce/thousand.lua -o FOLDER", 100, TIMES,
            read=read.thousand_points, asserted=False),
    *[Numbers(id, "git clone; cmake; ninja; ctest; ./strobe demo", 1200, TIMES, read=read.build_minutes, asserted=False)
      for id in ("build_minutes", "artifact_minutes")],
    Numbers("reload_edits", "STROBE_EDITS=1000 build/tests/test_session --gtest_filter='Edits*'", 300,
            "random edits with a fixed seed", read=read.random_edits),
    Numbers("rays_held", "STROBE_RAYS=2500000 build/tests/test_oracle --gtest_filter='RenderRays*'", 150,
            "rounding differs between devices", read=read.rays_held, tolerance=0.02),
    Numbers("reload_edits_time", "STROBE_EDITS=1000 build/tests/test_session --gtest_filter='Edits*'", 300, TIMES,
            read=read.random_edits_time, asserted=False),
]

PAST = [
    history("mended_truth", "a mistake that has been fixed", "2026-11-21", "5d06a84"),
    history("mended_sky", "a mistake that has been fixed", "2026-11-21", "5d06a84"),
    history("mended_mesh", "a mistake that has been fixed", "2026-11-21", "5d06a84"),
    history("precision_times", "times of frames drawn alternately", "2026-11-21", "79be7cf"),
    history("read_by_address", "times, drawn alternately, of a program that was not kept", "2026-11-27", "ea973e8"),
    history("cycles_against_truth", "needs Blender", "2026-11-28", "7572498"),
    history("cycles_noise", "needs Blender", "2026-11-28", "7572498"),
    history("wide_vectors", "times on one processor, drawn alternately", "2026-11-27", "ac214d2"),
]

CLAIMS = MEASURED + TUNED + DERIVED + EXPERIMENTS + FIGURES + OF_A_MACHINE + PAST

# Claims of --smoke: claims of at most SMOKE_LEAST_S, and the claims of these commands: figures, experiments with a few
# points, tables of a page. tests/repo/reproduce_test.cpp adds up their seconds.
SMOKE_LEAST_S = 3
SMOKE = ("figure1", "figure_pass_", "experiment_all_moves", "experiment_curves", "experiment_sub_pixel",
         "experiment_error_estimate", "tuned_", "tune_answer", "rendered_", "room_", "stability_page")


def is_in_smoke(claim):
    return claim.kind != "not repeated" and (claim.seconds <= SMOKE_LEAST_S or claim.id.startswith(SMOKE))
