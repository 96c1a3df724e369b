-- SPDX-License-Identifier: MIT
-- Compares the pipeline `adaptive` with rival designs that were considered in its place.
--   cd experiments/adaptive_design; strobe sweep adaptive_design.lua -o out/adaptive_design
local experiment = require "strobe.experiment"
local all_shots  = require "scripts.scenes.lib.all_shots"

local shots, pixels = all_shots.list(), 160 * 90
local base = "McGuire 2012"
local arms, adaptive = { { name = base, pipeline = "mcguire2012" } }, {}  -- all arms; names of the arms with adaptive

-- Appends one arm to the list `arms`, and its name to the list `names`.
local function arm(names, name, pipeline, set)
  arms[#arms + 1] = { name = name, pipeline = pipeline, timed = true, set = set }
  names[#names + 1] = name
end

-- The ends of the curve are a post-process blur (0) and ground truth with 64 samples (0.8).
for _, quality in ipairs { 0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8 } do
  arm(adaptive, ("quality %g"):format(quality), "adaptive", { quality = quality })
end

-- Rival designs. Each is compared with adaptive by time and by rays, in shots with a static and with a moving camera. Fields:
-- title
-- set(i)  settings of the rival's arm i, which has counts[i] samples
-- below   comparisons that the rival is expected to win: at some cost its error is smaller than the error of adaptive
-- why     reason of the expectations
-- known   reason of each failed expectation, by comparison
local counts = { 4, 16, 64 }
local rivals = {
  { title = "prediction", pipeline = "prediction", set = function(i) return { samples = counts[i] } end, below = {},
    why = "the prediction follows raster surfaces along straight paths. It finds the surfaces of few samples at " ..
          "silhouettes and of no samples on rotating objects, and each sample without a found surface gets a ray" },
  { title = "poses", pipeline = "poses", set = function(i) return { poses = counts[i], quality = 0.2 * i } end,
    below = { "moving camera, rays" },
    why = "an image rasterised at another time needs no rays except for shading, but it is drawn for the whole picture. " ..
          "Images are averaged only in cells without a static surface, and a static camera has hardly any such cell" },
  { title = "all times", pipeline = "all_times", set = function(i) return { samples = counts[i] } end, below = {},
    why = "a pixel whose colour does not change gets as many rays as a silhouette",
    known = { ["moving camera, time"] = "with 16 samples its error is a sixth smaller: before a moving camera most " ..
                                        "pixels change their colour, so adaptive traces most of them as well" } },
  { title = "steps", pipeline = "steps", set = function(i) return { steps = 2 ^ i // 1 | 0 } end,
    below = { "static camera, rays", "moving camera, rays" },
    why = "a step needs no rays except for shading, but the blur of a step invents the background of its silhouettes, and " ..
          "each step draws and filters the whole picture" },
  { title = "EEVEE", pipeline = "eevee", set = function(i) return { steps = 2 ^ i // 1 | 0 } end, below = {},
    why = "each step is drawn, filtered and shaded as a picture of its own",
    known = { ["moving camera, rays"] = "the shadow rays of a few pictures are fewer than the rays of adaptive, which " ..
                                        "traces all uncertain pixels",
              ["moving camera, time"] = "with 4 steps its error is four per cent smaller; with more steps, the error of " ..
                                        "adaptive is smaller" } },
  { title = "truth", pipeline = "ground_truth", set = function(i) return { samples = counts[i], mark_regions = false } end,
    below = {}, why = "each sample is traced and shaded" },
}
for _, rival in ipairs(rivals) do
  for i, samples in ipairs(counts) do arm(rival, ("%s, %d"):format(rival.title, samples), rival.pipeline, rival.set(i)) end
end

-- ---- classes of shots, and curves

local classes = { { title = "static camera" }, { title = "moving camera" } }
local moves = {}
for _, name in ipairs(all_shots.moving_camera) do moves[name] = true end
for _, shot in ipairs(shots) do
  local class = classes[moves[shot.name] and 2 or 1]
  class[#class + 1] = shot.name
end

-- Returns the cost and the error of an arm, as means over a class of shots (static or moving camera). The error is the
-- geometric mean of the ratios to the arm `base`. `cost`: "time" for the geometric mean of the ratios of frame times to `base`,
-- "rays" for the mean of the rays per pixel.
local function mean_of(r, class, name, cost)
  local errors, times, rays = 0, 0, 0
  for _, shot in ipairs(class) do
    local here, unit = r.at { shot = shot, arm = name }, r.at { shot = shot, arm = base }
    errors = errors + math.log(math.max(here.rmse, 1e-6) / math.max(unit.rmse, 1e-6)) / #class
    times, rays = times + math.log(here.ms_ratio) / #class, rays + here.rays / pixels / #class
  end
  return cost == "rays" and rays or math.exp(times), math.exp(errors)
end

-- Returns the least error of adaptive at costs up to `cost`; nil if its first setting costs more. Between two settings,
-- log(error) is linear in log(cost).
local function on_curve(r, class, kind, cost)
  local least, before_cost, before_error
  for _, name in ipairs(adaptive) do
    local at, error = mean_of(r, class, name, kind)
    if cost >= at then least = math.min(least or error, error)
    elseif before_cost and cost > before_cost then
      local share = math.log(cost / before_cost) / math.log(at / before_cost)
      least = math.min(least, before_error * (error / before_error) ^ share)
    end
    before_cost, before_error = at, error
  end
  return least
end

-- Returns true if a point is below the curve of adaptive by more than a fiftieth, and a text with the point and the curve.
local function compared(r, class, kind, label, cost, error)
  local least = on_curve(r, class, kind, cost)
  local curve = least and ("adaptive %.3f"):format(least) or "no setting of adaptive"
  return least ~= nil and error < 0.98 * least, ("%s: %.2f, %.3f (%s)"):format(label, cost, error, curve)
end

-- ---- expectations

local expect = {}
local function also(text, holds, known) expect[#expect + 1] = { text, holds, known = known } end

-- Returns true if a point of `rival` is below the curve, and a text with all points. `cost_of`: cost of a point from its
-- measured cost and its number of samples; nil: the measured cost.
local function any_below(r, class, kind, rival, cost_of)
  local is_below, texts = false, {}
  for i, name in ipairs(rival) do
    local cost, error = mean_of(r, class, name, kind)
    local below, text = compared(r, class, kind, tostring(counts[i]), cost_of and cost_of(cost, counts[i]) or cost, error)
    is_below, texts[i] = is_below or below, text
  end
  return is_below, table.concat(texts, "; ")
end

local function of_rival(class, kind, rival)
  local curve, wanted = class.title .. ", " .. kind, false
  for _, name in ipairs(rival.below) do wanted = wanted or name == curve end
  also(("%s: %s has %s setting below the curve of adaptive: %s"):format(curve, rival.title, wanted and "a" or "no", rival.why),
    function(r)
      local is_below, text = any_below(r, class, kind, rival)
      return is_below == wanted, text
    end, rival.known and rival.known[curve])
end

local function of_adaptive(class, kind)
  also(("%s, %s: each increase of quality has a higher cost and a smaller error"):format(class.title, kind), function(r)
    local good, texts, last_cost, last_error = true, {}, 0, math.huge
    for i, name in ipairs(adaptive) do
      local cost, error = mean_of(r, class, name, kind)
      good, texts[i] = good and cost > last_cost and error < last_error, ("%s: %.2f, %.3f"):format(name, cost, error)
      last_cost, last_error = cost, error
    end
    return good, table.concat(texts, "; ")
  end)
end

-- Adds an expectation with estimated times, for a design that is not implemented: `all times`, where one traversal of the tree
-- serves four times of a pixel. The estimate is a lower bound, because it assumes that four samples take the time of one
-- sample. The time of one sample is the slope of the frame time between 16 and 64 samples.
local function of_shared_traversal(class)
  local all = rivals[3]
  also(class.title .. ", time: all times has a setting below the curve of adaptive if four samples of a pixel take the time " ..
    "of one, and adaptive saves nothing", function(r)
    local slope = (mean_of(r, class, all[3], "time") - mean_of(r, class, all[2], "time")) / (counts[3] - counts[2])
    return any_below(r, class, "time", all, function(cost, samples) return math.max(cost - 0.75 * slope * samples, 1e-6) end)
  end)
end

for _, class in ipairs(classes) do
  for _, kind in ipairs { "time", "rays" } do
    of_adaptive(class, kind)
    for _, rival in ipairs(rivals) do of_rival(class, kind, rival) end
  end
  of_shared_traversal(class)
end
also("static camera: poses has the errors and rays of adaptive, because it draws no cell there", function(r)
  local most = 0
  for i, name in ipairs(rivals[2]) do
    for _, kind in ipairs { "rmse", "rays" } do
      for _, shot in ipairs(classes[1]) do
        local own = r.at { shot = shot, arm = ("quality %g"):format(0.2 * i) }[kind]
        most = math.max(most, math.abs(r.at { shot = shot, arm = name }[kind] - own) / math.max(own, 1e-6))
      end
    end
  end
  return most <= 1e-3, ("within %.1g of each other"):format(most)
end)

return experiment {
  title    = "Designs of adaptive",
  question = "The pipeline adaptive gathers in cells where a gather is certain, and traces rays at adaptively chosen times " ..
             "in all other pixels. Is another design better, in shots with a static or a moving camera?",
  note     = "Designs: `prediction` follows the displacements of raster surfaces to each time sample, validates three " ..
             "samples of a pixel by rays, and traces the samples whose surfaces it does not find. `poses` equals " ..
             "adaptive with one exception: if the camera moves, it averages images rasterised at several times (poses) in " ..
             "uncertain cells without a static surface. " ..
             "With 4, 16 and 64 poses its quality is 0.2, 0.4 and 0.6. `all times` traces all samples of all pixels that " ..
             "motion reaches. `steps` draws and blurs 2, 4 or 8 steps of the exposure. EEVEE does the same, but shades " ..
             "each step anew. All designs except EEVEE and truth take the colours of hits from the raster image where it " ..
             "shows their surfaces. Size of each design, as lines of Lua and GLSL in its own files, and nodes of a " ..
             "frame: adaptive has 585 lines and 8 nodes; prediction 148 and 8; poses 161 and 14, in addition to the " ..
             "passes of adaptive; all times 32 and 7, in addition to one pass of adaptive; steps 156 and 16. Numbers: " ..
             "errors and times are geometric means, over a class of shots, of the ratios to McGuire 2012. Rays are " ..
             "arithmetic means per pixel. For each number of samples, an expectation lists the cost and the error of the " ..
             "rival, and in parentheses the error of adaptive at the same cost. Between two settings of adaptive, this " ..
             "error is interpolated linearly in the logarithms of cost and error. Not built: a traversal of the tree " ..
             "that serves several times of a pixel. Under a moving camera, a ray without shading took three to seven " ..
             "tenths of the time of one sample of `all times`. A traversal for four times therefore saves at most about " ..
             "half of the time. The expectations assume that it saves three quarters. Adaptive can share traversals too, " ..
             "because the times of its first rays are known in advance. Shared traversal therefore does not decide " ..
             "between the designs. Tried and dropped: a variant of adaptive with an error tolerance relative to the " ..
             "colours of the rays, not absolute. It took more rays, and its error over all shots was larger by up to a " ..
             "tenth, because dark regions got more rays than their errors are worth.",
  size     = { 160, 90 },
  shots    = shots,
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 512, mark_regions = false } },
  base     = base,
  rounds   = 5,
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = expect,
  layout   = { table = {} },
}
