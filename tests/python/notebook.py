#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Executes a notebook and compares the text that its cells print with the text that it stores.

notebook.py [--write] FILE    --write: stores the new outputs instead
"""
import os
import pathlib
import sys

import nbformat
from nbconvert.preprocessors import ExecutePreprocessor

os.environ.setdefault("PYDEVD_DISABLE_FILE_VALIDATION", "1")  # without the debugger's messages
MOST_BYTES = 300_000


def executed(file):
    """The notebook with new outputs, without messages on standard error and times."""
    notebook = nbformat.read(file, as_version=4)
    ExecutePreprocessor(timeout=300, kernel_name="python3").preprocess(notebook, {"metadata": {"path": file.parent}})
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = [one for one in cell.outputs if one.get("name") != "stderr"]
    notebook.metadata = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"}}
    return notebook


def text_of(cell):
    """Text of the outputs. A picture counts as a word."""
    datas = [output.get("data", {"text/plain": output.get("text", "")}) for output in cell.get("outputs", [])]
    return "".join("picture" if "image/png" in data else data["text/plain"] for data in datas)


def main():
    file = pathlib.Path(sys.argv[-1]).resolve()
    new, stored = executed(file), nbformat.read(file, as_version=4)
    if "--write" in sys.argv:
        nbformat.write(new, file)
        stored = new
    problems = [f"cell {i + 1} prints\n{text_of(a)}\nand stores\n{text_of(b)}"
                for i, (a, b) in enumerate(zip(new.cells, stored.cells)) if text_of(a) != text_of(b)]
    if file.stat().st_size > MOST_BYTES:
        problems.append(f"{file.name} has more than {MOST_BYTES} bytes")
    sys.exit("\n\n".join(problems) or 0)


if __name__ == "__main__":
    main()
