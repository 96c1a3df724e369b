-- SPDX-License-Identifier: MIT
-- The function `capture { ... }`. It declares a capture: pictures that `strobe capture` renders and that can be rendered again
-- bit for bit, and figures and films of these pictures. This file checks the fields, reports all mistakes of a capture at once,
-- and returns the capture as plain data. docs/captures.md describes each field.
local check      = require "strobe.check"
local experiment = require "strobe.experiment"
local fields     = require "strobe.fields"
local figure     = require "strobe.figure"
local native     = require "strobe.native"
local shots      = require "strobe.shots"

local capture = {}

local text, number, bool, list, map = fields.text, fields.number, fields.bool, fields.list, fields.map
local copied = fields.copied

-- Fields of a capture, of a shot and of an arm, with the types of their values. Optional fields may be left out. A shot may
-- also have any option of the command line, under the option's name (`exposure`, `camera`).
capture.fields = {
  -- Fields of a capture:
  -- layers     images to store in the EXR file of a picture besides its colour: "all" (every output of every pass), or a list
  --            with names of outputs of the pipeline and with images between passes, written "node.port"
  -- most_flip  largest mean FLIP at which two pictures of one shot, from different devices, count as equal
  -- truth      name of the arm that is the reference of all errors
  -- figures    list of figures, checked by strobe.figure
  -- films      list of films, checked by strobe.figure
  capture = {
    title = { text }, note = { text, optional = true }, size = { list, optional = true },
    seed = { number, optional = true }, shots = { list }, arms = { list }, truth = { text, optional = true },
    layers = { fields.any, optional = true }, most_flip = { number, optional = true },
    figures = { list, optional = true }, films = { list, optional = true },
  },
  -- Fields of a shot:
  -- title        text that is displayed instead of the name
  -- frames       { from, to, step }: the shot is a sequence of pictures, one per frame number
  -- vary         { NAME = { values } }: the shot is a sequence of pictures, one per value; NAME is an option of the shot, a
  --              parameter of its scene ("scene.NAME") or a parameter of the pipelines of the arms
  -- stops        brightness of the displayed pictures: factor 2^stops
  -- curve        tone curve of the displayed pictures
  -- truth        settings of the truth arm for this shot
  -- crops        areas that the report magnifies: { x, y, width, height } in pixels, or "inner" for the place with the
  --              most pixels of the error region inner
  -- note         text for the report
  -- attribution  author of the scene
  shot = {
    name = { text }, title = { text, optional = true }, frames = { list, optional = true },
    vary = { map, optional = true }, stops = { number, optional = true }, curve = { text, optional = true },
    truth = { map, optional = true }, crops = { list, optional = true }, note = { text, optional = true },
    attribution = { text, optional = true },
  },
  -- Fields of an arm, which is a pipeline with settings:
  -- set     values of parameters of the pipeline
  -- shots   names of the shots that the arm renders; default: all
  -- layers  replaces the field `layers` of the capture
  -- files   a folder beside the script. For this arm, the scripts and shaders in the subfolder strobe/ replace shipped
  --         files, and those in the subfolder project/ replace files of the project
  -- role    role of the arm if the capture is measured: "method", or "floor" (ground truth with as many samples as a method)
  -- shown   false: the arm is in the tables of the report, but its pictures are not shown
  arm = {
    name = { text }, pipeline = { text }, set = { map, optional = true }, shots = { list, optional = true },
    layers = { fields.any, optional = true }, files = { text, optional = true }, role = { text, optional = true },
    shown = { bool, optional = true },
  },
}
-- Fields of an experiment that a capture may have too. A capture with `measures` is also an experiment: its arms are measured
-- against its truth.
local measuring = { "question", "regions", "measures", "rounds", "most_rounds", "within", "base", "background", "expect",
                    "layout" }
for _, name in ipairs(measuring) do capture.fields.capture[name] = experiment.fields.experiment[name] end

local kMostSteps = 1000

-- ---- camera paths

