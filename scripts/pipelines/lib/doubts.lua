-- SPDX-License-Identifier: MIT
-- Where the layers of the capture do not say what is seen at other times, and rays at their own time that do.
local pass          = require "strobe.pass"
local pipeline      = require "strobe.pipeline"
local bend          = require "passes.scene.bend"
local own_time      = require "passes.scene.own_time"
local unseen_close  = require "passes.scene.unseen_close"
local unseen_open   = require "passes.scene.unseen_open"
local visibility    = require "passes.scene.visibility"
local doubtful      = require "passes.tile.doubtful"
local farthest      = require "passes.tile.farthest"
local motion_bounds = require "passes.tile.motion_bounds"
local tile_max      = require "passes.tile.tile_max"
local tiles         = require "scripts.pipelines.lib.tiles"

local doubts = {}

-- Does the pipeline trace samples at their own time?
function doubts.are_asked(p)
  if p.own_time() == "none" then return false end
  if pass.reads(pass.member("composite", p.composite()), "doubtful") then return true end
  error(("own_time = %s: composite = %s leaves no samples to rays; it needs composite = layered"):format(
    p.own_time(), p.composite()), 0)
end

-- Bounds, per cell, of the displacements of what bends in these layers.
local function bent_bounds(layers, name)
  local bent = pipeline.loop {
    name = name .. "_middle", count = 1, times = "midpoint", slices = 1,
    body = function()
      local found = {}
      for i, layer in ipairs(layers) do
        local of = bend { depth = layer.depth, id = layer.id, velocity = layer.velocity, as = ("%s_bend_%d"):format(name, i) }
        found["bent_" .. i], found["hull_" .. i] = of.bent, of.hull
      end
      return found
    end,
  }
  local bounds
  for i, layer in ipairs(layers) do
    bounds = motion_bounds {
      velocity = layer.velocity, after_velocity = bent["hull_" .. i], valid = bent["bent_" .. i], others = bounds,
      as = ("%s_bounds_%d"):format(name, i),
    }.bounds
  end
  return bounds
end

-- What bends of what raster saw: its bounds, and the cells it comes to, where all is found by rays in any case.
function doubts.of_raster(seen)
  local bounds = bent_bounds({ seen }, "bent_raster")
  local reach = farthest { longest = tiles.motions(seen), as = "raster_farthest" }.reach
  return { bounds = bounds, reach = reach, elsewhere = doubtful { bounds = bounds, reach = reach, as = "bent_cells" }.doubtful }
end

-- Bounds of the displacements of what an end of the exposure sees and no layer holds, and the longest of each tile.
local function end_bounds(which, unseen, seen, revealed)
  local found = unseen {
    time = which, hit = visibility { time = which, as = which .. "_visibility" }.hit,
    depth = seen.depth, id = seen.id,
    revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
  }
  local longest = tile_max { velocity = found.velocity, valid = found.unseen, as = which .. "_tile_max" }.longest
  local bounds = motion_bounds { velocity = found.velocity, valid = found.unseen, as = which .. "_bounds" }.bounds
  return bounds, longest
end

-- The cells that something comes to of which layers do not say where it is: what bends, and what an end of the exposure
-- alone sees. `raster` is of doubts.of_raster.
function doubts.cells(_, seen, revealed, raster)
  local open_bounds, longest_open = end_bounds("open", unseen_open, seen, revealed[1])
  local close_bounds, longest_close = end_bounds("close", unseen_close, seen, revealed[1])
  local reach = farthest {
    longest = tiles.motions(seen), after = longest_open, revealed = longest_close, as = "doubtful_farthest",
  }.reach
  return doubtful {
    bounds = raster.bounds, behind_bounds = bent_bounds(revealed, "bent_behind"), open_bounds = open_bounds,
    close_bounds = close_bounds, reach = reach,
  }.doubtful
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
