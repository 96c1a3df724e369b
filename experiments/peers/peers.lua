-- SPDX-License-Identifier: MIT
-- Compares the pipelines hybrid_layered and adaptive with other methods since 2020. hybrid_layered traces rays at masked
-- pixels, and adaptive traces rays at several times. One of the other methods (Lee et al. 2024) draws several full layers by
-- depth peeling instead.
--   strobe sweep experiments/peers/peers.lua -o out/peers
local experiment = require "strobe.experiment"

-- Reasons why some of the expectations below failed; reports print these reasons.
local own_rays = "rasterised layers need rays only for light, while adaptive traces rays at several times. " ..
                 "For each rasterised layer, however, the scene is drawn again"

local shots = { "vase", "three", "enters", "tracking" }
local layers, best = "layers 2024", "adaptive"

local function at(r, shot, arm, region) return r.at { shot = shot, arm = arm, region = region } end

-- Returns the expectation that, in every shot, the error of `arm` in a region is at most `factor` times the error of the arm
-- `other`.
local function below(arm, other, region, factor, text)
  return { text, function(r)
    local most, where = 0, ""
    for _, shot in ipairs(shots) do
      local ratio = at(r, shot, arm, region).rmse / at(r, shot, other, region).rmse
      if ratio > most then most, where = ratio, shot end
    end
    return most <= factor, ("at most %.2f times the error (%s)"):format(most, where)
  end }
end

return experiment {
  title    = "Peers since 2020",
  question = "Compared with full layers drawn at every pixel, and with other blurs since 2020, how large are the errors of " ..
             "hybrid_layered, which traces rays at masked pixels, and of adaptive, which traces rays at several times?",
  note     = "All methods have 16 samples, except oberberger2022 with one ray per pixel. Rays include shadow rays: one for " ..
             "each light and shaded texel, unless the light is visible or blocked in the whole tile.",
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
    { name = "oberberger2022", pipeline = "oberberger2022" },
    { name = layers, pipeline = "lee2024" },
    { name = "hybrid_layered", pipeline = "hybrid_layered" },
    { name = best, pipeline = "adaptive" },
    { name = "truth, 16 samples", pipeline = "ground_truth", role = "floor", set = { samples = 16, times = "midpoint" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  regions  = { "whole", "inner", "hidden", "outer" },
  measures = { "rmse", "flip", "rays" },
  expect   = {
    below(layers, "Jimenez 2014", "hidden", 1, "full layers have a smaller error than Jimenez 2014 in disoccluded regions"),
    below(best, layers, "inner", 1, "adaptive has a smaller error than full layers inside silhouettes"),
    below(best, layers, "hidden", 1, "adaptive has a smaller error than full layers in disoccluded regions"),
    { "adaptive traces fewer rays than full layers", known = own_rays, function(r)
      local most, where = 0, ""
      for _, shot in ipairs(shots) do
        local ratio = at(r, shot, best, "whole").rays / at(r, shot, layers, "whole").rays
        if ratio > most then most, where = ratio, shot end
      end
      return most < 1, ("at most %.2f times as many rays (%s)"):format(most, where)
    end },
  },
  layout   = { front = { x = "rays", y = "rmse", region = "whole" }, table = {} },
}
