-- SPDX-License-Identifier: MIT
-- The parts of the hybrid: its parameters and its composites.
local pass            = require "strobe.pass"
local pipeline        = require "strobe.pipeline"
local layered         = require "passes.composite.layered"
local guessing        = require "passes.filter.layered_guessing"
local mcguire2012     = require "passes.gather.mcguire2012"
local longest_motion  = require "passes.tile.longest_motion"
local moving_behind   = require "passes.mask.moving_behind"
local motion_bounds   = require "passes.tile.motion_bounds"
local joined_bounds   = require "passes.tile.motion_bounds_joined"
local motion_reach    = require "passes.tile.motion_reach"
local reveal          = require "passes.scene.reveal"
local reveal_upsample = require "passes.scene.reveal_upsample"
local budget          = require "scripts.pipelines.lib.budget"
local curves          = require "scripts.pipelines.lib.curves"
local doubts          = require "scripts.pipelines.lib.doubts"
local edges           = require "scripts.pipelines.lib.edges"
local gathers         = require "scripts.pipelines.lib.gathers"
local lists           = require "scripts.pipelines.lib.lists"
local options         = require "scripts.pipelines.lib.options"
local ranges          = require "scripts.pipelines.lib.ranges"
local scene           = require "scripts.pipelines.lib.scene"
local tiles           = require "scripts.pipelines.lib.tiles"

local hybrid = {}

hybrid.mask_texts = {
  none     = "Nothing is revealed: the raster layer blurred alone. Fails at every silhouette that uncovers " ..
             "something: its background is taken from beside it.",
  seed     = "Displaced position, edges there, pixels in range of such an edge (Tan, Cui and Bhojan 2020). Fails " ..
             "when the background moves: it marks by the foreground's own motion, too little where they move " ..
             "against each other and nothing where only the background moves.",
  relative = "Motion relative to what is beyond the silhouette decides. Fails when that motion is visible nowhere " ..
             "near, and on self-occlusion of one instance.",
  moving   = "Everything that moves or that something may move over. Fails to save rays, most of what it marks " ..
             "uncovers nothing, and at the picture's border as all does.",
  all      = "Every pixel. Fails to save any rays, and at the picture's border: where something comes in from " ..
             "outside, which no layer has, the surface revealed behind it is taken.",
}

-- A file of passes/composite is a value.
local function composite_choice()
  local declared = pass.family("composite")
  declared.default, declared.doc = "layered", "how the two layers become one picture"
  declared.values = {
    alpha_over = "Both layers are blurred apart and laid over each other, as published. Wrong where a textured " ..
                 "background moves under a moving silhouette.",
    in_gather  = "One gather along the foreground's motion whose background taps read the revealed layer. Misses " ..
                 "surfaces that move neither like the fastest one around nor like the pixel's own.",
    layered    = "For each time sample the nearest surface of either layer that is at the pixel then. Misses what " ..
                 "is hidden behind two layers.",
  }
  return declared
end

