# SPDX-License-Identifier: MIT
"""Marks of measured numbers in the pages, and the rule that every measured number has a mark.

A mark is a pair of comments, which the rendered page does not show:

    A frame takes <!--= frame_ratio -->1.4 to 1.8<!--/--> times as long.

The numbers between the two comments are the numbers of the claim `frame_ratio` (claims.py), in reading order. Around a
table, each comment has a line of its own; numbers in the header and in the first cell of each row do not count. Numbers
in code (between backticks, fenced, indented) never count.

A number is measured if it is written in one of these forms: a decimal fraction, a power of ten, a number with a unit of
UNITS, "N of M", or the whole cell of a table. Each measured number must be in a mark, or in a text that definitions.py
lists with the reason why nothing was measured there. Whole numbers in sentences ("16 samples") are not checked.
"""
import re
from dataclasses import dataclass

UNITS = ("%", "s", "ms", "dB", "times", "seconds?", "minutes?", "hours?", "MiB", "MB", "GB", "rays", "bytes", "pixels",
         "frames per second")
# Versions and other names that contain a number.
NAMES = re.compile(r"\b(?:Vulkan|Ubuntu|Debian|glTF|RO-Crate|CC BY|Lua|Mesa|LLVM|McGuire|Guertin|Jimenez|OpenEXR|Python|"
                   r"SIGGRAPH) \d+(?:\.\d+)*(?: and \d+)?")
NUMBER = re.compile(r"(?<![\w.^])(?:(?<=[\s|(])[-−])?(?:\d[\d,]*\d|\d)?(?:(?<=\d)\.\d+|\.\d+)?(?:(?<=\d)e[-+]?\d+)?"
                    r"(?<=\d)(?![\w^]|\.\d)")
UNIT = re.compile(r"(?:\s|\n\s*)?(?:%|(?:" + "|".join(UNITS[1:]) + r")\b)")
OPEN, CLOSE = re.compile(r"<!--= ([a-z0-9_]+) -->"), re.compile(r"<!--/-->")


@dataclass
class Number:
    text: str
    at: int        # offset in the page
    measured: bool  # True if written like a measured number
    line: int = 0

    @property
    def value(self):
        return float(self.text.replace("−", "-").replace(",", ""))

    @property
    def half_a_unit(self):
        """Half a unit of the last written place; 0 for the text "0", which is exact."""
        if self.text == "0":
            return 0.0
        mantissa, _, power = self.text.partition("e")
        places = len(mantissa.partition(".")[2])
        return 0.5 * 10.0 ** (int(power or 0) - places)


    def rewritten(self, value):
        """Text of another value, with the same number of places and the same style."""
        mantissa, exponent, _ = self.text.partition("e")
        places = len(mantissa.partition(".")[2])
        if exponent:
            digits, _, power = f"{abs(value):.{places}e}".partition("e")
            text = f"{digits}e{int(power)}"
        else:
            text = f"{abs(value):,.{places}f}" if "," in mantissa else f"{abs(value):.{places}f}"
        if mantissa.lstrip("-−").startswith("."):
            text = text.removeprefix("0")
        minus = "−" if "−" in self.text else "-"
        return (minus if value < 0 and float(text.replace(",", "")) != 0 else "") + text


@dataclass
class Mark:
    page: str
    line: int
    id: str
    numbers: list  # of Number
    begin: int
    end: int


def spaces(match):
    return re.sub(r"[^\n]", " ", match.group(0))


def without_code(text):
    """The text with code, link targets and names overwritten; lines and offsets stay the same."""
    lines, fenced = [], False
    for line in text.split("\n"):
        fence = line.startswith("```")
        code = fence or fenced or line.startswith("    ")
        lines.append(" " * len(line) if code else line)
        fenced = fenced != fence
    text = re.sub(r"`[^`\n]*`", lambda m: "x" * len(m.group(0)), "\n".join(lines))
    text = re.sub(r"(?<=\])\([^)\s]*\)|\]\[[^\]]*\]|^\[[^\]]+\]:.*$", spaces, text, flags=re.MULTILINE)
    text = re.sub(r"\b10\.\d{4,}/\S+", spaces, text)
    return NAMES.sub(spaces, text)


