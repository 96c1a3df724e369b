-- SPDX-License-Identifier: MIT
-- Nodes of a pipeline's graph. A call of a pass inside the function `build` of a pipeline makes a node. The call returns the
-- outputs of the node as values. A value that is passed to another call wires the two nodes.
local check  = require "strobe.check"
local native = require "strobe.native"
local param  = require "strobe.param"

local node = {}

node.times = { "raster", "shutter_open", "shutter_close", "sample" }

-- The graph that the running `build` makes; nil outside of a `build`. Main fields: `nodes`, `passes`, `loops`, `loop`
-- (name of a loop while its body runs, otherwise nil), `params` (parameters of the pipeline), `p` (the argument of
-- `build`).
node.graph = nil

-- ---- values

local Value = {}  -- an output of a node: { node = , port = , format = , formats = { CHOICE = format } or nil }
local Ports = {}  -- the result of a call of a pass or of pipeline.loop; its fields are Values

Value.__index = native.at_caller(function(place, value, key)
  check.fail(place, "'%s.%s' is an image; it has no field %s", rawget(value, "node"), rawget(value, "port"),
             check.quoted(key))
end)

function node.is_value(value)
  return getmetatable(value) == Value
end

function node.source(value)
  return rawget(value, "node") .. "." .. rawget(value, "port")
end

-- Returns the format of an image if it matches the Lua pattern `wanted`. An image has several possible formats if a parameter
-- chooses its format; then each of these must match. Otherwise returns nil and a format that does not match.
function node.has_format(value, wanted)
  for _, format in pairs(rawget(value, "formats") or { rawget(value, "format") }) do
    if not format:find(wanted) then return nil, format end
  end
  return rawget(value, "format")
end

-- Returns the reason why `value` is not an image, as the end of a message: "is a number instead of an image".
local function not_a_value(value)
  if getmetatable(value) == Ports then
    local ports = check.names(rawget(value, "values"))
    return ("is the whole result of %s; name one of its images: %s"):format(rawget(value, "node"), table.concat(ports, ", "))
  end
  if node.is_reference(value) then return ("is the parameter '%s' instead of an image"):format(value.name) end
  return ("is a %s instead of an image"):format(type(value))
end
node.not_a_value = not_a_value

Ports.__index = native.at_caller(function(place, ports, key)
  local values, name = rawget(ports, "values"), rawget(ports, "node")
  if key == "get" then return node.optional end
  rawget(ports, "record").used = true
  if values[key] then return values[key] end
  local names = check.names(values)
  local near = type(key) == "string" and native.nearest(key, names) or ""
  if near == "" then near = "; it has " .. table.concat(names, ", ") end
  check.fail(place, "%s has no output %s%s", name, check.quoted(key), near)
end)

Ports.__newindex = native.at_caller(function(place, ports, key)
  check.fail(place, "%s cannot be given a field %s", rawget(ports, "node"), check.quoted(key))
end)

-- Makes the result of a call of a pass or of pipeline.loop: an object with the outputs `values` as its fields. Reading a field
-- sets `record.used`, so that nodes without a used output can be reported. `name`: name of the pass or loop in messages.
function node.ports(name, values, record)
  return setmetatable({ node = name, values = values, record = record }, Ports)
end

-- Returns the field `name` of a table, or nil if the table has no such field. The table may be the result of a call or a
-- record; without this function, reading an absent field of these is an error.
function node.optional(t, name)
  local is_ports = getmetatable(t) == Ports
  local value = rawget(is_ports and rawget(t, "values") or t, name)
  if is_ports and value ~= nil then rawget(t, "record").used = true end
  return value
end

-- ---- parameters

-- A reference to a parameter of the pipeline: the value of `p.NAME` in a `build`. A reference that is passed to a pass lets the
-- parameter change later without a new graph. A call of the reference, `p.NAME()`, returns the parameter's value. The graph may
-- depend on this value, so the name of the parameter is then added to the set `noted`.
local Reference = {}
-- For each reference to a parameter: the function that the call `p.NAME()` runs.
local taken = setmetatable({}, { __mode = "k" })
Reference.__call = function(reference) return taken[reference]() end
Reference.__index = native.at_caller(function(place, reference, key)
  check.fail(place, "parameter '%s' has no field %s; its value is p.%s()", rawget(reference, "name"), check.quoted(key),
             rawget(reference, "name"))
end)
Reference.__tostring = function(reference) return ("parameter '%s'"):format(reference.name) end

