# SPDX-License-Identifier: MIT
"""Kinds of claims. Each kind checks a claim with the data of a Bench and returns an Outcome."""
import json
import re
from dataclasses import dataclass
from pathlib import Path

import inputs
import marks
from bench import TIMES, Failed, Missing
from pixels import differing_share, pixels_of

HOLDS, MISSES, REPORTED, NOT_REPEATED, NOT_RUN = "holds", "misses", "reported", "not repeated", "not run"


@dataclass
class Outcome:
    stated: str
    now: str
    tolerance: str
    verdict: str
    why: str = ""  # reason of a miss or of a missing verdict
    command: str = ""


def shown(value):
    return "-" if value is None else f"{value:.4g}"


@dataclass
class Claim:
    id: str
    command: str      # as a reader types it
    seconds: float    # approximate, of the smoke form if the claim has one; two cores, software device
    because: str = ""  # reason of the tolerance or of the missing verdict

    marked = False  # True if pages have marks with this id
    kind = "not repeated"

    @property
    def whole_seconds(self):
        """Approximate seconds without --smoke."""
        return self.seconds

    @property
    def smoke_command(self):
        """Command of the smoke form."""
        return self.command

    def expected(self, page):
        """Text of the expected result, for ARTIFACT.md. `page` has the marked numbers."""
        return f"`{self.file}`"

    def limits(self):
        return "none"

    def check(self, bench, numbers):
        raise NotImplementedError


@dataclass
class Numbers(Claim):
    """Numbers of a page. `read(bench)` returns the new values, in reading order. A value holds if it differs from the
    stated number by at most `places` units of the last stated place, plus the share `tolerance` if the data are new."""
    read: object = None
    tolerance: float = 0.0
    places: float = 0.5        # allowed difference, units of the last stated place
    asserted: bool = True      # False for times, because they depend on the machine
    sources: tuple = ()        # names of the experiments that `read` uses
    made: list = None          # the new values
    marked = True
    kind = "numbers"

    @property
    def smoke_command(self):
        results = ", ".join(f"experiments/{name}/result.json" for name in self.sources)
        return "committed: " + results if results else self.command

    def expected(self, page):
        return f"numbers of [{page}]({page})"

    def limits(self, share=None):
        share = self.tolerance if share is None else share
        return f"{self.places:g} of the last place" + (f", {100 * share:g} %" if share else "") if self.asserted else "none"

    def replace(self, bench, mark):
        """Replaces the stated numbers by the new values, if the counts are equal."""
        if len(self.made) == len(mark.numbers):
            page = bench.root / mark.page
            page.write_text(marks.replaced(mark.page, page.read_text(), self.id, self.made))

    def check(self, bench, numbers):
        now = self.made = list(self.read(bench))
        if len(now) != len(numbers):
            return Outcome(f"{len(numbers)} numbers", f"{len(now)} numbers", "", MISSES,
                           "the page and the claim have different counts of numbers")
        anew = not self.sources or any(name in bench.fresh for name in self.sources)
        share = self.tolerance if anew else 0.0
        worst, excess = 0, -1.0
        for i, (number, value) in enumerate(zip(numbers, now)):
            allowed = 2 * self.places * number.half_a_unit + share * abs(number.value)
            away = abs(value - number.value) / (allowed + 1e-12 + 1e-9 * abs(number.value))
            if not away <= excess:
                worst, excess = i, away
        count = f"{len(now)} numbers, " if len(now) > 1 else ""
        verdict = (HOLDS if excess <= 1 else MISSES) if self.asserted else REPORTED
        why = "" if verdict == HOLDS else self.because
        if verdict == MISSES:
            why = f"line {numbers[worst].line}: {numbers[worst].text} is {now[worst]:.9g} now"
        stated = count + numbers[worst].text
        if not self.asserted and len(now) < 9:
            stated, count = ", ".join(number.text for number in numbers), ""
        recent = ", ".join(map(shown, now)) if not self.asserted and len(now) < 9 else count + shown(now[worst])
        kept = "" if anew else self.smoke_command
        return Outcome(stated, recent, self.limits(share), verdict, why, kept)


