-- SPDX-License-Identifier: MIT
-- Shows the most frequent complaints about motion blur. Each shot is one exhibit: an artefact, its error and its remedy.
--   strobe sweep experiments/exhibits/exhibits.lua -o out/exhibits
local experiment = require "strobe.experiment"

local none, bevy, mcguire, best = "no vectors", "Bevy", "McGuire 2012", "adaptive"
local short, ue4, last_frame = "UE4-style, limit 0.05", "UE4-style", "McGuire 2012, last frame's path"
local steps = "experiments/pipelines/hybrid_steps.lua"
local straight, curved = "layers, straight paths", "layers, curved paths"
local frozen = "truth, light at the raster time"

local grain = "a blended surface is drawn in a random share of the pixels of the raster image, and this grain remains in " ..
              "the picture"

-- Arms of each exhibit, by the name of the shot: first the arms with the artefact, then the arms without the artefact. Times of
-- an exhibit are ratios to the time of its first arm.
local drawn = {
  wheel      = { { straight }, { curved, best } },
  silhouette = { { bevy }, { mcguire, best } },
  halo       = { { mcguire, ue4 }, { best } },
  glass      = { { mcguire }, { best } },
  sky        = { { none }, { mcguire, best } },
  share      = { { mcguire, best }, {} },
  seconds    = { {}, { mcguire, best } },
  jump       = { { last_frame }, { mcguire, best } },
  followed   = { { mcguire, best }, {} },
  follow     = { {}, { mcguire, best } },
  short      = { { short }, { ue4, best } },
  shadow     = { { mcguire, best, frozen }, {} },
  chase      = { { mcguire, straight }, { best } },
  drive      = { { mcguire }, { best } },
  skin       = { { none }, { mcguire, best } },
}

local function is_drawn(shot, arm)
  for _, names in ipairs(drawn[shot]) do
    for _, name in ipairs(names) do if name == arm then return true end end
  end
  return false
end

-- Extends the note of each shot by a list of the arms with the artefact and without the artefact. Returns `shots`.
local function labelled(shots)
  for _, shot in ipairs(shots) do
    local wrong, mended = drawn[shot.name][1], drawn[shot.name][2]
    if #mended > 0 and #wrong > 0 then
      shot.note = ("%s With the artefact: %s. Without: %s."):format(shot.note, table.concat(wrong, "; "),
        table.concat(mended, "; "))
    end
  end
  return shots
end

local function at(r, shot, arm, more)
  local wanted = { shot = shot, arm = arm }
  for key, value in pairs(more or {}) do wanted[key] = value end
  return r.at(wanted)
end

-- Returns the expectation that the error of the arm `mended` is at most `share` times the error of the arm `wrong`, which has
-- the artefact. The report shows both errors, their ratio, and the ratio of the frame times of both arms.
local function mends(shot, wrong, mended, share, more)
  local where = more and more.region and ", " .. more.region or ""
  return { ("%s%s: %s has at most %g times the error of %s"):format(shot, where, mended, share, wrong), shot = shot,
    function(r)
      local before, after = at(r, shot, wrong, more).rmse, at(r, shot, mended, more).rmse
      local times = at(r, shot, mended).ms_ratio / at(r, shot, wrong).ms_ratio
      return after <= share * before, ("RMSE %.4f and %.4f, %.2f times the error, in %.1f times the time"):format(after, before,
        after / before, times)
    end }
end

local function changed(r, shot, rate)
  local most = 0
  for _, arm in ipairs { mcguire, best, "ground truth" } do
    most = math.max(most, at(r, shot, arm, { rate = rate }).change_rms)
  end
  return most
end

