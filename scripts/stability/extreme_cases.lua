-- SPDX-License-Identifier: MIT
-- Cases at the limits of numbers, tiles, cameras and scenes. Each case runs with every pipeline and each of its presets. The
-- correct result follows from a closed form, from truth, or from a picture that must be equal.
--   strobe stability --extremes --write docs/extreme-cases.md
--
-- A case has a name, a clause (its category), a text `says` (its requirement in words) and a function that returns its
-- checks.
--
-- A check names a shot to draw, one requirement on the picture, and, in `by`, the pipelines that it applies to. Every
-- picture that a check draws must be finite. The sharp picture is the picture without blur, of the pipeline `none`. The
-- requirements are:
--   draws         only that the picture is finite
--   as_captured   all but `pixels` pixels are equal, bit for bit, to the sharp picture of the shot. If the check has a shot
--                 `of`, the sharp picture is of that shot
--   within        all colours are in the range `low` to `high`. `unless`: text of a warning that lifts this requirement
--   nearer        the picture has a smaller error against truth than the sharp picture
--   same          at most `share` of the pixels differ by more than `tolerance` from the picture of the shot `other`
--   displacement  `exact` has the expected velocity of each pixel. The velocity differs from it by at most `share` of its
--                 length plus `tolerance_px`. A pixel with the value false in `exact` is not checked
--   truth         the red channel of truth equals `exact` within `tolerance`
--   sharp_at      the sharp picture has the red value `value` at a pixel, within `tolerance`
--   warns         a warning contains `text`
--   silent        no warning contains `text`
-- Values of `by`:
--   "all", "truth", "all_but_truth"
--   "blurs"       all pipelines except truth and the sharp picture
--   "filters"     blurs with a parameter `limit`
--   "others"      all pipelines except filters
-- If a pipeline lacks a parameter that a shot sets, this setting is left out.
local wanted = ...

local truth_times = 64

local list = {}