function node.reference(declaration, value, noted)
  local reference = setmetatable({ name = declaration.name, declaration = declaration }, Reference)
  taken[reference] = function()
    noted[declaration.name] = true
    return value
  end
  return reference
end

function node.is_reference(value)
  return getmetatable(value) == Reference
end

-- Returns nil if the parameter `wanted` of a pass can have the values of the parameter `source` of the pipeline.
-- Otherwise returns the reason why it cannot.
local function cannot_follow(wanted, source)
  local same = wanted.type == source.type or (wanted.type == "float" and source.type == "int")
  if not same then return ("is %s, but '%s' of the pipeline is %s"):format(wanted.type, source.name, source.type) end
  if wanted.unit ~= "" and source.unit ~= "" and wanted.unit ~= source.unit then
    return ("is in %s, but '%s' of the pipeline is in %s"):format(wanted.unit, source.name, source.unit)
  end
  for _, choice in ipairs(source.choices or {}) do
    if not check.contains(wanted.choices, choice) then
      local near = native.nearest(choice, wanted.choices)
      return ("has no choice '%s', but '%s' of the pipeline has it%s"):format(choice, source.name, near)
    end
  end
  local outside = wanted.min and (source.min < wanted.min or source.max > wanted.max)
  if not outside then return nil end
  return ("has the range %s to %s, but '%s' of the pipeline has the range %s to %s"):format(
    wanted.min, wanted.max, source.name, source.min, source.max)
end

-- Returns the value of `wanted`, a parameter of a pass, for a call that does not set this parameter. If the pipeline
-- has a parameter of the same name from the same shared declaration, the value is the reference `p.NAME` to it.
-- Otherwise returns nil.
local function shared(wanted)
  local declared = param.find(node.graph.params, wanted.name)
  return declared and param.same(declared, wanted) and node.graph.p[wanted.name] or nil
end

-- Returns the binding of the parameter `wanted` of a pass: { value = } for a constant, { follows = } for the name of a
-- parameter of the pipeline. `given`: the argument of the call, a constant or a reference `p.NAME`; nil stands for the default
-- of `wanted`. Returns nil after a mistake.
function node.bind(problems, wanted, given, place, owner)
  if given == nil then return { value = wanted.default, place = wanted.place } end
  if node.is_reference(given) then
    local reason = cannot_follow(wanted, given.declaration)
    if reason then problems:add(place, "parameter '%s' of %s %s", wanted.name, owner, reason) end
    return { follows = given.name, place = place }
  end
  if type(given) == "table" or type(given) == "function" then
    local what = node.is_value(given) and ("the image '%s'"):format(node.source(given)) or "a " .. type(given)
    problems:add(place, "parameter '%s' of %s is given %s instead of a value", wanted.name, owner, what)
    return nil
  end
  local value, wrong = param.check(wanted, given)
  if wrong then problems:add(place, "%s: %s", owner, wrong) end
  return { value = value, place = place }
end

-- ---- calls

local argument_names = setmetatable({}, { __mode = "k" })  -- cache: pass -> names of the arguments of its calls