local function three(value, default)
  value = value or default
  assert(type(value) == "table" and #value == 3, "a point must be { x, y, z }")
  return value
end

-- Returns a camera path on a horizontal circle of `radius` metres, `height` metres above the point `target`, which the camera
-- looks at. Between the frames `first` and `last`, the angle goes from `from` to `to` degrees. At 0 degrees the camera is on
-- the +z side of `target`, at 90 degrees on the +x side.
function capture.orbit(t)
  local target, keys = three(t.target), {}
  local from, to = math.rad(t.from or 0), math.rad(t.to or 360)
  -- The camera follows a cubic curve through the keys of its path. Keys are at most 10 degrees apart, with one extra
  -- key beyond each end, so the distance between this curve and the circle is at most 3e-5 times the radius.
  local count = math.max(1, math.ceil(math.abs(to - from) / math.rad(10)))
  for i = -1, count + 1 do
    local angle = from + (to - from) * i / count
    keys[i + 2] = { t.first + (t.last - t.first) * i / count,
      target[1] + t.radius * math.sin(angle), target[2] + (t.height or 0), target[3] + t.radius * math.cos(angle),
      target[1], target[2], target[3] }
  end
  return keys
end

-- Returns a straight camera path between the frames `first` and `last`. The camera moves from the point `from` to the point
-- `to`. It looks at a point that moves from `target` to `to_target` (default: `target`).
function capture.dolly(t)
  local function key(frame, eye, target)
    return { frame, eye[1], eye[2], eye[3], target[1], target[2], target[3] }
  end
  local from, to = three(t.from), three(t.to)
  return { key(t.first, from, three(t.target)), key(t.last, to, three(t.to_target, t.target)) }
end

-- ---- checks

local Checker = fields.checker(capture.fields)
shots.extend(Checker, capture.fields.shot)

-- Checks the field `layers` of a capture or an arm, and returns its value. It is "all" or a list of names of images.
function Checker:layers(value, path, what)
  if value == nil or value == "all" then return value end
  if type(value) ~= "table" then
    self:add(path, "the layers of %s must be \"all\" or a list of names", what)
    return {}
  end
  for i, name in ipairs(value) do
    if type(name) ~= "string" then self:add(check.joined(path, i), "a layer of %s is not a text", what) end
  end
  return value
end

-- Checks the field `vary` of a shot, { NAME = { values } }, and returns a list with the settings of each picture of the
-- sequence. Returns nil if the shot has no such field, and after a mistake.
function Checker:steps(t, path)
  local names = type(t) == "table" and check.names(t) or {}
  if t == nil then return nil end
  local name = names[1]
  if #names ~= 1 or type(t[name]) ~= "table" or #t[name] == 0 or #t[name] > kMostSteps then
    self:add(path, "vary must be { NAME = { values } } with one name and 1 to %d values", kMostSteps)
    return nil
  end
  local steps = {}
  for i, value in ipairs(t[name]) do
    local sorted = self:sorted({ [name] = value }, check.joined(path, name), "a step")
    steps[i] = { label = ("%s = %s"):format(name, fields.shown(value)), options = sorted.options,
                 scene_set = sorted.scene, set = sorted.others }
  end
  return steps
end

function Checker:captured_shot(entry, path)
  local result = self:shot(entry, path)
  result.steps = self:steps(result.vary, check.joined(path, "vary"))
  if result.vary ~= nil and result.frames ~= nil then
    self:add(check.joined(path, "vary"), "a shot cannot have both frames and vary")
  end
  result.vary = nil
  return result
end

function Checker:captured_arm(entry, path, shot_names)
  local result = copied(self:fields(entry, "arm", path, "arm " .. path[2]))
  result.set = self:settings(result.set, check.joined(path, "set"))
  result.layers = self:layers(result.layers, check.joined(path, "layers"), "arm " .. path[2])
  self:one_of(result.role, experiment.roles, check.joined(path, "role"), "the role of an arm")
  for i, name in ipairs(type(result.shots) == "table" and result.shots or {}) do
    self:one_of(name, shot_names, check.joined(check.joined(path, "shots"), i), "a shot of arm " .. path[2])
  end
  return result
end

-- Checks the rules for captures with `measures`: such a capture needs a truth arm, and cannot have shots with `vary` or arms
-- with `files`. Without `measures`, a capture cannot have the other fields of an experiment.
function Checker:measured(t, shot_names)
  for _, name in ipairs(measuring) do
    if t.measures == nil and t[name] ~= nil then
      self:add({ name }, "a capture with '%s' needs `measures`", name)
    end
  end
  for i, name in ipairs(shot_names) do
    local shot = t.shots[i]
    if type(shot.truth) == "table" and t.truth == nil then
      self:add({ "shots", i, "truth" }, "shot '%s' has settings of truth, but the capture has no 'truth' arm", name)
    end
    if t.measures and shot.vary ~= nil then
      self:add({ "shots", i, "vary" }, "a shot with vary cannot be measured; use the axes of an experiment")
    end
  end
  if t.measures == nil then return end
  if t.truth == nil then
    self:add({ "measures" }, "measures compare pictures with truth, but the capture has no 'truth' arm")
  end
  for i, arm in ipairs(t.arms) do
    if arm.files ~= nil then self:add({ "arms", i, "files" }, "an arm with `files` cannot be measured") end
  end
end

function Checker:whole(t)
  self:fields(t, "capture", {})
  local result = copied(t)
  result.shots = self:each(t, "shots", function(entry, _, path) return self:captured_shot(entry, path) end)
  local shot_names = self:distinct(result.shots, "name", "shots")
  result.arms = self:each(t, "arms", function(entry, _, path) return self:captured_arm(entry, path, shot_names) end)
  local arm_names = self:distinct(result.arms, "name", "arms")
  self:numbers(t.size, 2, { "size" }, "size")
  self:one_of(t.truth, arm_names, { "truth" }, "the truth of a capture")
  result.layers = self:layers(t.layers, { "layers" }, "the capture")
  local names = { shots = shot_names, arms = arm_names, truth = t.truth or false }
  for kind, one in pairs { figures = figure.checked, films = figure.checked_film } do
    if t[kind] ~= nil then
      result[kind] = self:each(t, kind, function(entry, _, path) return one(self, entry, path, names) end)
      self:distinct(result[kind], "name", kind)
    end
  end
  self:measured(t, shot_names)
  self.problems:raise()
  for _, name in ipairs(measuring) do if name ~= "measures" then result[name] = nil end end
  result.kind = "capture"
  return result
end

-- Converts the capture `t`, which has `measures`, to the table of an experiment. The truth arm becomes the field `truth`. The
-- field `shots` of an arm becomes the function `skip`, which leaves out the pictures that the arm does not render.
local function as_experiment(t)
  local result = { title = t.title, note = t.note, size = t.size, seed = t.seed, shots = t.shots, arms = {} }
  for _, name in ipairs(measuring) do result[name] = t[name] end
  result.layout = result.layout or { pictures = {} }
  local drawn = {}
  for _, arm in ipairs(t.arms) do
    if arm.name == t.truth then
      result.truth = { name = arm.name, pipeline = arm.pipeline, set = arm.set }
    else
      table.insert(result.arms, { name = arm.name, pipeline = arm.pipeline, set = arm.set, role = arm.role, shown = arm.shown })
      drawn[arm.name] = arm.shots
    end
  end
  function result.skip(point) return drawn[point.arm] ~= nil and not check.contains(drawn[point.arm], point.shot) end
  return result
end

local Made = { kind = "capture" }

-- Checks `result`, which the file of a capture returned, and returns it as plain data. `given.options`: the options
-- that a shot may have. `given.measures`: the measures of experiments, or nil if the command measures nothing. If
-- `given.measures` is not nil, a capture that has `measures` is returned as an experiment.
function Made.finished(result, given)
  local self = Checker.at(result.place)
  self.options = shots.by_name(given.options)
  local plain = self:whole(result.fields)
  if not given.measures or not result.fields.measures then return plain end
  return experiment.finished(as_experiment(result.fields), result.place, given)
end

return setmetatable(capture, { __call = native.at_caller(function(place, _, t)
  if type(t) ~= "table" then check.fail(place, "capture takes a table: capture { ... }") end
  return setmetatable({ fields = t, place = place }, Made)
end) })
