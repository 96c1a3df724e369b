-- SPDX-License-Identifier: MIT
-- Objects of every kind: turning, of many parts, entering and leaving the picture, before backgrounds with detail.
-- Expected, written before measuring, of the hybrid (best) in each shot, with the part of an error above the floor e
-- being sqrt(e^2 - floor^2), 0 where e is less, and the floor that of 16 midpoint samples of truth:
--   where something is uncovered (inner, hidden, self), its RMSE above the floor is at most a third of that of the best
--     post-process there;
--   in every region its RMSE is at most 1.5 times the floor;
--   in no region does a baseline have a smaller RMSE, rivals with layers or rays included (which came later).
--   strobe sweep experiments/any_object/any_object.lua -o out/any_object
-- The last shots are shared data (STROBE_DATA); without them they are skipped.
local experiment = require "strobe.experiment"

local hybrid, shaded, floor = "hybrid (best)", "hybrid (every hit shaded)", "truth, 16 samples"
local baselines = { mcguire2012 = "McGuire 2012", ue4 = "UE4-style", guertin2014 = "Guertin 2014",
  jimenez2014 = "Jimenez 2014", bevy = "Bevy", hdrp = "HDRP", layers2024 = "layers 2024", temporal1 = "temporal1" }
local postprocesses = { "mcguire2012", "ue4", "guertin2014", "jimenez2014", "bevy", "hdrp" }
local others = { "layers2024", "temporal1" }
local regions = { "whole", "inner", "hidden", "outer", "self" }
local uncovered = { "inner", "hidden", "self" }

local least_pixels = 100  -- of a region that is judged

-- What is measured in a region of a shot: RMSE of the floor, of the hybrid, of the best post-process and of the best of all
-- baselines, each with its name; nothing where the region is all but empty or displacements were shortened.
local function errors(r, shot, region)
  local function at(arm) return r.at { shot = shot, arm = arm, region = region } end
  local own = at(hybrid)
  if own.pixels < least_pixels or own.clamped > 0 then return nil end
  local function best_of(least, pipelines)
    for _, pipeline in ipairs(pipelines) do
      local baseline = at(baselines[pipeline])
      if baseline.clamped == 0 and baseline.rmse < least.rmse then
        least = { rmse = baseline.rmse, name = baselines[pipeline] }
      end
    end
    return least
  end
  local best = best_of({ rmse = math.huge }, postprocesses)
  return best.name and { own = own.rmse, floor = at(floor).rmse, best = best, any = best_of(best, others) } or nil
end

local function above(error, least) return math.sqrt(math.max(0, error * error - least * least)) end

-- Each rule: which regions, and what one of them has to say: does it hold, and the numbers.
local rules = {
  { text = "where something is uncovered, the hybrid's error above the floor is at most a third of the best post-process's",
    regions = uncovered, holds = function(e)
      local own, best = above(e.own, e.floor), above(e.best.rmse, e.floor)
      return own <= best / 3, ("%.4f of %.4f (%s)"):format(own, best, e.best.name)
    end },
  { text = "the hybrid's error is at most 1.5 times the floor, in every region",
    regions = regions, holds = function(e) return e.own <= 1.5 * e.floor, ("%.2f"):format(e.own / e.floor) end },
  { text = "no baseline has a smaller error than the hybrid, in any region",
    regions = regions, holds = function(e)
      return e.own <= e.any.rmse, ("%.4f, %.4f (%s)"):format(e.own, e.any.rmse, e.any.name)
    end },
}

-- Why the expectations that are known to fail do: by shot, then by number of the rule.
local fine = "texels of the capture stand for texture that is finer than they are, and for bends of half a pixel: with " ..
             "every hit shaded and every bend traced it is as good as the floor"
local known = {
  truck = { [2] = fine },
  box_rises = { [2] = fine },
}

