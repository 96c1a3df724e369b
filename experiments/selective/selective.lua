-- SPDX-License-Identifier: MIT
-- One number from a post-process blur to truth: is its curve of error against cost the front of everything else?
--   strobe sweep experiments/selective/selective.lua -o out/selective
local experiment = require "strobe.experiment"

local width, height = 160, 90

local function shot(name, title, scene, more)
  local one = { name = name, title = title, scene = scene }
  if scene ~= "cards" then one["scene.width"], one["scene.height"] = width, height end
  for key, value in pairs(more or {}) do one[key] = value end
  return one
end

local shots = {
  shot("room", "Living room", "living_room", { camera = "main", ["scene.pixels"] = 14 }),
  shot("room_tracking", "Living room, tracking", "living_room", { camera = "tracking", ["scene.pixels"] = 14 }),
  shot("vase", "Vase and cushion", "vase_and_cushion", { ["scene.pixels"] = 12 }),
  shot("turns_back", "Turns back", "turns_back", { anchor = "centre", frame = 1 }),
  shot("behind", "Behind", "behind"),
  shot("cards", "Cards", "cards"),
}
-- How far things go, px: as shares of the picture what the scenes have at 480x270.
local objects = { { "caged_fan", 27 }, { "car_and_road", 33 }, { "door", 33 }, { "enters", 33 }, { "leaves", 20 }, { "nearer" },
  { "pendulum", 33 }, { "spoked_wheel", 20 }, { "stacked", 27 }, { "telescope", 33 }, { "tracking_parallax", 17 } }
local oracles = { "bar", "half_plane", "hidden_white", "quad_2d", "textured_bar", "wedge" }
local properties = { "crowd", "extreme", "grazing", "passage" }
local function add(folder, names)
  for _, of in ipairs(names) do
    local name, pixels = of, nil
    if type(of) == "table" then name, pixels = of[1], of[2] end
    local title = name:gsub("_", " "):gsub("^%l", string.upper)
    shots[#shots + 1] = shot(name, title, folder .. "/" .. name, { ["scene.pixels"] = pixels })
  end
end
add("objects", objects)
add("oracles", oracles)
add("stability", properties)
shots[#shots + 1] = shot("planes", "Planes", "stability/planes", { ["scene.kind"] = 2, ["scene.velocity_x"] = 1 })

local arms, others, own = {}, {}, {}
local base = "McGuire 2012"
local function arm(list, name, pipeline, set)
  arms[#arms + 1] = { name = name, pipeline = pipeline, set = set or {} }
  list[#list + 1] = name
end
arm(others, base, "mcguire2012")
arm(others, "no blur", "none")
for _, preset in ipairs { "seed", "captured", "layers", "best" } do
  arm(others, "hybrid, " .. preset, "hybrid", { preset = preset })
end
arm(others, "Guertin 2014", "guertin2014")
arm(others, "Jimenez 2014", "jimenez2014")
arm(others, "UE4-style", "ue4")
arm(others, "Bevy", "bevy")
arm(others, "HDRP", "hdrp")
arm(others, "layers 2024", "layers2024")
arm(others, "temporal1", "temporal1")
for _, samples in ipairs { 4, 8, 16, 32, 64 } do
  arm(others, ("truth, %d"):format(samples), "ground_truth", { samples = samples, mark_regions = false })
end
local efforts = { 0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8 }
for _, effort in ipairs(efforts) do arm(own, ("effort %g"):format(effort), "selective", { effort = effort }) end

return experiment {
  title = "Selective", question = "?", size = { width, height },
  shots = shots, arms = arms, truth = { pipeline = "ground_truth", set = { samples = 512, mark_regions = false } }, base = base,
  rounds = 3, regions = { "whole" }, measures = { "rmse", "ms_ratio", "rays" },
  expect = {}, layout = { table = {} },
}
