#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Describes a capture for other programs as an RO-Crate, and packs it into one file.

    tools/crate.py DIR          # writes DIR/ro-crate-metadata.json
    tools/crate.py DIR --zip    # also writes DIR.zip, and prints its path

DIR is the folder of a capture (docs/captures.md). The description is an RO-Crate 1.1 with the profile Process Run Crate
0.5, and is derived from DIR/manifest.json. Equal captures give equal files. Exit code: 0 written; 1 refused, with the
reason; 2 usage error.
"""
import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import zipfile
from datetime import datetime, timedelta
from pathlib import Path, PurePosixPath
from urllib.parse import quote

HOME = Path(__file__).resolve().parent.parent
CRATE, MANIFEST, SUMS = "ro-crate-metadata.json", "manifest.json", "SHA256SUMS"
SPECIFICATION = "https://w3id.org/ro/crate/1.1"
PROFILE = "https://w3id.org/ro/wfrun/process/0.5"
SHA256_TERM = "https://w3id.org/ro/terms/workflow-run#sha256"  # the context of RO-Crate 1.1 has no term for SHA-256
MIT = "https://spdx.org/licenses/MIT"
FORMATS = {".png": "image/png", ".jpg": "image/jpeg", ".jpeg": "image/jpeg", ".exr": "image/x-exr",
           ".hdr": "image/vnd.radiance", ".pdf": "application/pdf", ".mp4": "video/mp4", ".mkv": "video/x-matroska",
           ".json": "application/json", ".gltf": "model/gltf+json", ".glb": "model/gltf-binary", ".lua": "text/x-lua",
           ".glsl": "text/plain", ".h": "text/plain", ".txt": "text/plain", ".ttf": "font/ttf"}


class Refusal(Exception):
    """A mistake of the user, or a damaged capture."""


def uri_of(path):
    """Path as a relative URI. Letters beyond ASCII stay (RO-Crate 1.1, "Encoding file paths")."""
    return "".join(c if ord(c) > 127 else quote(c, safe="-._~/!$&'()*+,;=@") for c in path)


def link(identity):
    return {"@id": identity}


def file_entity(name, sha256, size):
    kind = FORMATS.get(PurePosixPath(name).suffix.lower(), "application/octet-stream")
    return {"@id": uri_of(name), "@type": "File", "name": name, "encodingFormat": kind, "contentSize": str(size),
            "sha256": sha256}


def input_copy(name):
    """Place of an input in a bundle: "inputs/strobe/passes/x.lua" for "strobe:passes/x.lua"."""
    root, _, path = name.partition(":")
    return f"inputs/{root}/{path.lstrip('/')}"


def version_of(program):
    revision = f"+{program['revision']}" if "revision" in program else ""
    return program["version"] + revision + (".modified" if program.get("modified") else "")


def command_of(capture):
    width, height = capture["size"]
    options = f" --only {capture['only']}" if "only" in capture else ""
    options += " --bundle" if capture.get("bundle") else ""
    return f"strobe capture {capture['file']} --size {width}x{height}{options}"


def scene_entity(identity, shot, attribution):
    """Author and licence of a scene, from its file or from the text beside it."""
    extras = attribution.get("extras", {})
    extras = {key: value for key, value in extras.items() if isinstance(value, str)} if isinstance(extras, dict) else {}
    entity = {"@id": identity, "@type": "CreativeWork", "name": extras.get("title") or f"Scene of the shot '{shot}'"}
    texts = [attribution.get(key) for key in ("copyright", "text")]
    if description := "\n".join(text for text in texts if isinstance(text, str) and text):
        entity["description"] = description
    for field, key in (("author", "author"), ("license", "license"), ("url", "source")):
        if extras.get(key):
            entity[field] = extras[key]
    return entity


def crate_of(manifest, manifest_entity, listed, date):
    """The crate of a manifest. An input that is not listed in SHA256SUMS was not copied: it has no place, and must not have
    the type File."""
    capture, program, device = manifest["capture"], manifest["program"], manifest["device"]
    parts, used, made = [], [], []  # roles: files of the folder, inputs and results of the capture
    entities, scenes = [], {}
    based_on = {}  # identity of the scene, by file
    for picture in manifest["pictures"]:
        attribution = picture["record"].get("scene", {}).get("attribution")
        if attribution:
            key = json.dumps(attribution, sort_keys=True)
            scenes.setdefault(key, scene_entity(f"#scene-{len(scenes) + 1}", picture["shot"], attribution))
            based_on.update((file, scenes[key]["@id"]) for file in picture["images"].values())

    def add(entity, *roles):
        entities.append(entity)
        for role in roles:
            role.append(link(entity["@id"]))

    add({**manifest_entity, "description": "All inputs of the pictures, and the hash of the output of every pass"}, parts, made)
    for name, entry in manifest["files"].items():
        entity = file_entity(name, entry["sha256"], entry["bytes"])
        add({**entity, "isBasedOn": link(based_on[name])} if name in based_on else entity, parts, made)
    for entry in manifest["inputs"]:
        copy = input_copy(entry["name"])
        entity = {**file_entity(copy, entry["sha256"], entry["bytes"]), "name": entry["name"]}
        if entry["name"] == capture["file"]:
            entity["description"] = "The script of the capture"
        if copy in listed:
            add(entity, parts, used)
        else:
            add({**entity, "@id": "#" + entity["@id"], "@type": "CreativeWork",
                 "description": "Input that is not in this folder; a capture with --bundle includes it"}, used)
    add({"@id": SUMS, "@type": "File", "name": SUMS,
         "description": "SHA-256 of the files of this folder, for sha256sum -c", "encodingFormat": "text/plain"}, parts)

    note = capture.get("note", "")
    graph = [
        {"@id": CRATE, "@type": "CreativeWork", "conformsTo": link(SPECIFICATION), "about": link("./")},
        {"@id": "./", "@type": "Dataset", "name": capture["title"],
         "description": (note + " " if note else "") + "A capture of Strobe: pictures, and figures made from the pictures. "
                        "With manifest.json, the capture can be taken again and compared bit for bit.",
         "datePublished": date, "license": link("#licences"), "conformsTo": link(PROFILE), "hasPart": parts,
         "mentions": link("#capture")},
        {"@id": PROFILE, "@type": "CreativeWork", "name": "Process Run Crate", "version": "0.5"},
        {"@id": "#capture", "@type": "CreateAction", "name": "Taking the capture: " + capture["title"],
         "description": f"{command_of(capture)}\nDrawn by {device['name']}, {device['driver']}", "instrument": link("#strobe"),
         "object": used, "result": made},
        {"@id": "#strobe", "@type": "SoftwareApplication", "name": "Strobe",
         "description": "Research sandbox for motion blur", "softwareVersion": version_of(program), "license": link(MIT)},
        {"@id": MIT, "@type": "CreativeWork", "name": "MIT License",
         "description": "A permissive licence: copies keep the copyright and the licence's text"},
        {"@id": "#licences", "@type": "CreativeWork", "name": "Licences of the parts",
         "description": "Files of Strobe are under the MIT licence. Scripts, scenes and textures of other authors keep their "
                        "own licences. Pictures link to the author and licence of their scene (isBasedOn). A capture grants "
                        "no licence for its pictures."}]
    return {"@context": [SPECIFICATION + "/context", {"sha256": SHA256_TERM}],
            "@graph": graph + entities + list(scenes.values())}


def date_of(program):
    """Date of publication, which a crate must state, UTC. Two runs state the same date. Source: the environment variable
    SOURCE_DATE_EPOCH (seconds since 1970), else the program's revision in git, else 1970-01-01."""
    start = datetime(1970, 1, 1)
    text = os.environ.get("SOURCE_DATE_EPOCH")
    if text is None:
        text = revision_seconds(program.get("revision")) or "0"
    elif not (text.isascii() and text.isdigit() and int(text) < (datetime.max - start).total_seconds()):
        raise Refusal(f"SOURCE_DATE_EPOCH is not a number of seconds since 1970: '{text}'")
    return (start + timedelta(seconds=int(text))).strftime("%Y-%m-%d")


