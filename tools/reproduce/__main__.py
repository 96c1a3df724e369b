# SPDX-License-Identifier: MIT
"""Makes the figures and the measured numbers of the pages again and compares them with the pages. A claim is a figure,
a result or a group of numbers, together with the command that makes it (claims.py).

    ./strobe reproduce --quick           claims that take under a minute each
    ./strobe reproduce                   all claims (hours on a software device)
    ./strobe reproduce --only ID         claims whose id begins with ID; may be repeated
    ./strobe reproduce --list            claims, commands, seconds; runs no claim
    ./strobe reproduce --marks           checks that every measured number of the pages has a mark; runs no claim
    ./strobe reproduce --stale           results and pictures with inputs (scripts, shaders, scenes) that changed later

Exit code 0: every verdict holds, nothing is stale; 1: a claim misses or a file is stale, each is named; 2: wrong
command line.
"""
import argparse
import difflib
import json
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import marks  # noqa: E402
from bench import Bench  # noqa: E402
from claims import CLAIMS  # noqa: E402
from definitions import FRAGMENTS, GENERATED, PAGES_OF_DEFINITIONS  # noqa: E402
from kinds import HOLDS, MISSES, NOT_REPEATED, NOT_RUN, REPORTED, checked  # noqa: E402
from stale import stale_files  # noqa: E402

HOME = Path(__file__).resolve().parent.parent.parent


def pages_of(root):
    """Pages with marked numbers, relative to `root`."""
    found = [root / "README.md", root / "ARTIFACT.md"] + sorted(root.glob("docs/*.md")) + [root / "experiments/README.md"]
    names = [str(path.relative_to(root)) for path in found if path.exists()]
    return [name for name in names if name not in GENERATED and name not in PAGES_OF_DEFINITIONS]


def read_pages(root):
    """Marks by id, and one line of text per breach of the rules."""
    by_id, wrong = {}, []
    for page in pages_of(root):
        text = (root / page).read_text()
        found, findings = marks.marks_of(page, text)
        fragments = [fragment for name, fragment, _ in FRAGMENTS if name == page]
        wrong += findings + marks.unmarked(page, text, found, fragments)
        for mark in found:
            if mark.id in by_id:
                wrong.append(f"{page}:{mark.line}: '{mark.id}' is marked twice; first in {by_id[mark.id].page}")
            by_id[mark.id] = mark
    return by_id, wrong


def figures_of(root):
    """Pictures of the pages and picture sheets of the experiments, relative to `root`; no figures of reports."""
    found = list(root.glob("docs/pictures/**/*.png")) + list(root.glob("docs/pictures/**/*.svg"))
    found += list(root.glob("docs/pictures/**/*.pdf")) + list(root.glob("experiments/*/*.png"))
    return {str(path.relative_to(root)) for path in found}


def breaches(root):
    """Breaches of the rules: numbers without marks, marks without claims, claims without marks or files."""
    by_id, wrong = read_pages(root)
    claims = {claim.id: claim for claim in CLAIMS}
    for mark in by_id.values():
        if mark.id not in claims or not claims[mark.id].marked:
            wrong.append(f"{mark.page}:{mark.line}: no claim of tools/reproduce/claims.py is called '{mark.id}'")
    for claim in CLAIMS:
        if claim.marked and claim.id not in by_id:
            wrong.append(f"tools/reproduce/claims.py: no page marks a number with '{claim.id}'")
    made = {getattr(claim, "file", "") for claim in CLAIMS}
    wrong += [f"{file}: no claim of tools/reproduce/claims.py makes it" for file in sorted(figures_of(root) - made)]
    for folder in sorted(root.glob("experiments/**/result.json")):
        name = str(folder.parent.relative_to(root / "experiments"))
        if not any(getattr(claim, "name", "") == name for claim in CLAIMS):
            wrong.append(f"experiments/{name}/result.json: no claim of tools/reproduce/claims.py makes it")
    wrong += [f"tools/reproduce/claims.py: there is no {getattr(claim, 'file', '')}" for claim in CLAIMS
              if getattr(claim, "file", "").endswith((".png", ".svg", ".md", ".pdf")) and not (root / claim.file).exists()]
    return by_id, wrong


def chosen(options):
    known = [claim.id for claim in CLAIMS]
    for name in options.only:
        if not any(id.startswith(name) for id in known):
            near = difflib.get_close_matches(name, known, 1)
            refuse(f"there is no claim '{name}'" + (f"; did you mean '{near[0]}'?" if near else "; --list has all"))
    picked = [c for c in CLAIMS if not options.only or any(c.id.startswith(name) for name in options.only)]
    return [claim for claim in picked if claim.is_quick or not options.quick], picked


def refuse(text):
    print("strobe reproduce: " + text, file=sys.stderr)
    sys.exit(2)


def print_table(rows, head):
    widths = [max(len(row[i]) for row in [head] + rows) for i in range(len(head))]
    for row in [head, ["-" * width for width in widths]] + rows:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


