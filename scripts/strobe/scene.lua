-- SPDX-License-Identifier: MIT
-- Constructors for scenes. A constructor returns a copy of its table as plain data, with the kind of the object and its place
-- in the script. The program checks the keys when it loads the scene, reports all mistakes at once, and makes vertices and
-- texels from these data. Lengths are in metres, angles in degrees, times in seconds; y is up. Colours are linear { r, g, b }
-- or { r, g, b, a }. docs/describing-a-scene.md has the defaults and ranges.
local scene = {}
local type_of = type

-- The function that returns the place of a caller. It is a global function of Strobe's interpreter, and nil in another Lua
-- interpreter.
local caller_place = rawget(_ENV, "caller_place")

-- Returns the file and line of the script that calls the constructor; nil in another Lua interpreter.
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

-- Shapes, centred on their origin unless stated otherwise. `segments`: number of segments of round shapes.
-- quad { size = {w, h}, segments, tile }              faces +z; `tile`: metres per repeat of the texture (0: one repeat)
-- box { size = {x, y, z}, radius, segments, tile }    `radius`: rounding of the edges; `tile`: as for a quad
-- sphere { radius, segments }
-- torus { radius, tube_radius, segments, tube_segments }
-- superellipsoid { size, north, east, segments }      exponents `north`, `east`; both 1: ellipsoid; near 0: box; 2: octahedron
-- cylinder { radius, top_radius, height, segments, bevel }   `bevel`: rounding of the two rims
-- lathe { profile = { {radius, y}, ... }, segments, smooth, crease }   profile from bottom to top, outside on its right;
--                                                     `smooth`: steps of the smooth curve between two points of the
--                                                     profile; corners above the angle `crease` stay sharp
-- tube { path = { {x, y, z}, ... }, radius | radii, segments, smooth, flatten, up }   `flatten` below 1: flattened along `up`
-- cushion { size, pinch, quilt, quilt_depth, segments }   lies in the xy plane; `pinch`: how far the sides are drawn in
-- cloth { size = {w, h, depth}, folds, flare, thickness, segments, segments_down }
--                                                     `flare`: growth of the folds towards the lower edge
-- triangles { positions, normals, uvs, indices }      indices start at 1; without indices, every three positions are a triangle
for _, name in ipairs { "quad", "box", "sphere", "torus", "superellipsoid", "cylinder", "lathe", "tube", "cushion",
                        "cloth", "triangles" } do
  scene[name] = constructor("shape", name)
end

-- Textures. Every texture may have name, wrap = "repeat" | "mirror" | "clamp" and filter = "linear" | "nearest".
-- A pattern (stripes, checker, ...) has size = {w, h}, in texels, colors = { ... } and some of these fields (the page
-- docs/describing-a-scene.md lists the fields of each pattern):
--   count    number of repeats, one number or {u, v}
--   widths   relative widths of stripes
--   amount   strength of grain or noise
--   line     width of lines as a share of a repeat
--   seed     seed of the random numbers
-- texels { width, height, texels = { {r, g, b [, a]}, ... } }   top row first; sampled without a filter
-- image { file }                                               a PNG or JPEG; path relative to the file of the scene
scene.texture = {}
for _, name in ipairs { "image", "stripes", "checker", "quilt", "rug", "wood", "noise", "weave", "spine", "painting",
                        "gradient", "leaf", "texels" } do
  scene.texture[name] = constructor("texture", name)
end

-- use { texture, scale = {u, v}, offset = {u, v}, rotation }: places a texture on a material. `scale`: number of repeats along
-- u and v. `rotation`: degrees.
scene.use = constructor "use"

-- A metallic-roughness material as in glTF 2.0:
-- material { name, color, color_texture, metallic, roughness, metallic_roughness_texture, normal_texture, normal_scale,
--            emissive, emissive_texture, unlit, alpha_cutoff, blend, double_sided }
scene.material = constructor "material"

-- point_light { color, intensity, range, shadow, name }: intensity in candela
-- spot_light: has also inner_cone and outer_cone, which are half angles
-- directional_light: intensity in lux
-- Spot lights and directional lights shine along the -z axis of their node.
scene.point_light = constructor("light", "point")
scene.spot_light = constructor("light", "spot")
scene.directional_light = constructor("light", "directional")

-- camera { name, fov, near }: `fov` is the vertical angle of view, `near` the distance of the near plane
-- orthographic_camera { name, half_height, near }: `half_height` is half of the height of the view
scene.camera = constructor("camera", "perspective")
scene.orthographic_camera = constructor("camera", "orthographic")

-- gltf { file, animation = "all" | "none" | "NAME", variant }: a .glb or .gltf file; its path is relative to the file of the
-- scene. `animation`: clips of the file that play. `variant`: name of the material variant. Names in the file get the name of
-- the node as a prefix: if the file is loaded at a node "fan", its node "blade" is named "fan/blade", and likewise its clips,
-- cameras and lights.
scene.gltf = constructor "gltf"

-- node { name, position, rotation = {x, y, z} | look_at = {x, y, z}, scale, shape, material | parts, gltf, light, camera,
--        motion = { velocity, axis, degrees_per_second, rest_time }, cuts = { seconds }, children }: a place in the scene
-- rotation: about z, then x, then y. parts: a list of { shape, material, position, rotation, look_at, scale }, drawn as one
-- object. motion: motion at a constant rate, in world axes; `axis` and `degrees_per_second` spin the node about its own origin,
-- and `rest_time` is the time of the original placement. cuts: times when the node jumps, which is not blurred.
scene.node = constructor "node"

-- animation { name, tracks, duration }: a list of tracks, each for one property of one node
-- track { node, target = "translation" | "rotation" | "scale", interpolation = "linear" | "step" | "cubic", times, values }
-- `values` has one value per time; a rotation is a quaternion {x, y, z, w}. With "cubic" it has three values per time: the
-- in-tangent, the value and the out-tangent.
scene.animation = constructor "animation"
scene.track = constructor "track"

-- Returns the linear { r, g, b } of the sRGB colour `text`, "#rrggbb", multiplied by `factor` (default: 1).
function scene.srgb(text, factor)
  local r, g, b = tostring(text):match "^#(%x%x)(%x%x)(%x%x)$"
  if not r then error("srgb takes a colour like '#c08040', got '" .. tostring(text) .. "'", 2) end
  local function linear(hex)
    local c = tonumber(hex, 16) / 255
    return (c <= 0.04045 and c / 12.92 or ((c + 0.055) / 1.055) ^ 2.4) * (factor or 1)
  end
  return { linear(r), linear(g), linear(b) }
end

-- Returns the value of a parameter of the scene, which the setting `--set scene.NAME=VALUE` gives. Without this setting, the
-- value is `default`. The value has the type of `default`: number, text or boolean.
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
--         shot = { width, height, fps, frame, exposure } }: the scene, which the file of the scene returns
-- environment: radiance from above and below, and colour of pixels without a surface. cuts: times when the whole scene jumps.
-- loop: period of playback. shot: defaults for options of the command line.
return setmetatable(scene, { __call = function(_, fields)
  if type(fields) ~= "table" then error("scene takes a table, got a " .. type(fields), 2) end
  local result = {}
  for key, value in pairs(fields) do result[key] = value end
  result.kind, result.place = "scene", place()
  return result
end })
