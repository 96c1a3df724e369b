# SPDX-License-Identifier: MIT
"""Renders an exported scene in Blender's Cycles. Cycles shares no code with Strobe, so its picture checks ground truth
(docs/external-truth.md):

    ./strobe render ... --export-mitsuba FOLDER
    blender -b -P tools/cycles/render.py -- FOLDER OUT.exr [SAMPLES]

The picture is linear, with a box filter of one pixel. Surfaces of an unlit scene (integrator "aov") emit their colours
and do not light each other. If the camera moves, the script fixes the camera and moves all objects in camera space
instead: Cycles has only three poses of a moving camera."""
import math
import os
import sys
import xml.etree.ElementTree as xml

import bpy
import numpy as np
from mathutils import Matrix

FRAMES = 128  # length of the exposure in Blender frames; keys are at whole frames
TURN = Matrix.Diagonal((-1, 1, -1, 1))  # cameras and lights: Mitsuba looks along +z, Blender along -z


def value(element, name, default=None):
    found = [child.get("value") for child in element if child.get("name") == name]
    return found[0] if found else default


def color(text):
    return tuple(float(number) for number in text.split(","))


def keys_of(element):
    """Transforms at evenly spaced times of the exposure; one transform if static."""
    holder = element.find("animation")
    transforms = [element.find("transform")] if holder is None else list(holder)
    numbers = [[float(n) for n in t.find("matrix").get("value").split()] for t in transforms]
    return [Matrix([row[i:i + 4] for i in range(0, 16, 4)]) for row in numbers]


