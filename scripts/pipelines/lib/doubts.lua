-- SPDX-License-Identifier: MIT
-- Where the layers of the capture do not say what is seen at other times, and rays at their own time that do.
local pass          = require "strobe.pass"
local pipeline      = require "strobe.pipeline"
local moving_silhouettes = require "passes.mask.moving_silhouettes"
local path_bend     = require "passes.scene.path_bend"
local end_layer     = require "passes.scene.end_layer"
local own_time      = require "passes.scene.own_time"
local unseen_close  = require "passes.scene.unseen_close"
local unseen_open   = require "passes.scene.unseen_open"
local visibility_moving = require "passes.scene.visibility_moving"
local doubtful      = require "passes.tile.doubtful"
local bent_bounds   = require "passes.tile.bent_bounds"
local joined_bounds = require "passes.tile.bent_bounds_joined"
local curves        = require "scripts.pipelines.lib.curves"
local scene         = require "scripts.pipelines.lib.scene"
local tiles         = require "scripts.pipelines.lib.tiles"

local doubts = {}

local findings = pipeline.record("what doubts.looked_at yields", { "behind" })

-- Does the pipeline trace samples at their own time? Only a composite that leaves them open has any.
function doubts.are_asked(p)
  return p.own_time() ~= "none" and pass.reads(pass.member("composite", p.composite()), "doubtful")
end

-- Of samples between texels that differ too?
function doubts.of_detail(p) return p.own_time() == "detailed" end

-- The slowest motion that a filter takes notice of, px; nil: that of every blur, half a pixel. What moves by less needs rays.
function doubts.slowest(p) return doubts.of_detail(p) and p.most_rays() > 0 and 0.02 or nil end

local function jittered(p) return p.jitter() == "none" and 0 or 1 end

-- Over the whole exposure, into however many parts the range is divided.
local function whole_of(layer) return layer.whole_velocity or layer.velocity end

local function bend_of(layer, name)
  return path_bend {
    depth = layer.depth, id = layer.id, velocity = whole_of(layer), hit = layer.hit, normal = layer.normal,
    as = name .. "_bend",
  }
end

-- Per cell, of the texels of a layer that `valid` marks, bounds of their displacements and of how far their paths are from
-- straight lines, joined with those of `others`.
local function bounds_of(name, velocity, bend, valid, others)
  local images = { velocity = velocity, bend = bend, valid = valid, as = name .. "_bounds" }
  if not others then return bent_bounds(images) end
  images.others_bounds, images.others_bends = others.bounds, others.bends
  return joined_bounds(images)
end

-- What an end of the exposure sees and no layer holds.
local function unseen_of(which, unseen, hit, seen, revealed)
  return unseen {
    time = which, hit = hit, depth = seen.depth, id = seen.id,
    revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
  }
end

-- What the pose in the middle of the exposure and those at its ends tell of the layers: how far paths bend, and what an end
-- sees that none of them holds. What nobody asks for does not run.
function doubts.looked_at(seen, revealed)
  local hits = {}
  for _, which in ipairs { "open", "close" } do
    hits[which] = visibility_moving { time = which, as = which .. "_visibility" }.hit
  end
  local found = pipeline.loop { name = "middle", count = 1, times = "even", slices = 1, body = function()
    local result = {}
    local function keep(name, of, images)
      for _, image in ipairs(images) do result[name .. "_" .. image] = of[image] end
    end
    local function keep_bend(name, layer)
      if not layer.curve then keep(name, bend_of(layer, name), { "bend", "bent" }) end
    end
    keep_bend("raster", seen)
    keep("open", unseen_of("open", unseen_open, hits.open, seen, revealed[1]), { "unseen", "velocity", "bend" })
    keep("close", unseen_of("close", unseen_close, hits.close, seen, revealed[1]), { "unseen", "velocity", "bend" })
    for number, layer in ipairs(revealed) do
      keep_bend("revealed_" .. number, layer)
    end
    return result
  end }
  local function bounds_of_layer(name, layer, others)
    local bend, bent = layer.bend or found[name .. "_bend"], layer.bent or found[name .. "_bent"]
    return bounds_of(name .. "_bent", whole_of(layer), bend, bent, others)
  end
  local raster = bounds_of_layer("raster", seen)
  local behind
  for number, layer in ipairs(revealed) do
    behind = bounds_of_layer("revealed_" .. number, layer, behind)
  end
  local ends = {}
  for _, which in ipairs { "open", "close" } do
    local unseen, velocity = found[which .. "_unseen"], found[which .. "_velocity"]
    ends[which] = { hit = hits[which], unseen = unseen, velocity = velocity,
                    bounds = bounds_of(which .. "_unseen", velocity, found[which .. "_bend"], unseen) }
  end
  return findings { raster = raster, behind = behind, ends = ends }
