-- SPDX-License-Identifier: MIT
-- Compares rules that decide where a ray through the foreground ends: at the first hit that counts as background. A rule
-- compares the luminance of the hit with the foreground (as published), its geometry (proposed by the paper), its instance or
-- its motion.
local experiment = require "strobe.experiment"

-- Reasons why some of the expectations below failed; reports print these reasons.
local turns = "termination by motion treats each instance as one object: it compares the motions of different instances only"

local ways = { "luminance", "geometry", "instance", "motion" }

local function error_of(r, shot, arm, region)
  return r.at { shot = shot, arm = arm, region = region or "inner" }.rmse
end

-- Returns the expectation that the error of `arm` is at least `factor` times the error of `other`.
local function worse(shot, arm, other, factor, text, region, known)
  return { text, shot = shot, known = known, function(r)
    local a, b = error_of(r, shot, arm, region), error_of(r, shot, other, region)
    return a >= factor * b, ("RMSE %.4f with %s, %.4f with %s, %.1f times"):format(a, arm, b, other, a / b)
  end }
end

-- Returns the expectation that the errors of two arms differ by a factor of at most 1.1.
local function alike(shot, arm, other, text, known)
  return { text, shot = shot, known = known, function(r)
    local a, b = error_of(r, shot, arm), error_of(r, shot, other)
    return a <= 1.1 * b and b <= 1.1 * a, ("RMSE %.4f with %s, %.4f with %s"):format(a, arm, b, other)
  end }
end

local steps = "experiments/pipelines/hybrid_steps.lua"
local arms = { { name = "no rays", pipeline = steps, set = { mask = "none" }, shown = false } }
for _, way in ipairs(ways) do
  arms[#arms + 1] = { name = way, pipeline = steps, shown = way ~= "motion",
    set = { mask = "moving", termination = way, advance = "origin_kept" } }
end
arms[#arms + 1] = { name = "instance, one ray", pipeline = steps, shown = false,
  set = { mask = "moving", termination = "instance", advance = "instance_filter" } }

local function panels(name, title, front, behind, note)
  return { name = name, title = title, note = note, scene = "behind",
           ["scene.front"] = front, ["scene.behind"] = behind }
end

