-- SPDX-License-Identifier: MIT
-- A living room in low evening sun. A vase with twigs slides past a striped cushion. In a picture of `height` lines, with `fps`
-- frames per second and an exposure of `exposure` frames, the vase moves by `pixels` px over the exposure at frame 0. Camera
-- "main" is static; camera "tracking" follows the vase.
local scene = require "strobe.scene"
local furniture = require "scripts.scenes.lib.furniture"

local texture, use, material, node, srgb = scene.texture, scene.use, scene.material, scene.node, scene.srgb

local pixels = scene.param("pixels", 40)
local fps, exposure = scene.param("fps", 24), scene.param("exposure", 0.5)
local width, height = scene.param("width", 960), scene.param("height", 540)

-- ---- camera and motion

local fov = 31
local eye, aim = { 0.66, 0.98, 2.15 }, { 0.06, 0.80, -0.9 }
local vase_at = { 0.26, 0.42, -0.35 }

-- Distance of a point from the eye, along the view direction, metres.
local function view_depth(point)
  local length, along = 0, 0
  for i = 1, 3 do
    local forward = aim[i] - eye[i]
    length, along = length + forward * forward, along + forward * (point[i] - eye[i])
  end
  return along / math.sqrt(length)
end

local metres_per_pixel = 2 * math.tan(math.rad(fov / 2)) * view_depth(vase_at) / height
local motion = { velocity = { pixels * metres_per_pixel * fps / exposure, 0, 0 } }

-- Time until the vase leaves the picture of camera "main", seconds. By then, the vase has moved by 0.42 of the picture's width.
local loop = 0.42 * width * exposure / fps / math.max(math.abs(pixels), 1)

-- ---- materials

local walnut = material {
  name = "walnut", roughness = 0.45,
  color_texture = texture.wood { colors = { srgb "#6b4226", srgb "#2f1a0e" }, count = 1, amount = 0.9, seed = 3 },
}
local oak = material {
  name = "oak floor", roughness = 0.5,
  color_texture = texture.wood {
    size = { 1024, 1024 }, colors = { srgb "#b98a58", srgb "#7c5230" }, count = 8, amount = 0.8, line = 0.03, seed = 11,
  },
}
local plaster = material {
  name = "plaster", roughness = 0.95,
  color_texture = texture.noise { colors = { srgb "#d8cdb8", srgb "#e6dcc9" }, count = 12, amount = 0.6, seed = 5 },
}
local sage = material {
  name = "sage wall", roughness = 0.95,
  color_texture = texture.noise { colors = { srgb "#7f9487", srgb "#8fa396" }, count = 12, amount = 0.6, seed = 9 },
}
local white_paint = material { name = "white paint", color = srgb "#ebe6da", roughness = 0.5 }
local linen = material {
  name = "linen", roughness = 0.95,
  color_texture = use {
    texture = texture.weave { size = { 256, 256 }, colors = { srgb "#b7a488", srgb "#a39075" }, count = 32 },
    scale = { 3, 3 },
  },
}
local curtain = material { name = "curtain", color = srgb "#d9c3a0", roughness = 0.95 }
local brass = material { name = "brass", color = srgb "#c9a24c", metallic = 1, roughness = 0.35 }
local black_steel = material { name = "black steel", color = srgb "#26241f", metallic = 0.4, roughness = 0.45 }
local terracotta = material { name = "terracotta", color = srgb "#b4623c", roughness = 0.8 }
local stoneware = material { name = "stoneware", color = srgb "#d6c8ae", roughness = 0.55 }
local shade = material { name = "lamp shade", color = srgb "#f0dcb4", emissive = srgb("#ffc978", 0.75), roughness = 1 }
local bulb = material { name = "bulb", color = { 1, 1, 1 }, emissive = srgb("#ffdca0", 3) }
local leaf = material {
  name = "leaf", roughness = 0.55,
  color_texture = texture.leaf { size = { 128, 256 }, colors = { srgb "#3d6b35", srgb "#86a860" } },
}
local rug = material {
  name = "rug", roughness = 1,
  color_texture = texture.rug {
    size = { 1024, 768 }, seed = 2,
    colors = { srgb "#8e2f2a", srgb "#1f3552", srgb "#d9a24a", srgb "#efe3c8" },
  },
}
local striped = material {
  name = "striped cushion", roughness = 0.9,
  color_texture = texture.stripes {
    colors = { srgb "#f3ead6", srgb "#1d2f52", srgb "#f3ead6", srgb "#b8442f" }, widths = { 3, 3, 3, 1.5 }, count = 5,
  },
}
local quilted = material {
  name = "quilted cushion", roughness = 0.9,
  color_texture = texture.quilt { colors = { srgb "#d09a35", srgb "#8a5f18", srgb "#f1dca2" }, count = 5, line = 0.05 },
}
local rust = material {
  name = "rust cushion", roughness = 0.95,
  color_texture = texture.weave { size = { 256, 256 }, colors = { srgb "#a5492c", srgb "#8f3c24" }, count = 40 },
}
local glaze = material {
  name = "glazed vase", roughness = 0.22,
  color_texture = use {
    texture = texture.quilt { colors = { srgb "#14707a", srgb "#eadfc4", srgb "#d9a24a" }, count = { 8, 4 },
      line = 0.1 },
    scale = { 1, 1 },
  },
}
local knit = material {
  name = "knitted pouf", roughness = 1,
  color_texture = texture.weave { size = { 256, 256 }, colors = { srgb "#5d7078", srgb "#4c5d65" },
    count = { 48, 24 } },
}