def without_headers(text):
    """The text with the header row of each table, and the line below it, overwritten by spaces."""
    lines = text.split("\n")
    for i in range(1, len(lines)):
        if re.match(r"\|[-| :]+\|?$", lines[i]) and lines[i - 1].startswith("|"):
            lines[i - 1], lines[i] = " " * len(lines[i - 1]), " " * len(lines[i])
    return "\n".join(lines)


def without_first_cells(text):
    return re.sub(r"^\|[^|\n]*", spaces, text, flags=re.MULTILINE)


def is_measured(prose, match):
    text, after = match.group(0), prose[match.end():]
    if "." in text or "e" in text or UNIT.match(after):
        return True
    if re.match(r" of (?:the )?\d", after) or re.search(r"\d of (?:the )?$", prose[:match.start()]):
        return True
    line = prose[prose.rfind("\n", 0, match.start()) + 1:match.start()]
    return line.startswith("|") and bool(re.search(r"\| *\**$", line)) and bool(re.match(r"\** *(?:\||$)", after, re.M))


def numbers_in(prose, begin=0, end=None):
    end = len(prose) if end is None else end
    return [Number(m.group(0), m.start(), is_measured(prose, m), line_of(prose, m.start()))
            for m in NUMBER.finditer(prose, begin, end)]


def line_of(text, at):
    return text.count("\n", 0, at) + 1


def marks_of(page, text):
    """Marks of a page, and findings about wrong marks as "PAGE:LINE: FINDING"."""
    prose = without_headers(without_code(text))
    found, wrong, at = [], [], 0
    while opening := OPEN.search(prose, at):
        line = line_of(text, opening.start())
        closing = CLOSE.search(prose, opening.end())
        following = OPEN.search(prose, opening.end())
        if not closing or (following and following.start() < closing.start()):
            wrong.append(f"{page}:{line}: the mark '{opening.group(1)}' has no end <!--/-->")
            break
        starts_line = text[:opening.start()].endswith("\n") or opening.start() == 0
        if starts_line and text[opening.end():opening.end() + 1] != "\n":
            wrong.append(f"{page}:{line}: a line that begins with a mark does not start a paragraph: move the mark")
        span = " " * opening.end() + without_first_cells(prose)[opening.end():closing.start()]
        numbers = numbers_in(span, opening.end())
        for number in numbers:
            number.line = line_of(text, number.at)
        if not numbers:
            wrong.append(f"{page}:{line}: the mark '{opening.group(1)}' has no number")
        found.append(Mark(page, line, opening.group(1), numbers, opening.start(), closing.end()))
        at = closing.end()
    for stray in CLOSE.finditer(prose):
        if not any(mark.begin < stray.start() < mark.end for mark in found) and not wrong:
            wrong.append(f"{page}:{line_of(text, stray.start())}: <!--/--> ends no mark")
    return found, wrong


def fragment_pattern(text):
    return re.compile(r"\s+".join(re.escape(word) for word in text.split()))


def unmarked(page, text, marks, fragments):
    """Findings: measured numbers outside of marks and of `fragments`; then fragments that are not in the page."""
    plain = re.sub(r"<!--.*?-->", spaces, without_headers(without_code(text)), flags=re.DOTALL)
    free = [(mark.begin, mark.end) for mark in marks]
    lacking = []
    for fragment in fragments:
        places = [m.span() for m in fragment_pattern(fragment).finditer(text)]
        free += places
        if not places:
            lacking.append(f"{page}: definitions.py lists a text that is not there: {fragment}")
    findings = []
    for number in numbers_in(plain):
        if number.measured and not any(begin <= number.at < end for begin, end in free):
            around = " ".join(text[max(0, number.at - 30):number.at + 30].split())
            findings.append(f"{page}:{line_of(text, number.at)}: {number.text} has no mark (in \"{around}\"): mark it "
                            "with a claim of tools/reproduce/claims.py, or list the text in definitions.py")
    return findings + lacking


def replaced(page, text, id, values):
    """Text of the page with the numbers of the mark `id` replaced by `values`, in reading order."""
    mark = next(mark for mark in marks_of(page, text)[0] if mark.id == id)
    for number, value in reversed(list(zip(mark.numbers, values))):
        text = text[:number.at] + number.rewritten(value) + text[number.at + len(number.text):]
    return text
