-- SPDX-License-Identifier: MIT
-- Finds the time samples of a pixel that the raster layer and the revealed layer do not resolve, and traces a ray for each.
local pipeline = require "strobe.pipeline"
local moving_silhouettes   = require "passes.time.moving_silhouettes"
local trace_time_samples   = require "passes.time.trace_time_samples"
local path_deviation       = require "passes.time.path_deviation"
local disoccluded_at_close = require "passes.time.disoccluded_at_close"
local disoccluded_at_open  = require "passes.time.disoccluded_at_open"
local visibility_moving    = require "passes.gbuffer.visibility_moving"
local deviation_bounds     = require "passes.cell.deviation_bounds"
local classify_time_samples = require "passes.time.classify_time_samples"

local time_samples = {}

-- Displacement of a layer's surfaces over the whole exposure, px, also if the layer's motion is split into two segments.
local function whole_velocity(layer) return layer.whole_velocity or layer.velocity end

local function deviation_of(layer, name)
  return path_deviation {
    depth = layer.depth, id = layer.id, velocity = whole_velocity(layer), hit = layer.hit, normal = layer.normal,
    as = name .. "_deviation",
  }
end

-- Returns the surfaces `hit`, visible at `time` (shutter open or shutter close), that belong to neither layer. `disoccluded`:
-- the pass for this time.
local function disoccluded_at(time, disoccluded, hit, raster, revealed)
  return disoccluded {
    time = time, hit = hit, depth = raster.depth, id = raster.id,
    revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
  }
end

-- Returns the path deviations of both layers (distance of a path from a straight line in the middle of the exposure), and the
-- surfaces that are visible only at shutter open or only at shutter close. A loop of one iteration computes these images,
-- because only a loop can pose the scene in the middle of the exposure.
local function at_the_middle(raster, revealed)
  local open = visibility_moving { time = "shutter_open", as = "shutter_open_visibility" }.hit
  local close = visibility_moving { time = "shutter_close", as = "shutter_close_visibility" }.hit
  return pipeline.loop { name = "middle", count = 1, times = "even", slices = 1, body = function()
    local result = {}
    local function keep(name, of, images)
      for _, image in ipairs(images) do result[name .. "_" .. image] = of[image] end
    end
    if not raster.curve then keep("raster", deviation_of(raster, "raster"), { "path_deviation", "nonlinear" }) end
    local images = { "disoccluded", "velocity", "path_deviation" }
    keep("open", disoccluded_at("shutter_open", disoccluded_at_open, open, raster, revealed), images)
    keep("close", disoccluded_at("shutter_close", disoccluded_at_close, close, raster, revealed), images)
    if not revealed.curve then keep("revealed", deviation_of(revealed, "revealed"), { "path_deviation", "nonlinear" }) end
    return result
  end }
end

-- Marks the cells (squares of pixels) and time strata where the layers are unreliable. A layer is unreliable if paths deviate
-- from straight lines, or if a surface is visible only at shutter open or only at shutter close.
function time_samples.unreliable(p, raster, revealed)
  local found = at_the_middle(raster, revealed)
  local function bounds_of_layer(name, layer)
    return deviation_bounds {
      velocity = whole_velocity(layer), path_deviation = layer.path_deviation or found[name .. "_path_deviation"],
      valid = layer.nonlinear or found[name .. "_nonlinear"], as = name .. "_deviation_bounds",
    }
  end
  local function bounds_of_end(which)
    return deviation_bounds {
      velocity = found[which .. "_velocity"], path_deviation = found[which .. "_path_deviation"],
      valid = found[which .. "_disoccluded"], as = which .. "_disoccluded_bounds",
    }
  end
  local front, background = bounds_of_layer("raster", raster), bounds_of_layer("revealed", revealed)
  local open, close = bounds_of_end "open", bounds_of_end "close"
  return classify_time_samples {
    bounds = front.bounds, deviation_bounds = front.deviation_bounds,
    background_bounds = background.bounds, background_deviation_bounds = background.deviation_bounds,
    shutter_open_bounds = open.bounds, shutter_open_deviation_bounds = open.deviation_bounds,
    shutter_close_bounds = close.bounds, shutter_close_deviation_bounds = close.deviation_bounds,
    jittered = p.jitter() == "none" and 0 or 1,
  }.unreliable
end

-- Mask of the pixels beside a moving silhouette. A silhouette moves if the displacements at its two sides differ by more than
-- `slowest` px over the exposure. A sample between the two pixels may show the surface of either side.
function time_samples.silhouettes(raster, slowest)
  return moving_silhouettes {
    velocity = raster.velocity, velocity_post = raster.velocity_post, slowest = slowest,
  }.near
end

-- Traces a ray for each time sample that the composite left unresolved, and returns the complete picture. `made`: outputs of
-- the composite pass. `validation_share`: share of the pixel blocks that also trace rays to check resolved samples; nil: 0.01.
function time_samples.traced(p, raster, revealed, made, validation_share)
  return pipeline.loop {
    name = "traced_times", count = 1, times = "midpoint", slices = math.min(p.samples(), 64),
    body = function()
      return { picture = trace_time_samples {
        partial = made.blurred, unresolved = made.unresolved, time = "sample", shades_contrast = true,
        validation_share = validation_share, hit = raster.hit, color = raster.color, depth = raster.depth, id = raster.id,
        revealed_color = revealed.color,
        revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
      }.picture }
    end,
  }.picture
end

return time_samples
