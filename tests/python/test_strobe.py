# SPDX-License-Identifier: MIT
"""The package `strobe` against the built program. tests/program/python_test.cpp runs these tests."""
import contextlib
import io
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
import warnings

import numpy as np
import pandas as pd

import strobe
from strobe import program

HOME = pathlib.Path(__file__).resolve().parents[2]
SMALL = {"scene": "oracles/bar", "size": (33, 17)}
EXPERIMENT = """
local experiment = require "strobe.experiment"
return experiment {
  title = "Two numbers of samples",
  size = { 32, 18 },
  shots = { { name = "bar", scene = "oracles/bar" } },
  arms = { { name = "hybrid", pipeline = "hybrid" }, { name = "no blur", pipeline = "none", lacks = { "samples" } } },
  truth = { pipeline = "ground_truth", set = { samples = 16 } },
  vary = { experiment.list { name = "samples", values = { 2, 4 } } },
  measures = { "rmse", "psnr", "memory" },
}
"""


def table_in(folder):
    """table.csv of a sweep. The column `note` repeats `failed`."""
    table = pd.read_csv(folder / "table.csv")
    table["preset"] = table["preset"].fillna("")
    return table.drop(columns="note", errors="ignore")


class Strobe(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refusal(self, *words):
        """Exit code and message of the program for a command line."""
        end = subprocess.run([program.program(), *words], capture_output=True, text=True)
        return end.returncode, end.stderr.removeprefix("strobe: ").strip()

    def test_arrays_equal_the_file(self):
        file = self.folder / "x.exr"
        picture = strobe.render("hybrid", **SMALL, tap=["raster_neighbour_max.dominant"], multipart=True, out=file)
        layers = strobe.read_exr(file)
        self.assertEqual(sorted(layers), sorted(picture))
        for name, image in picture.items():
            self.assertEqual(image.tobytes(), layers[name].tobytes(), name)
            self.assertEqual((image.shape, image.dtype), (layers[name].shape, layers[name].dtype), name)
        self.assertEqual(picture["color"].shape, (17, 33, 4))
        self.assertEqual((picture["color"].dtype, picture["id"].dtype), (np.float32, np.uint32))
        self.assertEqual(picture.record, strobe.record(file))

    def test_a_part_of_several_layers(self):
        file = self.folder / "x.exr"
        picture = strobe.render("none", **SMALL, out=file)
        layers = strobe.read_exr(file)
        for name in ("color", "depth", "velocity", "normal", "id"):
            np.testing.assert_array_equal(layers[name], picture[name], name)

    def test_options_are_those_of_the_command_line(self):
        file = self.folder / "y.exr"
        picture = strobe.render("hybrid", scene="oracles/bar", size="32x18", exposure=0.25, shutter_curve=(0, 1, 0),
                                sets={"samples": 3, "own_edge": False, "gather_raster.jitter": "ign"},
                                model_everything=True, seed=None)
        subprocess.run([program.program(), "render", "hybrid", "--scene", "oracles/bar", "--size", "32x18",
                        "--exposure", "0.25", "--shutter-curve", "0,1,0", "--set", "samples=3", "--set",
                        "own_edge=false", "--set",
                        "gather_raster.jitter=ign", "--model-everything", "-o", file], check=True,
                       stdout=subprocess.DEVNULL)
        self.assertEqual(picture.record, strobe.record(file))

    def test_every_picture_equals_that_of_a_fresh_program(self):
        for samples in (2, 5, 2):
            for pipeline in ("hybrid", "mcguire2012"):
                kept = strobe.render(pipeline, **SMALL, sets={"samples": samples})
                program.end()
                fresh = strobe.render(pipeline, **SMALL, sets={"samples": samples})
                self.assertEqual(kept.record, fresh.record)
                self.assertEqual(kept["color"].tobytes(), fresh["color"].tobytes())

    def test_edits_count(self):
        scene = self.folder / "scene.lua"
        text = (HOME / "scripts/scenes/oracles/bar.lua").read_text()
        scene.write_text(text)
        before = strobe.render("none", scene=scene, size=(32, 18))
        scene.write_text("-- edited\n" + text.replace("return scene {", "return scene { background = { 9, 9, 9 },", 1))
        after = strobe.render("none", scene=scene, size=(32, 18))
        self.assertNotEqual(before.record["scene"]["hash"] + before.record["scripts"][str(scene)],
                            after.record["scene"]["hash"] + after.record["scripts"][str(scene)])

    def test_exceptions_have_the_messages_of_the_program(self):
        for words, call in (
                (["render", "hybrd"], lambda: strobe.render("hybrd")),
                (["render", "none", "--set", "tyle=3"], lambda: strobe.render("none", sets={"tyle": 3})),
                (["render", "none", "--exposur=1"], lambda: strobe.render("none", exposur=1)),
                (["render", "none", "--size=0x4"], lambda: strobe.render("none", size=(0, 4))),
                (["help", "hybrd"], lambda: strobe.parameters("hybrd")),
                (["compare", "a.png", "b.png"], lambda: strobe.compare("a.png", "b.png"))):
            code, message = self.refusal(*words)
            with self.assertRaises(strobe.StrobeError) as raised:
                call()
            self.assertEqual((raised.exception.exit_code, str(raised.exception)), (code, message))

    def test_commands_that_are_not_served(self):
        for command in ("live", "sweep", "serve"):
            with self.assertRaisesRegex(strobe.StrobeError, f"serve does not run '{command}'"):
                program.call(command, *(["x.lua"] if command == "sweep" else []))

    def test_an_ended_program_starts_again(self):
        strobe.render("none", **SMALL)
        program._server._process.kill()
        program._server._process.wait()
        strobe.render("none", **SMALL)
        with self.assertRaisesRegex(strobe.StrobeError, "ran for more than 1e-09 s") as raised:
            strobe.render("ground_truth", **SMALL, time_limit=1e-9)
        self.assertIsNone(raised.exception.exit_code)
        strobe.render("none", **SMALL)

    def test_warnings(self):
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            strobe.render("none", **SMALL, exposure=180)
        self.assertTrue(any("a shutter of 180 degrees is --exposure 0.5" in str(one.message) for one in seen))

    def test_another_folder(self):
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        strobe.render("none", **SMALL)
        os.chdir(self.folder)
        strobe.render("none", **SMALL, out="here.png")
        self.assertTrue((self.folder / "here.png").exists())

    def test_compare(self):
        test, truth = strobe.render("none", **SMALL), strobe.render("ground_truth", **SMALL, sets={"samples": 8})
        numbers = strobe.compare(test, truth)
        difference = test["color"][..., :3].astype(float) - truth["color"][..., :3]
        self.assertAlmostEqual(numbers["rmse"], math.sqrt((difference ** 2).mean()), places=7)
        self.assertEqual(strobe.compare(test["color"][..., :3], test)["psnr"], math.inf)

    def test_a_frame_equals_the_table(self):
        file = self.folder / "two.lua"
        file.write_text(EXPERIMENT)
        frame = strobe.sweep(file, self.folder / "out")
        table = table_in(self.folder / "out")
        self.assertEqual(len(frame), 4 * len(set(frame["region"])))
        pd.testing.assert_frame_equal(frame[list(table.columns)], table, check_dtype=False, check_exact=True)
        self.assertEqual(set(frame["role"]), {"method"})
        self.assertEqual(frame.attrs["units"], {"samples": "", "rmse": "", "psnr": "dB", "memory": "MiB"})
        pd.testing.assert_frame_equal(frame, strobe.results(self.folder / "out"))

    def test_failures_of_a_sweep(self):
        code, message = self.refusal("sweep", "missing.lua", "-o", str(self.folder / "out"))
        with self.assertRaises(strobe.StrobeError) as raised:
            strobe.sweep("missing.lua", self.folder / "out")
        self.assertEqual((raised.exception.exit_code, str(raised.exception)), (code, message))

    def test_results_of_the_repository(self):
        folder = HOME / "experiments/samples"
        table = table_in(folder)
        pd.testing.assert_frame_equal(strobe.results(folder)[list(table.columns)], table, check_exact=True,
                                      check_dtype=False)

    def test_declarations(self):
        frame = strobe.parameters("hybrid")
        self.assertEqual(frame.loc["samples", "default"], 16)
        self.assertEqual(frame.loc["tile", "unit"], "px")
        self.assertIn("sobel", frame.loc["edge", "choices"])
        self.assertEqual(strobe.passes().loc["edge/sobel", "kind"], "compute")

    def test_the_page(self):
        page = (HOME / "docs/python.md").read_text()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        os.symlink(HOME / "experiments", "experiments")
        pathlib.Path("my_sweep.lua").write_text(re.search("```lua\n(.*?)```", page, re.DOTALL).group(1))
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            for block in re.findall("```python\n(.*?)```", page, re.DOTALL):
                exec(block.replace("import matplotlib.pyplot", "import matplotlib; matplotlib.use('Agg')\n"
                                   "import matplotlib.pyplot"), names)
        self.assertIn("hybrid_layered", printed.getvalue())
        self.assertGreater(pathlib.Path("out/my_sweep/plot.png").stat().st_size, 1000)

    def test_size_and_version(self):
        sources = sorted((HOME / "python/strobe").glob("*.py"))
        self.assertLessEqual(sum(len(file.read_text().splitlines()) for file in sources), 400)
        version = subprocess.run([program.program(), "--version"], capture_output=True, text=True).stdout.split()[1]
        self.assertIn(f'version = "{version}"', (HOME / "python/pyproject.toml").read_text())


if __name__ == "__main__":
    unittest.main()
