-- SPDX-License-Identifier: MIT
-- Shots of all scenes of the repository except the exhibits, for experiments that compare methods over all scenes. Pictures
-- are 160x90, except for the scene `cards`. The scenes in scenes/objects are made for 480x270, so they get a third of their
-- default displacements, px.

-- Scenes, and their displacements in a picture of 160x90, px. An entry without a number has the displacement of the
-- scene's file.
local objects = { { "caged_fan", 27 }, { "car_and_road", 33 }, { "door", 33 }, { "enters", 33 }, { "leaves", 20 }, { "nearer" },
  { "pendulum", 33 }, { "spoked_wheel", 20 }, { "stacked", 27 }, { "telescope", 33 }, { "tracking_parallax", 17 } }
local oracles = { { "bar" }, { "half_plane" }, { "hidden_white" }, { "quad_2d" }, { "textured_bar" }, { "wedge" } }
local properties = { { "crowd" }, { "extreme" }, { "grazing" }, { "passage" } }

local all_shots = {}

-- Names of the shots with a moving camera. In all other shots the camera is static.
all_shots.moving_camera = { "room_tracking", "car_and_road", "tracking_parallax" }

-- Returns the shots, for pictures of 160x90.
function all_shots.list()
  local shots = {}
  local function shot(name, title, scene, more)
    local one = { name = name, title = title, scene = scene }
    if scene ~= "cards" then one["scene.width"], one["scene.height"] = 160, 90 end
    for key, value in pairs(more or {}) do one[key] = value end
    shots[#shots + 1] = one
  end
  local function add(folder, scenes)
    for _, scene in ipairs(scenes) do
      local name, pixels = scene[1], scene[2]
      shot(name, name:gsub("_", " "):gsub("^%l", string.upper), folder .. "/" .. name, { ["scene.pixels"] = pixels })
    end
  end
  shot("room", "Living room", "living_room", { camera = "main", ["scene.pixels"] = 14 })
  shot("room_tracking", "Living room, tracking", "living_room", { camera = "tracking", ["scene.pixels"] = 14 })
  shot("vase", "Vase and cushion", "vase_and_cushion", { ["scene.pixels"] = 12 })
  shot("turns_back", "Turns back", "turns_back", { anchor = "centre", frame = 1 })
  shot("behind", "Behind", "behind")
  shot("cards", "Cards", "cards")
  add("objects", objects)
  add("oracles", oracles)
  add("stability", properties)
  shot("planes", "Planes", "stability/planes", { ["scene.kind"] = 2, ["scene.velocity_x"] = 0.83 })
  return shots
end

return all_shots