local function argument_names_of(pass)
  local known = argument_names[pass]
  if known then return known end
  known = { "as", "time", "runs" }
  for _, list in ipairs { pass.reads, pass.params } do
    for _, one in ipairs(list) do known[#known + 1] = one.name end
  end
  argument_names[pass] = known
  return known
end

local function check_argument_names(problems, pass, arguments, place)
  local known = argument_names_of(pass)
  if not native.has_other_keys(arguments, known) then return end
  for key in pairs(arguments) do
    if not check.contains(known, key) then
      local near = type(key) == "string" and native.nearest(key, known) or "; name the port: port = image"
      local at = native.key_place(place, key)
      problems:add(at, "pass '%s' has no input or parameter %s%s", pass.name, check.quoted(key), near)
    end
  end
end

local function wire(problems, pass, read, value, at)
  local function refuse(text, ...)
    problems:add(at, "read '%s' of pass '%s' %s", read.name, pass.name, text:format(...))
  end
  if not node.is_value(value) then
    refuse("%s", not_a_value(value))
    return nil
  end
  if rawget(value, "graph") ~= node.graph then
    refuse("is an image of another pipeline")
    return nil
  end
  local format = rawget(value, "format")
  if check.is_buffer(format) ~= read.buffer then
    refuse("takes %s, but '%s' is %s", read.buffer and "a buffer" or "an image", node.source(value), format)
  elseif check.is_uint(format) ~= read.uint then
    refuse("takes %s, but '%s' is %s", read.uint and "unsigned integers" or "numbers", node.source(value), format)
  end
  return node.source(value)
end

local function wire_reads(problems, pass, arguments, place)
  local inputs = {}
  for _, read in ipairs(pass.reads) do
    local value = rawget(arguments, read.name)
    if value ~= nil then
      inputs[read.name] = wire(problems, pass, read, value, native.key_place(place, read.name))
    elseif not read.optional then
      problems:add(place, "read '%s' of pass '%s' is not given (%s)", read.name, pass.name, read.doc)
    end
  end
  return inputs
end

local function choose_name(problems, pass, arguments, place)
  local given = rawget(arguments, "as")
  local name = given == nil and pass.name:match("[^/]+$") or given
  local at = given == nil and place or native.key_place(place, "as")
  if type(name) == "string" then name = (node.graph.prefix or "") .. name end
  if not check.is_name(name) or name == "scene" then
    problems:add(at, "%s cannot name a node (a-z, then a-z, 0-9 and _, but not 'scene')", check.quoted(name))
    return nil
  end
  for _, other in ipairs(node.graph.nodes) do
    if other.name == name then
      local hint = given == nil and "; name this one with as = \"...\"" or ""
      problems:add(at, "there is a node '%s' already, from %s:%d%s", name, other.place.file, other.place.line, hint)
    end
  end
  return name
end

local function choose_runs(problems, pass, arguments, place)
  local passes = require "strobe.pass"
  local runs = rawget(arguments, "runs")
  if runs == nil then return passes.restriction_of(pass) end
  local owner = ("pass '%s'"):format(pass.name)
  passes.check_runs(problems, runs, pass, native.key_place(place, "runs"), owner)
  return runs
end

local function choose_time(problems, pass, arguments, place)
  local time = rawget(arguments, "time")
  if time == nil then return "raster" end
  local at = native.key_place(place, "time")
  if not check.contains(node.times, time) then
    local near = type(time) == "string" and native.nearest(time, node.times) or ""
    problems:add(at, "time = %s is not one of %s%s", check.quoted(time), table.concat(node.times, ", "), near)
  elseif time == "sample" and not node.graph.loop then
    problems:add(at, "time = \"sample\" is possible only in the body of a pipeline.loop")
  elseif not pass.scene then
    problems:add(at, "pass '%s' does not read the scene, so a time has no effect on it", pass.name)
  end
  return time
end

-- Adds a pass to the graph. Reports a mistake if the graph already has a different pass of the same name.
local function note_pass(problems, pass, place)
  local known = node.graph.passes[pass.name]
  node.graph.passes[pass.name] = known or pass
  if known and known ~= pass then
    problems:add(place, "two passes are called '%s': %s:%d and %s:%d", pass.name, known.place.file, known.place.line,
                 pass.place.file, pass.place.line)
  end
end

-- Makes the node of a call of `pass` at `place`, with the table `arguments`. Returns the outputs of the node. Raises one error
-- with all mistakes of the call.
function node.create(place, pass, arguments)
  if not node.graph then check.fail(place, "pass '%s' is called outside of a pipeline's build", pass.name) end
  if not check.is_plain(arguments) then
    check.fail(place, "pass '%s' takes a table: %s { port = image, parameter = value }", pass.name, pass.name)
  end
  local problems = check.problems()
  check_argument_names(problems, pass, arguments, place)
  note_pass(problems, pass, place)
  local made = { pass = pass.name, place = place, params = {}, loop = node.graph.loop or "" }
  made.name = choose_name(problems, pass, arguments, place)
  made.time = choose_time(problems, pass, arguments, place)
  made.runs = choose_runs(problems, pass, arguments, place)
  made.inputs = wire_reads(problems, pass, arguments, place)
  local owner = ("pass '%s'"):format(pass.name)
  for _, wanted in ipairs(pass.params) do
    local given, at = rawget(arguments, wanted.name), place
    if given == nil then given = shared(wanted) else at = native.key_place(place, wanted.name) end
    made.params[wanted.name] = node.bind(problems, wanted, given, at, owner)
  end
  problems:raise()

  local nodes = node.graph.nodes
  nodes[#nodes + 1] = made
  local record = { name = made.name, place = place, used = next(pass.counters) ~= nil }
  node.graph.records[#nodes] = record
  local values = {}
  for _, list in ipairs { pass.writes, pass.updates } do
    for _, port in ipairs(list) do
      local value = { node = made.name, port = port.name, format = port.format, formats = port.formats }
      value.graph, value.loop = node.graph, made.loop
      values[port.name] = setmetatable(value, Value)
    end
  end
  return node.ports(("pass '%s'"):format(pass.name), values, record)
end

return node