-- What the functions of lib/masks ask for.
function hybrid.mask_params()
  local edge_names = { default = "sobel", doc = "edge detector of the mask `seed`", values = edges.texts() }
  for _, name in ipairs(edges.names) do edge_names[#edge_names + 1] = name end
  return {
    mask      = pipeline.choice { "none", "seed", "relative", "moving", "all", default = "relative",
      doc = "pixels to reveal behind: by their own motion, or by motion relative to what is beyond their silhouette",
      values = hybrid.mask_texts },
    mask_taps = pipeline.int { 1, min = 1, max = 64,
      doc = "positions along the displacement at which the mask `seed` looks for something farther" },
    edge      = pipeline.choice(edge_names),
    own_edge  = pipeline.bool { true, doc = "an edge met along the motion must belong to the pixel's own instance" },
  }
end

-- What samples that have a ray or not, by thresholds and by cells, are no longer.
local by_cell = "which samples have a ray is decided by cells, which begin at the picture's corner"
local of_doubt = { mirrored = by_cell, shifted = by_cell,
                   scaled = "which samples have a ray is decided by thresholds, to whose other side rounding may lead" }

function hybrid.params()
  local choice = pipeline.choice
  return options.with(options.with(options.blur(40), hybrid.mask_params()), {
    termination = reveal.params.termination,
    tolerance   = reveal.params.tolerance,
    luminance_of = reveal.params.luminance_of,
    same_motion = reveal.params.same_motion,
    advance     = reveal.params.advance,
    max_layers  = reveal.params.max_layers,
    revealed_layers = pipeline.int { 1, min = 1, max = 4,
      doc = "composite layered: surfaces revealed one behind another; the next where the last one moves on the screen" },
    on_cap      = reveal.params.on_cap,
    reveal_velocity   = reveal.params.reveal_velocity,
    reveal_resolution = choice { "full", "half", default = "full", doc = "rays per masked pixel",
      values = {
        full = "One ray per masked pixel.",
        half = "One ray per square of 2x2 pixels of which any is masked, shared out by ids and depths. Smooths what " ..
               "is revealed, and moves silhouettes in it by up to a pixel.",
      },
      breaks = { half = { mirrored = "which pixel of a square has the ray is not mirrored" } } },
    reveal_over = choice { "picture", "list", default = "picture", doc = "what the ray reveal runs over: no matter to pictures",
      values = {
        picture = "The whole picture; pixels outside of the mask end at once, beside others that do not.",
        list    = "A list of the masked pixels, so that invocations which run together all have a ray. Three small " ..
                  "passes make it.",
      } },
    tiles       = choice { "separate", "union", default = "union", doc = "dominant motion per layer, or of both",
      values = {
        separate = "Each layer has the longest displacements of its own, as published. Fails where only the " ..
                   "revealed layer moves: what is in front of it is not blurred along that motion.",
        union = "One for both layers, the longest of either. Fails by letting the longer motion of one layer decide " ..
                "where the other is sampled.",
      } },
    range       = ranges.param,
    trajectory  = layered.params.trajectory,
    weights     = choice(gathers.choice("uniform", "of the taps, under alpha_over")),
    directions  = mcguire2012.params.directions,
    composite   = choice(composite_choice()),
    taps        = layered.params.taps,
    end_layers  = pipeline.bool { false,
      doc = "composite layered: what an end of the exposure sees and no layer of the capture holds is a layer too" },
    own_time    = choice { "none", "unexplained", "uncertain", "detailed", default = "none",
      doc = "composite layered: samples that are traced at their own time",
      values = {
        none = "None: where no layer has anything to show, what was revealed at the pixel stands in. Fails where " ..
               "objects turn or enter the picture: what faces the camera only at other times is in no layer.",
        unexplained = "Those at which no layer has anything, and all of cells that something passes which bends away " ..
                      "from a straight path, or which an end of the exposure sees and the capture does not. A ray " ..
                      "each. Fails for what comes out and goes in again within the exposure.",
        uncertain = "Those too that fall within a pixel of a silhouette in motion, of which a filter's nearest pixel may " ..
                    "be on the wrong side.",
        detailed = "Those too that fall between texels that differ, however slow the motion; shaded where the ray meets " ..
                   "them. Texture in motion is met to a part of a pixel, for a ray wherever it has an edge.",
      },
      breaks = { unexplained = of_doubt, uncertain = of_doubt, detailed = of_doubt },
    },
    most_rays   = budget.param,
    unlike      = layered.params.unlike,
    detail_below = layered.params.detail_below,
  })
end

local seed_text = {
  mask = "seed", edge = "sobel", own_edge = false, termination = "luminance", advance = "restart", on_cap = "last_hit",
  tiles = "separate", weights = "mcguire2012", composite = "alpha_over", taps = "nearest", own_time = "none",
}
local seed_linear = options.with(options.with({}, seed_text), { weights = "uniform" })
-- Where the text is silent, what reproduces its claims: rays pass over the object in front, and each tap counts alike.
local seed = options.with(options.with({}, seed_linear), { advance = "instance_filter" })
local captured = {
  mask = "relative", termination = "instance", advance = "instance_filter", on_cap = "fallback",
  tiles = "union", weights = "uniform", composite = "layered", taps = "nearest", own_time = "none",
}
local layers_of_ends = options.with(options.with({}, captured), { revealed_layers = 4, end_layers = true })
local best = options.with(options.with({}, captured), { taps = "linear", own_time = "detailed" })
hybrid.presets = {
  seed        = { doc = "as published, read so that its claims hold: rays pass over the object in front, taps count alike",
                  set = seed },
  seed_text   = { doc = "as published, to the letter", set = seed_text },
  seed_linear = { doc = "to the letter, but each tap counts as an equal share of the exposure", set = seed_linear },
  captured    = { doc = "the layers of the capture alone, per time sample", set = captured },
  layers      = { doc = "all that layers can hold: four behind each other, and what the ends of the exposure see",
                  set = layers_of_ends },
  best        = { doc = "the least error of what has been tried", set = best },
  blended     = { doc = "best, but what layers hold between texels is blended: fewer rays, smoothed texture",
                  set = options.with(options.with({}, best), { own_time = "uncertain" }) },
}

-- Does the composite chosen read that? What others know nothing of is not made for them.
local function knows(p, image) return pass.reads(pass.member("composite", p.composite()), image) end

-- What lies behind the masked pixels: a list of layers, nearest first, each the ports of the pass `reveal`.
function hybrid.revealed(p, seen, mask)
  local half, count = p.reveal_resolution() == "half", knows(p, "revealed_2_color") and p.revealed_layers() or 1
  if half and count > 1 then error("revealed_layers > 1: a ray per pixel is needed, reveal_resolution = full", 0) end
  local function revealed(hit, on, divide, name)
    local listed = p.reveal_over() == "list" and lists.of(on, name, divide) or nil
    return reveal { hit = hit, mask = on, listed = listed, divide = divide, mask_reached = p.mask() == "relative", as = name }
  end
  local rays = revealed(seen.hit, mask, half and 2 or 1, "reveal")
  if half then
    return { reveal_upsample {
      hit = seen.hit, mask = mask, front_depth = seen.depth, color = rays.color, depth = rays.depth, id = rays.id,
      velocity = rays.velocity, valid = rays.valid,
    } }
  end
  local layers = { rays }
  for number = 2, count do
    local last = layers[number - 1]
    local on = moving_behind {
      valid = last.valid, id = last.id, velocity = last.velocity, as = "moving_behind_" .. number,
    }.mask
    layers[number] = revealed(last.found, on, 1, "reveal_" .. number)
  end
  return layers
end

-- The revealed layers as filters see them (ranges.divided). A displacement that is not its own stays one for both parts.
function hybrid.divided(p, revealed)
  local divided = {}
  for number, of in ipairs(revealed) do
    local layer = scene.layer { color = of.color, depth = of.depth, id = of.id, velocity = of.velocity, valid = of.valid }
    if p.reveal_resolution() == "full" then layer.hit = of.found end
    if p.reveal_velocity() == "own" then
      layer = ranges.divided(p, layer, number == 1 and "revealed_halves" or ("revealed_%d_halves"):format(number))
    elseif ranges.are_split(p) then
      layer.after_velocity = layer.velocity
    end
    divided[number] = layer
  end
  return divided
end

-- Displacements per tile for the raster layer, united with the revealed one's if `tiles` says so; `second` as for
-- tiles.dominant.
function hybrid.dominant(p, seen, revealed, second)
  if p.tiles() == "union" then return tiles.dominant(p, seen, { extra = revealed, second = second }) end
  return tiles.dominant(p, seen, { second = second, prefix = "raster_" })
end

-- The same of the revealed layer; `united` is what hybrid.dominant gave.
function hybrid.revealed_dominant(p, revealed, united)
  if p.tiles() == "union" then return united end
  return tiles.dominant(p, revealed, { prefix = "revealed_" })
end

-- The two layers blurred apart, for composites that lay one over the other.
local function blurred(p, seen, revealed)
  local on_top = hybrid.dominant(p, seen, revealed)
  local below = hybrid.revealed_dominant(p, revealed, on_top)
  return {
    front = gathers.blurred(p.weights(), gathers.images(seen, on_top, revealed), "gather_raster", p.color_format),
    back = gathers.blurred(p.weights(), gathers.images(revealed, below), "gather_revealed", p.color_format),
  }
end

local function put(images, prefix, layer)
  for name, image in pairs(layer) do images[prefix .. name] = image end
end

-- The layers as they are, with displacements per tile, for composites that blur by themselves. What a composite reads
-- as x, of the revealed layers it reads as revealed_x, revealed_2_x ...
local function layers(p, seen, revealed, composite)
  ranges.require_parts(seen, composite, "composite = " .. p.composite())
  local images = {}
  put(images, "", seen)
  for number, layer in ipairs(revealed) do
    put(images, number == 1 and "revealed_" or ("revealed_%d_"):format(number), layer)
  end
  put(images, "", hybrid.dominant(p, seen, revealed[1], pass.reads(composite, "second")))
  if p.tiles() == "separate" and pass.reads(composite, "revealed_dominant") then
    put(images, "revealed_", hybrid.revealed_dominant(p, revealed[1]))
  end
  return images
end

-- The cells in which anything happens, for composites that leave out the others.
local function reached_cells(p, seen, revealed, images)
  local function bounds(layer, name, others)
    return (others and joined_bounds or motion_bounds) {
      velocity = layer.velocity, after_velocity = layer.after_velocity, curve = layer.curve, valid = layer.valid,
      others = others, all_count = not layer.valid or nil, as = name,
    }.bounds
  end
  local behind
  for number, layer in ipairs(revealed) do
    behind = bounds(layer, number == 1 and "revealed_bounds" or ("revealed_%d_bounds"):format(number), behind)
  end
  local cells = motion_reach {
    bounds = bounds(seen, "raster_bounds"), behind_bounds = behind, slowest = doubts.slowest(p),
    dominant = images.dominant, after_dominant = images.after_dominant,
    second = images.second, after_second = images.after_second,
    revealed_dominant = images.revealed_dominant, revealed_after_dominant = images.revealed_after_dominant,
    reach = longest_motion {
      longest = images.dominant, curve = images.dominant_curve, after = images.after_dominant,
      revealed = images.revealed_dominant, revealed_after = images.revealed_after_dominant, as = "longest_of_all",
    }.reach,
  }
  return { moved = cells.moved, behind = cells.behind, missed = cells.missed }
end

-- The layers with their names. What was revealed keeps a displacement that is not its own.
local function named(p, seen, revealed)
  local all = { { "raster", seen } }
  for number, layer in ipairs(revealed) do
    all[#all + 1] = { number == 1 and "revealed" or ("revealed_%d"):format(number), layer, p.reveal_velocity() ~= "own" }
  end
  return all
end

-- The picture, by the composite chosen: a pass that reads blurred layers (front, back) or the layers themselves; and where
-- rays are: `mask`, or of a share of the pixels all that have some.
function hybrid.composited(p, seen, revealed, mask)
  local composite = pass.member("composite", p.composite())
  local apart = pass.reads(composite, "front")
  curves.require(p, apart and pass.member("gather", p.weights()) or composite,
    apart and "weights = " .. p.weights() or "composite = " .. p.composite())
  local all = named(p, seen, revealed)
  -- From earlier frames the raster layer has had its curves (pipelines/hybrid.lua).
  curves.add(p, curves.are_foretold(p) and { table.unpack(all, 2) } or all)
  local images = apart and blurred(p, seen, revealed[1]) or layers(p, seen, revealed, composite)
  if pass.reads(composite, "moved") then put(images, "", reached_cells(p, seen, revealed, images)) end
  local doubted, ends = doubts.are_asked(p), p.end_layers() and knows(p, "open_color")
  local found = (doubted or ends) and doubts.looked_at(seen, revealed)
  if ends then
    put(images, "", doubts.end_layers(p, found))
    images.arriving = doubts.cells(p, found, true, "arriving")
  end
  if doubted then
    images.doubtful = doubts.cells(p, found, not ends, "doubtful")
    images.silhouettes = doubts.silhouettes(p, seen)
  end
  local limited = doubted and budget.is_set(p)
  local made = (limited and guessing or composite)(pass.wired(composite, images, {
    as = "composite", leaves_open = doubted or nil, leaves_unlike = doubted and doubts.of_detail(p) or nil,
    slowest = doubted and doubts.slowest(p) or nil,
  }))
  if not doubted then return apart and made.color or made.blurred, mask end
  local traced = mask
  if limited then made, traced = budget.open(p, made, mask) end
  return doubts.traced(p, seen, revealed[1], made, limited), traced
end

return hybrid
