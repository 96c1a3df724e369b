-- SPDX-License-Identifier: MIT
-- Measures how the time of a frame depends on pixels, masked pixels, motion, samples, triangles, instances and lights. Only one
-- of these quantities varies at a time.
--   strobe bench slopes experiments/costs/costs.lua -o out/slopes
local experiment = require "strobe.experiment"

local height, displacement = 180, 16
local layered = "hybrid_layered"

-- Returns a function that declares expected times. `how`: expected growth of the time with the varied quantity ("constant",
-- "linear" or "logarithmic"). Arguments of the function: `parts`, names of passes or "frame", separated by spaces; `why`, the
-- reason for this growth; `arm`, the only arm with this growth (nil: all arms).
local function grow(how)
  return function(parts, why, arm)
    local list = {}
    for part in parts:gmatch "%S+" do list[#list + 1] = { part = part, grows = how, why = why, arm = arm } end
    return list
  end
end
local constant, linear, logarithmic = grow "constant", grow "linear", grow "logarithmic"

-- Returns an axis (a varied quantity) of the shot `cards`. The field `costs` of `fields` is a list of lists of expected times,
-- which this function joins to one list.
local function axis(fields)
  local costs = {}
  for _, list in ipairs(fields.costs) do table.move(list, 1, #list, #costs + 1, costs) end
  fields.shots, fields.costs = { "cards" }, costs
  return experiment.list(fields)
end

local function sets(parameter, from)
  return function(value) return { ["scene." .. parameter] = from and from(value) or value } end
end

local gathers = "gather gather_raster"

local pixels = axis {
  name = "pixels", title = "Pixels of the picture", unit = "px",
  values = { 160 * 90, 320 * 180, 480 * 270, 640 * 360, 800 * 450 },
  at = function(count)
    local h = math.floor(math.sqrt(count * 9 / 16) + 0.5)
    return { size = { h * 16 // 9, h }, ["scene.shift"] = displacement / h }
  end,
  costs = {
    linear("frame", "each pass runs at every pixel"),
    linear("gbuffer shade composite " .. gathers, "constant work at every pixel"),
  },
}

local masked = axis {
  name = "cover", title = "Masked pixels, by the size of the moving cards", unit = "px", against = "masked",
  values = { 0.1, 0.2, 0.4, 0.6, 0.8 }, at = sets "cover",
  costs = {
    constant("frame", "a frame without blur has no mask", "no blur"),
    linear("reveal", "a ray for each masked pixel"),
    constant("shade", "every pixel shows a surface, masked or not"),
  },
}

local moved = axis {
  name = "shift", title = "Displacement over the exposure, px", unit = "px", against = "displacement",
  values = { 2, 4, 8, 16, 32 },
  at = sets("shift", function(value) return value / height end),
  costs = {
    constant("frame", "independent of motion", "no blur"),
    linear("reveal", "the mask is as wide as the displacement"),
    constant(gathers, "the number of taps is constant, only their distance grows"),
    constant("shade", "independent of motion"),
  },
}

local samples = axis {
  name = "samples", title = "Samples", unit = "sample", values = { 4, 8, 16, 32, 64 },
  costs = {
    linear(gathers, "a tap for each sample"),
    linear("composite", "a tap for each sample", layered),
    constant("shade reveal", "independent of samples"),
  },
}

local triangles = axis {
  name = "triangles", title = "Triangles of the wall", unit = "triangle", values = { 2, 512, 8192, 32768, 131072 },
  at = sets("cells", function(count) return math.floor(math.sqrt(count / 2) + 0.5) end),
  costs = {
    logarithmic("shade reveal", "rays descend a tree"),
    linear("visibility", "raster reads each vertex"),
    constant("composite " .. gathers, "depends on pixels alone"),
  },
}

local instances = axis {
  name = "instances", title = "Instances", unit = "instance", values = { 1, 16, 64, 256, 1024 }, at = sets "instances",
  costs = {
    linear("visibility", "a draw for each instance"),
    logarithmic("shade reveal", "rays descend a tree"),
    constant("composite " .. gathers, "depends on pixels alone"),
  },
}

local lights = axis {
  name = "lights", title = "Lights", unit = "light", values = { 1, 2, 4, 8, 16 }, at = sets "lights",
  costs = {
    linear("frame shade", "a shadow ray for each light and pixel"),
    linear("reveal", "the revealed background is shaded too"),
    constant("composite " .. gathers, "independent of lights, because shaded images are blurred"),
  },
}

-- Returns a frame rate that the paper published, for comparison. It was measured with another model of a living room.
local function published(fps)
  return { fps = fps, shot = "living room", by = "Tan, Cui and Bhojan 2020, figure 1: GeForce RTX 2080 Ti, size not stated" }
end

return experiment {
  title    = "Cost of a frame",
  question = "How does the time of a frame and of its passes grow with pixels, motion, samples, geometry and lights?",
  size     = { 320, height },
  shots    = {
    { name = "cards", scene = "cards" },
    { name = "living room", scene = "living_room" },
  },
  arms     = {
    { name = "no blur", pipeline = "none", lacks = { "samples" } },
    { name = "McGuire 2012", pipeline = "mcguire2012", published = published(295) },
    { name = "hybrid", pipeline = "hybrid", published = published(205) },
    { name = layered, pipeline = "hybrid_layered" },
    { name = "adaptive", pipeline = "adaptive" },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 16 } },
  rounds   = 15,
  vary     = { experiment.each { pixels, masked, moved, samples, triangles, instances, lights } },
  regions  = { "whole", "inner" },
  measures = { "rmse", "rays", "masked", "ms" },
}
