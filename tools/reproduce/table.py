# SPDX-License-Identifier: MIT
"""Tables of claims in ARTIFACT.md. `--table` writes them, `--marks` compares them with the claims."""
import os
import re

from claims import CLAIMS, is_in_smoke

PAGE = "ARTIFACT.md"
BEGIN, END = "<!-- claims: written by ./strobe reproduce --table -->\n", "<!-- end of claims -->\n"
BLOCK = re.compile(re.escape(BEGIN) + ".*?" + re.escape(END), re.DOTALL)
HEAD = "| claim | command | expected | tolerance | minutes |\n|---|---|---|---|---:|\n"


def names(ids):
    """The ids, or for three or more their common prefix, if it selects no other claim (--only PREFIX)."""
    prefix = os.path.commonprefix(ids)
    alone = len(ids) > 2 and {claim.id for claim in CLAIMS if claim.id.startswith(prefix)} == set(ids)
    return f"`{prefix}`... ({len(ids)})" if prefix and alone else ", ".join(f"`{id}`" for id in ids)


def minutes(seconds):
    return f"{max(seconds / 60, 0.1):.{0 if seconds >= 600 else 1}f}"


def rows(claims, smoke, pages):
    """One row for the claims that share a command, a tolerance and a kind."""
    groups = {}
    for claim in claims:
        command = claim.smoke_command if smoke else claim.command
        groups.setdefault((command, claim.limits(), claim.kind), []).append(claim)
    for (command, limits, _), group in groups.items():
        expected = dict.fromkeys(claim.expected(pages.get(claim.id, "")) for claim in group)
        if len(expected) > 3:
            folder = os.path.commonpath([claim.file for claim in group])
            expected = [f"pictures in `{folder}`"]
        yield (f"| {names([claim.id for claim in group])} | `{command}` | {', '.join(expected)} | {limits} | "
               f"{minutes(max(claim.seconds if smoke else claim.whole_seconds for claim in group))} |\n")


def tables(pages):
    """The block of ARTIFACT.md. `pages`: the page of each marked claim."""
    repeated = [claim for claim in CLAIMS if claim.kind != "not repeated"]
    smoke = rows(filter(is_in_smoke, CLAIMS), True, pages)
    other = rows([claim for claim in repeated if not is_in_smoke(claim) or claim.whole_seconds > claim.seconds], False, pages)
    return (f"{BEGIN}\nClaims of `--smoke`:\n\n{HEAD}{''.join(smoke)}\n"
            f"Claims and whole experiments of the full run only:\n\n{HEAD}{''.join(other)}\n{END}")


def without_tables(text):
    """The text with the block overwritten by spaces: its numbers need no marks."""
    return BLOCK.sub(lambda match: re.sub(r"[^\n]", " ", match.group(0)), text)


def write(root, pages):
    page = root / PAGE
    page.write_text(BLOCK.sub(lambda _: tables(pages), page.read_text()))


def breaches(root, pages):
    if tables(pages) in (root / PAGE).read_text():
        return []
    return [f"{PAGE}: the tables of claims differ from tools/reproduce/claims.py; ./strobe reproduce --table writes them"]
