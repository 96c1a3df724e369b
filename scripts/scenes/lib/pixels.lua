-- SPDX-License-Identifier: MIT
-- Shared parts of the scenes with known exact pictures (scenes/oracles): an orthographic camera with one unit per pixel of a
-- `width` x `height` picture, and rectangles placed in pixels (x right, y down, from the top left corner). Materials are unlit.
local scene = require "strobe.scene"

local pixels = {}

-- Returns the parameters that these scenes share: size of the picture, frame rate and exposure. Displacements are over this
-- exposure. `width`, `height`: default size, px.
function pixels.picture(width, height)
  return {
    width = scene.param("width", width), height = scene.param("height", height),
    fps = scene.param("fps", 24), exposure = scene.param("exposure", 0.5),
  }
end

-- Returns a motion by (dx, dy) px over the exposure. At frame 0, the node is at the position in its table.
function pixels.motion(picture, dx, dy)
  local per_second = picture.fps / picture.exposure
  return { velocity = { dx * per_second, -(dy or 0) * per_second, 0 } }
end

-- Returns a rectangle that covers the pixels [left, right) x [top, bottom). `edges`: { left, top, right, bottom }, px. `z`:
-- position in depth; a larger z is nearer.
function pixels.rectangle(picture, name, edges, z, material, motion)
  local left, top, right, bottom = edges[1], edges[2], edges[3], edges[4]
  return scene.node {
    name = name, motion = motion, material = material,
    position = { (left + right) / 2 - picture.width / 2, picture.height / 2 - (top + bottom) / 2, z },
    shape = scene.quad { size = { right - left, bottom - top } },
  }
end

function pixels.flat(name, color)
  return scene.material { name = name, color = { color, color, color }, unlit = true }
end

-- Returns an unlit material with a texture of `width` x `height` texels, which is sampled without a filter.
function pixels.textured(name, width, height, texels)
  local texture = scene.texture.texels { width = width, height = height, texels = texels, wrap = "clamp" }
  return scene.material { name = name, color_texture = texture, unlit = true }
end

-- Returns `count` grey texels in stripes: the values `a` and `b` alternate every `period` texels.
function pixels.stripes(count, period, a, b)
  local texels = {}
  for i = 0, count - 1 do
    local value = i // period % 2 == 0 and a or b
    texels[#texels + 1] = { value, value, value }
  end
  return texels
end

function pixels.scene(picture, name, nodes, background, animations)
  nodes[#nodes + 1] = scene.node {
    name = "camera", position = { 0, 0, 100 },
    camera = scene.orthographic_camera { name = "main", half_height = picture.height / 2, near = 1 },
  }
  local sky = background or 0
  return scene {
    name = name, nodes = nodes, animations = animations, environment = { background = { sky, sky, sky } },
    shot = { width = picture.width, height = picture.height, fps = picture.fps, frame = 0,
      exposure = picture.exposure },
  }
end

return pixels
