-- SPDX-License-Identifier: MIT
-- What tells the object in front from what is behind it: luminance (as published), geometry (what the paper hopes to
-- switch to), instance or motion.
local experiment = require "strobe.experiment"

-- Why a failed expectation fails.
local turns = "termination by motion takes one instance for one thing: only other instances are asked how they move"

local ways = { "luminance", "geometry", "instance", "motion" }

local function error_of(r, shot, arm, region)
  return r.at { shot = shot, arm = arm, region = region or "inner" }.rmse
end

-- In `shot` the error of `arm` is at least `factor` times that of `other`.
local function worse(shot, arm, other, factor, text, region, known)
  return { text, shot = shot, known = known, function(r)
    local a, b = error_of(r, shot, arm, region), error_of(r, shot, other, region)
    return a >= factor * b, ("RMSE %.4f under %s, %.4f under %s, %.1f times"):format(a, arm, b, other, a / b)
  end }
end

-- In `shot` the errors of two are within a tenth of each other.
local function alike(shot, arm, other, text, known)
  return { text, shot = shot, known = known, function(r)
    local a, b = error_of(r, shot, arm), error_of(r, shot, other)
    return a <= 1.1 * b and b <= 1.1 * a, ("RMSE %.4f under %s, %.4f under %s"):format(a, arm, b, other)
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
  title    = "What counts as another object",
  question = "What does GeometryIndex gain over luminance as the sign of another object, and where? The paper asks this.",
  note     = "All arms are hybrid_layered, but with a ray behind everything that moves; they differ in " ..
             "what ends the ray. It goes from hit to hit, up to 8, but under \"instance, one ray\", which ignores the " ..
             "instance in front. Where no hit ends it the pixel is blurred as without rays. Times are ratios to no rays.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = {
    { name = "vase", title = "Living room", scene = "living_room", camera = "main", ["scene.pixels"] = 24,
      note = "A hollow glazed vase, which holds twigs, slides past a striped cushion." },
    panels("plain", "One colour", "plain", "varied", "A closed box of one colour before cells of other luminances."),
    panels("equal", "Equal luminance behind", "plain", "alike",
           "The box before cells as bright as itself, and those before a wall."),
    panels("textured", "Textured front", "textured", "varied", "The box is checkered in two luminances."),
    panels("parts", "Two parts", "parts", "varied", "One object of two parts: a box in a box, of different luminance."),
    panels("alike", "Two parts alike", "alike", "varied", "The same, both as bright as each other."),
    panels("nodes", "Two objects as one", "nodes", "varied", "The same box in a box as two objects that move as one."),
    panels("posts", "Covers itself", "posts", "varied", "A turning ring of posts: one object, whose far side moves " ..
           "against its near side."),
  },
  arms     = arms,
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  base     = "no rays",
  rounds   = 3,
  regions  = { "whole", "inner", "hidden" },
  measures = { "rmse", "flip", "ms_ratio", "pixels" },
  expect   = {
    alike("plain", "luminance", "geometry",
          "in front of something of another luminance a box of one colour needs no more than luminance"),
    worse("equal", "luminance", "geometry", 3,
          "before a background of equal luminance the error under luminance is at least 3 times that under geometry"),
    worse("textured", "luminance", "geometry", 3,
          "with a textured front the error under luminance is at least 3 times that under geometry"),
    worse("vase", "luminance", "geometry", 3,
          "the vase's own far wall is lit otherwise: the error under luminance is at least 3 times that under geometry"),
    alike("vase", "geometry", "instance", "the vase needs no more than geometry",
          "twigs and leaves in and behind the vase are geometries of their own: rays end at them"),
    worse("parts", "geometry", "instance", 3,
          "an object of two parts needs the instance: the error under geometry is at least 3 times as large"),
    worse("alike", "geometry", "luminance", 3,
          "geometry loses to luminance where the parts of an object are equally bright: 3 times the error"),
    worse("nodes", "instance", "motion", 3,
          "two objects that move as one need motion: the error under instance is at least 3 times as large"),
    worse("posts", "instance", "motion", 1.25,
          "what covers itself needs motion: in hidden the error under instance is at least 1.25 times as large", "hidden",
          turns),
    { "motion is nowhere more than a tenth worse than the best of the others", known = turns, function(r)
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
    { "geometry gains where fronts are textured or hollow, or backgrounds as bright, and loses where objects have parts",
      function(r)
        local gains, losses = {}, {}
        for _, shot in ipairs { "vase", "plain", "equal", "textured", "parts", "alike", "nodes" } do
          local ratio = error_of(r, shot, "luminance") / error_of(r, shot, "geometry")
          if ratio >= 1.5 then gains[#gains + 1] = ("%s %.1f"):format(shot, ratio) end
          if ratio <= 1 / 1.5 then losses[#losses + 1] = ("%s %.2f"):format(shot, ratio) end
        end
        return #gains == 3 and #losses == 1, ("error under luminance over that under geometry: gains %s; losses %s"):format(
          table.concat(gains, ", "), #losses > 0 and table.concat(losses, ", ") or "none")
      end },
    worse("vase", "instance", "instance, one ray", 1.5,
          "found afterwards: rays through vase and twigs meet the cap of 8 hits, which one traversal does not"),
    { "one traversal that ignores the instance costs no more than going from hit to hit", function(r)
      local one, many = r.at { arm = "instance, one ray" }.ms_ratio, r.at { arm = "instance" }.ms_ratio
      return one <= 1.02 * many, ("%.2f and %.2f times the time without rays, over all shots"):format(one, many)
    end },
  },
  layout   = { table = {},
               front = { x = "ms_ratio", y = "rmse", region = "inner" } },
}