end

-- The cells and times at which something is there of which layers do not say where it is: what bends or grows, and, with
-- `ends`, what an end of the exposure alone sees. `found` is from doubts.looked_at.
function doubts.cells(p, found, ends, name)
  local raster, behind = found.raster, found.behind
  local open, close = ends and found.ends.open.bounds or {}, ends and found.ends.close.bounds or {}
  return doubtful {
    bounds = raster.bounds, bends = raster.bends, behind_bounds = behind.bounds, behind_bends = behind.bends,
    open_bounds = open.bounds, open_bends = open.bends, close_bounds = close.bounds, close_bends = close.bends,
    jittered = jittered(p), as = name,
  }.doubtful
end

-- What a composite reads of the ends of the exposure as layers: open_color, ..., close_dominant.
function doubts.end_layers(p, found)
  local layers = {}
  for _, which in ipairs { "open", "close" } do
    local seen, end_of = found.ends[which], which == "open" and "start" or "finish"
    local made = end_layer { hit = seen.hit, unseen = seen.unseen, end_of = end_of, as = which .. "_layer" }
    layers[#layers + 1] = { which, scene.layer {
      color = made.color, depth = made.depth, velocity = seen.velocity, valid = seen.unseen, id = seen.hit, hit = seen.hit,
      seen_at = end_of,
    } }
  end
  -- Who knows poses of earlier frames has none at the ends.
  if not curves.are_foretold(p) then curves.add(p, layers, "inside_ends") end
  local images = {}
  for _, given in ipairs(layers) do
    local which, own = given[1], given[2]
    local around = tiles.dominant(p, own, { prefix = which .. "_", seen_at = own.seen_at })
    for _, part in ipairs { "color", "depth", "velocity", "valid", "curve" } do
      images[which .. "_" .. part] = own[part]
    end
    for _, part in ipairs { "dominant", "dominant_curve", "dominant_place" } do
      images[which .. "_" .. part] = around[part]
    end
  end
  return images
end

-- Where a sample may fall to either side of an edge, if rays are to tell; else nil.
function doubts.silhouettes(p, seen)
  if p.own_time() ~= "uncertain" and not doubts.of_detail(p) then return nil end
  return moving_silhouettes {
    velocity = seen.velocity, after_velocity = seen.after_velocity, slowest = doubts.slowest(p),
  }.near
end

-- The picture, from what a composite made that left samples open; `revealed` is the first layer behind. Of `limited` rays
-- none checks what layers explain.
function doubts.traced(p, seen, revealed, made, limited)
  return pipeline.loop {
    name = "own_times", count = 1, times = "midpoint", slices = math.min(p.samples(), 64),
    body = function()
      return { picture = own_time {
        seen = made.blurred, open = made.open, time = "sample", shades_unlike = doubts.of_detail(p),
        audit = limited and 0 or nil,
        hit = seen.hit, color = seen.color, depth = seen.depth, id = seen.id, revealed_color = revealed.color,
        revealed_depth = revealed.depth, revealed_id = revealed.id, revealed_valid = revealed.valid,
      }.picture }
    end,
  }.picture
end

return doubts