-- ---- the room

local nodes = {}
local function add(fields) nodes[#nodes + 1] = node(fields) end

add { name = "floor", shape = scene.box { size = { 6.2, 0.1, 6.4 }, tile = 2.2 }, material = oak,
  position = { 0, -0.05, 0.7 } }
add { name = "ceiling", shape = scene.box { size = { 6.2, 0.1, 6.4 } }, material = white_paint,
  position = { 0, 2.75, 0.7 } }
add { name = "back_wall", shape = scene.box { size = { 6.2, 2.7, 0.1 }, tile = 2 }, material = sage,
  position = { 0, 1.35, -2.45 } }
add { name = "front_wall", shape = scene.box { size = { 6.2, 2.7, 0.1 }, tile = 2 }, material = plaster,
  position = { 0, 1.35, 3.85 } }
add { name = "right_wall", shape = scene.box { size = { 0.1, 2.7, 6.2 }, tile = 2 }, material = plaster,
  position = { 3.05, 1.35, 0.7 } }
-- Wall with an opening for the window, from z = -1.1 to 1.5 and from y = 0.75 to 2.3, metres.
add {
  name = "window_wall", position = { -3.05, 0, 0 },
  parts = {
    { shape = scene.box { size = { 0.1, 0.75, 6.2 }, tile = 2 }, material = plaster, position = { 0, 0.375, 0.7 } },
    { shape = scene.box { size = { 0.1, 0.4, 6.2 }, tile = 2 }, material = plaster, position = { 0, 2.5, 0.7 } },
    { shape = scene.box { size = { 0.1, 1.55, 1.3 }, tile = 2 }, material = plaster, position = { 0, 1.525, -1.75 } },
    { shape = scene.box { size = { 0.1, 1.55, 2.3 }, tile = 2 }, material = plaster, position = { 0, 1.525, 2.65 } },
  },
}
add(furniture.window { name = "window_frame", position = { -3.02, 1.525, 0.2 }, size = { 2.6, 1.55 },
  material = white_paint })
add { name = "window_sill", shape = scene.box { size = { 0.24, 0.04, 2.8 }, radius = 0.01 }, material = white_paint,
  position = { -2.92, 0.74, 0.2 } }
add { name = "skirting", parts = {
  { shape = scene.box { size = { 6, 0.1, 0.02 }, radius = 0.005 }, material = white_paint,
    position = { 0, 0.05, -2.39 } },
  { shape = scene.box { size = { 0.02, 0.1, 6 }, radius = 0.005 }, material = white_paint,
    position = { 2.99, 0.05, 0.7 } },
} }
add { name = "curtain_rod", shape = scene.tube { path = { { 0, 0, -1.9 }, { 0, 0, 2.2 } }, radius = 0.014 },
  material = brass, position = { -2.88, 2.42, 0 } }
for i, z in ipairs { -1.42, 1.78 } do
  add {
    name = "curtain_" .. i, position = { -2.88, 1.24, z }, rotation = { 0, 90, 0 }, material = curtain,
    shape = scene.cloth { size = { 0.75, 2.34, 0.13 }, folds = 6, segments = 120 },
  }
end
add { name = "rug", shape = scene.box { size = { 2.9, 0.014, 2.0 }, radius = 0.004 }, material = rug,
  position = { 0.05, 0.007, -0.25 } }

-- ---- sofa and cushions

for _, part in ipairs(furniture.sofa { position = { -0.1, 0, -1.75 }, width = 2.2, fabric = linen, wood = walnut }) do
  nodes[#nodes + 1] = part
end
add {
  name = "cushion", material = striped, position = { 0.03, 0.70, -1.52 }, rotation = { -16, -4, 2 },
  shape = scene.cushion { size = { 0.52, 0.48, 0.19 }, pinch = 0.05, segments = 40 },
}
add {
  name = "cushion_quilted", material = quilted, position = { -0.72, 0.68, -1.55 }, rotation = { -20, 14, -5 },
  shape = scene.cushion { size = { 0.46, 0.44, 0.18 }, quilt = 5, quilt_depth = 0.2, segments = 40 },
}
add {
  name = "cushion_rust", material = rust, position = { 0.62, 0.67, -1.56 }, rotation = { -18, -20, 6 },
  shape = scene.cushion { size = { 0.44, 0.42, 0.17 } },
}

-- ---- coffee table and the objects on it

for _, part in ipairs(furniture.coffee_table { position = { 0.1, 0, -0.35 }, size = { 1.25, 0.42, 0.6 }, wood = walnut,
                                               metal = black_steel }) do
  nodes[#nodes + 1] = part
end
-- Vase and twigs are one object with one motion, so that no pass takes the vase as background of the twigs or vice versa.
local vase_parts = furniture.twigs { position = { 0, 0.34, 0 }, seed = 4 }
table.insert(vase_parts, 1, {
  material = glaze,
    shape = scene.lathe {
      segments = 56, smooth = 5, crease = 50,
      profile = {
        { 0, 0 }, { 0.055, 0 }, { 0.062, 0.008 }, { 0.085, 0.06 }, { 0.108, 0.14 }, { 0.106, 0.22 }, { 0.078, 0.29 },
        { 0.046, 0.335 }, { 0.036, 0.37 }, { 0.042, 0.40 }, { 0.056, 0.418 }, { 0.052, 0.421 }, { 0.036, 0.40 },
        { 0.030, 0.37 }, { 0.040, 0.335 }, { 0.070, 0.29 }, { 0.096, 0.20 }, { 0.06, 0.03 }, { 0, 0.02 },
      },
    },
})
add { name = "vase", position = vase_at, scale = 1.2, motion = motion, parts = vase_parts }
add {
  name = "bowl", position = { -0.28, 0.42, -0.28 }, material = stoneware,
  shape = scene.lathe {
    segments = 48, smooth = 4,
    profile = { { 0, 0 }, { 0.05, 0 }, { 0.055, 0.012 }, { 0.11, 0.045 }, { 0.14, 0.085 }, { 0.134, 0.086 },
      { 0.1, 0.05 },
                { 0.04, 0.022 }, { 0, 0.02 } },
  },
}
for i, fruit in ipairs { { -0.05, 0, "#c8452d" }, { 0.04, 0.045, "#d8a03a" }, { 0.035, -0.045, "#8fa83c" } } do
  add {
    name = "fruit_" .. i, position = { -0.28 + fruit[1], 0.495, -0.28 + fruit[2] },
    shape = scene.superellipsoid { size = { 0.078, 0.072, 0.078 }, north = 1, east = 1, segments = 24 },
    material = material { name = "fruit " .. i, color = srgb(fruit[3]), roughness = 0.4 },
  }
end
add {
  name = "cup", position = { 0.48, 0.42, -0.22 },
  parts = {
    { material = white_paint, shape = scene.lathe { segments = 36, smooth = 3, profile = { { 0, 0 }, { 0.03, 0 },
      { 0.038, 0.03 }, { 0.041, 0.08 }, { 0.037, 0.08 }, { 0.034, 0.03 }, { 0, 0.01 } } } },
    { material = white_paint, shape = scene.torus { radius = 0.022, tube_radius = 0.005, segments = 24,
      tube_segments = 8 },
      position = { 0.045, 0.042, 0 }, rotation = { 90, 0, 0 } },
  },
}
for i, book in ipairs { { 0.26, 0.03, 0.19, "#23395b", 8 }, { 0.22, 0.024, 0.16, "#b9a06a", -14 } } do
  add {
    name = "table_book_" .. i, position = { 0.43, i == 1 and 0.435 or 0.462, -0.44 }, rotation = { 0, book[5], 0 },
    shape = scene.box { size = { book[1], book[2], book[3] }, radius = 0.003 },
    material = material { name = "table book " .. i, color = srgb(book[4]), roughness = 0.6 },
  }
end
add {
  name = "pouf", position = { 1.25, 0.2, -0.45 }, material = knit,
  shape = scene.superellipsoid { size = { 0.62, 0.4, 0.62 }, north = 0.6, east = 1, segments = 48 },
}

-- ---- lamps, shelf, plants, pictures

for _, part in ipairs(furniture.floor_lamp { name = "floor_lamp", position = { 1.32, 0, -1.85 }, metal = brass,
  shade = shade,
                                             bulb = bulb }) do
  nodes[#nodes + 1] = part
end
for _, part in ipairs(furniture.side_lamp { position = { -1.62, 0, -1.75 }, wood = walnut, body = terracotta,
  shade = shade,
                                            bulb = bulb }) do
  nodes[#nodes + 1] = part
end
for _, part in ipairs(furniture.bookshelf { position = { 2.2, 0, -2.2 }, wood = walnut, brass = brass, pot = stoneware,
                                            leaf = leaf, glaze = terracotta }) do
  nodes[#nodes + 1] = part
end
for _, part in ipairs(furniture.plant { name = "plant", position = { -2.35, 0, -1.75 }, pot = terracotta, leaf = leaf,
                                        leaves = 17, size = 1.15, seed = 7 }) do
  nodes[#nodes + 1] = part
end
for _, part in ipairs(furniture.picture { name = "painting", position = { -0.35, 1.62, -2.385 },
  size = { 1.05, 0.68 }, frame = walnut,
                                          seed = 3, colors = { "#8fb7c9", "#f3c67a", "#6f8f9b", "#4a6b5d",
                                            "#2d3f3a" } }) do
  nodes[#nodes + 1] = part
end
for _, part in ipairs(furniture.picture { name = "small_painting", position = { 0.58, 1.58, -2.385 },
  size = { 0.42, 0.56 },
                                          frame = black_steel, seed = 8,
                                          colors = { "#e9c9a0", "#d9604a", "#a8584a", "#70404a", "#33263a" } }) do
  nodes[#nodes + 1] = part
end

-- ---- light and cameras

add { name = "sun", rotation = { -21.8, -68, 0 },
      light = scene.directional_light { color = srgb "#ffd29a", intensity = 7.5 } }
add { name = "fill", position = { 1.5, 2.3, 2.6 },
  light = scene.point_light { color = srgb "#c4d8ff", intensity = 24 } }
add { name = "main_camera", position = eye, look_at = aim,
  camera = scene.camera { name = "main", fov = fov, near = 0.05 } }
add {
  name = "dolly", motion = motion,
  children = { node { name = "tracking_camera", position = { 0.34, 0.98, 1.42 }, look_at = { 0.24, 0.70, -0.9 },
                      camera = scene.camera { name = "tracking", fov = fov, near = 0.05 } } },
}

return scene {
  name = "living_room", nodes = nodes, loop = loop, shot = { width = width, height = height, fps = fps, frame = 0,
    exposure = exposure },
  environment = { sky = { 0.42, 0.45, 0.50 }, ground = { 0.30, 0.25, 0.20 }, background = { 1.15, 1.25, 1.4 } },
}