def short(text, width):
    return text if len(text) <= width else text[:width - 3] + "..."


def as_data(claim, outcome):
    return {"claim": claim.id, "command": outcome.command or claim.command, "stated": outcome.stated, "now": outcome.now,
            "tolerance": outcome.tolerance, "verdict": outcome.verdict, "why": outcome.why}


def rows_of(results):
    return [[claim.id, short(o.command or claim.command, 60), short(o.stated, 40), short(o.now, 64), o.tolerance, o.verdict]
            for claim, o in results]


def report(results, left_out, bench):
    """Prints the claims with a verdict, the claims without one, the reasons of misses, and the counts."""
    by = {verdict: [one for one in results if one[1].verdict == verdict]
          for verdict in (HOLDS, MISSES, REPORTED, NOT_REPEATED, NOT_RUN)}
    judged = [one for one in results if one[1].verdict in (HOLDS, MISSES)]
    if judged:
        print_table(rows_of(judged), ["claim", "command", "stated", "now", "tolerance", "verdict"])
    for verdict, text in ((REPORTED, "Times of a machine: no verdict"), (NOT_REPEATED, "Not made again"),
                          (NOT_RUN, "Not run, because something is missing")):
        if by[verdict]:
            print(f"\n{text}:")
            print_table([[c.id, short(o.stated, 60), short(o.now, 60), o.why] for c, o in by[verdict]],
                        ["claim", "stated", "now", "why"])
    print()
    for claim, outcome in judged:
        if outcome.why:
            print(f"{claim.id} {outcome.verdict}: {outcome.why}")
    print(f"{len(results)} claims in {bench.spent_s:.0f} s: " + ", ".join(f"{len(by[v])} {v}" for v in by if by[v]))
    if left_out:
        print(f"{len(left_out)} claims take longer than a minute; without --quick they run too")
    print("not every verdict holds" if by[MISSES] else f'every verdict "{HOLDS}"')


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="strobe reproduce", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="claims under a minute; some points of experiments")
    parser.add_argument("--only", metavar="ID", action="append", default=[], help="claims whose id begins with ID")
    parser.add_argument("--list", action="store_true", help="print the claims and run nothing")
    parser.add_argument("--marks", action="store_true", help="check the marks of the pages and run nothing")
    parser.add_argument("--stale", action="store_true", help="print results and pictures with changed inputs")
    parser.add_argument("--replace", action="store_true", help="replace committed pictures and numbers by the new ones")
    parser.add_argument("--json", action="store_true", help="print the table as JSON")
    parser.add_argument("--root", type=Path, default=HOME, help="folder with the pages (default: this repository)")
    parser.add_argument("--program", type=Path, default=HOME / "build" / "strobe", help="default: build/strobe")
    parser.add_argument("-o", "--out", type=Path, default=HOME / "out" / "reproduce", help="default: out/reproduce")
    return parser.parse_args(arguments)


def report_stale(root, as_json):
    found = stale_files(root, figures_of(root), read_pages(root)[0])
    if as_json:
        print(json.dumps([one.data() for one in found], indent=1, ensure_ascii=False))
    else:
        print("\n".join(one.text() for one in found) or "no input of a result or a picture changed")
    return 1 if found else 0


def main(arguments):
    options = parsed(arguments)
    if not (options.root / "README.md").exists():
        refuse(f"there is no {options.root / 'README.md'}")
    options.root = options.root.resolve()
    if options.marks:
        wrong = breaches(options.root)[1]
        print("\n".join(wrong) if wrong else "every measured number has a mark, every mark a claim")
        return 1 if wrong else 0
    if options.stale:
        return report_stale(options.root, options.json)
    claims, picked = chosen(options)
    if options.list:
        print_table([[c.id, c.command, f"{c.seconds:g}", c.because] for c in claims],
                    ["claim", "command", "seconds", "because"])
        return 0
    if not claims:
        refuse(f"{picked[0].id} takes longer than a minute: run it without --quick")
    by_id, wrong = breaches(options.root)
    lost = [line for line in wrong if "no page marks" in line]
    say = lambda line: print(f"strobe reproduce: {line}", file=sys.stderr, flush=True)  # noqa: E731
    bench = Bench(options.root, options.program.resolve(), options.out.resolve(), options.quick, say)
    results = []
    for claim in claims:
        if claim.marked and claim.id not in by_id:
            refuse("\n".join(lost) or f"no page marks a number with '{claim.id}'")
        results.append((claim, checked(claim, bench, by_id[claim.id].numbers if claim.marked else [])))
        if options.replace and getattr(claim, "made", None):
            claim.replace(bench, by_id.get(claim.id))
    if options.json:
        print(json.dumps([as_data(*result) for result in results], indent=1, ensure_ascii=False))
    else:
        report(results, [c for c in picked if c not in claims], bench)
    return 1 if any(outcome.verdict == MISSES for _, outcome in results) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
