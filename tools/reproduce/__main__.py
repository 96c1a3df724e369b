# SPDX-License-Identifier: MIT
"""Makes the figures and the measured numbers of the pages again and compares them with the pages. A claim is a figure,
a result or a group of numbers, together with the command that makes it (claims.py).

    ./strobe reproduce --smoke           some claims of each kind, at most ten minutes on two cores
    ./strobe reproduce                   all claims (hours on a software device)
    ./strobe reproduce --only ID         claims whose id begins with ID; may be repeated
    ./strobe reproduce --list            claims, commands, seconds; runs no claim
    ./strobe reproduce --marks           checks that every measured number of the pages has a mark; runs no claim
    ./strobe reproduce --table           writes the tables of claims into ARTIFACT.md; runs no claim
    ./strobe reproduce --stale           results and pictures with inputs (scripts, shaders, scenes) that changed later

Exit code 0: every verdict holds, nothing is stale; 1: a claim misses or a file is stale, each is named; 2: wrong
command line.
"""
import argparse
import difflib
import json
import sys
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import marks  # noqa: E402
import table  # noqa: E402
from bench import Bench  # noqa: E402
from claims import CLAIMS, is_in_smoke  # noqa: E402
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
        text = table.without_tables((root / page).read_text())
        found, findings = marks.marks_of(page, text)
        fragments = [fragment for name, fragment, _ in FRAGMENTS if name == page]
        wrong += findings + marks.unmarked(page, text, found, fragments)
        for mark in found:
            if mark.id in by_id:
                wrong.append(f"{page}:{mark.line}: '{mark.id}' is marked twice; first in {by_id[mark.id].page}")
            by_id[mark.id] = mark
    return by_id, wrong


def pages_by_id(by_id):
    return {id: mark.page for id, mark in by_id.items()}


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
    if len(claims) < len(CLAIMS):
        wrong.append("tools/reproduce/claims.py: two claims have the same id")
    return by_id, wrong + table.breaches(root, pages_by_id(by_id))


def chosen(options):
    known = [claim.id for claim in CLAIMS]
    for name in options.only:
        if not any(id.startswith(name) for id in known):
            near = difflib.get_close_matches(name, known, 1)
            refuse(f"there is no claim '{name}'" + (f"; did you mean '{near[0]}'?" if near else "; --list has all"))
    if options.only:
        return [claim for claim in CLAIMS if claim.id.startswith(tuple(options.only))]
    return [claim for claim in CLAIMS if is_in_smoke(claim) or not options.smoke]


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
    return {"claim": claim.id, "command": outcome.command, "stated": outcome.stated, "now": outcome.now,
            "tolerance": outcome.tolerance, "verdict": outcome.verdict, "why": outcome.why}


def rows_of(results):
    return [[claim.id, short(o.command, 60), short(o.stated, 40), short(o.now, 64), o.tolerance, o.verdict]
            for claim, o in results]


def counts(claims):
    """Number of claims, and the number of each kind, as text."""
    kinds = Counter(claim.kind for claim in claims)
    return f"{len(claims)} claims: " + ", ".join(f"{kind} {kinds[kind]}" for kind in kinds)


def print_list(claims, smoke):
    """Prints the claims, their counts, and the time of all commands; equal commands run once."""
    forms = [(claim, *((claim.smoke_command, claim.seconds) if smoke else (claim.command, claim.whole_seconds)))
             for claim in claims]
    print_table([[claim.id, command, f"{seconds:g}", claim.because] for claim, command, seconds in forms],
                ["claim", "command", "seconds", "because"])
    longest = {command: max(s for _, other, s in forms if other == command) for _, command, _ in forms}
    print(f"\n{counts(claims)}; about {sum(longest.values()) / 60:.1f} minutes")


def report(results, bench):
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
    if bench.smoke:
        touched = [claim for claim, _ in results]
        print(f"touched {counts(touched)}")
        print(f"not touched {counts([claim for claim in CLAIMS if claim not in touched])}")
    print("not every verdict holds" if by[MISSES] else f'every verdict "{HOLDS}"')


def parsed(arguments):
    parser = argparse.ArgumentParser(prog="strobe reproduce", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--smoke", action="store_true", help="some claims of each kind; with --only, these claims in their "
                        "short form: a few points of an experiment, a section of a page")
    parser.add_argument("--only", metavar="ID", action="append", default=[], help="claims whose id begins with ID")
    parser.add_argument("--list", action="store_true", help="print the claims and run nothing")
    parser.add_argument("--marks", action="store_true", help="check the marks of the pages and run nothing")
    parser.add_argument("--table", action="store_true", help="write the tables of claims into ARTIFACT.md and run nothing")
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
    if options.table:
        table.write(options.root, pages_by_id(read_pages(options.root)[0]))
        return 0
    claims = chosen(options)
    if options.list:
        print_list(claims, options.smoke)
        return 0
    by_id, wrong = breaches(options.root)
    lost = [line for line in wrong if "no page marks" in line]
    say = lambda line: print(f"strobe reproduce: {line}", file=sys.stderr, flush=True)  # noqa: E731
    bench = Bench(options.root, options.program.resolve(), options.out.resolve(), options.smoke, say)
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
        report(results, bench)
    return 1 if any(outcome.verdict == MISSES for _, outcome in results) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