return experiment {
  title    = "Complaints about motion blur",
  question = "Which artefacts do users of motion blur report most, how large are their errors, and what reduces them?",
  note     = "Thirteen complaints have one exhibit each; the sixth and the eighth have two shots. In each shot the first " ..
             "arms have the artefact, and the other arms, if any, do not. Times are ratios to the first arm of the shot. " ..
             "The arms are timed in turn in one run. Errors are against truth with the shading of the raster time. In the " ..
             "tenth exhibit, truth is shaded at each time sample.",
  size     = { 320, 180 },
  size_params = { "width", "height" },
  shots    = labelled {
    { name = "wheel", title = "1 Wheels blur in straight lines", scene = "objects/spoked_wheel", ["scene.pixels"] = 40,
      note = "A displacement is a straight line, so a spoke that turns by 45 degrees changes its length. Remedies: curved " ..
             "paths (trajectory=arc) in the layered composite, or rays at several times." },
    { name = "silhouette", title = "2 Blur stops at the silhouette", scene = "living_room", camera = "main",
      ["scene.pixels"] = 26,
      note = "Each pixel gathers along its own displacement, which is zero beside the vase. Remedy outside the " ..
             "silhouette: gather along the dominant displacement of the tile. Remedy inside the silhouette: rays, " ..
             "which find the background." },
    { name = "halo", title = "3 Halos around near objects", scene = "objects/car_and_road", ["scene.follow"] = 1,
      ["scene.pixels"] = 60,
      note = "The blur of the road beside the car needs road that the car hides at the raster time. Taps on the car are " ..
             "rejected, and the remaining taps leave a border around the car. Remedy: rays, which find the road " ..
             "behind the car." },
    { name = "glass", title = "4 Transparent objects", scene = "objects/glass",
      note = "A pixel stores one displacement, of the pane or of the wall behind the pane. Here blended materials are drawn " ..
             "in a random share of the pixels, and each pixel stores the displacement of the surface that it shows. Rays " ..
             "find the background of the pixels that show the pane." },
    { name = "sky", title = "5 The sky is not blurred", scene = "objects/panorama",
      note = "A renderer that stores no motion vectors for the sky, or draws the sky's dome without them, leaves the sky " ..
             "sharp. Here the sky and domes have the displacement of the camera's motion, in every method." },
    { name = "share", title = "6 Strength of blur depends on the frame rate: exposure as a share of the frame",
      scene = "objects/car_and_road", ["scene.follow"] = 0, ["scene.pixels"] = 40, exposure = 0.5,
      note = "An exposure of half a frame lasts a sixth as long at 144 frames per second as at 24, so the blur is a sixth " ..
             "as long." },
    { name = "seconds", title = "6 Exposure in seconds", scene = "objects/car_and_road", ["scene.follow"] = 0,
      ["scene.pixels"] = 40, exposure_time = 1 / 48,
      note = "Remedy: exposure_time gives the exposure in seconds, so it lasts as long as at 24 frames per second." },
    { name = "jump", title = "7 First frame, cut, teleport: a streak over the screen", scene = "objects/jump", frame = 12,
      anchor = "start",
      note = "A renderer that keeps only the poses of the last frame treats the jump as motion. Here the exposure " ..
             "is after the jump, and the remedy is to use poses within the exposure (displacement=window). If the " ..
             "jump is within the exposure, the remedy is a cut." },
    { name = "followed", title = "8 The object that the camera follows is blurred", scene = "objects/car_and_road",
      ["scene.follow"] = 1, ["scene.pixels"] = 60, camera_blur = 0.3,
      note = "Many games let the player reduce the blur of the camera's motion. Then the car, which moves with the camera, " ..
             "is blurred by the motion that the camera loses. Remedy: --follow car reduces the car's motion by the same " ..
             "share." },
    { name = "follow", title = "8 Blur of the camera reduced, with --follow", scene = "objects/car_and_road",
      ["scene.follow"] = 1, ["scene.pixels"] = 60, camera_blur = 0.3, follow = "car",
      note = "The car is sharp. The road is blurred over three tenths of its displacement." },
    { name = "short", title = "9 The blur is too short", scene = "objects/car_and_road", ["scene.follow"] = 0,
      ["scene.pixels"] = 60,
      note = "A limit of 5 % of the width shortens the displacement from 60 px to 16 px. Remedy: limit=auto, the default." },
    { name = "shadow", title = "10 Shadows and reflections do not blur", scene = "objects/shadow",
      truth = { shading = "full" },
      note = "The floor under the shadow does not move, so it has no displacement, and its light is computed at the raster " ..
             "time. Only truth with shading=full blurs the shadow. Reflections of objects are not tested, because surfaces " ..
             "reflect only the sky." },
    { name = "chase", title = "11 The road under a racing car appears on the car", scene = "objects/chase",
      note = "Filters compare depths at the raster time. At that time, a road mark between the camera and the " ..
             "bumper is nearer than the car. But at the time when the mark is at a pixel of the car, the mark is " ..
             "under the car. Remedy: compare depths at the time of the sample." },
    { name = "drive", title = "12 Vectors flip behind the near plane", scene = "objects/drive", anchor = "start",
      note = "A post that the camera passes leaves the view frustum through the near plane. The perspective division by a " ..
             "negative depth reverses its path. Here the path is extrapolated from its part in front of the near plane. " ..
             "Rays need no such division." },
    { name = "skin", title = "13 Skinned and instanced objects", scene = "skin.gltf", fps = 2, frame = 1,
      note = "A skinned mesh that has only the motion vectors of its node stays sharp, and so do instances without " ..
             "motion vectors. Here motion vectors are differences of vertex positions at shutter open and close, so " ..
             "every method blurs these objects. Rays find the disoccluded background." },
  },
  arms     = {
    { name = none, pipeline = "none" },
    { name = last_frame, pipeline = "mcguire2012", set = { displacement = "extrapolated" } },
    { name = short, pipeline = "ue4", set = { limit = 0.05 } },
    { name = bevy, pipeline = "bevy" },
    { name = mcguire, pipeline = "mcguire2012" },
    { name = ue4, pipeline = "ue4" },
    { name = straight, pipeline = steps, set = { mask = "moving" } },
    { name = curved, pipeline = steps, set = { mask = "moving", trajectory = "arc" } },
    { name = best, pipeline = "adaptive" },
    { name = frozen, pipeline = "ground_truth", role = "floor",
      set = { samples = 256, times = "stratified", shading = "frozen" } },
  },
  truth    = { pipeline = "ground_truth", set = { samples = 256, times = "stratified" } },
  vary     = { experiment.each {
    experiment.list { name = "case", values = { "as it is" }, at = function() return {} end,
      shots = { "wheel", "silhouette", "halo", "glass", "sky", "follow", "short", "shadow", "chase", "drive", "skin" } },
    experiment.list { name = "rate", title = "frames per second", values = { 144, 24 }, benign = 24,
      shots = { "share", "seconds" }, at = function(value) return { fps = value } end },
    experiment.list { name = "follow", values = { "nothing", "car" }, benign = "car", shots = { "followed" },
      at = function(value) return value == "car" and { follow = value } or {} end },
    experiment.list { name = "cut", values = { false, true }, shots = { "jump" },
      at = function(value) return { ["scene.cut"] = value } end },
  } },
  skip     = function(point) return not is_drawn(point.shot, point.arm) end,
  regions  = { "whole", "inner", "outer" },
  measures = { "rmse", "flip", "rays", "ms_ratio", "displacement", "clamped", "change_rms" },
  rounds   = 7,
  expect   = {
    mends("wheel", straight, curved, 0.75), mends("wheel", straight, best, 0.5),
    mends("silhouette", bevy, mcguire, 0.8, { region = "outer" }), mends("silhouette", bevy, best, 0.2),
    mends("halo", mcguire, best, 0.5), mends("halo", ue4, best, 0.5),
    mends("glass", mcguire, best, 0.5),
    mends("sky", none, mcguire, 0.5), mends("sky", none, best, 0.2),
    { "share: at 144 frames per second the displacement is a sixth of that at 24, and the picture of adaptive " ..
      "changes by more than five times the error of adaptive", shot = "share", function(r)
      local fast, slow = at(r, "share", best, { rate = 144 }), at(r, "share", best, { rate = 24 })
      local ratio = fast.displacement / slow.displacement
      return math.abs(ratio * 6 - 1) < 0.02 and fast.change_rms > 5 * slow.rmse,
        ("%.1f and %.1f px; the picture changes by %.4f, the error of adaptive is %.4f"):format(fast.displacement,
          slow.displacement, fast.change_rms, slow.rmse)
    end },
    { "seconds: no picture changes with the frame rate, truth included", shot = "seconds", function(r)
      return changed(r, "seconds", 144) == 0, ("change %g; with the exposure as a share of the frame up to %.4f"):format(
        changed(r, "seconds", 144), changed(r, "share", 144))
    end },
    mends("jump", last_frame, mcguire, 0.5, { cut = false }), mends("jump", last_frame, best, 0.2, { cut = false }),
    { "found afterwards: jump: a cut removes the streak, but the first frame after the cut has no displacements",
      shot = "jump", function(r)
        local streak = at(r, "jump", last_frame, { cut = false, region = "whole" })
        local cut = at(r, "jump", last_frame, { cut = true, region = "whole" })
        return streak.displacement > 5 * at(r, "jump", mcguire, { cut = false }).displacement and cut.displacement == 0 and
          cut.flip < streak.flip, ("displacements %.1f and %.1f px, FLIP %.4f and %.4f"):format(streak.displacement,
          cut.displacement, streak.flip, cut.flip)
      end },
    { "followed: --follow changes adaptive's picture by at least five times adaptive's error", shot = "followed",
      function(r)
      local wrong, own = at(r, "followed", best, { follow = "nothing" }).change_rms, at(r, "followed", best,
        { follow = "car" }).rmse
      return wrong >= 5 * own, ("change %.4f, error %.4f"):format(wrong, own)
    end },
    { "short: a limit of 5 % of the width shortens displacements, and limit=auto does not", shot = "short", function(r)
      local clamped, free = at(r, "short", short).clamped, at(r, "short", ue4).clamped + at(r, "short", best).clamped
      return clamped > 0 and free == 0, ("%d pixels shortened"):format(clamped)
    end },
    { "found afterwards: short: if the background is estimated, unshortened displacements reduce the error by less than a " ..
      "fifth", shot = "short", function(r)
      local ratio = at(r, "short", ue4).rmse / at(r, "short", short).rmse
      return ratio > 0.8, ("%.2f of the error"):format(ratio)
    end },
    mends("short", short, best, 0.2),
    { "shadow: at least nine tenths of adaptive's error come from the light of the raster time, which no parameter changes",
      shot = "shadow", function(r)
      local own, light = at(r, "shadow", best).rmse, at(r, "shadow", frozen).rmse
      return light >= 0.9 * own, ("RMSE %.4f, truth with light at the raster time %.4f"):format(own, light)
    end },
    mends("chase", mcguire, best, 0.2),
    { "found afterwards: chase: layers at the raster time reduce the error by less than a fifth, because they lack surfaces " ..
      "that enter at the border", shot = "chase",
      function(r)
        local ratio = at(r, "chase", straight).rmse / at(r, "chase", mcguire).rmse
        return ratio > 0.8, ("%.2f of the error"):format(ratio)
      end },
    mends("drive", mcguire, best, 0.2),
    mends("skin", none, mcguire, 0.9), mends("skin", none, best, 0.2),
    { "in every exhibit except the shadow, adaptive has at most 0.3 times the error of the first arm with the " ..
      "artefact",
      known = grain, function(r)
        local most, where = 0, ""
        for shot, arms in pairs(drawn) do
          local wrong = shot ~= "shadow" and arms[1][1]
          if wrong and arms[2][1] then
            local ratio = at(r, shot, best).rmse / at(r, shot, wrong).rmse
            if ratio > most then most, where = ratio, shot end
          end
        end
        return most <= 0.3, ("at most %.2f times the error (%s)"):format(most, where)
      end },
  },
  layout   = { pictures = { crop_size = { 120, 68 } }, table = {} },
}
