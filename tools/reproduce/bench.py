# SPDX-License-Identifier: MIT
"""Where claims get their data: commands that run once, and results of experiments."""
import json
import os
import shlex
import subprocess
import time
from pathlib import Path

TIMES = {"ms", "ms_least", "ms_low", "ms_high", "ms_ratio", "ms_own", "own_ratio"}


class Missing(Exception):
    """What a claim needs is not here; the text says what."""


class Failed(Exception):
    """A command ended as it should not; the text says which, and what it wrote last."""


class Results:
    """A result.json of an experiment."""

    def __init__(self, file, fresh):
        self.file, self.fresh = Path(file), fresh  # fresh: made in this run, on this device
        self.data = json.loads(self.file.read_text())

    def points(self, **at):
        """Of every group and arm that match: names are arm, shot, role, or axes."""
        for group in self.data["groups"]:
            for point in group["points"]:
                known = {"shot": group["shot"], "anchor": group.get("anchor"), **group["at"],
                         "arm": point["arm"], "role": point["role"]}
                if all(known.get(name) == value for name, value in at.items()):
                    yield known, point

    def point(self, **at):
        found = [point for _, point in self.points(**at)]
        if len(found) != 1:
            raise Failed(f"{self.file}: {len(found)} points match {at}")
        return found[0]

    def value(self, measure, region="all", **at):
        return self.point(**at)["values"][measure][region]

    @property
    def device(self):
        return self.data["device"]


class Bench:
    """`root` has the pages and committed results, `program` runs; files go below `out`."""

    def __init__(self, root, program, out, quick, say):
        self.root, self.program, self.out, self.quick, self.say = Path(root), Path(program), Path(out), quick, say
        self.done = {}   # command line: CompletedProcess
        self.fresh = {}  # experiment: folder of a complete run
        self.spent_s = 0.0
        self.last = None  # what the last command gave

    def run(self, *words, cwd=None, codes=(0,), environment=None):
        """The output of a command, run once however many claims ask for it."""
        words = [str(self.program) if word == "strobe" else str(word) for word in words]
        line = shlex.join(words)
        if line not in self.done:
            self.say(line)
            self.out.mkdir(parents=True, exist_ok=True)
            begin = time.monotonic()
            try:
                end = subprocess.run(words, cwd=cwd or self.root, capture_output=True, text=True,
                                     env={**os.environ, **(environment or {}), "STROBE_PROGRAM": str(self.program)})
            except FileNotFoundError as error:
                raise Missing(f"{words[0]} is not here") from error
            self.spent_s += time.monotonic() - begin
            self.done[line] = end
        end = self.last = self.done[line]
        if end.returncode not in codes:
            if end.returncode == 127:  # of a shell: a program that is not there
                raise Missing((end.stderr.strip() or line).splitlines()[-1])
            last = (end.stderr.strip() or end.stdout.strip() or "no output").splitlines()[-1]
            raise Failed(f"exit code {end.returncode}: {last}")
        return end.stdout

    def folder(self, name):
        path = self.out / name
        path.mkdir(parents=True, exist_ok=True)
        return path

    def committed(self, experiment):
        return Results(self.root / "experiments" / experiment / "result.json", fresh=False)

    def results(self, experiment):
        """Of the complete run in this invocation, else the committed ones."""
        if experiment in self.fresh:
            return Results(self.fresh[experiment] / "result.json", fresh=True)
        return self.committed(experiment)

    def swept(self, file, name, only=""):
        """Runs an experiment, or some points of it; continues what an earlier run left in the folder."""
        folder = self.out / (name + ("_quick" if only else ""))
        home = (self.root / file).parent
        cwd = home if (home / "strobe.project.lua").exists() else None  # of a project
        words = ["strobe", "sweep", Path(file).name if cwd else file, "-o", folder] + (["--only", only] if only else [])
        self.run(*words, cwd=cwd, codes=(0, 1))  # 1: an expectation that does not hold, known ones too
        if not (folder / "result.json").exists():
            self.run(*words, cwd=cwd)  # says why
        if not only:
            self.fresh[name] = folder
        return Results(folder / "result.json", fresh=True)

    def need(self, *files, why):
        for file in files:
            if not Path(file).exists():
                raise Missing(why)

    def shared_scenes(self):
        """Their folder, which has to be here."""
        folder = Path(os.environ.get("STROBE_DATA", self.root.parent / "shared")) / "scenes"
        self.need(folder, why="the shared scenes (STROBE_DATA) are not here")
        return folder
