# SPDX-License-Identifier: MIT
"""Committed results and pictures with inputs that changed later, and the pages that publish the results and
pictures."""
import json
import os
import re
from dataclasses import asdict, dataclass

import inputs
from claims import CLAIMS

LINK = re.compile(r"\]\(([^)#\s]+)|\bsrc=\"([^\"]+)\"")


@dataclass
class Stale:
    name: str      # path of a result.json or a picture
    changed: list  # names of the inputs that changed
    pages: list    # pages that state numbers of the result or show the picture
    reason: str = ""  # only for a file without recorded inputs

    def text(self):
        pages = f" [{', '.join(self.pages)}]" if self.pages else ""
        files = ", ".join(name.removeprefix(inputs.SHIPPED) for name in self.changed)
        return f"{self.name}{pages}: {self.reason or files}"

    def data(self):
        return asdict(self)


def folder_of(name):
    return name.rpartition("/")[0]


def shown_files(root):
    """Pages by linked or shown file; all paths relative to `root`."""
    pages = [root / "README.md", root / "ARTIFACT.md", root / "experiments/README.md", *sorted(root.glob("docs/**/*.md"))]
    shown = {}
    for page in filter(lambda page: page.exists(), pages):
        name = str(page.relative_to(root))
        for target in {a or b for a, b in LINK.findall(page.read_text())}:
            shown.setdefault(os.path.normpath(os.path.join(folder_of(name), target)), set()).add(name)
    return shown


def pages_by_file(root, marks):
    """Pages by file. File: a picture that the page shows, or a result with numbers or figures in the page."""
    pages = shown_files(root)
    for file, by in list(pages.items()):
        if file.endswith((".png", ".svg")):
            pages.setdefault(folder_of(file) + "/result.json", set()).update(by)
    for claim in CLAIMS:
        for experiment in getattr(claim, "sources", ()) if claim.id in marks else ():
            pages.setdefault(f"experiments/{experiment}/result.json", set()).add(marks[claim.id].page)
    return pages


def stale_files(root, pictures, marks):
    """Stale results and stale files of `pictures`, sorted by name."""
    recorded = inputs.of_pictures(root / inputs.PICTURES)
    made_from = {name: recorded.get(name) for name in pictures}
    for file in root.glob("experiments/**/result.json"):
        made_from[str(file.relative_to(root))] = json.loads(file.read_text()).get("inputs")
    pages, found = pages_by_file(root, marks), []
    for name, files in sorted(made_from.items()):
        changed = inputs.changed(root, files or {}, (root / name).parent, name.startswith("experiments/"))
        if files is None or changed:
            found.append(Stale(name, changed, sorted(pages.get(name, ())), inputs.NOT_RECORDED if files is None else ""))
    return found
