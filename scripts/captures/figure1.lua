-- SPDX-License-Identifier: MIT
-- Figure 1 of Tan, Cui and Bhojan 2020, with the scene of the living room: a close-up of a vase whose left edge covers the left
-- edge of a cushion. The vase moves to the left by 40 px over the exposure. The exposure ends at the raster time, so background
-- that the raster image hides behind the left edge of the vase is visible earlier in the exposure. The paper makes three
-- claims. With the filter of McGuire et al., this background is hardly visible. UE4 fills it with a mirror image of the pixels
-- beside the vase, which adds a false cushion edge (yellow arrow). The hybrid has the cushion edge of ground truth (green
-- arrow).
--   strobe capture scripts/captures/figure1.lua -o out/figure1
local capture = require "strobe.capture"

local crop = { 385, 222, 150, 125 }
local true_edge = { { to = { 424, 318 }, by = { -26, 9 }, color = "green" } }

return capture {
  title = "Hybrid MBlur, figure 1",
  size = { 960, 540 },
  layers = { "velocity" },
  shots = {
    { name = "vase", scene = "living_room", ["scene.pixels"] = -40, view = { 0.95, 0.98, 2.15, 0.16, 0.80, -0.9 } },
  },
  arms = {
    { name = "original", pipeline = "none" },
    { name = "McGuire", pipeline = "mcguire2012" },
    { name = "UE4", pipeline = "ue4" },
    { name = "adaptive", pipeline = "adaptive" },
    { name = "hybrid", pipeline = "hybrid" },
    { name = "letter", pipeline = "hybrid", set = { preset = "text" } },
    { name = "truth", pipeline = "ground_truth", set = { samples = 64, times = "stratified" },
      layers = { "velocity", "inner", "error" } },
  },
  truth = "truth",
  figures = {
    {
      name = "figure1", crop = crop, zoom = 2, letters = true, width_mm = 178, text_size = 22, gap = 8,
      columns = {
        { arm = "original", label = "original scene" },
        { arm = "McGuire", label = "McGuire et al., adapted" },
        { arm = "UE4", label = "UE4-style" },
        { arm = "adaptive" },
        { arm = "truth", label = "ray-traced" },
      },
      rows = {
        { caption = "inner RMSE {rmse inner %.3f}" },
        { label = "difference", against = "truth", gain = 4 },
      },
      cells = {
        { row = 1, column = "UE4-style", arrows = { { to = { 446, 257 }, by = { 26, -9 } } } },
        { row = 1, column = "adaptive", arrows = true_edge },
        { row = 1, column = "ray-traced", arrows = true_edge, caption = "standard error {standard_error inner %.3f}" },
        { row = 2, column = "ray-traced", empty = true },
      },
    },
    -- Two interpretations of the paper: its text to the letter (preset `text`), and the preset `paper`. To the letter,
    -- a ray ends at the first hit with a luminance that differs from the luminance of the foreground. This fails here,
    -- because the pattern of the vase itself has several luminances.
    {
      name = "figure1_presets", crop = crop, zoom = 2, width_mm = 85, text_size = 22, gap = 8,
      caption = "inner RMSE {rmse inner %.3f}",
      columns = {
        { arm = "letter", label = "hybrid (text)" }, { arm = "hybrid" },
        { arm = "adaptive" }, { arm = "truth", label = "ray-traced", caption = "" },
      },
    },
  },
}
