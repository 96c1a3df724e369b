# SPDX-License-Identifier: MIT
"""Index of the public types of runtime/: each type with the first sentence of its comment and its header.

    python3 tools/types                            prints the page
    python3 tools/types --write docs/types.md      writes the page
"""

import argparse
import re
import sys
from pathlib import Path

HOME = Path(__file__).resolve().parents[2]
HEAD = """# Types

<!-- Written by `python3 tools/types --write docs/types.md` from the headers of runtime/; edit those. -->

Types of the headers of `runtime/`, by room (folder). [Contributing](contributing.md) describes the rooms.
"""


def comment_before(lines, row):
    """Text of the comment that ends directly above a row."""
    first = row
    while first > 0 and lines[first - 1].startswith(("template", "//")):
        first -= 1
    return " ".join(line[2:].strip() for line in lines[first:row] if line.startswith("//"))


def first_sentence(text):
    """Text up to the first full stop that ends a sentence."""
    end = re.search(r"(?<!e\.g)(?<!i\.e)(?<!Eq)\.(?=\s+[A-Z`]|$)|:(?=\s*$)", text)
    return (text[: end.start()] if end else text).strip()


def types_of(header):
    """Types that a header defines, as pairs of name and sentence. Types within types are left out."""
    lines = header.read_text().split("\n")
    text = "\n".join(lines)
    for found in re.finditer(r"^(?:template\s*<.*>\s*)?(?:struct|class|enum class|enum)\s+([\w:]+)[^;()={]*\{", text, re.M):
        row = text.count("\n", 0, found.start())
        if "::" not in found.group(1):
            yield found.group(1), first_sentence(comment_before(lines, row))


def page():
    """The page, and faults of the headers: types without a comment, names that two headers define."""
    text, faults, headers = HEAD, [], {}
    for room in sorted(path for path in (HOME / "runtime").iterdir() if path.is_dir()):
        rows = []
        for header in sorted(room.glob("*.h")):
            for name, sentence in types_of(header):
                rows.append(f"| `{name}` | {sentence.replace('|', '&#124;')} | `{header.name}` |\n")
                place = header.relative_to(HOME)
                if not sentence:
                    faults.append(f"{place}: {name} has no comment")
                if headers.setdefault(name, place) != place:
                    faults.append(f"{place}: {name} is also the name of a type in {headers[name]}")
        if rows:
            text += f"\n## {room.name}\n\n| type | description | header |\n| --- | --- | --- |\n" + "".join(sorted(rows))
    return text, faults


def main():
    parser = argparse.ArgumentParser(prog="python3 tools/types", description=__doc__.split("\n")[0])
    parser.add_argument("--write", metavar="FILE", type=Path, help="writes the page to this file")
    options = parser.parse_args()
    text, faults = page()
    if options.write:
        options.write.write_text(text)
    else:
        sys.stdout.write(text)
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