@dataclass
class History(Claim):
    """Numbers that no command makes again, measured at `date` on `device` with `revision`."""
    command: str = "none"
    seconds: float = 0
    date: str = ""
    device: str = ""
    revision: str = ""
    marked = True

    def check(self, bench, numbers):
        stated = ", ".join(number.text for number in numbers[:6]) + (", ..." if len(numbers) > 6 else "")
        return Outcome(stated, f"{self.date}, {self.device}, {self.revision}", "none", NOT_REPEATED, self.because)


@dataclass
class Experiment(Claim):
    """Committed results of an experiment. Compares all values of all points except times, and all expectations. `few`
    selects points like --only of a sweep, for --smoke."""
    name: str = ""
    file: str = ""
    few: str = ""
    full_seconds: float = 0  # for all points
    tolerance: float = 0.0
    least: float = 1e-5  # lower limit of the divisor of relative differences
    shared: bool = False
    make: object = None  # returns Results instead of a sweep; only points of both results are compared
    kind = "experiments"

    @property
    def smoke_command(self):
        return self.command + (f" --only {self.few}" if self.few else "")

    @property
    def whole_seconds(self):
        return self.full_seconds or self.seconds

    def expected(self, page):
        return f"`experiments/{self.name}/result.json`"

    def limits(self):
        return f"{100 * self.tolerance:g} %"

    def check(self, bench, numbers):
        if self.shared:
            bench.shared_scenes()
        stated = bench.committed(self.name)
        now = self.make(bench) if self.make else bench.swept(self.file, self.name, self.few if bench.smoke else "")
        known = {key(at): point for at, point in stated.points()}
        compared = equal = values = 0
        worst, where = 0.0, ""
        for at, point in now.points():
            before = known.get(key(at))
            if before is None and self.make:
                continue
            if before is None:
                return Outcome(f"{len(known)} points", "another point", "", MISSES, f"{key(at)} is not in the results")
            compared += 1
            equal += point.get("image") == before.get("image")
            for measure, region, was, value in both(before, point):
                values += 1
                away = abs(value - was) / max(abs(was), self.least)
                if away > worst:
                    worst, where = away, f"{measure} ({region}) of {at['arm']}, {at['shot']}: {was:.6g}, now {value:.6g}"
        complete = not (bench.smoke and self.few or self.make)
        verdict = HOLDS if worst <= self.tolerance and compared == (len(known) if complete else compared) > 0 else MISSES
        why = where if worst > self.tolerance else "" if verdict == HOLDS else "points are missing"
        if verdict == HOLDS and complete:
            why = "; ".join(turned_expectations(stated, now))
        return Outcome(f"{len(known)} points", f"{compared} points, {equal} bit for bit, {values} values within "
                       f"{100 * worst:.2g} %", self.limits(), verdict, why)


def key(at):
    """Text that identifies a point by its names; 1 and 1.0 give equal texts."""
    plain = lambda value: float(value) if type(value) is int else value  # noqa: E731
    return json.dumps({name: plain(value) for name, value in at.items() if name != "role"}, sort_keys=True)


def both(before, point):
    """Yields measure, region and the values of both points, for all measures except times."""
    for measure, regions in before["values"].items():
        if measure in TIMES:
            continue
        for region, was in regions.items():
            value = point["values"].get(measure, {}).get(region)
            if was is not None and value is not None:
                yield measure, region, was, value


def turned_expectations(stated, now):
    """Texts of expectations with a changed outcome. If all values hold, only times can have changed an outcome, so the
    claim holds and reports the change."""
    outcomes = {one["text"]: one["outcome"] for one in now.data["expectations"]}
    return [f"'{one['text']}' {one['outcome']}, now {outcomes.get(one['text'], 'missing')}"
            for one in stated.data["expectations"] if outcomes.get(one["text"]) != one["outcome"]]