def resampled(keys, count):
    """The same motion with `count` keys: linear in translation and scale, rotation along the shorter arc."""
    if len(keys) in (1, count):
        return keys * (count // len(keys))
    step, result = (count - 1) // (len(keys) - 1), []
    for i in range(count):
        k = min(i // step, len(keys) - 2)
        t = i / step - k
        (p, q, s), (p1, q1, s1) = keys[k].decompose(), keys[k + 1].decompose()
        result.append(Matrix.LocRotScale(p.lerp(p1, t), q.slerp(q1, t), s.lerp(s1, t)))
    return result


def animate(thing, keys):
    parts = [key.decompose() for key in keys]
    for before, (_, rotation, _) in zip(parts, parts[1:]):
        if before[1].dot(rotation) < 0:
            rotation.negate()
    thing.rotation_mode = "QUATERNION"
    thing.animation_data_create().action = action = bpy.data.actions.new(thing.name)
    for path, size, part in (("location", 3, 0), ("rotation_quaternion", 4, 1), ("scale", 3, 2)):
        for axis in range(size):
            curve = action.fcurves.new(path, index=axis)
            curve.keyframe_points.add(len(keys))
            frames = [FRAMES * k / (len(keys) - 1) for k in range(len(keys))]
            curve.keyframe_points.foreach_set("co", [n for f, p in zip(frames, parts) for n in (f, p[part][axis])])
            for point in curve.keyframe_points:
                point.interpolation = "LINEAR"
    thing.cycles.use_motion_blur = True
    thing.cycles.motion_steps = max(1, int(math.log2(len(keys) - 1)))


def placed(name, data, keys):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    thing.matrix_world = keys[0]
    if len(keys) > 1:
        animate(thing, keys)
    return thing


def mesh_of(path, still):
    """Mesh of a PLY file. `still`: transform of a static mesh; may have shear, which an object cannot have."""
    data = open(path, "rb").read()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    counts = {line.split()[1]: int(line.split()[2]) for line in data[:end].decode().split("\n") if line.startswith("element")}
    vertices = np.frombuffer(data, "<f4", 8 * counts["vertex"], end).reshape(-1, 8)
    faces = np.frombuffer(data, np.dtype([("n", "u1"), ("i", "<i4", 3)]), counts["face"], end + vertices.nbytes)["i"]
    mesh = bpy.data.meshes.new(os.path.basename(path))
    mesh.from_pydata(vertices[:, :3].tolist(), [], faces.tolist())
    corners = faces.reshape(-1)
    uvs = vertices[corners][:, 6:].copy()
    uvs[:, 1] = 1 - uvs[:, 1]  # v of Blender points up
    mesh.uv_layers.new().data.foreach_set("uv", uvs.reshape(-1))
    mesh.use_auto_smooth = True
    mesh.normals_split_custom_set(vertices[corners][:, 3:6].tolist())
    if still:
        mesh.transform(still)
    return mesh


def colored(tree, folder, socket, element, name):
    """Sets a colour socket to a property: numbers or a bitmap."""
    texture = [t for t in element.findall("texture") if t.get("name") == name]
    if not texture:
        socket.default_value = (*color(value(element, name)), 1)
        return
    image = tree.nodes.new("ShaderNodeTexImage")
    image.image = bpy.data.images.load(os.path.join(os.path.abspath(folder), value(texture[0], "filename")))
    image.image.colorspace_settings.name = "Linear"
    image.interpolation = "Closest" if value(texture[0], "filter_type") == "nearest" else "Linear"
    wrap = value(texture[0], "wrap_mode", "repeat")
    image.extension = {"repeat": "REPEAT", "clamp": "EXTEND"}.get(wrap) or sys.exit(f"no wrap mode {wrap} in Blender 3.4")
    tree.links.new(image.outputs["Color"], socket)


def material_of(folder, shape, bsdfs, unlit):
    emitter, own = shape.find("emitter"), shape.find("bsdf")
    bsdf = own if own is not None else bsdfs[shape.find("ref").get("id")]
    bsdf = bsdf if bsdf.find("bsdf") is None else bsdf.find("bsdf")
    material = bpy.data.materials.new(shape.get("id"))
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    both = tree.nodes.new("ShaderNodeAddShader")
    parts = [("ShaderNodeEmission" if unlit else "ShaderNodeBsdfDiffuse", bsdf, "reflectance")]
    parts += [("ShaderNodeEmission", emitter, "radiance")] if emitter is not None else []
    for i, (kind, element, name) in enumerate(parts):
        shader = tree.nodes.new(kind)
        colored(tree, folder, shader.inputs["Color"], element, name)
        tree.links.new(shader.outputs[0], both.inputs[i])
    tree.links.new(both.outputs[0], tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def add_light(emitter, keys):
    kind = {"point": "POINT", "spot": "SPOT", "directional": "SUN"}[emitter.get("type")]
    light = bpy.data.lights.new(emitter.get("id"), kind)
    rgb = color(value(emitter, "irradiance" if kind == "SUN" else "intensity"))
    strength = max(rgb) or 1
    light.color = [c / strength for c in rgb]
    light.energy = strength if kind == "SUN" else strength * 4 * math.pi  # sun: watts per square metre; others: watts
    setattr(light, "angle" if kind == "SUN" else "shadow_soft_size", 0)
    if kind == "SPOT":
        light.spot_size = math.radians(2 * float(value(emitter, "cutoff_angle")))
        light.spot_blend = 1 - float(value(emitter, "beam_width")) / float(value(emitter, "cutoff_angle"))
    placed(emitter.get("id"), light, [key @ TURN for key in keys])


def set_camera(sensor, half_height, keys):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit = "VERTICAL"
    camera.clip_start, camera.clip_end = float(value(sensor, "near_clip")), float(value(sensor, "far_clip"))
    if sensor.get("type") == "orthographic":
        camera.type = "ORTHO"
        camera.ortho_scale = 2 * half_height
    else:
        camera.angle = math.radians(float(value(sensor, "fov")))
    bpy.context.scene.camera = placed("camera", camera, keys)


def set_picture(film, samples, unlit):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y = int(value(film, "width")), int(value(film, "height"))
    scene.render.resolution_percentage = 100
    scene.render.use_motion_blur, scene.render.motion_blur_shutter = True, FRAMES
    scene.frame_set(FRAMES // 2)
    cycles = scene.cycles
    cycles.motion_blur_position = "CENTER"
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = samples, False, False
    cycles.max_bounces = 0 if unlit else 1
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"


def set_background(scene):
    world = bpy.context.scene.world = bpy.data.worlds.new("background")
    world.use_nodes = True
    constant = scene.find("emitter[@type='constant']")
    radiance = (0, 0, 0) if constant is None else color(value(constant, "radiance"))
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (*radiance, 1)
    if scene.find("emitter[@type='envmap']") is not None:
        print("render.py does not render the gradient of the background")


def main(folder, out, samples=1024):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = xml.parse(os.path.join(folder, "scene.xml")).getroot()
    sensor, film = scene.find("sensor"), scene.find("sensor/film")
    unlit = scene.find("integrator").get("type") == "aov"
    set_picture(film, int(samples), unlit)
    set_background(scene)
    bsdfs = {bsdf.get("id"): bsdf for bsdf in scene.findall("bsdf")}
    groups = {shape.get("id"): shape for shape in scene.findall("shape[@type='shapegroup']")}
    camera = keys_of(sensor)
    half_width = camera[0].to_scale().x if sensor.get("type") == "orthographic" else 1
    camera = [Matrix.LocRotScale(key.to_translation(), key.to_quaternion(), None) @ TURN for key in camera]
    moves = len(camera) > 1

    def seen(keys):
        if not moves:
            return keys
        count = max(len(keys), len(camera))
        return [eye.inverted() @ key for eye, key in zip(resampled(camera, count), resampled(keys, count))]

    set_camera(sensor, half_width * int(value(film, "height")) / int(value(film, "width")), [Matrix()] if moves else camera)
    for shape in scene.findall("shape"):
        if shape.get("type") in ("shapegroup", "sphere"):
            continue  # the background of an unlit scene; the world has its colour
        keys, parts = seen(keys_of(shape)), [shape]
        if shape.get("type") == "instance":
            parts = groups[shape.find("ref").get("id")].findall("shape")
        for part in parts:
            still = keys[0] if len(keys) == 1 else None
            mesh = mesh_of(os.path.join(folder, value(part, "filename")), still)
            mesh.materials.append(material_of(folder, part, bsdfs, unlit))
            placed(part.get("id"), mesh, [Matrix()] if still else keys)
    for emitter in scene.findall("emitter"):
        if emitter.get("type") in ("point", "spot", "directional") and not unlit:
            add_light(emitter, seen(keys_of(emitter)))
    bpy.context.scene.render.filepath = os.path.abspath(out)
    bpy.ops.render.render(write_still=True)


main(*sys.argv[sys.argv.index("--") + 1:])