local function case(name, clause, says, checks)
  list[#list + 1] = { name = name, clause = clause, says = says, checks = checks }
end

-- ---- checks

local function draws(shot) return { check = "draws", shot = shot } end
local function as_captured(shot, pixels) return { check = "as_captured", shot = shot, pixels = pixels } end
local function within(shot, low, high) return { check = "within", shot = shot, low = low, high = high } end
local function nearer(shot) return { check = "nearer", shot = shot, by = "blurs" } end
local function warns(shot, text, by) return { check = "warns", shot = shot, text = text, by = by } end
local function silent(shot, text, by) return { check = "silent", shot = shot, text = text, by = by } end

local function same(shot, other, tolerance, share)
  return { check = "same", shot = shot, other = other, tolerance = tolerance, share = share }
end

-- Calls visit(x, y) for each pixel, row by row from the top left. x, y: centre of the pixel.
local function each_pixel(shot, visit)
  for y = 0, shot.size[2] - 1 do
    for x = 0, shot.size[1] - 1 do visit(x + 0.5, y + 0.5) end
  end
end

-- Check of displacements. path(x, y) returns the exact displacement of a pixel, px over the exposure; nil if it is not checked.
local function displacement(shot, path, share, tolerance_px)
  local exact = {}
  each_pixel(shot, function(x, y)
    local dx, dy = path(x, y)
    exact[#exact + 1] = dx or false
    exact[#exact + 1] = dy or false
  end)
  return { check = "displacement", shot = shot, exact = exact, share = share, tolerance_px = tolerance_px }
end

local function truth(shot, value, tolerance)
  local exact = {}
  each_pixel(shot, function(x, y) exact[#exact + 1] = value(x, y) end)
  return { check = "truth", shot = shot, exact = exact, tolerance = tolerance, by = "truth" }
end

-- ---- shots

local function merged(...)
  local result = {}
  for _, part in ipairs { ... } do
    for key, value in pairs(part) do result[key] = value end
  end
  return result
end

-- Returns the settings with whole numbers as integers, as if they were typed on the command line.
local function plain(settings)
  local result = {}
  for name, value in pairs(settings) do
    result[name] = math.type(value) == "float" and math.tointeger(value) or value
  end
  return result
end

local function shot(scene, width, height, scene_set, set, more)
  local numbers = plain(merged({ width = width, height = height }, scene_set))
  return merged({ scene = scene, size = { width, height }, frame = 0, scene_set = numbers, set = set }, more or {})
end

local anchors = { "end", "centre", "start" }

-- ---- a bar over a static background

local bar_value, back_value = 1, 0.2

local function bar_in(width, height, displacement_px, left, right, set, more)
  local numbers = { left = left, right = right, d_f = displacement_px, foreground = bar_value, background = back_value }
  return shot("oracles/bar", width, height, numbers, set, more)
end

local function bar(displacement_px, set, more) return bar_in(48, 4, displacement_px, 16, 32, set, more) end

-- Share of the interval [from, to] during which a bar covers x. Times are in exposures, relative to the raster time. The bar
-- covers [left, right) at the raster time and moves by `d` px over the exposure.
local function coverage(left, right, d, from, to, x)
  if d == 0 then return x >= left and x < right and 1 or 0 end
  local a, b = (x - left) / d, (x - right) / d -- the bar covers x between these times
  return math.max(0, math.min(to, math.max(a, b)) - math.max(from, math.min(a, b))) / (to - from)
end

local function bar_over_time(left, right, d, from, to)
  return function(x) return back_value + (bar_value - back_value) * coverage(left, right, d, from, to, x) end
end

-- Largest error of truth. The bar has two silhouettes, each with a step of 0.8 in colour. A silhouette causes an error
-- of at most this step times half the weight of a time sample.
local bar_tolerance = 2 * (bar_value - back_value) / (2 * truth_times) + 1e-4

local function between(a_shot) return within(a_shot, back_value, bar_value) end

local function exact_bar(d, left, right)
  local moving = bar_in(48, 4, d, left, right, { limit = 10, tile = 8 })
  return { truth(moving, bar_over_time(left, right, d, -1, 0), bar_tolerance), between(moving) }
end

-- ---- displacements

for _, v in ipairs { { "zero", 0 }, { "1e_8", 1e-8 }, { "0_49", 0.49 }, { "half", 0.5 }, { "minus_half", -0.5 } } do
  case("displacement_" .. v[1] .. "_px", "displacement",
       "motion by at most half a pixel reaches no other pixel centre, so the picture is the raster image, bit for bit",
       function() return { as_captured(bar(v[2], { limit = 10 })) } end)
end

for _, anchor in ipairs(anchors) do
  case("displacement_0_51_px_" .. anchor, "displacement", "colours stay between the colours of bar and background",
       function() return { between(bar(0.51, { limit = 10 }, { anchor = anchor })) } end)
end

for _, v in ipairs { { "one_tile", 8 }, { "minus_one_tile", -8 }, { "two_tiles", 16 }, { "one_picture", 48 } } do
  case("displacement_" .. v[1], "displacement",
       "truth equals the exact coverage; every blur is nearer to truth than the picture without blur",
       function()
         local checks = exact_bar(v[2], 16, 32)
         checks[#checks + 1] = nearer(bar(v[2], { limit = 10, tile = 8 }))
         return checks
       end)
end

for _, v in ipairs { { "ten_pictures", 480 }, { "1e7_px", 1e7 }, { "minus_1e7_px", -1e7 } } do
  case("displacement_" .. v[1], "displacement",
       "truth equals the exact coverage; colours stay between the colours of bar and background",
       function() return exact_bar(v[2], 16, 32) end)
end

for _, v in ipairs { { "enters", -4, 24 }, { "has_entered", 8, 24 }, { "has_left", -24, -24 },
                     { "passes_by", 60, 160 } } do
  case("object_" .. v[1], "displacement",
       "truth includes objects that move through the border; colours stay between the colours of bar and background",
       function() return exact_bar(v[3], v[2], v[2] + 16) end)
end

for _, v in ipairs { { "one_pixel", 24, 25 }, { "a_tenth_of_a_pixel", 24.45, 24.55 } } do
  case("bar_of_" .. v[1], "displacement",
       "in truth, a bar narrower than its displacement covers a pixel for width / displacement of the exposure",
       function() return exact_bar(12, v[2], v[3]) end)
end

case("displacement_over_the_limit", "displacement", "filters warn that they shorten displacements; truth is exact", function()
  local far = bar(40, { limit = 0.1, tile = 8 })
  return {
    between(far), warns(far, "farther than the limit", "filters"), silent(far, "farther than the limit", "others"),
    truth(far, bar_over_time(16, 32, 40, -1, 0), bar_tolerance),
  }
end)

for _, v in ipairs { { "diagonal", 8, 8 }, { "diagonal_back", -8, 8 }, { "steep", 3, -17 },
                     { "far_diagonal", 34, 34 } } do
  case("displacement_" .. v[1], "displacement", "every blur is nearer to truth than the picture without blur",
       function()
    local numbers = { left = 16, right = 32, top = 16, bottom = 32, d_x = v[2], d_y = v[3] }
    local square = shot("oracles/quad_2d", 48, 48, numbers, { limit = 2, tile = 8 })
    return { within(square, 0.1, 0.9), nearer(square) }
  end)
end

-- ---- sizes, tiles

for _, v in ipairs { { 1, 1 }, { 1, 40 }, { 40, 1 }, { 2, 2 }, { 37, 23 }, { 7, 61 } } do
  local width, height = v[1], v[2]
  case(("size_%dx%d"):format(width, height), "picture sizes",
       "a static bar gives the raster image; for a moving bar, colours stay between the colours of bar and background",
       function()
    local left, right = width // 4, width // 4 * 3 + 1
    return {
      as_captured(bar_in(width, height, 0, left, right)),
      between(bar_in(width, height, 9, left, right, { limit = 10 })),
    }
  end)
end

case("size_1xN_shortens_and_says", "picture sizes",
     "the displacement limit is a share of the width; in a picture 1 px wide all motion exceeds it, with a warning",
     function()
  local numbers = { left = 0, right = 1, top = 12, bottom = 28, d_x = 0, d_y = 9 }
  return {
    warns(shot("oracles/quad_2d", 1, 40, numbers, { limit = 0.1 }), "farther than the limit", "filters"),
    nearer(shot("oracles/quad_2d", 1, 40, numbers, { limit = 10 })),
  }
end)

for _, tile in ipairs { 1, 7, 1024 } do
  case("tile_" .. tile, "tiles", "with any tile size, every blur is nearer to truth than the picture without blur",
       function()
    local moving = bar_in(48, 4, 12, 17, 31, { limit = 0.5, tile = tile })
    return { between(moving), nearer(moving) }
  end)
end

case("tile_1_limit_10", "tiles",
     "a displacement limit of hundreds of tiles: the search for tiles ends at the border of the picture", function()
  local moving = bar_in(36, 8, 12, 17, 31, { limit = 10, tile = 1 })
  return { between(moving), nearer(moving) }
end)

case("limit_0", "tiles", "with a displacement limit of 0, filters do not blur, and warn about all motion", function()
  local held = bar(12, { limit = 0 })
  return { merged(as_captured(held), { by = "filters" }), warns(held, "farther than the limit", "filters") }
end)

case("opposite_motions_in_one_tile", "tiles", "every blur is nearer to truth than the picture without blur",
       function()
  return { nearer(bar_in(48, 8, 10, 16, 32, { limit = 1, tile = 64 }, { moves = { "background=-6,0,0" } })) }
end)

-- ---- exposure and samples

local window_start = { ["end"] = -1, centre = -0.5, start = 0 }

for _, anchor in ipairs(anchors) do
  case("exposure_0_" .. anchor, "exposure", "an exposure of 0 gives the raster image, bit for bit", function()
    return { as_captured(shot("stability/extreme", 48, 32, {}, { limit = 10 }, { anchor = anchor, exposure = 0 })) }
  end)
  case("exposure_3_" .. anchor, "exposure",
       "exposure of three frames: displacements span all of it, and truth equals the exact coverage", function()
    -- 4 px over an exposure of 0.5 are 24 px over an exposure of 3.
    local long, from = bar(4, { limit = 10, tile = 8 }, { anchor = anchor, exposure = 3 }), window_start[anchor]
    return {
      truth(long, bar_over_time(16, 32, 24, from, from + 1), bar_tolerance), between(long),
      displacement(long, function(x) return x >= 16 and x < 32 and 24 or 0, 0 end, 0, 1e-3), nearer(long),
    }
  end)
end

-- Share of the total weight that a shutter which opens and closes linearly has before time t (0: shutter open, 1: shutter
-- close).
local function triangle(t)
  t = math.max(0, math.min(1, t))
  return t < 0.5 and 2 * t * t or 1 - 2 * (1 - t) * (1 - t)
end

for _, anchor in ipairs(anchors) do
  case("shutter_curve_" .. anchor, "exposure",
       "shutter curve with unequal weights: truth equals the weighted coverage; every blur is nearer to truth than no blur",
       function()
    local from = window_start[anchor]
    local curved = bar(12, { limit = 10, tile = 8 }, { anchor = anchor, shutter_curve = "triangle" })
    local function covered(x) -- total weight of the times while the bar covers x
      return triangle((x - 16) / 12 - from) - triangle((x - 32) / 12 - from)
    end
    local function value(x) return back_value + (bar_value - back_value) * covered(x) end
    return { truth(curved, value, bar_tolerance), between(curved), nearer(curved) }
  end)
end

case("no_share_of_motion_blurs", "exposure", "if neither camera nor objects blur, the picture is the raster image, bit for bit",
     function()
  local still = { camera_blur = 0, object_blur = 0 }
  return { as_captured(shot("stability/extreme", 48, 32, {}, { limit = 10 }, still)) }
end)

case("exposure_1", "exposure", "an exposure of a whole frame: every blur is nearer to truth than the picture without blur",
     function() return { nearer(bar(6, { limit = 10, tile = 8 }, { exposure = 1 })) } end)

case("exposure_3_extrapolated", "exposure", "filters warn that the path of one frame is stretched over three frames", function()
  local long = bar(4, { limit = 10, displacement = "extrapolated" }, { exposure = 3 })
  local text = "stretched over an exposure of more than one"  -- part of the warning (counter `stretched` of the pass gbuffer)
  return { warns(long, text, "filters"), silent(long, text, "others") }
end)

for _, samples in ipairs { 1, 2, 3, 15 } do
  case("samples_" .. samples, "samples",
       "few or odd numbers of samples: exact if the bar is static, otherwise between the colours of bar and background",
       function()
    local checks = { as_captured(bar(0, { samples = samples })) }
    for _, anchor in ipairs(anchors) do
      checks[#checks + 1] = between(bar(11, { samples = samples, limit = 10 }, { anchor = anchor }))
    end
    return checks
  end)
end

case("samples_1_truth", "samples",
     "one sample, at the middle of the exposure, gives the raster image of the bar at that time: 4 px back", function()
  return { merged(as_captured(bar(8, { samples = 1 })), { of = bar_in(48, 4, 0, 12, 28), by = "truth" }) }
end)

-- ---- scales, places and times: the room that is moved, scaled and sped up

local function room(numbers, more)
  return shot("stability/extreme", 48, 32, numbers or {}, { limit = 10, tile = 8, samples = 16 }, more)
end

for _, v in ipairs { { "minus_20", 1 / 1048576 }, { "20", 1048576 } } do
  case("scale_2_to_" .. v[1], "scale", "a scale that is a power of two changes no bit of the picture",
       function() return { same(room(), room { scale = v[2] }, 0, 0) } end)
end

-- With a scale that is not a power of two, rounding may change pixels at silhouettes: up to 0.1 % of all pixels.
for _, v in ipairs { { "1e_6", 1e-6 }, { "1e_3", 1e-3 }, { "0_37", 0.37 }, { "1e3", 1e3 }, { "1e6", 1e6 } } do
  case("scale_" .. v[1], "scale", "a scale does not change the picture; only 0.1 % of the pixels may differ by more than 1e-5",
       function() return { same(room(), room { scale = v[2] }, 1e-5, 1e-3 + 1 / 1536) } end)
end

local nestings = { [0] = "", "_in_a_node", "_there_and_back", "_in_its_vertices" }

for _, v in ipairs { { "1e5", 1e5 }, { "1e6", 1e6 }, { "1e7", 1e7 } } do
  for nesting = 0, v[2] == 1e7 and 3 or 0 do
    case("offset_" .. v[1] .. nestings[nesting], "world offset",
         "a static scene has displacements below 1e-3 px; a moving scene gives the same picture as at the origin", function()
      local there, pan = { offset = v[2], nesting = nesting }, { camera_speed = 6.0625, turn = 3 }
      return {
        displacement(room(merged(there, { speed = 0 })), function() return 0, 0 end, 0, 1e-3),
        same(room(), room(there), 1e-4, 2e-3), same(room(pan), room(merged(there, pan)), 1e-4, 2e-3),
      }
    end)
  end
end

for _, v in ipairs { { "1e6", 1000000 }, { "2_to_31", 2147483647 } } do
  case("frame_" .. v[1], "far times", "the same motion gives the same picture at any time", function()
    local late = room({ rest_s = v[2] / 24, camera_speed = 6.0625 }, { frame = v[2] })
    return { same(room { camera_speed = 6.0625 }, late, 1e-4, 2e-3) }
  end)
end

-- ---- cameras

local wide, high, focal, near_m = 48, 32, 32, 0.1

local function planes(kind, numbers, set, more)
  return shot("stability/planes", wide, high, merged({ kind = kind }, numbers or {}),
              merged({ limit = 10, tile = 8 }, set or {}), more)
end

local function pixel_of(p) return focal * p[1] / p[3], focal * p[2] / p[3] end

-- Displacement on the screen, px, of a point that moves from `from` to `to` (x right, y down, z ahead; metres), in double
-- precision. If the path ends behind the plane at `near`, the displacement up to this plane is extrapolated to the whole path.
local function path_of(from, to, near)
  local s = 1
  if to[3] < near then
    s = (from[3] - near) / (from[3] - to[3])
    local part = {}
    for i = 1, 3 do part[i] = from[i] * (1 - s) + to[i] * s end
    to = part
  end
  local x, y = pixel_of(to)
  local from_x, from_y = pixel_of(from)
  return (x - from_x) / s, (y - from_y) / s
end

-- Point that the pixel (x, y) shows of a floor `below` metres under the camera; nil for pixels above the horizon.
local function floor_at(x, y, below)
  if y <= high / 2 then return nil end
  local z = below * focal / (y - high / 2)
  return z > near_m and { (x - wide / 2) * z / focal, below, z } or nil
end

-- Displacement, px over the exposure, of a point that moves by `step` relative to the camera (x right, y down, z ahead; metres
-- over the exposure).
local function displacement_of(point, step, anchor)
  local back, ahead = anchor == "centre" and 0.5 or 1, anchor == "centre" and 0.5 or 1
  if anchor == "start" then back = 0 end
  if anchor == "end" then ahead = 0 end
  local open, close = {}, {}
  for i = 1, 3 do open[i], close[i] = point[i] - step[i] * back, point[i] + step[i] * ahead end
  local near = near_m * 1.001
  local close_x, close_y = path_of(point, close, near)
  local open_x, open_y = path_of(point, open, near)
  return close_x - open_x, close_y - open_y
end

-- Direction of a pixel's ray after the camera has turned to its left by `angle` radians.
local function turned_sky(x, y, angle)
  local dx, dy = (x - wide / 2) / focal, (y - high / 2) / focal
  return { dx * math.cos(angle) + math.sin(angle), dy, math.cos(angle) - dx * math.sin(angle) }
end

-- Allowed error of a displacement: the share `path_share` of its length plus `path_px` px. The allowance covers
-- single-precision rounding at the ends of a path, where a depth close to the near plane is wrong by a few units in the last
-- place.
local path_share, path_px = 1e-4, 2e-3

local function over_a_floor(name, ahead, anchor)
  case(("camera_%s_over_a_floor_%s"):format(name, anchor), "near plane",
       "displacements equal the closed form in double precision, even if points pass behind the camera", function()
    local flight = planes(1, { camera_z = ahead, depth = 1.5, extent = 400 }, nil, { anchor = anchor })
    local function path(x, y)
      local point = floor_at(x, y, 1.5)
      if not point or point[3] >= 190 then return nil end
      return displacement_of(point, { 0, 0, ahead }, anchor)
    end
    return { displacement(flight, path, path_share, path_px), within(flight, 0.25, 1) }
  end)
end

local function moving_card(name, away, anchor)
  case(("card_%s_%s"):format(name, anchor), "near plane",
       "displacements equal the closed form in double precision, with a warning about extrapolated displacements", function()
    local card = planes(2, { velocity_z = -away, velocity_x = 0.5 }, nil, { anchor = anchor })
    local function path(x, y)
      if math.abs(x - wide / 2) >= 15 or math.abs(y - high / 2) >= 15 then return nil end
      return displacement_of({ (x - wide / 2) / focal * 4, (y - high / 2) / focal * 4, 4 }, { 0.5, 0, away }, anchor)
    end
    local share, near = anchor == "centre" and 0.5 or 1, 1.001 * near_m
    local crosses = anchor ~= "start" and 4 - away * share < near or anchor ~= "end" and 4 + away * share < near
    return {
      displacement(card, path, path_share, path_px), (crosses and warns or silent)(card, "behind the near plane"),
      within(card, 0.2, 1),
    }
  end)
end

for _, anchor in ipairs(anchors) do
  over_a_floor("forward", -20, anchor)
  over_a_floor("back", 20, anchor)
  over_a_floor("by_a_hair", -1e-4, anchor)
  moving_card("from_behind", 12, anchor)
  moving_card("to_behind", -12, anchor)
  moving_card("to_the_camera", -4, anchor)
  moving_card("to_the_near_plane", -3.9, anchor)
end

for _, turn in ipairs { 10, 45, 85, 100, 170, -170 } do
  case(("turn_%s%d"):format(turn < 0 and "minus_" or "", math.abs(turn)), "all sky",
       "displacements of the sky equal the closed form, and the colour of the sky does not change", function()
    local function path(x, y)
      local dx, dy = path_of(turned_sky(x, y, 0), turned_sky(x, y, -turn * math.pi / 180), 1 / 64)
      return -dx, -dy
    end
    local checks = {}
    for _, near in ipairs { near_m, 5 } do -- the near plane must not affect the sky
      local sky = planes(0, { turn = turn, near = near })
      checks[#checks + 1] = displacement(sky, path, path_share, path_px)
      checks[#checks + 1] = same(sky, planes(0), 1e-6, 0)
    end
    return checks
  end)
end

case("only_sky_at_rest", "all sky",
     "a picture of the sky only is the raster image", function() return { as_captured(planes(0)) } end)

for _, v in ipairs { { "", 0.1, 0.9, 0.9 }, { "_that_the_near_plane_cuts", 3.2, 0.2, 0.9 },
                     { "_all_before_the_near_plane", 5, 0.2, 0.2 } } do
  case("inside_a_ball" .. v[1], "camera inside",
       "raster and rays agree; colours stay in the range of the visible surfaces' colours, or a warning states that a " ..
         "surface behind these shows through", function()
    local inside = within(planes(4, { near = v[2], velocity_x = 1 }), v[3], v[4])
    return { as_captured(planes(4, { near = v[2] })), merged(inside, { unless = "it shows through" }) }
  end)
end

case("orthographic_far_away", "near plane", "an orthographic camera shows surfaces at any distance", function()
  local parallel = planes(2, { orthographic = 1, focal = 32000, aside = 10 })
  return { as_captured(parallel), within(parallel, 0.2, 0.2) }
end)

-- ---- large and fast objects

for _, v in ipairs { { "2e4", 2e4 }, { "2e7", 2e7 } } do
  case(("floor_%s_m_wide"):format(v[1]), "scale",
       "displacements of near points on a large triangle are as precise as those on a small triangle", function()
    local flight = planes(1, { camera_x = 0.5, camera_z = -1, depth = 1.5, extent = v[2] })
    local function path(x, y)
      local point = floor_at(x, y, 1.5)
      if point then return displacement_of(point, { -0.5, 0, -1 }, "end") end
    end
    return { displacement(flight, path, 1e-3, 1e-2) }
  end)
end

for _, turns in ipairs { 32, 1000 } do
  case(("spin_of_%d_turns"):format(turns), "displacement",
       "an object that turns many times within the exposure is found in every pose: rays and raster agree", function()
    local function spun(set)
      return planes(2, {}, merged({ samples = 23, mark_regions = false }, set),
                    { spins = { ("card=0,0,1,%d"):format(2 * 360 * turns) } })
    end
    return { merged(same(spun {}, spun { mode = "raster" }, 1e-5, 4e-3), { by = "truth" }) }
  end)
end

-- ---- surfaces

for _, v in ipairs { { "1_mm", 1e-3 }, { "1_um", 1e-6 }, { "0", 1e-12 } } do
  case(("floor_%s_below"):format(v[1]), "grazing",
       "raster and rays agree under a static camera; under a moving camera, colours stay in the range of the colours of " ..
         "floor and sky",
       function()
    return { as_captured(planes(1, { depth = v[2] })), within(planes(1, { depth = v[2], camera_x = 0.5 }), 0.25, 1) }
  end)
end

for _, order in ipairs { 1, -1 } do
  local suffix = order > 0 and "" or "_other_way_round"
  case("coplanar_cards" .. suffix, "equal depths", "at equal depths raster and rays show the scene's first instance",
       function()
    local cards = planes(3, { order = order })
    return {
      as_captured(cards), within(planes(3, { order = order, velocity_x = 1 }), 0.2, 0.9),
      { check = "sharp_at", shot = cards, pixel = { 32, 16 }, value = order > 0 and 0.9 or 0.5, tolerance = 1e-6 },
    }
  end)
  case("coplanar_cards_that_lean" .. suffix, "equal depths", "where depths differ by rounding only, either card may be shown",
       function()
    local still = planes(3, { order = order, lean = 50 })
    return {
      merged(as_captured(still), { by = "all_but_truth" }), within(still, 0.2, 0.9),
      within(planes(3, { order = order, lean = 50, velocity_x = 1 }), 0.2, 0.9),
    }
  end)
end

case("cards_a_hair_apart", "equal depths", "cards 1e-5 of their depth apart: raster and rays show the nearer card", function()
  return {
    as_captured(planes(3, { gap = 4e-5, lean = 50 })),
    within(planes(3, { gap = 4e-5, lean = 50, velocity_x = 1 }), 0.2, 0.9),
  }
end)

case("one_triangle_over_the_picture", "triangles",
     "a triangle that covers the picture and has a corner behind the camera: the picture has the triangle's colour",
     function()
  local moving = planes(5, { velocity_x = 3 })
  return { as_captured(planes(5)), within(planes(5), 0.89, 0.91), same(moving, planes(5), 1e-6, 0) }
end)

case("triangles_of_no_area", "triangles",
     "triangles without area and nodes without triangles do not change the picture", function()
  local motion = { velocity_x = 0.7031, velocity_y = 0.2969 }
  return { same(planes(6, motion), planes(2, motion), 1e-6, 0) }
end)

for _, v in ipairs { { "thousands_of_instances", 8, 0.7, 8, "raster and rays agree; colours stay in their range" },
                     { "a_million_triangles", 9, 0.9, 2,
                       "triangles smaller than pixels: raster and rays agree; colours stay in their range" } } do
  case(v[1], "triangles", v[5], function()
    local motion = { velocity_x = 0.7, velocity_y = 0.3 }
    return { within(planes(v[2], motion), 0.2, v[3]), as_captured(planes(v[2], motion, nil, { exposure = 0 }), v[4]) }
  end)
end

for _, v in ipairs { { "black", 0 }, { "equal_luminance", 0.9 } } do
  case(v[1], "equal colours", "motion in front of a surface of equal colour does not change the picture", function()
    -- A pipeline whose rays end by luminance cannot separate the two surfaces, and warns about this.
    return { merged(within(planes(7, { value = v[2], velocity_x = 0.7 }), v[2], v[2]),
                    { unless = "as bright as the foreground" }) }
  end)
end

case("light_of_1e29", "equal colours", "a radiance near the largest number of single precision stays finite",
     function() return { draws(room { brightness = 3e26 }) } end)

-- ---- the requested cases with their checks, or all

local asked = {}
for _, name in ipairs(wanted.cases or {}) do asked[name] = true end
for _, one in ipairs(list) do one.checks = (not wanted.cases or asked[one.name]) and one.checks() or nil end

return {
  sharp = { pipeline = "none" },
  truth = { pipeline = "ground_truth", set = { samples = truth_times, mark_regions = false } },
  truth_method = { samples = 16 }, -- settings of ground truth if it is tested like a blur
  cases = list,
}
