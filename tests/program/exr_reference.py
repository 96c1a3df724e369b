#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Content of an OpenEXR file read by OpenImageIO and NumPy, as JSON for exr_test.cpp.

parts FILE    each part: name, size, channels with their type and the SHA-256 of their values (floats as 32 bits),
              attributes
mattes FILE   Cryptomatte decoded with an independent hash: for each kind, the largest difference between the matte of a
              name and the pixels with that id (pixels with one sample); checks that apply to any file
"""
import hashlib
import json
import struct
import sys

import numpy
import OpenImageIO


def parts_of(name):
    source = OpenImageIO.ImageInput.open(name)
    index, parts = 0, []
    while source.seek_subimage(index, 0):
        spec = source.spec()
        names = list(spec.channelnames)
        types = [str(t) for t in spec.channelformats] or [str(spec.format)] * len(names)
        channels = {}
        for c, channel in enumerate(names):
            wanted = OpenImageIO.UINT if types[c].startswith("uint") else OpenImageIO.FLOAT
            values = numpy.asarray(source.read_image(index, 0, c, c + 1, wanted)).reshape(spec.height, spec.width)
            channels[channel] = (types[c], numpy.ascontiguousarray(values))
        attributes = {a.name: a.value for a in spec.extra_attribs}
        parts.append({"name": attributes.get("oiio:subimagename", ""), "size": [spec.width, spec.height],
                      "full": [spec.full_width, spec.full_height], "channels": channels, "attributes": attributes})
        index += 1
    return parts


def plain(value):
    return value if isinstance(value, (str, int, float)) else [plain(v) for v in value]


def described(part):
    channels = {n: {"type": t, "sha256": hashlib.sha256(v.tobytes()).hexdigest()}
                for n, (t, v) in part["channels"].items()}
    attributes = {n: plain(v) for n, v in part["attributes"].items() if isinstance(v, (str, int, float, tuple))}
    return {"name": part["name"], "size": part["size"], "full": part["full"], "channels": channels,
            "attributes": attributes}


def murmur3(data):
    def rotl(x, r):
        return ((x << r) | (x >> (32 - r))) & 0xFFFFFFFF

    def mixed(k):
        return rotl((k * 0xCC9E2D51) & 0xFFFFFFFF, 15) * 0x1B873593 & 0xFFFFFFFF

    h = 0
    for i in range(0, len(data) - len(data) % 4, 4):
        h = (rotl(h ^ mixed(struct.unpack_from("<I", data, i)[0]), 13) * 5 + 0xE6546B64) & 0xFFFFFFFF
    h ^= mixed(int.from_bytes(data[len(data) - len(data) % 4:], "little"))
    h ^= len(data)
    for shift, factor in ((16, 0x85EBCA6B), (13, 0xC2B2AE35), (16, 1)):
        h = (h ^ (h >> shift)) * factor & 0xFFFFFFFF
    return h


def id_bits(name):
    h = murmur3(name.encode("utf-8"))
    exponent = min(max(h >> 23 & 255, 1), 254)
    return (h & 0x807FFFFF) | exponent << 23


def kinds_of(attributes):
    keys = {n.split("/")[1] for n in attributes if n.startswith("cryptomatte/")}
    return {attributes["cryptomatte/%s/name" % k]: {f: attributes["cryptomatte/%s/%s" % (k, f)]
                                                   for f in ("hash", "conversion", "manifest")} for k in keys}


def names_at(table, ids, geometries, kind):
    """The name of each pixel's first sample; None for the background."""
    names = {}
    for entry in table:
        for i in range(entry["first"], entry["last"] + 1):
            for g, material in enumerate(entry["materials"]):
                names[i, g + 1] = entry["node"] if kind == "CryptoObject" else material
    pairs = zip(ids.ravel().tolist(), geometries.ravel().tolist())
    return numpy.array([names.get(pair, "") for pair in pairs], dtype=object).reshape(ids.shape)


def mattes(name):
    parts = parts_of(name)
    channels = {n: v for part in parts for n, (t, v) in part["channels"].items()}
    attributes = parts[0]["attributes"]
    table = json.loads(attributes["strobeIds"])
    result = {}
    for kind, described_by in kinds_of(attributes).items():
        manifest = json.loads(described_by["manifest"])
        for entry, bits in manifest.items():
            assert bits == "%08x" % id_bits(entry), entry
        ranks = [(channels["%s%02d.%s" % (kind, i, a)].view(numpy.uint32), channels["%s%02d.%s" % (kind, i, b)])
                 for i in range(3) for a, b in ("RG", "BA")]
        shares = numpy.stack([share for _, share in ranks])
        seen = names_at(table, channels["id"], channels["geometry"], kind)
        matte_of = {n: sum(numpy.where(ids == id_bits(n), share, 0) for ids, share in ranks) for n in manifest}
        result[kind] = {
            "hash": described_by["hash"],
            "conversion": described_by["conversion"],
            "names": sorted(manifest),
            "sorted": bool((numpy.diff(shares, axis=0) <= 0).all()),
            "unnamed": int(sum(((ids != 0) & ~numpy.isin(ids, [id_bits(n) for n in manifest])).sum()
                               for ids, _ in ranks)),
            "sum": float(numpy.abs(sum(matte_of.values()) - channels["coverage.Y"]).max()),
            "difference": float(max(numpy.abs(matte_of[n] - (seen == n)).max() for n in manifest)),
            "missing": int(sum(((seen == n) & (matte_of[n] == 0)).sum() for n in manifest)),
            "partial": int(((shares[0] > 0) & (shares[0] < 1)).sum()),
        }
    return result


if __name__ == "__main__":
    what, file = sys.argv[1:]
    print(json.dumps([described(part) for part in parts_of(file)] if what == "parts" else mattes(file)))