def revision_seconds(revision):
    """Time of a revision of this repository, as text; nothing without git."""
    try:
        return subprocess.run(["git", "--no-optional-locks", "-C", HOME, "log", "-1", "--no-show-signature", "--format=%ct",
                               str(revision)], capture_output=True, text=True, timeout=20).stdout.strip()
    except (OSError, subprocess.TimeoutExpired):
        return ""


def listed_in(folder):
    """Names in lines of the form "SHA-256, two spaces, name"."""
    return {line[66:] for line in (folder / SUMS).read_text(encoding="utf-8").splitlines() if len(line) > 66}


def write_whole(path, write):
    """Calls `write` with a temporary path, which then replaces `path`. The file is complete, or unchanged."""
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.", suffix=".part")
    os.close(handle)
    try:
        os.chmod(temporary, 0o644)
        write(temporary)
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def write_zip(folder, names, path):
    """Names are sorted, times are 1980-01-01, permissions rw-r--r--."""
    with zipfile.ZipFile(path, "w") as packed:
        for name in sorted(names, key=lambda name: name.encode()):
            if not (folder / name).is_file():
                raise Refusal(f"{folder / name}: is listed, but is missing")
            entry = zipfile.ZipInfo(name)  # of 1980-01-01
            entry.create_system, entry.external_attr, entry.compress_type = 3, 0o100644 << 16, zipfile.ZIP_DEFLATED
            packed.writestr(entry, (folder / name).read_bytes())


def manifest_in(folder):
    data = (folder / MANIFEST).read_bytes()
    try:
        manifest = json.loads(data)
        if manifest["format"] == "strobe.manifest":
            return manifest, file_entity(MANIFEST, hashlib.sha256(data).hexdigest(), len(data))
    except (ValueError, KeyError, TypeError):
        pass
    raise Refusal(f"{folder / MANIFEST}: is not a manifest of a capture, or it is cut short")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], allow_abbrev=False)
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of a capture")
    parser.add_argument("--zip", action="store_true", help="also write DIR.zip")
    options = parser.parse_args()
    folder = Path(os.path.abspath(options.folder))
    try:
        manifest, manifest_entity = manifest_in(folder)
        listed = listed_in(folder)
        crate = crate_of(manifest, manifest_entity, listed, date_of(manifest["program"]))
        text = json.dumps(crate, indent=1, ensure_ascii=False) + "\n"
        write_whole(folder / CRATE, lambda path: Path(path).write_text(text, encoding="utf-8"))
        if options.zip:
            path = folder.with_name(folder.name + ".zip")
            write_whole(path, lambda file: write_zip(folder, listed | {SUMS, CRATE}, file))
            print(path)
    except (Refusal, OSError) as problem:
        sys.exit(f"crate: {problem}")
    except KeyError as problem:
        sys.exit(f"crate: {folder / MANIFEST}: has no {problem}")


if __name__ == "__main__":
    main()
