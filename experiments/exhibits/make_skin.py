#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes skin.gltf: an arm of three joints that bends, and a turning ring of instances, before a wall of instances.
    experiments/exhibits/make_skin.py > experiments/exhibits/skin.gltf"""
import base64
import json
import math
import struct

data, views, accessors = bytearray(), [], []


def accessor(values, kind, component, extent=False):
    """Rows of numbers as an accessor: its index. component: 5126 float, 5123 unsigned short."""
    flat = [x for row in values for x in row]
    packed = struct.pack("<%d%s" % (len(flat), "f" if component == 5126 else "H"), *flat)
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
    data.extend(packed + b"\0" * (-len(packed) % 4))
    made = {"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind}
    if extent:
        made["min"], made["max"] = ([pick(column) for column in zip(*values)] for pick in (min, max))
    accessors.append(made)
    return len(accessors) - 1


def box(w, h, d):
    """Positions, normals and triangles."""
    points, normals, triangles = [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            first = len(points)
            for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                at = [0, 0, 0]
                at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3] = sign, a * sign, b
                points.append([at[0] * w / 2, at[1] * h / 2, at[2] * d / 2])
                normals.append([sign if i == axis else 0 for i in range(3)])
            triangles += [[first, first + 1, first + 2], [first, first + 2, first + 3]]
    return points, normals, triangles


def primitive(points, normals, triangles, material, more=None):
    attributes = {"POSITION": accessor(points, "VEC3", 5126, True), "NORMAL": accessor(normals, "VEC3", 5126)}
    attributes.update(more or {})
    indices = accessor([[i] for triangle in triangles for i in triangle], "SCALAR", 5123)
    return {"attributes": attributes, "indices": indices, "material": material}


def turned(degrees):
    """A turn about z."""
    return [0, 0, math.sin(math.radians(degrees) / 2), math.cos(math.radians(degrees) / 2)]


# ---- the skinned arm: boxes, one above the other. The skinning weights of a vertex on two joints depend on its height.

SEGMENTS, JOINTS, LENGTH, THICK = 12, 3, 1.5, 0.2


def arm():
    bands = ([], [])  # of two materials
    for s in range(SEGMENTS):
        low, high = LENGTH * s / SEGMENTS, LENGTH * (s + 1) / SEGMENTS
        points, normals, triangles = box(THICK, high - low, THICK)
        bands[s % 2].append(([[x, y + (low + high) / 2, z] for x, y, z in points], normals, triangles))
    primitives = []
    for material, band in enumerate(bands):
        points, normals, triangles = [], [], []
        for p, n, t in band:
            triangles += [[i + len(points) for i in triangle] for triangle in t]
            points, normals = points + p, normals + n
        along = [min(max(JOINTS * y / LENGTH - 0.5, 0), JOINTS - 1) for _, y, _ in points]
        first = [min(int(a), JOINTS - 2) for a in along]
        shares = [a - f for a, f in zip(along, first)]
        joints = [[f if share < 1 else 0, f + 1 if share > 0 else 0, 0, 0] for f, share in zip(first, shares)]
        more = {"JOINTS_0": accessor(joints, "VEC4", 5123),
                "WEIGHTS_0": accessor([[1 - share, share, 0, 0] for share in shares], "VEC4", 5126)}
        primitives.append(primitive(points, normals, triangles, material, more))
    return primitives


def grid(odd):
    return [[0.3 * i, 0.3 * k, -1.2] for i in range(-8, 9) for k in range(-2, 8) if (i * 7 + k * 3) % 5 % 2 == odd]


COLORS = [[0.75, 0.1, 0.06], [0.9, 0.75, 0.5], [0.05, 0.15, 0.35], [0.35, 0.55, 0.45], [0.02, 0.02, 0.02]]
RING = [[0.42 * math.cos(math.radians(a)), 0.42 * math.sin(math.radians(a)), 0] for a in range(0, 360, 45)]


def instances(places):
    return {"extensions": {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": accessor(places, "VEC3", 5126)}}}}


meshes = [{"primitives": arm()}, {"primitives": [primitive(*box(0.29, 0.29, 0.1), 2)]},
          {"primitives": [primitive(*box(0.29, 0.29, 0.16), 3)]}, {"primitives": [primitive(*box(0.16, 0.16, 0.16), 1)]},
          {"primitives": [primitive(*box(6, 4, 0.1), 4)]}]
step = LENGTH / JOINTS
joint = 6
nodes = [
    {"name": "arm", "mesh": 0, "skin": 0},
    {"name": "tiles_blue", "mesh": 1, **instances(grid(0))},
    {"name": "tiles_green", "mesh": 2, **instances(grid(1))},
    {"name": "ring", "mesh": 3, "translation": [0.95, 0.75, 0], **instances(RING)},
    {"name": "wall", "mesh": 4, "translation": [0, 0.7, -1.3]},
    {"name": "camera", "camera": 0, "translation": [0.2, 0.75, 3.4]},
    {"name": "joint_0", "translation": [-0.35, 0, 0], "children": [joint + 1]},
    {"name": "joint_1", "translation": [0, step, 0], "children": [joint + 2]},
    {"name": "joint_2", "translation": [0, step, 0]},
    {"name": "sun", "rotation": [-0.35, -0.3, 0.12, 0.88], "extensions": {"KHR_lights_punctual": {"light": 0}}},
]
inverse = [[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -step * i, 0, 1] for i in range(JOINTS)]

# In one second, each joint turns by 50 degrees, and the ring of boxes by 80 degrees.
times = accessor([[0.0], [1.0]], "SCALAR", 5126, True)
bend, turn = (accessor([turned(-d), turned(d)], "VEC4", 5126) for d in (25, 40))
targets = [(joint, bend), (joint + 1, bend), (joint + 2, bend), (3, turn)]
animation = {"samplers": [{"input": times, "output": output} for _, output in targets],
             "channels": [{"sampler": i, "target": {"node": node, "path": "rotation"}} for i, (node, _) in enumerate(targets)]}

scene = {
    "asset": {"version": "2.0", "generator": "experiments/exhibits/make_skin.py",
              "copyright": "SPDX-License-Identifier: MIT"},
    "extensionsUsed": ["EXT_mesh_gpu_instancing", "KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 3}]}},
    "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3, 4, 5, joint, 9]}], "nodes": nodes, "meshes": meshes,
    "skins": [{"joints": [joint, joint + 1, joint + 2], "inverseBindMatrices": accessor(inverse, "MAT4", 5126)}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": color + [1], "metallicFactor": 0, "roughnessFactor": 0.7}}
                  for color in COLORS],
    "cameras": [{"type": "perspective", "perspective": {"yfov": math.radians(30), "znear": 0.05}}],
    "animations": [animation],
}
scene["accessors"], scene["bufferViews"] = accessors, views
scene["buffers"] = [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(bytes(data)).decode()}]
print(json.dumps(scene, separators=(",", ":")))