return experiment {
  title    = "Termination of rays",
  question = "A revealing ray ends at the first hit that counts as background. When does a test of the GeometryIndex, " ..
             "proposed by the paper, have a smaller error than the published test of luminance?",
  note     = "All arms except \"no rays\" are hybrid_layered with the mask moving, which selects every pixel that " ..
             "moves or that a moving surface may cover. The arms differ in the rule that ends the ray. Rays advance " ..
             "from hit to hit, up to 8 hits. In the arm \"instance, one ray\" a single traversal ignores the " ..
             "instance in front. If no hit ends the ray, the pixel is blurred as without rays. Times are ratios to " ..
             "the arm \"no rays\".",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "A hollow glazed vase with twigs in it slides past a striped cushion." },
    panels("plain", "One colour", "plain", "varied",
           "A closed box of one colour moves in front of cells of other luminances."),
    panels("equal", "Equal luminance behind", "plain", "alike",
           "The box moves in front of cells of the box's luminance. Behind the cells is a wall."),
    panels("textured", "Textured front", "textured", "varied", "The box is checkered in two luminances."),
    panels("parts", "Two parts", "parts", "varied", "One object of two parts with different luminance: a box in a box."),
    panels("alike", "Two parts alike", "alike", "varied", "One object of two parts with equal luminance: a box in a box."),
    panels("nodes", "Two objects as one", "nodes", "varied", "A box in a box, as two objects that move together."),
    panels("posts", "Covers itself", "posts", "varied", "A turning ring of posts is one object. Its far side and " ..
           "its near side move in opposite directions."),
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  base     = "no rays",
  rounds   = 3,
  regions  = { "whole", "inner", "hidden" },
  measures = { "rmse", "flip", "ms_ratio", "pixels" },
  expect   = {
    alike("plain", "luminance", "geometry",
          "for a box of one colour in front of a background of another luminance, termination by luminance " ..
            "suffices: the error with luminance and the error with geometry are within a tenth of each other"),
    worse("equal", "luminance", "geometry", 3,
          "in front of a background of equal luminance the error with luminance is at least 3 times the error with " ..
          "geometry"),
    worse("textured", "luminance", "geometry", 3,
          "if the foreground is textured, the error with luminance is at least 3 times the error with geometry"),
    worse("vase", "luminance", "geometry", 3,
          "the vase's far wall is lit differently from its near wall, so the error with luminance is at least 3 times the " ..
            "error with geometry"),
    alike("vase", "geometry", "instance",
          "for the vase, termination by geometry suffices: the error with geometry and the error with instance are " ..
            "within a tenth of each other",
          "twigs and leaves in and behind the vase are separate geometries, so rays end at them"),
    worse("parts", "geometry", "instance", 3,
          "an object of two parts needs termination by instance: the error with geometry is at least 3 times the " ..
            "error with instance"),
    worse("alike", "geometry", "luminance", 3,
          "if the parts of an object are equally bright, the error with geometry is at least 3 times the error with luminance"),
    worse("nodes", "instance", "motion", 3,
          "two objects that move as one need termination by motion: the error with instance is at least 3 times the " ..
            "error with motion"),
    worse("posts", "instance", "motion", 1.25,
          "an object that covers itself needs termination by motion: in the region hidden the error with instance " ..
            "is at least 1.25 times the error with motion", "hidden", turns),
    { "in the region hidden of every shot the error with motion is at most 1.1 times the smallest error of the other rules",
      known = turns, function(r)
      local most, where = 0, ""
      for _, shot in ipairs { "vase", "plain", "equal", "textured", "parts", "alike", "nodes", "posts" } do
        local least = math.huge
        for _, way in ipairs { "luminance", "geometry", "instance" } do
          least = math.min(least, error_of(r, shot, way, "hidden"))
        end
        local ratio = error_of(r, shot, "motion", "hidden") / least
        if ratio > most then most, where = ratio, shot end
      end
      return most <= 1.1, ("at most %.2f times, in the shot %s"):format(most, where)
    end },
    { "geometry has a smaller error than luminance for a textured or hollow foreground and for a background of equal " ..
      "luminance, and a larger error for an object of parts",
      function(r)
        local gains, losses = {}, {}
        for _, shot in ipairs { "vase", "plain", "equal", "textured", "parts", "alike", "nodes" } do
          local ratio = error_of(r, shot, "luminance") / error_of(r, shot, "geometry")
          if ratio >= 1.5 then gains[#gains + 1] = ("%s %.1f"):format(shot, ratio) end
          if ratio <= 1 / 1.5 then losses[#losses + 1] = ("%s %.2f"):format(shot, ratio) end
        end
        return #gains == 3 and #losses == 1, ("error with luminance over error with geometry: gains %s; losses %s"):format(
          table.concat(gains, ", "), #losses > 0 and table.concat(losses, ", ") or "none")
      end },
    worse("vase", "instance", "instance, one ray", 1.5,
          "found afterwards: rays that advance through vase and twigs end at the limit of 8 hits, and have at least 1.5 " ..
          "times the error of a single traversal, which has no limit"),
    { "a single traversal that ignores the instance takes at most 1.02 times the time of an advance from hit to hit",
      function(r)
      local one, many = r.at { arm = "instance, one ray" }.ms_ratio, r.at { arm = "instance" }.ms_ratio
      return one <= 1.02 * many, ("%.2f and %.2f times the time without rays, over all shots"):format(one, many)
    end },
  },
  layout   = { table = {},
               front = { x = "ms_ratio", y = "rmse", region = "inner" } },
}
