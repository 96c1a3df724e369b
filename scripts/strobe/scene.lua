-- SPDX-License-Identifier: MIT
-- Constructors of scenes. Each constructor returns its table as plain data, with the kind of the object and its place in the
-- script. Keys are checked
-- when the scene is built, and all mistakes are reported at once. Vertices and texels are made later, by the program.
-- Lengths are in metres, angles in degrees, times in seconds; y is up. Colours are linear { r, g, b } or { r, g, b, a }.
local scene = {}
local type_of = type

-- A global function of Strobe's interpreter; nil in another Lua interpreter.
local caller_place = rawget(_ENV, "caller_place")

-- The file and line of the script that calls the constructor.
local function place()
  return caller_place and caller_place(1) or nil
end

local function constructor(kind, type)
  return function(fields)
    if fields == nil then fields = {} end
    local name = type or kind
    if type_of(fields) ~= "table" then error(name .. " takes a table, got a " .. type_of(fields), 2) end
    local result = {}
    for key, value in pairs(fields) do result[key] = value end
    result.kind, result.type, result.place = kind, type, place()
    return result
  end
end

-- Shapes, centred on their origin unless stated otherwise:
-- quad { size = {w, h}, segments, tile }              faces +z; `tile` metres per repeat of the texture (0: one repeat)
-- box { size = {x, y, z}, radius, segments, tile }    edges rounded by `radius`
-- sphere { radius, segments }
-- torus { radius, tube_radius, segments, tube_segments }
-- superellipsoid { size, north, east, segments }      north = east = 1: ellipsoid; near 0: box; 2: octahedron
-- cylinder { radius, top_radius, height, segments, bevel }
-- lathe { profile = { {radius, y}, ... }, segments, smooth, crease }   profile from bottom to top, outside on its right
-- tube { path = { {x, y, z}, ... }, radius | radii, segments, smooth, flatten, up }
-- cushion { size, pinch, quilt, quilt_depth, segments }   lies in the xy plane
-- cloth { size = {w, h, depth}, folds, flare, thickness, segments, segments_down }
-- triangles { positions, normals, uvs, indices }      indices start at 1; without indices, three positions each are a triangle
for _, name in ipairs { "quad", "box", "sphere", "torus", "superellipsoid", "cylinder", "lathe", "tube", "cushion",
                        "cloth", "triangles" } do
  scene[name] = constructor("shape", name)
end

-- Textures. Every texture may have size = {w, h}, wrap = "repeat" | "mirror" | "clamp", filter = "linear" | "nearest" and name.
-- Patterns: colors = { ... }, count (or {u, v}), widths, amount, line, seed.
-- texels { width, height, texels = { {r, g, b [, a]}, ... } }   top row first; sampled without a filter
-- image { file }                                               a PNG or JPEG; path relative to the file of the scene
scene.texture = {}
for _, name in ipairs { "image", "stripes", "checker", "quilt", "rug", "wood", "noise", "weave", "spine", "painting",
                        "gradient", "leaf", "texels" } do
  scene.texture[name] = constructor("texture", name)
end

-- use { texture, scale = {u, v}, offset = {u, v}, rotation }: a texture placed on a material.
scene.use = constructor "use"

-- material { name, color, color_texture, metallic, roughness, metallic_roughness_texture, normal_texture, normal_scale,
--            emissive, emissive_texture, unlit, alpha_cutoff, blend, double_sided }
scene.material = constructor "material"

-- point_light { color, intensity, range, shadow, name }    intensity in candela
-- spot_light           has also inner_cone and outer_cone, which are half angles
-- directional_light    intensity in lux
-- Spot lights and directional lights shine along the -z axis of their node.
scene.point_light = constructor("light", "point")
scene.spot_light = constructor("light", "spot")
scene.directional_light = constructor("light", "directional")

-- camera { name, fov, near }: fov is the vertical angle; orthographic_camera { name, half_height, near }
scene.camera = constructor("camera", "perspective")
scene.orthographic_camera = constructor("camera", "orthographic")

-- gltf { file, animation = "all" | "none" | "NAME", variant }: a .glb or .gltf file; its path is relative to the file of the
-- scene. `variant`: name of the material variant. If the file is loaded at a node "fan", a node "blade" of the file is named
-- "fan/blade"; names of clips, cameras and lights get the same prefix.
scene.gltf = constructor "gltf"

-- node { name, position, rotation = {x, y, z} | look_at = {x, y, z}, scale, shape, material | parts, gltf, light, camera,
--        motion = { velocity, axis, degrees_per_second, rest_time }, cuts = { seconds }, children }
-- parts: a list of { shape, material, position, rotation, look_at, scale }, drawn as one object.
-- A rotation turns about z, then x, then y. The motion is along the axes of the world. The spin turns about the origin of the
-- node.
scene.node = constructor "node"

-- animation { name, tracks, duration }
-- track { node, target = "translation" | "rotation" | "scale", interpolation = "linear" | "step" | "cubic",
--         times, values }      rotations as quaternions {x, y, z, w}; cubic: in-tangent, value, out-tangent per key
scene.animation = constructor "animation"
scene.track = constructor "track"

-- Returns the linear { r, g, b } of an sRGB colour "#rrggbb", multiplied by `factor` (default: 1).
function scene.srgb(text, factor)
  local r, g, b = tostring(text):match "^#(%x%x)(%x%x)(%x%x)$"
  if not r then error("srgb takes a colour like '#c08040', got '" .. tostring(text) .. "'", 2) end
  local function linear(hex)
    local c = tonumber(hex, 16) / 255
    return (c <= 0.04045 and c / 12.92 or ((c + 0.055) / 1.055) ^ 2.4) * (factor or 1)
  end
  return { linear(r), linear(g), linear(b) }
end

-- Returns a parameter of the scene: a number, text or boolean of the type of `default`, which is its value unless `--set
-- scene.NAME=VALUE` gives another.
function scene.param(name, default)
  local given = rawget(_ENV, "scene_params") and scene_params[name]
  if given == nil then return default end
  local wanted = type(default)
  local value = given
  if wanted == "number" then value = tonumber(given) end
  if wanted == "boolean" and type(given) ~= "boolean" then value = ({ ["true"] = true, ["false"] = false })[given] end
  if wanted == "string" then value = tostring(given) end
  if value == nil then error(("scene.%s = '%s' is not a %s"):format(name, tostring(given), wanted), 2) end
  return value
end

-- scene { name, nodes, environment = { sky, ground, background }, animations, cuts = { seconds }, loop = seconds,
--         shot = { width, height, fps, frame, exposure } }   defaults for the options of the command line
return setmetatable(scene, { __call = function(_, fields)
  if type(fields) ~= "table" then error("scene takes a table, got a " .. type(fields), 2) end
  local result = {}
  for key, value in pairs(fields) do result[key] = value end
  result.kind, result.place = "scene", place()
  return result
end })
