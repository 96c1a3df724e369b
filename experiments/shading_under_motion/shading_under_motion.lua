-- SPDX-License-Identifier: MIT
-- What methods freeze: light, shadows and highlights are those of the capture in all but truth.
--   strobe sweep experiments/shading_under_motion/shading_under_motion.lua -o out/shading_under_motion
local experiment = require "strobe.experiment"

local none, mcguire, ue4, best = "no blur", "McGuire 2012", "UE4-style", "hybrid, best"
local floor, moving = "truth, 16 samples", "truth, light in motion"
local in_pictures = { lamp = true, shadow = true, gloss = true }

local function at(r, shot, arm, region) return r.at { shot = shot, arm = arm, region = region or "whole" } end

-- RMS by which truth changes where its light moves too.
local function freezing(r, shot, region) return at(r, shot, "ground truth", region).rmse_full end

-- The part of a method's squared error against full truth that is left where its error against frozen truth is taken away.
local function share(r, shot, arm, region)
  local full, frozen = at(r, shot, arm, region).rmse_full, at(r, shot, arm, region).rmse
  return 1 - frozen * frozen / (full * full)
end

-- In every one of `shots`, the share of frozen shading in an arm's squared error is at least, or at most, so much.
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
  question = "What do methods freeze, and how much of their error is that?",
  note     = "`RMSE` is against truth that is shaded as at the capture, `RMSE, full` against truth in which light, shadows " ..
             "and highlights move too; the truth's own row has the difference of the two. Surfaces mirror the sky alone, so " ..
             "that there are no reflections of things to freeze.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "lamp", title = "A lamp goes by things at rest", scene = "objects/lamp",
      note = "Nothing that is seen moves: frozen truth is the picture of the capture, and so is every method's." },
    { name = "shadow", title = "A mover's shadow", scene = "objects/shadow",
      note = "The ball blurs, its shadow does not." },
    { name = "gloss", title = "A glazed vase turns", scene = "objects/gloss",
      note = "Light is carried along with the surface: highlights are smeared that stand, and sides are lit as they were " ..
             "when they faced elsewhere." },
    { name = "telescope", title = "A telescope turns to the camera", scene = "objects/telescope" },
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 26,
      note = "The vase slides: shadows on the table and highlights on the glaze go with it or not." },
    { name = "car", title = "A tracking shot", scene = "objects/car_and_road", ["scene.pixels"] = 60 },
  },
  arms     = {
    { name = none, pipeline = "none" },
    { name = mcguire, pipeline = "mcguire2012" },
    { name = ue4, pipeline = "ue4" },
    { name = best, pipeline = "hybrid_traced" },
    { name = floor, pipeline = "ground_truth", role = "floor", set = { samples = 16, times = "midpoint" } },
    { name = moving, pipeline = "ground_truth", role = "floor",
      set = { samples = 256, times = "stratified", shading = "full" } },
  },
  skip     = function(point) return point.arm == moving and not in_pictures[point.shot] end,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" }, full = { shading = "full" } },
  regions  = { "whole", "inner", "outer", "moving" },
  measures = { "rmse", "rmse_full", "flip" },
  expect   = {
    { "a lamp that goes by is frozen whole: all methods leave one picture, and of its squared error against full truth all " ..
      "but a fiftieth is frozen shading", shot = "lamp", function(r)
        local same, least = true, 1
        for _, arm in ipairs { none, mcguire, ue4, best } do
          same = same and at(r, "lamp", arm).rmse == at(r, "lamp", none).rmse
          least = math.min(least, share(r, "lamp", arm))
        end
        return same and least >= 0.98, ("%.3f; the rest are silhouettes that raster and rays place otherwise; RMSE %.4f " ..
          "against full truth"):format(least, at(r, "lamp", none).rmse_full)
      end },
    of_shading(best, { "shadow", "gloss" }, 0.8, 1,
      "of the hybrid's squared error, at least four fifths is frozen shading where a shadow or a highlight moves"),
    of_shading(mcguire, { "telescope", "vase", "car" }, -1, 0.5,
      "of McGuire's, at most half wherever things move in light that stands"),
    of_shading(mcguire, { "telescope", "vase", "car" }, -1, 0.05, "found afterwards: at most a twentieth there"),
    of_shading(best, { "telescope", "vase", "car" }, 0.25, 1,
      "found afterwards: of the hybrid's at least a quarter there: with visibility mended, light is what is left"),
    { "found afterwards: a glazed vase that turns is nearer to truth sharp than blurred rightly with frozen light",
      shot = "gloss", function(r)
        local sharp, frozen = at(r, "gloss", none).rmse_full, freezing(r, "gloss")
        return sharp < frozen, ("RMSE %.4f, frozen truth %.4f"):format(sharp, frozen)
      end },
  },
  layout   = { pictures = { crop_size = { 120, 68 } }, table = {} },
}
