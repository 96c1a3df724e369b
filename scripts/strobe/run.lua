-- SPDX-License-Identifier: MIT
-- Entry points of the child process that evaluates scripts. The program (runtime/script) starts the child and calls one of
-- these functions. Each function takes a request as a table and returns plain data.
local check    = require "strobe.check"
local native   = require "strobe.native"
local pass     = require "strobe.pass"
local pipeline = require "strobe.pipeline"

local run = {}

-- Loads the file of a pipeline before the requests that evaluate the pipeline with settings. Returns the data that is
-- common to all these requests: the passes that files declare, and the parameters of the pipeline. To save time, the
-- result of a later request does not repeat this data: it refers to a pass by its number in the returned list, and has
-- no parameters.
local loaded
local numbers = {}
function run.load()
  loaded = native.main()
  for number, description in ipairs(pass.declared) do numbers[description] = number end
  return { passes = pass.declared, params = pipeline.is_pipeline(loaded) and loaded.params or {} }
end

function run.pipeline(request)
  local result = loaded or native.main()
  if not pipeline.is_pipeline(result) then
    local what = pass.is_pass(result) and "a pass" or (result == nil and "nothing" or "a " .. type(result))
    check.fail({ file = request.file, line = 0 }, "returns %s instead of a pipeline { ... }", what)
  end
  local described = pipeline.describe(result, request.name, request.file, request.sets, request.lenient)
  for i, one in ipairs(described.passes) do described.passes[i] = numbers[one] or one end
  if loaded then described.params = nil end
  return described
end

-- Returns the kind of each pipeline in the list `request.names`, by name. Files with errors are left out.
function run.kinds(request)
  local kinds = {}
  for _, name in ipairs(request.names) do
    local good, result = pcall(require, "scripts.pipelines." .. name:gsub("/", "."))
    if good and pipeline.is_pipeline(result) then kinds[name] = result.kind end
  end
  return kinds
end

-- Returns the value that the text of a setting stands for: true, false, a number, or the text itself.
local function typed(text)
  if type(text) ~= "string" then return text end
  if text == "true" then return true end
  if text == "false" then return false end
  return tonumber(text) or text
end

-- Returns the global variable `scene_params` for the script of a scene. `scene_params.NAME` is the value that the setting
-- `--set scene.NAME=VALUE` gives, or nil: `local count = scene_params.count or 5`. `sets`: the settings. `asked`: a table that
-- gets the names that the scene reads, so that settings without effect can be reported.
local function scene_params(sets, asked)
  local values = {}
  for _, set in ipairs(sets) do values[set.name] = typed(set.value) end
  return setmetatable({}, {
    __index = function(_, name)
      asked[name] = true
      return values[name]
    end,
    __newindex = function() error("scene_params cannot be assigned", 2) end,
  })
end

function run.scene(request)
  local asked, problems = {}, check.problems()
  native.define("scene_params", scene_params(request.sets, asked))
  local result = native.main()
  for _, set in ipairs(request.sets) do
    if not asked[set.name] then
      local place = { file = ("--set scene.%s=%s"):format(set.name, set.value), line = 0 }
      problems:add(place, "the scene has no parameter '%s'%s", set.name, native.nearest(set.name, check.names(asked)))
    end
  end
  problems:raise()
  if result == nil then check.fail({ file = request.file, line = 0 }, "returns nothing; it should end in 'return'") end
  return result
end

function run.data(request)
  local result = native.main(request.arguments)
  if result == nil then check.fail({ file = request.file, line = 0 }, "returns nothing; it should end in 'return'") end
  local finished = (getmetatable(result) or {}).finished  -- checks an experiment or a capture; nil for other results
  return finished and finished(result, request.arguments) or result
end

-- Returns "experiment" or "capture" if the file returns one of these, otherwise "".
function run.kind()
  return { kind = (getmetatable(native.main()) or {}).kind or "" }
end

-- Loads all files of passes, `request.modules`, and returns the descriptions of their passes. Raises one error with the
-- mistakes of all files.
function run.passes(request)
  local problems, passes, by_name = check.problems(), {}, {}
  for _, module in ipairs(request.modules) do
    local good, result = pcall(require, module)
    local file = { file = module:gsub("%.", "/") .. ".lua", line = 0 }
    if not good and type(result) == "table" and result.problems then
      for _, problem in ipairs(result.problems) do problems:add(problem.place, "%s", problem.message) end
    elseif not good then
      local name, line, text = tostring(result):match("^(.-):(%d+): (.*)$")
      local place = name and { file = name, line = math.tointeger(line) } or file
      problems:add(place, "%s", text or tostring(result))
    elseif not pass.is_pass(result) then
      problems:add(file, "returns a %s instead of a pass", type(result))
    else
      local description = result.description
      local other = by_name[description.name]
      if other then
        local second, first = description.place, other.place
        -- Report the mistake at the pass of the project, not at the shipped pass.
        if second.file:find("^strobe:") then second, first = first, second end
        problems:add(second, "another pass is called '%s': %s:%d", description.name, first.file, first.line)
      end
      by_name[description.name] = description
    end
  end
  problems:raise()
  for _, description in pairs(by_name) do passes[#passes + 1] = description end
  return passes
end

return run
