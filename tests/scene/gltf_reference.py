# SPDX-License-Identifier: MIT
"""World matrices of every node of a glTF file, and positions of vertices with skins and morph targets, implemented from
the text of glTF 2.0: transforms of nodes (3.5.3), morph targets (3.7.2.2), skins (3.7.3), animations (3.11) and their
interpolation (appendix C). The standard library only.

    gltf_reference.py SHARE,SHARE,... FILES...

prints for each file {"rest": [a pose without animation], "clips": [the poses of each animation at each share of its
duration]}. A pose is {"t": seconds, "worlds": [a matrix of 16 by columns for each node], "bent": [{"node": its number,
"corners": [x, y, z of each corner of its triangles]} for each primitive of nodes with a skin or weights]}. A channel
has the value of its first or last key outside its keys."""
import base64
import json
import math
import os
import struct
import sys


def load(path):
    data = open(path, "rb").read()
    if data[:4] != b"glTF":
        return json.loads(data), None
    size = struct.unpack_from("<I", data, 12)[0]
    rest = 20 + size
    return json.loads(data[20:rest]), data[rest + 8:] if rest + 8 < len(data) else None


def buffer_of(gltf, index, path, chunk):
    uri = gltf["buffers"][index].get("uri")
    if uri is None:
        return chunk
    if uri.startswith("data:"):
        return base64.b64decode(uri.split(",", 1)[1])
    return open(os.path.join(os.path.dirname(path), uri), "rb").read()


FORMATS = {5120: ("b", 127), 5121: ("B", 255), 5122: ("h", 32767), 5123: ("H", 65535), 5125: ("I", 1), 5126: ("f", 1)}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


def elements(gltf, index, path, chunk):
    accessor = gltf["accessors"][index]
    letter, largest = FORMATS[accessor["componentType"]]
    width = WIDTHS[accessor["type"]]
    rows = [[0.0] * width for _ in range(accessor["count"])]
    if "bufferView" in accessor:
        rows = view_rows(gltf, accessor, accessor, letter, largest, width, path, chunk)
    if "sparse" in accessor:
        sparse = accessor["sparse"]
        at = {"count": sparse["count"], **sparse["indices"]}
        number, _ = FORMATS[at["componentType"]]
        places = view_rows(gltf, at, {"count": sparse["count"]}, number, 1, 1, path, chunk)
        values = view_rows(gltf, sparse["values"], {**accessor, "count": sparse["count"]}, letter, largest, width, path,
                           chunk)
        for (place,), value in zip(places, values):
            rows[place] = value
    return rows


def view_rows(gltf, where, accessor, letter, largest, width, path, chunk):
    view = gltf["bufferViews"][where["bufferView"]]
    data = buffer_of(gltf, view["buffer"], path, chunk)
    stride = view.get("byteStride", width * struct.calcsize(letter))
    start = view.get("byteOffset", 0) + where.get("byteOffset", 0)
    rows = []
    for i in range(accessor["count"]):
        row = struct.unpack_from("<%d%s" % (width, letter), data, start + i * stride)
        if accessor.get("normalized"):
            row = [max(value / largest, -1.0) for value in row]
        rows.append(list(row))
    return rows


def unit(q):
    length = math.sqrt(sum(c * c for c in q))
    return [c / length for c in q]


def sampled(times, values, how, t, rotation):
    """Appendix C: C.2 step, C.3 linear, C.4 spherical linear, C.5 cubic spline."""
    cubic = how == "CUBICSPLINE"
    if how == "STEP":  # files store times as floats: a time within their rounding of a key is the key
        t *= 1 + 2 ** -22

    def key(i):
        return values[3 * i + 1] if cubic else values[i]

    if t <= times[0] or len(times) == 1:
        result = key(0)
    elif t >= times[-1]:
        result = key(len(times) - 1)
    else:
        k = max(i for i in range(len(times) - 1) if times[i] <= t)
        td = times[k + 1] - times[k]
        s = (t - times[k]) / td
        a, b = key(k), key(k + 1)
        if how == "STEP":
            result = a
        elif cubic:
            out, into = values[3 * k + 2], values[3 * k + 3]
            result = [(2 * s ** 3 - 3 * s ** 2 + 1) * a[c] + td * (s ** 3 - 2 * s ** 2 + s) * out[c] +
                      (-2 * s ** 3 + 3 * s ** 2) * b[c] + td * (s ** 3 - s ** 2) * into[c] for c in range(len(a))]
        elif rotation:
            a, b = unit(a), unit(b)
            d = sum(x * y for x, y in zip(a, b))
            angle = math.acos(min(abs(d), 1.0))
            if angle < 1e-7:
                result = [(1 - s) * x + s * math.copysign(1, d) * y for x, y in zip(a, b)]
            else:
                result = [(math.sin(angle * (1 - s)) * x + math.copysign(1, d) * math.sin(angle * s) * y) / math.sin(angle)
                          for x, y in zip(a, b)]
        else:
            result = [x + s * (y - x) for x, y in zip(a, b)]
    return unit(result) if rotation else result


def times_matrix(a, b):
    return [sum(a[4 * k + r] * b[4 * c + k] for k in range(4)) for c in range(4) for r in range(4)]


