-- SPDX-License-Identifier: MIT
-- Time samples that the layers do not resolve, and rays that resolve them.
local pipeline          = require "strobe.pipeline"
local moving_silhouettes = require "passes.mask.moving_silhouettes"
local own_time          = require "passes.scene.own_time"
local path_bend         = require "passes.scene.path_bend"
local unseen_close      = require "passes.scene.unseen_close"
local unseen_open       = require "passes.scene.unseen_open"
local visibility_moving = require "passes.scene.visibility_moving"
local bent_bounds       = require "passes.tile.bent_bounds"
local doubtful          = require "passes.tile.doubtful"

local time_samples = {}

-- Velocity over the whole exposure, also for a layer whose motion has two segments.
local function whole_velocity(layer) return layer.whole_velocity or layer.velocity end

local function bend_of(layer, name)
  return path_bend {
    depth = layer.depth, id = layer.id, velocity = whole_velocity(layer), hit = layer.hit, normal = layer.normal,
    as = name .. "_bend",
  }
end

-- Surfaces that are visible at shutter open or shutter close (`which`), but in no layer.
local function unseen_of(which, unseen, hit, raster, revealed)
  return unseen {
    time = which, hit = hit, depth = raster.depth, id = raster.id,
    revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
  }
end

-- One step of a loop at the middle of the exposure: path deviations of both layers, and surfaces visible only at shutter open
-- or shutter close.
local function at_the_middle(raster, revealed)
  local open = visibility_moving { time = "open", as = "open_visibility" }.hit
  local close = visibility_moving { time = "close", as = "close_visibility" }.hit
  return pipeline.loop { name = "middle", count = 1, times = "even", slices = 1, body = function()
    local result = {}
    local function keep(name, of, images)
      for _, image in ipairs(images) do result[name .. "_" .. image] = of[image] end
    end
    if not raster.curve then keep("raster", bend_of(raster, "raster"), { "bend", "bent" }) end
    keep("open", unseen_of("open", unseen_open, open, raster, revealed), { "unseen", "velocity", "bend" })
    keep("close", unseen_of("close", unseen_close, close, raster, revealed), { "unseen", "velocity", "bend" })
    if not revealed.curve then keep("revealed_1", bend_of(revealed, "revealed_1"), { "bend", "bent" }) end
    return result
  end }
end

-- Unreliable cells and time strata of the layers: paths deviate, or a surface is visible only at shutter open or close.
function time_samples.unreliable(p, raster, revealed)
  local found = at_the_middle(raster, revealed)
  local function bounds_of_layer(name, layer)
    return bent_bounds {
      velocity = whole_velocity(layer), bend = layer.bend or found[name .. "_bend"],
      valid = layer.bent or found[name .. "_bent"], as = name .. "_bent_bounds",
    }
  end
  local function bounds_of_end(which)
    return bent_bounds {
      velocity = found[which .. "_velocity"], bend = found[which .. "_bend"], valid = found[which .. "_unseen"],
      as = which .. "_unseen_bounds",
    }
  end
  local front, behind = bounds_of_layer("raster", raster), bounds_of_layer("revealed_1", revealed)
  local open, close = bounds_of_end "open", bounds_of_end "close"
  return doubtful {
    bounds = front.bounds, bends = front.bends, behind_bounds = behind.bounds, behind_bends = behind.bends,
    open_bounds = open.bounds, open_bends = open.bends, close_bounds = close.bounds, close_bends = close.bends,
    jittered = p.jitter() == "none" and 0 or 1, as = "doubtful",
  }.doubtful
end

-- Pixels beside a moving silhouette: displacements differ by more than `slowest` px, so a sample may fall to either side.
function time_samples.silhouettes(raster, slowest)
  return moving_silhouettes {
    velocity = raster.velocity, after_velocity = raster.after_velocity, slowest = slowest,
  }.near
end

-- The picture, with rays for the samples that the composite `made` left unresolved. `audit`: share of the blocks of pixels that
-- trace validation rays; nil: 0.01.
function time_samples.traced(p, raster, revealed, made, audit)
  return pipeline.loop {
    name = "own_times", count = 1, times = "midpoint", slices = math.min(p.samples(), 64),
    body = function()
      return { picture = own_time {
        seen = made.blurred, open = made.open, time = "sample", shades_unlike = true, audit = audit,
        hit = raster.hit, color = raster.color, depth = raster.depth, id = raster.id, revealed_color = revealed.color,
        revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
      }.picture }
    end,
  }.picture
end

return time_samples
