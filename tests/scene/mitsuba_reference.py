# SPDX-License-Identifier: MIT
"""Positions of all objects in a folder with a Mitsuba 3 scene (scene.xml and PLY files), implemented from the documentation
of Mitsuba 3 and PLY with the standard library only.

    mitsuba_reference.py FOLDER TIME,TIME,...

prints {"integrator": type, "sensor": {..., "rays": for each time [origin, direction] through each of five points of the film},
"shapes": [{"id", "bsdf", "points": for each time the corners of all triangles, world space, ...}], "emitters": [...],
"comments": [...]}. A transform is [times, matrices]; between keys, scale and translation are interpolated linearly and
rotations along the shorter arc (Mitsuba 3, "Animation and motion blur")."""
import json
import math
import os
import struct
import sys
import xml.dom.minidom


def children(element, tag=None):
    return [c for c in element.childNodes if c.nodeType == c.ELEMENT_NODE and tag in (None, c.tagName)]


def properties(element):
    """Values of the float, integer, string, boolean and rgb tags of an element, by name."""
    found = {}
    for child in children(element):
        value, name = child.getAttribute("value"), child.getAttribute("name")
        if child.tagName in ("float", "integer"):
            found[name] = float(value)
        elif child.tagName in ("string", "boolean"):
            found[name] = value
        elif child.tagName in ("rgb", "point"):
            found[name] = [float(v) for v in value.split(",")]
    return found


def matrix_of(transform):
    numbers = [float(v) for v in children(transform, "matrix")[0].getAttribute("value").split()]
    return [numbers[4 * row:4 * row + 4] for row in range(4)]


def keys_of(element):
    for animation in children(element, "animation"):
        keys = children(animation, "transform")
        return [float(k.getAttribute("time")) for k in keys], [matrix_of(k) for k in keys]
    for transform in children(element, "transform"):
        return [0.0], [matrix_of(transform)]
    return [0.0], [[[float(r == c) for c in range(4)] for r in range(4)]]


def decomposed(m):
    """Translation, rotation as 3x3 and scale, which is negative if the matrix mirrors."""
    scale = [math.sqrt(sum(m[r][c] ** 2 for r in range(3))) for c in range(3)]
    x, y, z = ([m[r][c] for r in range(3)] for c in range(3))
    if x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]) < 0:
        scale = [-s for s in scale]
    return [m[r][3] for r in range(3)], [[m[r][c] / scale[c] for c in range(3)] for r in range(3)], scale


def product(a, b):
    return [[sum(a[r][k] * b[k][c] for k in range(len(b))) for c in range(len(b[0]))] for r in range(len(a))]


def turned(a, b, t):
    """The rotation a, turned by the share t of the angle to b: a * exp(t * log(a^-1 * b)), by Rodrigues' formula."""
    delta = product([list(row) for row in zip(*a)], b)
    axis = [delta[2][1] - delta[1][2], delta[0][2] - delta[2][0], delta[1][0] - delta[0][1]]
    sine = math.sqrt(sum(v * v for v in axis)) / 2
    angle = t * math.atan2(sine, (delta[0][0] + delta[1][1] + delta[2][2] - 1) / 2)
    if sine < 1e-15:
        return a
    x, y, z = (v / (2 * sine) for v in axis)
    c, s = math.cos(angle), math.sin(angle)
    n = 1 - c
    part = [[c + x * x * n, x * y * n - z * s, x * z * n + y * s], [y * x * n + z * s, c + y * y * n, y * z * n - x * s],
            [z * x * n - y * s, z * y * n + x * s, c + z * z * n]]
    return product(a, part)


def at(keys, time):
    times, matrices = keys
    if len(times) == 1:
        return matrices[0]
    k = max(i for i in range(len(times) - 1) if times[i] <= time)
    t = (time - times[k]) / (times[k + 1] - times[k])
    (p, q, s), (p1, q1, s1) = decomposed(matrices[k]), decomposed(matrices[k + 1])
    rotation = turned(q, q1, t)
    return [[rotation[r][c] * (s[c] + t * (s1[c] - s[c])) for c in range(3)] + [p[r] + t * (p1[r] - p[r])] for r in range(3)]


def apply(m, v, w=1.0):
    return [sum(m[r][c] * v[c] for c in range(3)) + w * m[r][3] for r in range(3)]


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def ply(path):
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode().split("\n")
    assert header[0] == "ply" and header[1] == "format binary_little_endian 1.0", path
    counts = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element")}
    names = [line.split()[2] for line in header if line.startswith("property float")]
    assert names == ["x", "y", "z", "nx", "ny", "nz", "u", "v"], names
    assert "property list uchar int vertex_indices" in header
    vertices = [struct.unpack_from("<8f", data, end + 32 * i) for i in range(counts["vertex"])]
    start = end + 32 * counts["vertex"]
    faces = [struct.unpack_from("<B3i", data, start + 13 * i) for i in range(counts["face"])]
    assert len(data) == start + 13 * counts["face"] and all(face[0] == 3 for face in faces), path
    return vertices, [face[1:] for face in faces]


