-- SPDX-License-Identifier: MIT
-- What a frame costs as it has more of one thing: pixels, masked pixels, motion, samples, triangles, instances, lights.
--   strobe bench slopes experiments/costs/costs.lua -o out/slopes
local experiment = require "strobe.experiment"

local height, displacement = 180, 16
local seed, best = "hybrid (as published)", "hybrid (best)"

-- An axis along which only the scene of cards varies.
local function axis(fields)
  fields.shots = { "cards" }
  return experiment.list(fields)
end

local function sets(parameter, from)
  return function(value) return { ["scene." .. parameter] = from and from(value) or value } end
end

local function constant(part, why) return { part = part, grows = "constant", why = why } end
local function linear(part, why, arm) return { part = part, grows = "linear", why = why, arm = arm } end
local function logarithmic(part, why) return { part = part, grows = "logarithmic", why = why } end

local pixels = axis {
  name = "pixels", title = "Pixels", unit = "px",
  values = { 160 * 90, 320 * 180, 480 * 270, 640 * 360, 800 * 450 },
  at = function(count)
    local h = math.floor(math.sqrt(count * 9 / 16) + 0.5)
    return { size = { h * 16 // 9, h }, ["scene.shift"] = displacement / h }
  end,
  costs = {
    linear("frame", "passes do the same at every pixel"),
    linear("shade"), linear("gather"), linear("composite"),
  },
}

local masked = axis {
  name = "cover", title = "Masked pixels, by the size of what moves", unit = "px", against = "masked",
  values = { 0.1, 0.2, 0.4, 0.6, 0.8 }, at = sets "cover",
  costs = {
    { part = "frame", arm = "no blur", grows = "constant" },
    linear("reveal", "a ray for each masked pixel"),
    constant("shade", "every pixel sees a surface, masked or not"),
  },
}

local moved = axis {
  name = "shift", title = "Displacement", unit = "px", values = { 2, 4, 8, 16, 32 },
  at = sets("shift", function(value) return value / height end),
  costs = {
    { part = "frame", arm = "no blur", grows = "constant" },
    linear("reveal", "the mask is as wide as the displacement"),
    constant("gather", "as many taps, however far apart"),
    constant("shade"),
  },
}

local samples = axis {
  name = "samples", title = "Samples", values = { 4, 8, 16, 32, 64 },
  costs = {
    linear("gather", "a tap for each sample"), linear("composite", "a tap for each sample", best),
    constant("shade", "it knows nothing of samples"), constant("reveal"),
  },
}

local triangles = axis {
  name = "triangles", title = "Triangles of the wall", values = { 2, 512, 8192, 32768, 131072 },
  at = sets("cells", function(count) return math.floor(math.sqrt(count / 2) + 0.5) end),
  costs = {
    logarithmic("shade", "shadow rays walk down a tree"), logarithmic("reveal", "rays walk down a tree"),
    linear("visibility", "raster reads each vertex"),
    constant("gather"), constant("composite"),
  },
}

local instances = axis {
  name = "instances", title = "Instances", values = { 1, 16, 64, 256, 1024 }, at = sets "instances",
  costs = {
    linear("(rest)", "the structure over instances is built in every frame"),
    linear("visibility", "each is drawn for itself"),
    logarithmic("shade", "shadow rays walk down a tree"), logarithmic("reveal", "rays walk down a tree"),
    constant("gather"), constant("composite"),
  },
}

local lights = axis {
  name = "lights", title = "Lights", values = { 1, 2, 4, 8, 16 }, at = sets "lights",
  costs = {
    linear("frame", "a shadow ray for each light and pixel"), linear("shade", "a shadow ray for each light and pixel"),
    linear("reveal", "what is revealed is shaded too"),
    constant("gather"), constant("composite"),
  },
}

local figure = "Tan, Cui and Bhojan 2020, figure 1: GeForce RTX 2080 Ti, size not stated"

return experiment {
  title    = "What a frame costs",
  question = "How does the time of a frame and of its passes grow with what the frame has?",
  size     = { 320, height },
  shots    = {
    { name = "cards", scene = "cards" },
    { name = "living room", scene = "living_room" },
  },
  arms     = {
    { name = "no blur", pipeline = "none", lacks = { "samples" } },
    { name = "McGuire 2012", pipeline = "mcguire2012", published = { fps = 295, by = figure } },
    { name = seed, pipeline = "hybrid", set = { preset = "seed" }, published = { fps = 205, by = figure } },
    { name = best, pipeline = "hybrid", set = { preset = "best" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 16 } },
  rounds   = 15,
  vary     = { experiment.each { pixels, masked, moved, samples, triangles, instances, lights } },
  regions  = { "whole", "inner" },
  measures = { "rmse", "rays", "masked", "ms" },
}
