#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Inputs of results and pictures: scripts, shaders and scenes, each with a hash of its content.

The program writes the inputs of an experiment to the field `inputs` of its results. The inputs of committed pictures
are in docs/pictures/inputs.json, by picture. Names of inputs begin with "strobe:" (this repository), "shared:" (the
shared data) or "project:" (the folder of the result, if the folder is a project).

    tools/reproduce/inputs.py FILE PICTURE SOURCE...

writes the inputs of a picture into FILE. A source is a run record, the manifest of a capture, the result of an
experiment, any other file, or a folder of files.
"""
import hashlib
import json
import os
import re
import sys
from pathlib import Path

HOME = Path(__file__).resolve().parent.parent.parent
PICTURES = "docs/pictures/inputs.json"
NOT_RECORDED = "inputs are not recorded"
SHIPPED, SHARED, PROJECT = "strobe:", "shared:", "project:"
GLSL = re.compile(rb"(?P<kept>)(?://[^\n]*|/\*.*?\*/)", re.DOTALL)
STRING = rb"""(?:"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|\[(?P<%s>=*)\[.*?\](?P=%s)\])"""
JOINED = STRING + rb"(?:\s*\.\.\s*" + STRING + rb")*"  # strings joined by ".."
HELP = rb"\b(?:doc|fails)\s*=\s*" + JOINED % (b"a", b"a", b"b", b"b")
LUA = re.compile(HELP + rb"|(?P<kept>" + JOINED % (b"c", b"c", b"d", b"d") + rb")|--(?:\[(?P<e>=*)\[.*?\](?P=e)\]|[^\n]*)",
                 re.DOTALL)
ONE_STRING = re.compile(STRING % (b"a", b"a"), re.DOTALL)
COMMENTS = {".glsl": GLSL, ".h": GLSL, ".lua": LUA}


def code_of(match):
    """A blank for a comment or a text for people; otherwise the matched code."""
    code = match["kept"] or b" "
    texts = (one.group() for one in ONE_STRING.finditer(code))
    return b" " if any(not text.startswith(b"[") and text.count(b" ") >= 2 for text in texts) else code


def hash_of(file):
    """SHA-256 of a file. In Lua and GLSL, comments and blanks without meaning do not count. In Lua, texts for people do not
    count: fields `doc` and `fails`, and strings joined by ".." if one of these has three words or more. inputHash of
    runtime/base/inputs.h returns the same hash."""
    data = Path(file).read_bytes()
    suffix = Path(file).suffix
    if suffix in COMMENTS:
        data = COMMENTS[suffix].sub(code_of, data)
    if suffix == ".lua":
        data = re.sub(rb"(?<!\w) | (?!\w)", b"", re.sub(rb"[ \t\r\n]+", b" ", data))
    elif suffix in COMMENTS:
        data = b"".join(line + b"\n" for line in (line.rstrip(b" \t\r") for line in data.split(b"\n")) if line)
    return hashlib.sha256(data).hexdigest()


def shared_folder(root):
    return Path(os.environ.get("STROBE_DATA", root.parent / "shared"))


def path_of(root, name, project=None):
    """Path of an input. `project`: the folder of the result or the picture."""
    if name.startswith(SHARED):
        return shared_folder(root) / name[len(SHARED):]
    if name.startswith(PROJECT):
        return (project or root) / name[len(PROJECT):]
    return root / name.removeprefix(SHIPPED)


def names_in(source):
    """Names of the inputs that a run record or the manifest of a capture lists."""
    if "inputs" in source:
        return [one["name"] for one in source["inputs"]]
    return [*source.get("scripts", {}), *source.get("shaders", {})]


def of_source(root, source):
    """Inputs of one source with their hashes; None if the source does not record inputs."""
    if source.is_dir():
        names = [str(file) for file in sorted(source.rglob("*")) if file.is_file()]
    elif source.suffix != ".json":
        names = [str(source)]
    else:
        data = json.loads(source.read_text())
        if "groups" in data:  # a result has the hashes of its inputs
            return data.get("inputs")
        names = names_in(data)
    named = {name if ":" in name else SHIPPED + os.path.relpath(name, root): path_of(root, name) for name in names}
    return {name: hash_of(file) for name, file in named.items() if file.is_file()}


# Modules that check experiments and judge expectations. No picture depends on them.
JUDGES = (SHIPPED + "scripts/strobe/experiment.lua", SHIPPED + "scripts/strobe/judge.lua")


def changed(root, inputs, project, of_experiment=False):
    """Names of inputs with changed content. Skips modules that judge experiments, and shared data if its folder is missing.
    `of_experiment`: inputs of a result, or of a sheet of its pictures. The file of the experiment does not count then: a test
    compares the points of the result with it."""
    experiment = project / f"{project.name}.lua"

    def is_changed(name, was):
        file = path_of(root, name, project)
        if name in JUDGES or (of_experiment and file == experiment):
            return False
        if name.startswith(SHARED) and not shared_folder(root).is_dir():
            return False
        return not file.is_file() or hash_of(file) != was
    return sorted(name for name, was in inputs.items() if is_changed(name, was))


def of_pictures(file):
    return json.loads(file.read_text()) if file.exists() else {}


def note(file, picture, inputs):
    """Writes the inputs of a picture into a file like docs/pictures/inputs.json."""
    known = {**of_pictures(file), picture: dict(sorted(inputs.items()))}
    file.write_text(json.dumps(dict(sorted(known.items())), indent=1) + "\n")


def main(file, picture, *sources):
    inputs = {}
    for source in sources:
        found = of_source(HOME, Path(source).resolve())
        if found is None:
            sys.exit(f"{source}: {NOT_RECORDED}")
        inputs.update(found)
    note(Path(file), picture, inputs)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
