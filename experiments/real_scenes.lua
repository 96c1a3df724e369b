-- SPDX-License-Identifier: MIT
-- Real scenes: an object moves about 40 px over the exposure before a background with detail, nothing clamped.
-- Expected, written before measuring: wherever the background's standard deviation over `inner` is at least a fifth of
-- its mean difference from what is in front, the RMSE of the hybrid (best) in `inner` against frozen truth is at most
-- one fifth of each baseline's in the same anchor, and at most 1.5 times the floor of 16 samples.
--   strobe demo experiments/real_scenes.lua -o out/real_scenes --markdown docs/real_scenes.md
-- Two of the scenes are shared data (STROBE_DATA); without them their shots are skipped.
local demo = require "strobe.demo"

local baselines = { "McGuire 2012", "UE4-style" }
local truth, full = { samples = 128 }, { shading = "full", samples = 16 }

-- The same motion for several nodes that belong together.
local function together(motion, nodes)
  local moves = {}
  for _, name in ipairs(nodes) do moves[name] = motion end
  return moves
end

local kitchen = "shared:scenes/country_kitchen/country_kitchen.glb"
local kitchen_by = "\"Country Kitchen\" by Jay-Artist, CC BY 3.0, pbrt version by Benedikt Bitterli; converted, simplified"

return demo {
  title = "An object in motion in real scenes",
  note = "The expectation: where the background varies by at least a fifth of its difference from the front, the hybrid's " ..
         "error inside the silhouette is at most a fifth of each baseline's and 1.5 times the floor of its own 16 samples.",
  size = { 960, 540 },
  crop_size = { 120, 68 },
  measures = { "rmse", "flip", "ms" },
  background = { column = "hybrid (best)", front = "no blur", color = "revealed", valid = "revealed_valid" },
  expectation = { column = "hybrid (best)", baselines = baselines, region = "inner", share = 0.2, floor = 1.5,
                  contrast = 0.2 },
  columns = {
    { label = "no blur", pipeline = "none" },
    { label = "McGuire 2012", pipeline = "mcguire2012", own_anchor = "centre" },
    { label = "UE4-style", pipeline = "ue4", set = { limit = 0.1 }, own_anchor = "centre" },
    { label = "hybrid (as published)", pipeline = "hybrid", set = { preset = "seed" } },
    { label = "hybrid (as published, uniform weights)", pipeline = "hybrid", set = { preset = "seed_linear" }, shown = false },
    { label = "hybrid (best)", pipeline = "hybrid", set = { preset = "best" } },
    { label = "hybrid (best, termination motion)", pipeline = "hybrid", set = { termination = "motion" }, shown = false },
    { label = "truth, 16 samples", pipeline = "ground_truth", role = "floor", shown = false,
      set = { samples = 16, times = "midpoint" } },
    { label = "ground truth", pipeline = "ground_truth", role = "truth", set = { times = "stratified" } },
  },
  shots = {
    { title = "Living room", note = "The vase and its twigs slide past the cushions.", scene = "living_room",
      camera = "main", truth = truth, full_shading = full, crops = { "inner" } },
    { title = "Country kitchen, pot",
      note = "The steel pot slides along the picture plane, behind the saucepan, before tiles and hood.",
      scene = kitchen, exposure = 0.5, moves = { Mesh080_SteelPot = { 0.4, 0, -0.195 } },
      truth = truth, full_shading = full, crops = { "inner" }, attribution = kitchen_by },
    { title = "Country kitchen, mug", note = "The mug slides over the edge of the worktop, before chairs and floor.",
      scene = kitchen, exposure = 0.5, moves = { Mesh036_WhitePot = { 0.34, 0, 0 } },
      truth = truth, full_shading = full, crops = { "inner" }, attribution = kitchen_by },
    { title = "Country kitchen, lamp",
      note = "The lamp swings before the bars of the window. It is made of four instances, one behind the other.",
      scene = kitchen, exposure = 0.5,
      moves = together({ 0.5, 0, 0 }, { "Mesh052_Lamp", "Mesh050_LampInside", "Mesh055_Bulb", "Mesh053_LampCable" }),
      truth = truth, full_shading = full, crops = { "inner" }, attribution = kitchen_by },
    { title = "Modern living room", note = "The small red bowl slides over the table before two vases.",
      scene = "shared:scenes/modern_living_room_partial/modern_living_room_partial.glb", exposure = 0.5,
      moves = { Mesh017_Glass = { -0.25, 0, -0.122 } }, truth = truth, full_shading = full, crops = { "inner" },
      attribution = "\"The Modern Living Room\" by Wig42, CC BY 3.0, tungsten version by Benedikt Bitterli; 28 of 35 meshes" },
  },
}