local function expected(shots)
  local list = {}
  for _, shot in ipairs(shots) do
    for number, rule in ipairs(rules) do
      list[#list + 1] = { ("%s: %s"):format(shot.title, rule.text), shot = shot.name,
        known = known[shot.name] and known[shot.name][number], function(r)
          local texts, all, any = {}, true, false
          for _, region in ipairs(rule.regions) do
            local e = errors(r, shot.name, region)
            if e then
              local holds, text = rule.holds(e)
              all, any = all and holds, true
              texts[#texts + 1] = ("%s %s%s"):format(region, text, holds and "" or ", which is too much")
            end
          end
          if not any then return nil, "no region of " .. least_pixels .. " pixels without shortened displacements" end
          return all, table.concat(texts, "; ")
        end }
    end
  end
  local text = "found afterwards: with every hit of a ray shaded and every bend traced, the error is at most 1.25 times " ..
               "the floor, in every region of every shot"
  list[#list + 1] = { text, function(r)
      local most, where = 0, ""
      for _, shot in ipairs(shots) do
        for _, region in ipairs(regions) do
          local own = r.at { shot = shot.name, arm = shaded, region = region }
          local ratio = own.pixels >= least_pixels and
                        own.rmse / r.at { shot = shot.name, arm = floor, region = region }.rmse or 0
          if ratio > most then most, where = ratio, ("%s, %s"):format(shot.name, region) end
        end
      end
      return most <= 1.25, ("at most %.2f (%s)"):format(most, where)
    end }
  return list
end

local function object(name, title, note, set)
  local shot = { name = name, title = title, note = note, scene = "objects/" .. name }
  for key, value in pairs(set or {}) do shot[key] = value end
  return shot
end

local samples = "shared:scenes/khronos_samples/"
local shots = {
  object("telescope", "Telescope", "Three parts that turn together by 12 degrees and come to point at the camera: the " ..
         "dew cap hides a barrel that was seen from the side before."),
  object("spoked_wheel", "Spoked wheel", "One object that rolls by 45 degrees: its spokes uncover the wall, and rim " ..
         "and spokes each other."),
  object("enters", "Leaves and enters", "A crate is seen at the beginning of the exposure only, a ball not before its " ..
         "end."),
  object("caged_fan", "Caged fan", "Blades turn by 60 degrees behind and before thin wires at rest."),
  object("pendulum", "Pendulum", "Rod and bob swing by 25 degrees behind the bars of a clock's case."),
  object("leaves", "Leaves", "Three layers of leaves, one before the other, each leaf moving and turning its own way."),
  object("car_and_road", "Car and road", "A car drives with rolling wheels; the camera goes with it for nine tenths of " ..
         "its way, so that the road moves most."),
  object("car_passes", "Passing car", "The same car, the camera at rest.",
         { scene = "objects/car_and_road", ["scene.follow"] = 0 }),
  object("tracking_parallax", "Tracking shot", "The camera moves sideways through posts, balls and boxes at many depths."),
  object("door", "Door", "A door turns about its hinge by 32 degrees, into a room."),
  object("stacked", "Three movers", "Three boxes one behind the other, each moving its own way."),
  object("stacked_alike", "Four movers alike", "Four of them, all of one plain colour.",
         { scene = "objects/stacked", ["scene.count"] = 4, ["scene.equal"] = true }),
  { name = "walker", title = "Walking figure", scene = samples .. "CesiumMan.glb",
    note = "A figure that its joints bend walks on the spot.", fps = 6, frame = 4, exposure = 1,
    view = { 2.2, 1.3, 2.2, 0, 0.8, 0 } },
  { name = "desk_fan", title = "Desk fan", scene = "shared:scenes/vintage_desk_fan/vintage_desk_fan.glb",
    note = "Head, cage and blades turn to the side together, by 36 degrees: a cage of wires before and behind the blades.",
    fps = 24, exposure = 0.5, animation = "none", view = { 6, 34, 70, 0, 29, 0 },
    spin = { fanHead_low = { 0, 1, 0, 72 }, fanBlade_low = { 0, 1, 0, 72 } } },
  { name = "truck", title = "Milk truck", scene = samples .. "CesiumMilkTruck.glb",
    note = "The truck drives by as its wheels turn: 70 degrees within the exposure.",
    fps = 4, frame = 3, exposure = 1, view = { 1.2, 1.8, 6.2, -0.3, 1.1, 0 }, move = { node_0 = { 0.5225, 0, 0 } } },
  { name = "box_rises", title = "Box out of a box", scene = samples .. "BoxAnimated.glb",
    note = "A box rises out of another one, which hides more of it at the beginning than at the capture.",
    fps = 4, frame = 2, exposure = 1, view = { 1, 1.9, 2.3, 0, 0.8, 0 } },
  { name = "box_turns", title = "Turning box", scene = samples .. "BoxAnimated.glb",
    note = "The same box turns by 36 degrees above the other: a face that is seen at the beginning is hidden at the " ..
           "capture.",
    fps = 4, frame = 8, exposure = 1, view = { 1.1, 3.1, 1.5, 0, 2.5, 0 } },
}

local arms = { { name = "no blur", pipeline = "none" } }
for _, list in ipairs { postprocesses, others } do
  for _, pipeline in ipairs(list) do arms[#arms + 1] = { name = baselines[pipeline], pipeline = pipeline } end
end
arms[#arms + 1] = { name = "selective", pipeline = "selective" }
arms[#arms + 1] = { name = "hybrid (captured)", pipeline = "hybrid_layered" }
arms[#arms + 1] = { name = hybrid, pipeline = "hybrid_traced" }
arms[#arms + 1] = { name = shaded, pipeline = "hybrid_traced", shown = false,
  set = { ["own_time.same_depth"] = 0, ["raster_bend.most_bend"] = 0 } }
arms[#arms + 1] = { name = floor, pipeline = "ground_truth", role = "floor", shown = false,
  set = { samples = 16, times = "midpoint" } }

return experiment {
  title = "Any object",
  question = "Is the hybrid right on any object: turning, of many parts, entering, leaving?",
  note = "All methods have 16 samples, the exposure ends at the capture, and nothing is shortened. Expected of the hybrid " ..
         "(best): above the floor of its own 16 samples at most a third of the error of the " ..
         "best post-process where something is uncovered; at most 1.5 times the floor, and no baseline nearer to the " ..
         "truth, in any region.",
  size = { 480, 270 },
  regions = regions,
  measures = { "rmse", "flip", "rays", "clamped", "displacement", "pixels" },
  arms = arms,
  truth = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  shots = shots,
  expect = expected(shots),
  layout = { table = {} },
}
