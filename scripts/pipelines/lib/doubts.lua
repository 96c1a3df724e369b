-- SPDX-License-Identifier: MIT
-- Where the layers of the capture do not say what is seen at other times, and rays at their own time that do.
local pass          = require "strobe.pass"
local pipeline      = require "strobe.pipeline"
local silhouettes   = require "passes.mask.silhouettes"
local bend          = require "passes.scene.bend"
local own_time      = require "passes.scene.own_time"
local unseen_close  = require "passes.scene.unseen_close"
local unseen_open   = require "passes.scene.unseen_open"
local visibility    = require "passes.scene.visibility"
local doubtful      = require "passes.tile.doubtful"
local motion_bounds = require "passes.tile.motion_bounds"

local doubts = {}

-- Does the pipeline trace samples at their own time?
function doubts.are_asked(p)
  if p.own_time() == "none" then return false end
  if pass.reads(pass.member("composite", p.composite()), "doubtful") then return true end
  error(("own_time = %s: composite = %s leaves no samples to rays; it needs composite = layered"):format(
    p.own_time(), p.composite()), 0)
end

local function jittered(p) return p.jitter() == "none" and 0 or 1 end

-- Per cell, of what bends in these layers, bounds of its displacements and of how far it is from a straight line.
local function bent_bounds(layers, name)
  local bent = pipeline.loop {
    name = name .. "_middle", count = 1, times = "midpoint", slices = 1,
    body = function()
      local found = {}
      for i, layer in ipairs(layers) do
        local of = bend {
          depth = layer.depth, id = layer.id, velocity = layer.velocity, normal = layer.normal,
          as = ("%s_bend_%d"):format(name, i),
        }
        found["bent_" .. i], found["bend_" .. i] = of.bent, of.bend
      end
      return found
    end,
  }
  local bounds, bends
  for i, layer in ipairs(layers) do
    local valid = bent["bent_" .. i]
    bounds = motion_bounds {
      velocity = layer.velocity, valid = valid, others = bounds, as = ("%s_bounds_%d"):format(name, i),
    }.bounds
    bends = motion_bounds {
      velocity = bent["bend_" .. i], valid = valid, others = bends, as = ("%s_bends_%d"):format(name, i),
    }.bounds
  end
  return bounds, bends
end

-- What bends of what raster saw: its bounds, and where it comes to, where all is found by rays in any case.
function doubts.of_raster(p, seen)
  local bounds, bends = bent_bounds({ seen }, "bent_raster")
  local elsewhere = doubtful { bounds = bounds, bends = bends, jittered = jittered(p), as = "bent_cells" }.doubtful
  return { bounds = bounds, bends = bends, elsewhere = elsewhere }
end

-- The same of what an end of the exposure sees and no layer holds.
local function end_bounds(which, unseen, seen, revealed)
  local hit = visibility { time = which, as = which .. "_visibility" }.hit
  local found = pipeline.loop {
    name = which .. "_middle", count = 1, times = "midpoint", slices = 1,
    body = function()
      local of = unseen {
        time = which, hit = hit, depth = seen.depth, id = seen.id,
        revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
      }
      return { unseen = of.unseen, velocity = of.velocity, bend = of.bend }
    end,
  }
  local function bounds(of, name) return motion_bounds { velocity = of, valid = found.unseen, as = which .. name }.bounds end
  return bounds(found.velocity, "_bounds"), bounds(found.bend, "_bends")
end

-- The cells and times at which something is there of which layers do not say where it is: what bends, and what an end of
-- the exposure alone sees. `raster` is of doubts.of_raster.
function doubts.cells(p, seen, revealed, raster)
  local behind_bounds, behind_bends = bent_bounds(revealed, "bent_behind")
  local open_bounds, open_bends = end_bounds("open", unseen_open, seen, revealed[1])
  local close_bounds, close_bends = end_bounds("close", unseen_close, seen, revealed[1])
  return doubtful {
    bounds = raster.bounds, bends = raster.bends, behind_bounds = behind_bounds, behind_bends = behind_bends,
    open_bounds = open_bounds, open_bends = open_bends, close_bounds = close_bounds, close_bends = close_bends,
    jittered = jittered(p),
  }.doubtful
end

-- Where a sample may fall to either side of an edge, if rays are to tell; else nil.
function doubts.silhouettes(p, seen)
  if p.own_time() ~= "uncertain" then return nil end
  return silhouettes { velocity = seen.velocity, after_velocity = seen.after_velocity }.near
end

-- The picture, from what a composite made that left samples open; `revealed` is the first layer behind.
function doubts.traced(p, seen, revealed, made)
  return pipeline.loop {
    name = "own_times", count = 1, times = "midpoint", slices = math.min(p.samples(), 32),
    body = function()
      return { picture = own_time {
        seen = made.blurred, open = made.open, time = "sample",
        hit = seen.hit, color = seen.color, depth = seen.depth, id = seen.id, revealed_color = revealed.color,
        revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
      }.picture }
    end,
  }.picture
end

return doubts
