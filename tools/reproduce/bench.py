# SPDX-License-Identifier: MIT
"""Data of claims: the output of commands, which run once, and results of experiments."""
import json
import os
import shlex
import subprocess
import time
from pathlib import Path

TIMES = {"ms", "ms_least", "ms_low", "ms_high", "ms_ratio", "ms_own", "own_ratio"}


class Missing(Exception):
    """A claim needs something that is missing here. The text names it."""


class Failed(Exception):
    """A command or a check failed. The text has the reason, for a command its last line of output."""


class Results:
    """A result.json of an experiment."""

    def __init__(self, file, fresh):
        self.file, self.fresh = Path(file), fresh  # fresh: made in this run, on this device
        self.data = json.loads(self.file.read_text())

    def points(self, **at):
        """Yields (names, data) of each point that matches `at`. The names are arm, shot, anchor, role and the axes."""
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
    """Runs commands of `program`. `root` has the pages and committed results; new files are written below `out`."""

    def __init__(self, root, program, out, smoke, say):
        self.root, self.program, self.out, self.smoke, self.say = Path(root), Path(program), Path(out), smoke, say
        self.done = {}   # command line: CompletedProcess
        self.fresh = {}  # experiment: folder of a complete run
        self.spent_s = 0.0
        self.last = None  # CompletedProcess of the last command

    def run(self, *words, cwd=None, codes=(0,), environment=None):
        """Output of a command. Equal commands run only once, even for several claims."""
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
                raise Missing(f"{words[0]} is missing") from error
            self.spent_s += time.monotonic() - begin
            self.done[line] = end
        end = self.last = self.done[line]
        if end.returncode not in codes:
            if end.returncode == 127:  # exit code of a shell if a program is missing
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
        """Results of a complete run in this invocation, otherwise the committed results."""
        if experiment in self.fresh:
            return Results(self.fresh[experiment] / "result.json", fresh=True)
        return self.committed(experiment)

    def swept(self, file, name, only=""):
        """Runs an experiment, or the points that `only` selects. Continues an earlier run in the same folder."""
        folder = self.out / (name + ("_smoke" if only else ""))
        home = (self.root / file).parent
        cwd = home if (home / "strobe.project.lua").exists() else None  # run in the project
        words = ["strobe", "sweep", Path(file).name if cwd else file, "-o", folder] + (["--only", only] if only else [])
        self.run(*words, cwd=cwd, codes=(0, 1))  # 1: an expectation does not hold, perhaps a known failure
        if not (folder / "result.json").exists():
            self.run(*words, cwd=cwd)  # raises Failed with the reason
        if not only:
            self.fresh[name] = folder
        return Results(folder / "result.json", fresh=True)

    def need(self, *files, why):
        for file in files:
            if not Path(file).exists():
                raise Missing(why)

    def shared_scenes(self):
        """Folder of the shared scenes; raises Missing without it."""
        folder = Path(os.environ.get("STROBE_DATA", self.root.parent / "shared")) / "scenes"
        self.need(folder, why="the shared scenes (STROBE_DATA) are missing")
        return folder
