-- SPDX-License-Identifier: MIT
-- Figure 1 of Tan, Cui and Bhojan 2020, with errors against ground truth. In the first shot, a vase slides past a cushion.
-- In the second shot, a camera follows the vase.
-- For each shot, the capture checks one expectation in the region inner, the pixels of a moving object that show its
-- background at another time: the error of `adaptive` is smaller than the errors of the two baselines, McGuire 2012 and
-- UE4-style. The difference must exceed two standard errors of truth, because the noise of truth shifts each of the two
-- compared errors by at most one standard error (triangle inequality).
--   strobe demo
local capture = require "strobe.capture"

local truth = "ground truth"
local title = "Hybrid motion blur: the background of a moving object"
local note = "After figure 1 of Tan, Cui and Bhojan, \"Hybrid MBlur\" (SIGGRAPH '20 Posters): inside a moving object's " ..
             "silhouette the blur uncovers a background that the raster image does not have. hybrid (text): the paper's " ..
             "text, step by step. hybrid: the settings under which the paper's claims hold."
local baselines = { "McGuire 2012", "UE4-style" }
local crop_size, colors = { 120, 68 }, { "#ffc208", "#1abff2" }

local function less_than_baselines(shot)
  return { "in the region inner the error of adaptive is below the errors of both baselines", shot = shot, function(r)
    local function error_of(arm) return r.at { shot = shot, arm = arm, region = "inner" }.rmse end
    local own, best, noise = error_of "adaptive", math.huge, error_of(truth)
    for _, name in ipairs(baselines) do best = math.min(best, error_of(name)) end
    return own + 2 * noise < best,
      ("RMSE %.5f, %.2f of the better baseline's; truth's standard error %.5f"):format(own, own / best, noise)
  end }
end

local shots = {
  { name = "object", title = "An object in motion", scene = "living_room", camera = "main", truth = { samples = 256 },
    crops = { { 480, 232, 120, 68 }, "inner" } },
  { name = "tracking", title = "A tracking shot", scene = "living_room", camera = "tracking", truth = { samples = 64 },
    crops = { { 400, 195, 120, 68 }, "inner" } },
}

-- Rows of the figure. Each shot has a row of pictures, a row for each crop, and a row of differences from truth.
local rows, cells = {}, {}
local function add(row, of_truth)
  rows[#rows + 1] = row
  of_truth.row, of_truth.column = #rows, truth
  cells[#cells + 1] = of_truth
end
for _, shot in ipairs(shots) do
  local boxes, crops = {}, {}
  for i, crop in ipairs(shot.crops) do
    crops[i] = crop == "inner" and { "inner", crop_size[1], crop_size[2] } or crop
    boxes[i] = { area = crops[i], color = colors[i], width = 2 }
  end
  add({ shot = shot.name, title = shot.title, boxes = boxes, caption = "RMSE inner {rmse inner}, whole {rmse}",
        note = "{size}, exposure {exposure} of 1/{fps} s, anchor {anchor}, median displacement of moving " ..
               "surfaces {displacement} over the exposure" },
      { caption = "standard error of truth: whole {standard_error}, inner {standard_error inner}, hidden " ..
                  "{standard_error hidden}, outer {standard_error outer}" })
  for i, crop in ipairs(crops) do
    local where = crop[1] == "inner" and "inner blur" or ("crop at %d,%d"):format(crop[1], crop[2])
    add({ shot = shot.name, label = where, crop = crop, frame = colors[i] }, {})
  end
  add({ shot = shot.name, label = "difference", against = truth, difference = "channels", gain = 4, boxes = boxes },
      { empty = true })
end

return capture {
  title = title,
  note = note,
  size = { 960, 540 },
  shots = shots,
  layers = {},
  arms = {
    { name = "no blur", pipeline = "none" },
    { name = "McGuire 2012", pipeline = "mcguire2012" },
    { name = "UE4-style", pipeline = "ue4" },
    { name = "hybrid (text)", pipeline = "hybrid", set = { preset = "text" } },
    { name = "hybrid", pipeline = "hybrid" },
    { name = "adaptive", pipeline = "adaptive" },
    { name = "ray-traced, 16 samples", pipeline = "ground_truth", role = "floor", shown = false,
      set = { samples = 16, times = "midpoint" } },
    { name = truth, pipeline = "ground_truth", set = { times = "stratified" },
      layers = { "inner", "hidden", "outer", "error", "velocity", "id" } },
  },
  truth = truth,
  measures = { "rmse", "flip", "ms" },
  background = { arm = "hybrid", front = "no blur", color = "revealed", valid = "revealed_valid" },
  expect = { less_than_baselines "object", less_than_baselines "tracking" },
  layout = { pictures = { crop_size = crop_size, difference_gain = 4 } },
  figures = {
    {
      name = "demo", title = title,
      note = note .. " Errors are RMSE of linear values against truth: whole picture and region inner (the silhouette).",
      cell_width = 480, text_size = 24, gap = 10, margin = 28, rows = rows, cells = cells,
      columns = {
        { arm = "no blur" }, { arm = "McGuire 2012" }, { arm = "UE4-style" }, { arm = "hybrid (text)" },
        { arm = "hybrid" }, { arm = "adaptive" }, { arm = truth },
      },
    },
  },
}