def matrix_of(trs):
    (tx, ty, tz), (x, y, z, w), s = trs["translation"], trs["rotation"], trs["scale"]
    columns = [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
               [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
               [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]]
    result = []
    for column, size in zip(columns, s):
        result += [size * value for value in column] + [0.0]
    return result + [tx, ty, tz, 1.0]


def moved(matrix, p):
    return [sum(matrix[4 * c + r] * v for c, v in enumerate(p + [1.0])) for r in range(3)]


class Shapes:
    """Vertices of the nodes with a skin or weights, in the order of the file."""

    def __init__(self, gltf, path, chunk):
        self.gltf = gltf
        self.read = lambda index: elements(gltf, index, path, chunk)
        self.binds = [self.inverse_binds(skin) for skin in gltf.get("skins", [])]
        self.parts = []
        for number, node in enumerate(gltf["nodes"]):
            mesh = gltf["meshes"][node["mesh"]] if "mesh" in node else {"primitives": []}
            for primitive in mesh["primitives"]:
                if "skin" in node or "targets" in primitive:
                    self.parts.append((number, node, self.vertices(primitive, "skin" in node)))

    def inverse_binds(self, skin):
        if "inverseBindMatrices" not in skin:
            return [[1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0, 0, 0, 0, 0, 1.0]] * len(skin["joints"])
        return self.read(skin["inverseBindMatrices"])

    def vertices(self, primitive, skinned):
        attributes = primitive["attributes"]
        positions = self.read(attributes["POSITION"])
        corners = [row[0] for row in self.read(primitive["indices"])] if "indices" in primitive else range(len(positions))
        targets = [self.read(target["POSITION"]) for target in primitive.get("targets", [])]
        follows = [[] for _ in positions]
        for k in range(10):
            if skinned and "JOINTS_%d" % k in attributes:
                joints, weights = self.read(attributes["JOINTS_%d" % k]), self.read(attributes["WEIGHTS_%d" % k])
                for pairs, j, w in zip(follows, joints, weights):
                    pairs += [(joint, weight) for joint, weight in zip(j, w) if weight]
        return positions, targets, follows, list(corners)

    def bent(self, worlds, weights):
        result = []
        for number, node, (positions, targets, follows, corners) in self.parts:
            points = []
            for v in sorted(set(corners)):
                p = [float(c) for c in positions[v]]
                for target, weight in zip(targets, weights[number]):
                    p = [a + weight * b for a, b in zip(p, target[v])]
                if "skin" in node:
                    joints = self.gltf["skins"][node["skin"]]["joints"]
                    total = sum(weight for _, weight in follows[v])
                    matrices = [(weight / total, times_matrix(worlds[joints[j]], self.binds[node["skin"]][j]))
                                for j, weight in follows[v]]
                    p = [sum(weight * moved(matrix, p)[c] for weight, matrix in matrices) for c in range(3)]
                else:
                    p = moved(worlds[number], p)
                points.append((v, p))
            place = dict(points)
            result.append({"node": number, "corners": [c for v in corners for c in place[v]]})
        return result


def rest_weights(gltf):
    weights = []
    for node in gltf["nodes"]:
        mesh = gltf["meshes"][node["mesh"]] if "mesh" in node else {"primitives": [{}]}
        none = [0.0] * len(mesh["primitives"][0].get("targets", []))
        weights.append(list(node.get("weights", mesh.get("weights", none))))
    return weights


def poses(gltf, path, chunk, shapes, animation, shares):
    channels = []
    for channel in animation["channels"]:
        target = channel["target"]
        if "node" not in target:
            continue
        sampler = animation["samplers"][channel["sampler"]]
        keys = [row[0] for row in elements(gltf, sampler["input"], path, chunk)]
        values = elements(gltf, sampler["output"], path, chunk)
        how = sampler.get("interpolation", "LINEAR")
        if target["path"] == "weights":
            rows = len(keys) * (3 if how == "CUBICSPLINE" else 1)
            each = len(values) // rows
            values = [[row[0] for row in values[each * i:each * (i + 1)]] for i in range(rows)]
        channels.append((target["node"], target["path"], keys, values, how))
    duration = max([keys[-1] for _, _, keys, _, _ in channels], default=0.0)
    parents = {child: i for i, node in enumerate(gltf["nodes"]) for child in node.get("children", [])}
    result = []
    for share in shares:
        t = share * duration
        own, weights = [], rest_weights(gltf)
        for node in gltf["nodes"]:
            rotation = node.get("rotation", [0, 0, 0, 1])
            own.append({"translation": node.get("translation", [0, 0, 0]), "rotation": unit(rotation),
                        "scale": node.get("scale", [1, 1, 1]), "matrix": node.get("matrix")})
        for node, name, keys, values, how in channels:
            value = sampled(keys, values, how, t, name == "rotation")
            if name == "weights":
                weights[node] = value
                continue
            own[node][name] = value
            own[node]["matrix"] = None
        worlds = []
        for i in range(len(own)):
            world = own[i]["matrix"] or matrix_of(own[i])
            up = parents.get(i)
            while up is not None:
                world = times_matrix(own[up]["matrix"] or matrix_of(own[up]), world)
                up = parents.get(up)
            worlds.append(world)
        result.append({"t": t, "worlds": worlds, "bent": shapes.bent(worlds, weights)})
    return result


def all_of(path, shares):
    gltf, chunk = load(path)
    shapes = Shapes(gltf, path, chunk)
    return {"rest": poses(gltf, path, chunk, shapes, {"channels": [], "samplers": []}, [0]),
            "clips": [poses(gltf, path, chunk, shapes, animation, shares) for animation in gltf.get("animations", [])]}


def main():
    shares = [float(text) for text in sys.argv[1].split(",")]
    print(json.dumps([all_of(path, shares) for path in sys.argv[2:]]))


main()