FILM = [(0.5, 0.5), (0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.25, 0.75)]  # shares of width and height, from the top left


def ray(sensor, values, aspect, time, position):
    """x of a camera points to the left of the picture, y up, z into the scene."""
    m = at(keys_of(sensor), time)
    x, y = 1 - 2 * position[0], 1 - 2 * position[1]
    if sensor.getAttribute("type") == "orthographic":
        return [apply(m, [x, y / aspect, 0]), unit(apply(m, [0, 0, 1], 0))]
    assert values["fov_axis"] == "y"
    half = math.tan(math.radians(values["fov"]) / 2)
    return [apply(m, [0, 0, 0]), unit(apply(m, [x * half * aspect, y * half, 1], 0))]


def sensor_of(scene, times):
    sensor = children(scene, "sensor")[0]
    values = properties(sensor)
    film = properties(children(sensor, "film")[0])
    aspect = film["width"] / film["height"]
    rays = [[ray(sensor, values, aspect, time, position) for position in FILM] for time in times]
    return {"type": sensor.getAttribute("type"), "rays": rays, "keys": len(keys_of(sensor)[0]), **values, **film}


def color_of(owner, name):
    """The colour of a property: numbers, or the texture's file, filter and wrap mode."""
    found = properties(owner).get(name)
    for texture in children(owner, "texture"):
        if texture.getAttribute("name") == name:
            found = properties(texture)
    return found


def bsdf_of(shape, bsdfs):
    own = children(shape, "bsdf")
    bsdf = own[0] if own else bsdfs[children(shape, "ref")[0].getAttribute("id")]
    inner = children(bsdf, "bsdf")
    return color_of(inner[0] if inner else bsdf, "reflectance")


def shape_of(folder, shape, keys, bsdfs, times, id):
    vertices, faces = ply(os.path.join(folder, properties(shape)["filename"]))
    corners = [vertices[i] for face in faces for i in face]
    points = [[apply(at(keys, time), corner[:3]) for corner in corners] for time in times]
    emission = [color_of(emitter, "radiance") for emitter in children(shape, "emitter")]
    return {"id": id, "keys": len(keys[0]), "points": points, "normals": [corner[3:6] for corner in corners],
            "uvs": [corner[6:8] for corner in corners], "bsdf": bsdf_of(shape, bsdfs), "emission": emission}


def shapes_of(folder, scene, times):
    bsdfs = {b.getAttribute("id"): b for b in children(scene, "bsdf")}
    groups = {s.getAttribute("id"): s for s in children(scene, "shape") if s.getAttribute("type") == "shapegroup"}
    found = []
    for shape in children(scene, "shape"):
        id = shape.getAttribute("id")
        if shape.getAttribute("type") == "ply":
            found.append(shape_of(folder, shape, keys_of(shape), bsdfs, times, id))
        elif shape.getAttribute("type") == "instance":
            for part in children(groups[children(shape, "ref")[0].getAttribute("id")], "shape"):
                found.append(shape_of(folder, part, keys_of(shape), bsdfs, times, id))
        elif shape.getAttribute("type") == "sphere":
            found.append({"id": id, **properties(shape), "bsdf": bsdf_of(shape, bsdfs)})
    return found


def emitter_of(emitter, times):
    keys = keys_of(emitter)
    poses = [at(keys, time) for time in times]
    return {"type": emitter.getAttribute("type"), "id": emitter.getAttribute("id"), **properties(emitter),
            "positions": [apply(m, [0, 0, 0]) for m in poses], "directions": [unit(apply(m, [0, 0, 1], 0)) for m in poses]}


folder, times = sys.argv[1], [float(t) for t in sys.argv[2].split(",")]
document = xml.dom.minidom.parse(os.path.join(folder, "scene.xml"))
scene = document.documentElement
assert scene.tagName == "scene" and scene.getAttribute("version") == "3.0.0"
ids = [e.getAttribute("id") for e in scene.getElementsByTagName("*") if e.hasAttribute("id") and e.tagName != "ref"]
assert len(ids) == len(set(ids)) and not any("." in id for id in ids), ids
print(json.dumps({
    "integrator": children(scene, "integrator")[0].getAttribute("type"), "sensor": sensor_of(scene, times),
    "shapes": shapes_of(folder, scene, times), "emitters": [emitter_of(e, times) for e in children(scene, "emitter")],
    "comments": [c.data for c in document.childNodes if c.nodeType == c.COMMENT_NODE]}))
