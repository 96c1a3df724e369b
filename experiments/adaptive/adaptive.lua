-- SPDX-License-Identifier: MIT
-- Compares the pipeline `adaptive` with all other pipelines, by error against cost. The parameter `quality` of `adaptive`
-- leads from a post-process blur to ground truth, so its settings form a curve.
--   strobe sweep experiments/adaptive/adaptive.lua -o out/adaptive
local experiment = require "strobe.experiment"
local all_shots  = require "scripts.scenes.lib.all_shots"

local shots, width, height = all_shots.list(), 160, 90
local arms, others, own = {}, {}, {}  -- all arms; names of the arms of other pipelines; names of the arms of adaptive
local base = "McGuire 2012"
local postprocess = "UE4-style"  -- equals adaptive with quality = 0
local function arm(list, name, pipeline, set)
  arms[#arms + 1] = { name = name, pipeline = pipeline, set = set or {} }
  list[#list + 1] = name
end
arm(others, base, "mcguire2012")
arm(others, "no blur", "none")
arm(others, "hybrid", "hybrid")
arm(others, "hybrid_layered", "hybrid_layered")
arm(others, "Guertin 2014", "guertin2014")
arm(others, "Jimenez 2014", "jimenez2014")
arm(others, postprocess, "ue4")
arm(others, "Bevy", "bevy")
arm(others, "HDRP", "hdrp")
arm(others, "layers 2024", "lee2024")
arm(others, "oberberger2022", "oberberger2022")
-- Arms of ground truth with a measured time. From a quality of 0.75 on, the pipeline adaptive runs the passes of ground_truth.
-- At a quality of 0.8, it has 4 times `samples` samples.
for _, samples in ipairs { 4, 8, 16, 32 } do
  arm(others, ("truth, %d"):format(samples), "adaptive", { quality = 0.8, samples = samples // 4 })
end
for _, quality in ipairs { 0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8 } do
  arm(own, ("quality %g"):format(quality), "adaptive", { quality = quality })
end
local exact = "ground truth, 64"
arms[#arms + 1] = { name = exact, pipeline = "ground_truth", timed = true, set = { samples = 64, mark_regions = false } }

-- ---- curves

-- Returns the cost and the error of an arm in a shot. `cost`: "rays" for the rays per pixel, otherwise the frame time divided
-- by the frame time of the arm `base`. The error is divided by the error of `base`.
local function in_shot(r, one, name, cost)
  local here, unit = r.at { shot = one.name, arm = name }, r.at { shot = one.name, arm = base }
  local of = cost == "rays" and here.rays / (width * height) or here.ms_ratio
  return of, math.max(here.rmse, 1e-6) / math.max(unit.rmse, 1e-6)
end

-- Returns the geometric means of cost and error over all shots. If the cost is rays, its mean is arithmetic, because an arm may
-- trace 0 rays.
local function over_all(r, name, cost)
  local costs, errors = 0, 0
  for _, one in ipairs(shots) do
    local of, error = in_shot(r, one, name, cost)
    costs, errors = costs + (cost == "rays" and of or math.log(of)), errors + math.log(error)
  end
  costs = costs / #shots
  return cost == "rays" and costs or math.exp(costs), math.exp(errors / #shots)
end

local function points(names, at)
  local list = {}
  for i, name in ipairs(names) do
    local cost, error = at(name)
    list[i] = { name = name, cost = cost, error = error }
  end
  return list
end

-- Returns the least error on `curve` at costs up to `cost`; nil if `cost` is below the cost of the first point. Between the
-- points of the curve, log(error) is linear in log(cost).
local function on_curve(curve, cost)
  if cost < curve[1].cost then return nil end
  local least = curve[1].error
  for i = 2, #curve do
    local a, b = curve[i - 1], curve[i]
    if cost >= b.cost then least = math.min(least, b.error)
    elseif cost > a.cost then
      local share = math.log(cost / a.cost) / math.log(b.cost / a.cost)
      least = math.min(least, a.error * (b.error / a.error) ^ share)
    end
  end
  return least
end

-- Returns the names of the points of `list` with an error below the curve. `share`: a point is below the curve if its error is
-- less than this share of the error on the curve.
local function below(curve, list, share)
  local found = {}
  for _, one in ipairs(list) do
    local least = on_curve(curve, one.cost)
    if least and one.error < share * least then found[#found + 1] = one.name end
  end
  return found
end
local slack = 0.98  -- share for a point that is clearly below the curve

-- Returns the points of `curve` on the Pareto front: no point of `list` is at least as good in both cost and error.
local function on_front(curve, list)
  local names = {}
  for _, own_one in ipairs(curve) do
    local beaten = false
    for _, one in ipairs(list) do beaten = beaten or (one.cost <= own_one.cost and one.error <= own_one.error) end
    if not beaten then names[#names + 1] = ("%s (%.2f, %.3f)"):format(own_one.name, own_one.cost, own_one.error) end
  end
  return names
end

local function fronts(r, cost)
  local function at(name) return over_all(r, name, cost) end
  return points(own, at), points(others, at)
end

local function of_curve(cost, words, known)
  return {
    { ("over all scenes, no point of another pipeline lies below the curve of adaptive (%s)"):format(words), function(r)
      local curve, list = fronts(r, cost)
      local found = below(curve, list, slack)
      return #found == 0, #found == 0 and "none of " .. #list or table.concat(found, ", ")
    end, known = known },
    { ("over all scenes, at least five settings of adaptive are on the front (%s)"):format(words), function(r)
      local names = on_front(fronts(r, cost))
      return #names >= 5, ("%d: %s"):format(#names, table.concat(names, ", "))
    end },
  }
end

-- Returns the number of scenes where no point of another pipeline lies below the curve of adaptive. Also returns a text for
-- each of the other scenes, with the points below the curve. `share`: as for `below`.
local function scene_by_scene(r, cost, share)
  local good, texts = 0, {}
  for _, one in ipairs(shots) do
    local function at(name) return in_shot(r, one, name, cost) end
    local found = below(points(own, at), points(others, at), share)
    if #found == 0 then good = good + 1 else texts[#texts + 1] = one.title .. ": " .. table.concat(found, ", ") end
  end
  return good, texts
end

-- Returns the expectation that the curve of adaptive has at most the error `most` at the cost `cost`.
local function reaches(most, cost, known)
  return { ("over all scenes, adaptive has at most %g of the error of McGuire 2012 at %g times the time"):format(most, cost),
    function(r)
      local least = on_curve(fronts(r, "ms"), cost)
      return least ~= nil and least <= most, least and ("%.3f"):format(least) or "its first setting takes longer"
    end, known = known }
end

local passes = "even if few rays follow, the passes that find reliable cells take half as long as McGuire 2012"
local expect = { reaches(0.05, 2.5), reaches(0.12, 1.6, passes) }
local few_rays = "methods with layers at the raster time rasterise most of these layers: they trace few rays, but " ..
                 "take long"
for _, part in ipairs { of_curve("ms", "error against time"), of_curve("rays", "error against rays", few_rays) } do
  for _, one in ipairs(part) do expect[#expect + 1] = one end
end
local function also(text, holds, known) expect[#expect + 1] = { text, holds, known = known } end

also("in no single scene does a point of another pipeline lie below the curve of adaptive (error against time)", function(r)
  local good, texts = scene_by_scene(r, "ms", slack)
  return good == #shots, ("in %d of %d; %s"):format(good, #shots, table.concat(texts, "; "))
end, "in some scenes, layers at the raster time contain all surfaces that are visible at any time. There, methods " ..
  "with layers have a smaller error for the same time")
also("in every scene, adaptive has at most 1.5 times the error of each point of another pipeline, in the same time", function(r)
  local good, texts = scene_by_scene(r, "ms", 1 / 1.5)
  return good == #shots, ("in %d of %d; %s"):format(good, #shots, table.concat(texts, "; "))
end, "in these scenes, little moves in front of a static background, which truth traces once; or layers at the raster time " ..
  "contain all surfaces that are visible at any time")
also("over all scenes, no pipeline but UE4-style, which a quality of 0 equals, has at most the error of this quality in at " ..
  "most 0.95 times the time", function(r)
  local curve, list = fronts(r, "ms")
  local names = {}
  for _, one in ipairs(list) do
    if one.name ~= postprocess and one.cost <= 0.95 * curve[1].cost and one.error <= curve[1].error then
      names[#names + 1] = ("%s (%.2f, %.3f)"):format(one.name, one.cost, one.error)
    end
  end
  return #names == 0, table.concat(names, ", ")
end)
also("a quality of 0 equals UE4-style: it has the same error in every scene, and takes at most 1.05 times the time of " ..
  "McGuire 2012", function(r)
  local same, cost = true, over_all(r, own[1], "ms")
  for _, one in ipairs(shots) do
    same = same and r.at { shot = one.name, arm = own[1] }.rmse == r.at { shot = one.name, arm = postprocess }.rmse
  end
  return same and cost <= 1.05, ("%.3f times the time"):format(cost)
end)
also("a quality of 0.8 equals truth: it has the error of ground truth with 64 samples in every scene", function(r)
  local same = true
  for _, one in ipairs(shots) do
    same = same and r.at { shot = one.name, arm = own[#own] }.rmse == r.at { shot = one.name, arm = exact }.rmse
  end
  return same, ("%d scenes"):format(#shots)
end)
also("over all scenes, each increase of quality takes more time and has a smaller error", function(r)
  local curve, good, texts = fronts(r, "ms"), true, {}
  for i = 2, #curve do
    good = good and curve[i].cost > curve[i - 1].cost and curve[i].error < curve[i - 1].error
    texts[#texts + 1] = ("%.2f, %.3f"):format(curve[i].cost, curve[i].error)
  end
  return good, table.concat(texts, "; ")
end)

also("in every scene, each increase of quality takes at least 0.95 times the time, and has at most 1.05 times the error, of " ..
  "the setting before", function(r)
  local texts = {}
  for _, one in ipairs(shots) do
    local curve = points(own, function(name) return in_shot(r, one, name, "ms") end)
    for i = 2, #curve do
      local a, b = curve[i - 1], curve[i]
      if b.cost < 0.95 * a.cost or b.error > 1.05 * a.error + 1e-6 then
        texts[#texts + 1] = ("%s, %s (time %.2f, error %.2f times)"):format(one.title, b.name, b.cost / a.cost,
          b.error / a.error)
      end
    end
  end
  return #texts == 0, table.concat(texts, "; ")
end, "frames take a few milliseconds, and their times vary by more than this bound")

return experiment {
  title    = "Adaptive",
  question = "The pipeline adaptive gathers in cells where a gather is certain, and traces all other pixels. Its parameter " ..
             "quality leads from a post-process blur to truth. Do its settings form the front of error against time?",
  note     = "The shots are all scenes of the repository except the exhibits. In relation to the size of the " ..
             "picture, displacements are as long as in the scenes' own pictures. Errors and times are ratios to " ..
             "McGuire 2012 in the same scene; values over all scenes are geometric means. The curve of adaptive is " ..
             "linear in the logarithms of cost and error between two settings. Points of other pipelines that cost " ..
             "less than the first setting of adaptive are not compared with the curve. Pairs in parentheses are " ..
             "(cost, error).",
  size     = { width, height },
  shots    = shots,
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 512, mark_regions = false } },
  base     = base,
  rounds   = 5,
  regions  = { "whole" },
  measures = { "rmse", "ms_ratio", "rays" },
  expect   = expect,
  layout   = { front = { x = "ms_ratio", y = "rmse", region = "whole" }, table = {} },
}