@dataclass
class Figure(Claim):
    """A file that a command makes again. `make(bench)` returns the path of the new file. `compare`: "bytes"; "titles", the
    titles of nodes and edges of an SVG file; "pixels", where at most the share `share` of the pixels may differ by more
    than `step` of 255 levels."""
    file: str = ""
    make: object = None
    compare: str = "bytes"
    share: float = 0.0
    step: int = 0
    region: tuple = None  # compared part: x, y, width, height; None: all
    block: int = 1        # side of the squares of pixels whose means are compared
    inputs: object = None  # for a committed picture: inputs(bench) returns the inputs of the new picture
    made: Path = None      # the new file
    kind = "figures"

    def limits(self):
        return f"{100 * self.share:g} % by more than {self.step}" if self.compare == "pixels" else f"equal {self.compare}"

    def replace(self, bench, _):
        """Replaces the committed picture and its inputs by the new picture and its inputs."""
        found = self.inputs(bench) if self.inputs else None
        if found is None:
            bench.say(f"{self.file} is not replaced: {inputs.NOT_RECORDED}")
            return
        (bench.root / self.file).write_bytes(self.made.read_bytes())
        inputs.note(bench.root / inputs.PICTURES, self.file, found)

    def check(self, bench, numbers):
        stated, made = bench.root / self.file, Path(self.make(bench))
        self.made = made
        if self.compare != "pixels":
            same = self.content(stated) == self.content(made)
            return Outcome(self.file, ("the same " if same else "other ") + self.compare, self.limits(),
                           HOLDS if same else MISSES, "" if same else f"{made} differs")
        differ, size = differing_share(*[pixels_of(file, self.region, self.block) for file in (stated, made)], self.step)
        verdict = HOLDS if differ <= self.share else MISSES
        return Outcome(self.file, f"{100 * differ:.3g} % of {size} pixels differ",
                       self.limits(), verdict,
                       "" if verdict == HOLDS else f"{made} differs: {self.because}")

    def content(self, file):
        if self.compare == "bytes":
            return file.read_bytes()
        return sorted(re.findall(r"<title>(.*?)</title>", file.read_text()))


@dataclass
class Page(Claim):
    """A page that the command `words` writes, with a file as its last argument. With --smoke, the command checks the
    pipeline `part` only, and its section of the page is compared."""
    file: str = ""
    words: tuple = ()
    part: str = ""
    full_seconds: float = 0  # for the whole page
    kind = "pages"

    @property
    def smoke_command(self):
        return self.command.replace(" --write", f" {self.part} --write") if self.part else self.command

    @property
    def whole_seconds(self):
        return self.full_seconds

    def expected(self, page):
        return f"[{self.file}]({self.file})"

    def limits(self):
        return "equal text"

    def check(self, bench, numbers):
        part = self.part if bench.smoke else ""
        made = bench.out / Path(self.file).name
        bench.run("strobe", *self.words, *([part] if part else []), "--write", made)
        stated, now = (self.content(file, part) for file in (bench.root / self.file, made))
        return Outcome(self.file + (f", section {part}" if part else ""), "the same text" if stated == now else "other text",
                       self.limits(), HOLDS if stated == now else MISSES, "" if stated == now else f"{made} differs")

    def content(self, file, part):
        """Text of the file, or of the section `part`."""
        text = file.read_text()
        sections = [one for one in text.split("\n## ") if one.split("\n")[0] == part]
        return sections[0].strip() if part and sections else text


@dataclass
class Unrepeated(Claim):
    """A file that is not made again; `because` has the reason."""
    file: str = ""
    seconds: float = 0
    command: str = "none"

    def check(self, bench, numbers):
        return Outcome(self.file, "-", "none", NOT_REPEATED, self.because)


def checked(claim, bench, numbers):
    outcome = outcome_of(claim, bench, numbers)
    outcome.command = outcome.command or (claim.smoke_command if bench.smoke else claim.command)
    return outcome


def outcome_of(claim, bench, numbers):
    try:
        return claim.check(bench, numbers)
    except Missing as missing:
        return Outcome("-", "-", "-", NOT_RUN, str(missing))
    except Failed as failed:
        return Outcome("-", "-", "-", MISSES, str(failed))
    except (KeyError, IndexError, ValueError) as error:
        return Outcome("-", "-", "-", MISSES, f"the output of the command cannot be read: {error!r}")
