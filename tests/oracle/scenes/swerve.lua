-- SPDX-License-Identifier: MIT
-- Two small cards within ten pixels of each other, for 96 x 64 px. At t exposures after frame 0 `fast` is displaced by
-- 44 t px and `slow` by 4 t px to the left, and both by 16 t^2 px down.
local scene = require "strobe.scene"
local pixels = require "scripts.scenes.lib.pixels"

local picture = pixels.picture(96, 64)
local exposure_s, reach, bend = picture.exposure / picture.fps, 8, 32

local function card(name, left, top) -- at the time of frame 0
  return pixels.rectangle(picture, name, { left, top, left + 4, top + 4 }, 0, pixels.flat(name, 0.9))
end

-- Quadratic, so a cubic is exact.
local function path(node, d)
  local function place(t)
    local x, y, z = table.unpack(node.position)
    return { x - d * t, y - bend * t * t / 2, z }
  end
  local function tangent(t) return { -d / exposure_s, -bend * t / exposure_s, 0 } end
  return scene.track {
    node = node.name, target = "translation", interpolation = "cubic", times = { -reach * exposure_s, reach * exposure_s },
    values = { { 0, 0, 0 }, place(-reach), tangent(-reach), tangent(reach), place(reach), { 0, 0, 0 } },
  }
end

local fast, slow = card("fast", 61, 31), card("slow", 65, 35)
local wall = pixels.rectangle(picture, "wall", { -8, -8, picture.width + 8, picture.height + 8 }, -10, pixels.flat("wall", 0.2))
return pixels.scene(picture, "swerve", { wall, fast, slow }, 0, {
  scene.animation { name = "swerve", tracks = { path(fast, 44), path(slow, 4) } },
})
