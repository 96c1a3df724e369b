-- SPDX-License-Identifier: MIT
-- Measures the error of frozen shading: all methods except ground truth use the light, shadows and highlights of the raster
-- time for the whole exposure.
--   strobe sweep experiments/shading_under_motion/shading_under_motion.lua -o out/shading_under_motion
local experiment = require "strobe.experiment"

local none, mcguire, ue4, best = "no blur", "McGuire 2012", "UE4-style", "adaptive"
local floor, moving = "truth, 16 samples", "truth, light in motion"
local in_pictures = { lamp = true, shadow = true, gloss = true }

local function at(r, shot, arm, region) return r.at { shot = shot, arm = arm, region = region or "whole" } end

-- Returns the RMS difference between two ground truths: with frozen shading, and with shading at each time sample (full).
local function freezing(r, shot, region) return at(r, shot, "ground truth", region).rmse_full end

-- Returns the share of a method's squared error that frozen shading causes: 1 - (error against frozen truth / error against
-- full truth)^2.
local function share(r, shot, arm, region)
  local full, frozen = at(r, shot, arm, region).rmse_full, at(r, shot, arm, region).rmse
  return 1 - frozen * frozen / (full * full)
end

-- Returns the expectation that the share of frozen shading in an arm's squared error is between `least` and `most`, in all
-- `shots`.
local function of_shading(arm, shots, least, most, text)
  return { text, function(r)
    local low, high, where_low, where_high = math.huge, -math.huge, "", ""
    for _, shot in ipairs(shots) do
      local value = share(r, shot, arm)
      if value < low then low, where_low = value, shot end
      if value > high then high, where_high = value, shot end
    end
    return low >= least and high <= most, ("%.2f (%s) to %.2f (%s)"):format(low, where_low, high, where_high)
  end }
end

return experiment {
  title    = "Shading under motion",
  question = "How much of the methods' error is frozen shading?",
  note     = "`RMSE` is against truth with the shading of the raster time (frozen). `RMSE, full` is against truth with " ..
             "moving light, shadows and highlights. The row of truth has the RMS difference of the two truths. Surfaces " ..
             "reflect only the sky, so reflections of objects are not measured.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "lamp", title = "A lamp passes objects at rest", scene = "objects/lamp",
      note = "No visible surface moves, so frozen truth and every method give the rasterised image." },
    { name = "shadow", title = "The shadow of a moving ball", scene = "objects/shadow",
      note = "The ball is blurred, its shadow is not." },
    { name = "gloss", title = "A glazed vase turns", scene = "objects/gloss",
      note = "Frozen shading moves with the surface. So highlights that are at rest are blurred, and each side of " ..
             "the vase keeps the light that it has at the raster time." },
    { name = "telescope", title = "A telescope turns to the camera", scene = "objects/telescope" },
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 26,
      note = "The vase slides. Truth with full shading moves its shadow on the table and the highlights on its glaze." },
    { name = "car", title = "A tracking shot", scene = "objects/car_and_road", ["scene.pixels"] = 60 },
  },
  arms     = {
    { name = none, pipeline = "none" },
    { name = mcguire, pipeline = "mcguire2012" },
    { name = ue4, pipeline = "ue4" },
    { name = best, pipeline = "adaptive" },
    { name = floor, pipeline = "ground_truth", role = "floor", set = { samples = 16, times = "midpoint" } },
    { name = moving, pipeline = "ground_truth", role = "floor",
      set = { samples = 256, times = "stratified", shading = "full" } },
  },
  skip     = function(point) return point.arm == moving and not in_pictures[point.shot] end,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" }, full = { shading = "full" } },
  regions  = { "whole", "inner", "outer", "moving" },
  measures = { "rmse", "rmse_full", "flip" },
  expect   = {
    { "if a lamp passes objects at rest, all methods give the same picture, and frozen shading causes at least 0.98 " ..
      "of the squared error of this picture against full truth", shot = "lamp", function(r)
        local same, least = true, 1
        for _, arm in ipairs { none, mcguire, ue4, best } do
          same = same and at(r, "lamp", arm).rmse == at(r, "lamp", none).rmse
          least = math.min(least, share(r, "lamp", arm))
        end
        return same and least >= 0.98, ("%.3f; the rest is at silhouettes, where raster and rays differ; RMSE %.4f " ..
          "against full truth"):format(least, at(r, "lamp", none).rmse_full)
      end },
    of_shading(best, { "shadow", "gloss" }, 0.8, 1,
      "if a shadow or a highlight moves, at least four fifths of adaptive's squared error are frozen shading"),
    of_shading(mcguire, { "telescope", "vase", "car" }, -1, 0.5,
      "if objects move in constant light, at most half of McGuire's squared error is frozen shading"),
    of_shading(mcguire, { "telescope", "vase", "car" }, -1, 0.05, "found afterwards: if objects move in constant light, " ..
      "at most a twentieth of McGuire's squared error is frozen shading"),
    of_shading(best, { "telescope", "vase", "car" }, 0.25, 1,
      "found afterwards: if objects move in constant light, at least a quarter of adaptive's squared error is " ..
      "frozen shading, because adaptive has correct visibility, so that mainly the error of the light remains"),
    { "found afterwards: for the glazed vase that turns, the sharp picture has a smaller error than exact blur with " ..
      "frozen light",
      shot = "gloss", function(r)
        local sharp, frozen = at(r, "gloss", none).rmse_full, freezing(r, "gloss")
        return sharp < frozen, ("RMSE %.4f, frozen truth %.4f"):format(sharp, frozen)
      end },
  },
  layout   = { pictures = { crop_size = { 120, 68 } }, table = {} },
}
