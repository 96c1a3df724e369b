-- SPDX-License-Identifier: MIT
-- Full layers, drawn everywhere, against masked rays and rays at their own time; and what else has been done since 2020.
--   strobe sweep experiments/peers/peers.lua -o out/peers
local experiment = require "strobe.experiment"

-- Why a failed expectation fails.
local own_rays = "layers of raster have rays for their light alone, while samples at their own time need one each: of the " ..
                 "two costs, rays and scenes drawn again, each has more of one"

local shots = { "vase", "three", "enters", "tracking" }
local layers, best = "layers 2024", "hybrid, best"

local function at(r, shot, arm, region) return r.at { shot = shot, arm = arm, region = region } end

-- In a region of every shot that has one, the error of `arm` is at most `factor` times that of `other`.
local function below(arm, other, region, factor, text)
  return { text, function(r)
    local most, where = 0, ""
    for _, shot in ipairs(shots) do
      local ratio = at(r, shot, arm, region).rmse / at(r, shot, other, region).rmse
      if ratio > most then most, where = ratio, shot end
    end
    return most <= factor, ("at most %.2f of it (%s)"):format(most, where)
  end }
end

return experiment {
  title    = "Peers since 2020",
  question = "What do full layers drawn everywhere leave to masked rays, and what do other blurs since 2020 do?",
  note     = "All at 16 samples but for temporal1, which has one ray per pixel. Rays are those of shading too: a shadow ray " ..
             "for each light of each texel that is shaded, unless its tile is answered at once.",
  size     = { 160, 90 },
  size_params = { "width", "height" },
  shots    = {
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 20 },
    { name = "three", title = "Three movers", scene = "objects/stacked", ["scene.count"] = 3, ["scene.pixels"] = 26 },
    { name = "enters", title = "Leaves and enters", scene = "objects/enters", ["scene.pixels"] = 50 },
    { name = "tracking", title = "Tracking shot", scene = "objects/tracking_parallax" },
  },
  arms     = {
    { name = "Jimenez 2014", pipeline = "jimenez2014" },
    { name = "Bevy", pipeline = "bevy" },
    { name = "HDRP", pipeline = "hdrp" },
    { name = "temporal1", pipeline = "temporal1" },
    { name = layers, pipeline = "layers2024" },
    { name = best, pipeline = "hybrid_traced" },
    { name = "truth, 16 samples", pipeline = "ground_truth", role = "floor", set = { samples = 16, times = "midpoint" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  regions  = { "whole", "inner", "hidden", "outer" },
  measures = { "rmse", "flip", "rays" },
  expect   = {
    below(layers, "Jimenez 2014", "hidden", 1, "full layers err less than a post-process where the capture saw nothing"),
    below(best, layers, "inner", 1, "the hybrid (best) errs less than full layers inside silhouettes"),
    below(best, layers, "hidden", 1, "the hybrid (best) errs less than full layers where the capture saw nothing"),
    { "and for fewer rays", known = own_rays, function(r)
      local most, where = 0, ""
      for _, shot in ipairs(shots) do
        local ratio = at(r, shot, best, "whole").rays / at(r, shot, layers, "whole").rays
        if ratio > most then most, where = ratio, shot end
      end
      return most < 1, ("at most %.2f times as many (%s)"):format(most, where)
    end },
  },
  layout   = { front = { x = "rays", y = "rmse", region = "whole" }, table = {} },
}
