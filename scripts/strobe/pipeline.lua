-- SPDX-License-Identifier: MIT
-- Pipelines: `pipeline { doc, params, presets, default_preset, build = function(p) ... end }`. The function `build` calls
-- passes and returns named images. These calls make the graph of the pipeline. `pipeline.describe` runs `build` once and
-- returns the graph as plain data.
local check  = require "strobe.check"
local native = require "strobe.native"
local node   = require "strobe.node"
local param  = require "strobe.param"
local preset = require "strobe.preset"

local pipeline = { int = param.int, float = param.float, bool = param.bool, choice = param.choice }

-- Returns a function that makes a table a record: reading an unknown field of a record is an error. `t:get(name)` reads a field
-- that may be absent from the record `t`.
pipeline.record = check.record

pipeline.keys = {
  "doc", "kind", "params", "presets", "default_preset", "build", "breaks", "compare_with", "equals", "regions",
}
pipeline.equal_keys = { "when", "pipeline", "set" }
pipeline.loop_keys = { "name", "count", "first", "parts", "times", "slices", "until_", "body" }

local Pipeline = {}

-- ---- declaration

local function check_kind(problems, t, place)
  if t.kind == nil then return "method" end
  local kinds = native.pipeline_kinds()
  if not check.contains(kinds, t.kind) then
    local near = type(t.kind) == "string" and native.nearest(t.kind, kinds) or ""
    if near == "" then near = "; kinds are " .. table.concat(kinds, ", ") end
    problems:add(native.key_place(place, "kind"), "unknown kind of pipeline %s%s", check.quoted(t.kind), near)
  end
  return t.kind
end

-- Checks `regions`, { OUTPUT = "description of the region" }, and returns it as a list. Each named output is the mask of an
-- error region: the pixels that an error is averaged over.
local function declare_regions(problems, t, place)
  local list = {}
  for name, text in pairs(t.regions or {}) do
    local at = native.key_place(place, "regions", name)
    if not check.is_name(name) then problems:add(at, "%s is not a name for a region", check.quoted(name)) end
    if type(text) ~= "string" or not text:find("%S") then
      problems:add(at, "region %s needs a text that describes its pixels", check.quoted(name))
    end
    list[#list + 1] = { name = name, doc = text }
  end
  return list
end

local function check_condition(problems, params, when, i, place)
  local names = {}
  for k, one in ipairs(params) do names[k] = one.name end
  for name, value in pairs(when) do
    local at = native.key_place(place, "equals", i, "when", name)
    local declared = param.find(params, name)
    local _, wrong
    if declared then _, wrong = param.check(declared, value) end
    if wrong then problems:add(at, "entry %d of equals: %s", i, wrong) end
    if not declared then
      local near = type(name) == "string" and native.nearest(name, names) or ""
      problems:add(at, "entry %d of equals depends on %s, which is not a parameter%s", i, check.quoted(name), near)
    end
  end
end

-- Checks `equals`, a list of equalities with other pipelines, and returns it. Example: `{ when = { mask = "none" }, pipeline =
-- "x", set = {} }`. If the parameters have the values `when`, the picture equals the picture of the pipeline `x` with the
-- parameter values `set`.
local function check_equals(problems, t, params, place)
  local result = {}
  for i, equal in ipairs(t.equals or {}) do
    local what = ("entry %d of equals"):format(i)
    local at = native.key_place(place, "equals", i)
    if type(equal) ~= "table" then
      problems:add(at, "%s is a %s instead of { when = {}, pipeline = \"name\", set = {} }", what, type(equal))
    else
      check.keys(problems, equal, pipeline.equal_keys, place, what, { "equals", i })
      check.field(problems, equal, "pipeline", "string", place, what, { "equals", i })
      if check.field(problems, equal, "when", "table", place, what, { "equals", i }) then
        check_condition(problems, params, equal.when, i, place)
      end
      result[i] = { when = equal.when, pipeline = equal.pipeline, set = equal.set or {} }
    end
  end
  return result
end

local function declare(place, t)
  if type(t) ~= "table" then check.fail(place, "pipeline takes a table: pipeline { ... }") end
  t = check.with_merged(t, "params")
  local problems = check.problems()
  check.keys(problems, t, pipeline.keys, place, "the pipeline")
  check.field(problems, t, "build", "function", place, "the pipeline")
  local doc = check.doc(problems, t, place, "the pipeline")
  for _, key in ipairs { "params", "presets", "equals", "regions" } do
    if t[key] ~= nil then check.field(problems, t, key, "table", place, "the pipeline") end
  end
  if t.compare_with ~= nil then check.field(problems, t, "compare_with", "string", place, "the pipeline") end
  if t.default_preset ~= nil and t.presets == nil then
    problems:add(native.key_place(place, "default_preset"), "the pipeline has default_preset, but no presets")
  end
  problems:raise()

  local params = param.declare_all(problems, t.params or {}, place, "the pipeline")
  if t.params and t.params.preset then
    problems:add(native.key_place(place, "params", "preset"),
                 "a parameter cannot be called 'preset': --set preset=NAME takes one of the presets")
  end
  for _, one in ipairs(params) do
    if one.wired then
      problems:add(one.place, "'wired' is for parameters of passes; '%s' is a parameter of the pipeline", one.name)
    end
  end
  problems:raise()
  local result = { doc = doc, params = params, build = t.build, place = place }
  result.kind = check_kind(problems, t, place)
  result.presets = preset.declare_all(problems, t, params, place)
  result.regions = declare_regions(problems, t, place)
  result.breaks = check.breaks(problems, t.breaks, place, "the pipeline", { "breaks" })
  result.equals = check_equals(problems, t, params, place)
  result.compare_with = t.compare_with
  problems:raise()
  return setmetatable(result, Pipeline)
end

setmetatable(pipeline, { __call = native.at_caller(function(place, _, t) return declare(place, t) end) })
check.closed(pipeline, "pipeline")

function pipeline.is_pipeline(value)
  return getmetatable(value) == Pipeline
end

-- ---- loops

local function whole(name, max)
  return { name = name, type = "int", min = 1, max = max, unit = "", default = 1 }
end
local count_parameter, slices_parameter = whole("count", 1 << 20), whole("slices", 1024)
local times_parameter = { name = "times", type = "choice", choices = { "midpoint", "stratified", "even", "frames" }, unit = "",
                          default = "midpoint" }

local function check_results(problems, results, place)
  if not check.is_plain(results) then
    problems:add(place, "the body of a loop must return a table of images: return { sum = s.sum }")
    return
  end
  for name, value in pairs(results) do
    if not check.is_name(name) then problems:add(place, "%s is not a name for a result", check.quoted(name)) end
    if not node.is_value(value) then
      problems:add(place, "result %s of the loop %s", check.quoted(name), node.not_a_value(value))
    end
  end
end

-- Checks `until_` of a loop, and returns it as "NODE.PORT"; "" after a mistake. The field `until_` is an image of one
-- texel that a pass in the loop writes, or a function of the loop's result that returns this image. The loop ends when
-- the texel is not zero.
local function check_until(problems, t, loop, results, place)
  local value = t.until_
  if type(value) == "function" then value = value(results) end
  if not node.is_value(value) then
    problems:add(place, "until_ of loop '%s' %s", loop.name, node.not_a_value(value))
  elseif not node.has_format(value, "^r32f$") or rawget(value, "loop") ~= loop.name then
    problems:add(place, "until_ of loop '%s' is not an r32f image written inside the loop", loop.name)
  else
    return node.source(value)
  end
  return ""
end

-- Checks `first` and `parts` of a loop. With these fields, several loops can share the samples of an exposure. The exposure is
-- divided into `parts` parts, and the loop samples `count` of these, from number `first` on (0-based). The parts are numbered
-- in an order that spreads consecutive numbers over the whole exposure.
local function check_parts(problems, t, place)
  for _, key in ipairs { "first", "parts" } do
    local at_least = key == "first" and 0 or 1
    local value = t[key]
    if value ~= nil and (math.type(value) ~= "integer" or value < at_least or value > 1 << 20) then
      problems:add(native.key_place(place, key), "'%s' of the loop is not an integer from %d to %d", key, at_least, 1 << 20)
    end
  end
  if (t.first == nil) ~= (t.parts == nil) then problems:add(place, "a loop must have both 'first' and 'parts', or neither") end
end

local function check_loop(problems, t, place)
  check.keys(problems, t, pipeline.loop_keys, place, "the loop")
  check.field(problems, t, "body", "function", place, "the loop")
  check_parts(problems, t, place)
  if check.field(problems, t, "name", "string", place, "the loop") and not check.is_name(t.name) then
    problems:add(native.key_place(place, "name"), "'%s' is not a name (a-z, then a-z, 0-9 and _)", t.name)
  end
  if t.count == nil then problems:add(place, "the loop has no 'count'") end
  if node.graph.loop then
    problems:add(place, "loop '%s' is inside loop '%s'; loops cannot be nested", tostring(t.name), node.graph.loop)
  end
  for _, other in ipairs(node.graph.loops) do
    if other.name == t.name then
      problems:add(native.key_place(place, "name"), "there is a loop '%s' already, from %s:%d", t.name,
                   other.place.file, other.place.line)
    end
  end
end

pipeline.loop = native.at_caller(function(place, t)
  if not node.graph then check.fail(place, "pipeline.loop is called outside of a pipeline's build") end
  if type(t) ~= "table" then check.fail(place, "pipeline.loop takes a table") end
  local problems = check.problems()
  check_loop(problems, t, place)
  problems:raise()

  local owner = ("loop '%s'"):format(t.name)
  local loop = { name = t.name, place = place, ["until"] = "", first = t.first, parts = t.parts }
  loop.count  = node.bind(problems, count_parameter, t.count, native.key_place(place, "count"), owner)
  loop.times  = node.bind(problems, times_parameter, t.times, native.key_place(place, "times"), owner)
  loop.slices = node.bind(problems, slices_parameter, t.slices, native.key_place(place, "slices"), owner)
  problems:raise()
  for _, key in ipairs { "count", "times", "slices" } do loop[key].place = loop[key].place or place end
  node.graph.loops[#node.graph.loops + 1] = loop

  node.graph.loop = t.name
  local results = t.body()
  check_results(problems, results, native.return_place(t.body))
  problems:raise()
  local ports = node.ports(owner, results, {})
  if t.until_ ~= nil then loop["until"] = check_until(problems, t, loop, ports, native.key_place(place, "until_")) end
  node.graph.loop = nil
  problems:raise()
  return ports
end)

-- Runs the function `body` and returns its result. The names of all nodes that `body` makes get the prefix `prefix`. So a part
-- of a graph can be made twice, with different names.
pipeline.prefixed = native.at_caller(function(place, prefix, body)
  if not node.graph then check.fail(place, "pipeline.prefixed is called outside of a pipeline's build") end
  if not check.is_name(prefix) then check.fail(place, "%s cannot be the start of the name of a node", check.quoted(prefix)) end
  if type(body) ~= "function" then check.fail(place, "pipeline.prefixed takes a function, got a %s", type(body)) end
  local outer = node.graph.prefix
  node.graph.prefix = (outer or "") .. prefix
  local result = body()
  node.graph.prefix = outer
  return result
end)

-- ---- evaluation

-- Handles a setting that does not fit the pipeline. With a list `dropped`, the setting is added to the list. Otherwise it is
-- reported as a mistake.
local function refuse(problems, dropped, set, text, ...)
  if not dropped then return problems:add(set.place, text, ...) end
  dropped[#dropped + 1] = { name = set.name, value = tostring(set.value), reason = text:format(...) }
end

-- Applies the settings `sets` to the parameters of the pipeline. A preset overrides the defaults, and a setting overrides the
-- preset. Returns the values of all parameters, the settings that name no parameter of the pipeline, the list of presets, and
-- the name of the chosen preset.
local function resolve(problems, self, sets, dropped)
  local values, unknown, explicit = {}, {}, {}
  local presets, chosen = self.presets, preset.default_of(self.presets)
  for _, set in ipairs(sets) do
    local declared = param.find(self.params, set.name)
    if preset.is_set_by(set, presets) then
      local more, value, wrong = preset.taken(problems, presets, self.params, set.value)
      if wrong then refuse(problems, dropped, set, "%s", wrong) end
      presets, chosen = more or presets, value or chosen
    elseif declared then
      local value, wrong = native.check_value(declared, set.value)
      if wrong then refuse(problems, dropped, set, "%s", wrong) end
      explicit[set.name] = value
    elseif not set.name:find(".", 1, true) then
      unknown[#unknown + 1] = set
    end
  end
  problems:raise()
  for _, one in ipairs(self.params) do values[one.name] = one.default end
  local taken = param.find(presets, chosen)
  for name, value in pairs(taken and taken.values or {}) do values[name] = value end
  for name, value in pairs(explicit) do values[name] = value end
  return values, unknown, presets, chosen
end

-- Returns the argument `p` of a `build`, a table: `p.NAME` is a reference to the parameter NAME. Two sets get names of
-- parameters while `build` runs: `used`, if `build` refers to a parameter (p.NAME), and `noted`, if `build` reads its value
-- (p.NAME()).
local function parameters(self, values, used, noted)
  local names = {}
  for i, one in ipairs(self.params) do names[i] = one.name end
  return setmetatable({}, {
    __index = native.at_caller(function(place, _, name)
      local declared = param.find(self.params, name)
      if not declared then
        local near = type(name) == "string" and native.nearest(name, names) or ""
        check.fail(place, "the pipeline has no parameter %s%s", check.quoted(name), near)
      end
      used[name] = true
      return node.reference(declared, values[name], noted)
    end),
    __newindex = native.at_caller(function(place, _, name)
      check.fail(place, "parameter %s cannot be assigned", check.quoted(name))
    end),
  })
end

local function check_outputs(problems, outputs, build)
  local place = native.return_place(build)
  if not check.is_plain(outputs) then
    problems:add(place, "build must return a table of images: return { color = x.color }")
    return {}
  end
  local sources = {}
  for name, value in pairs(outputs) do
    local at = native.return_place(build, name)
    if not check.is_name(name) then
      problems:add(at, "%s is not a name for an output", check.quoted(name))
    elseif not node.is_value(value) then
      problems:add(at, "output '%s' %s", name, node.not_a_value(value))
    else
      sources[name] = node.source(value)
      local fits, other = node.has_format(value, "^rgba%d+f$")
      if node.has_format(value, "^buffer") then
        problems:add(at, "output '%s' is '%s', a buffer; outputs are images", name, sources[name])
      elseif name == "color" and not fits then
        problems:add(at, "output 'color' is '%s' of format %s; it must be rgba16f or rgba32f", sources[name], other)
      end
    end
  end
  if rawget(outputs, "color") == nil then
    local near = native.nearest("color", check.names(outputs))
    problems:add(place, "build returns no output 'color', which every pipeline must have%s", near)
  end
  return sources
end

-- Returns the declared error regions with a mask among the outputs of this graph. The graph may lack some of the masks, because
-- it depends on the values of parameters.
local function regions_of(self, sources)
  local list = {}
  for _, region in ipairs(self.regions) do
    if sources[region.name] then list[#list + 1] = region end
  end
  return list
end

-- Reports unused parameters and unused results of nodes. A graph for other parameter values may use a parameter that this graph
-- does not use. So a parameter also counts as used if a loaded file contains `p.NAME` in any branch, or if a loaded pass has
-- the parameter.
local function check_unused(problems, self, graph, used)
  for _, one in ipairs(self.params) do
    for _, place in ipairs(native.conditions_on(one.name)) do
      problems:add(place, "p.%s is the parameter itself, which is always true; its value is p.%s()", one.name, one.name)
    end
    if not (used[one.name] or param.is_of_a_pass(one) or native.reads_field(one.name)) then
      problems:add(one.place, "parameter '%s' of the pipeline is not used by its build", one.name)
    end
  end
  for _, record in ipairs(graph.records) do
    if not record.used then problems:add(record.place, "the result of node '%s' is never used", record.name) end
  end
end

local function settable_names(self, graph)
  local names = { #self.presets > 0 and "preset" or nil }
  for _, one in ipairs(self.params) do names[#names + 1] = one.name end
  for _, made in ipairs(graph.nodes) do
    for name in pairs(made.params) do
      if not param.find(graph.passes[made.pass].params, name).wired then names[#names + 1] = made.name .. "." .. name end
    end
  end
  return names
end

-- Returns a hint for the message about a setting `--set NAME=...` without a parameter NAME in the pipeline: the nodes that have
-- a parameter of this name. Returns nil if no node has it.
local function nodes_with(graph, name)
  local found = {}
  for _, made in ipairs(graph.nodes) do
    local own = param.find(graph.passes[made.pass].params, name)
    if own and not own.wired then found[#found + 1] = ("'%s.%s'"):format(made.name, name) end
  end
  return #found > 0 and "; these nodes have it: " .. table.concat(found, ", ") or nil
end

-- Applies the settings of parameters of nodes, `--set NODE.PARAM=VALUE`. They replace the values that the calls in `build`
-- give. Reports settings that match no parameter. `unknown`: the settings without a dot that match no parameter of the
-- pipeline.
local function apply_node_sets(problems, self, graph, sets, unknown, dropped)
  for _, set in ipairs(unknown) do
    local hint = nodes_with(graph, set.name) or native.nearest(set.name, settable_names(self, graph))
    refuse(problems, dropped, set, "the pipeline has no parameter '%s'%s", set.name, hint)
  end
  for _, set in ipairs(sets) do
    local node_name, name = set.name:match("^([^.]*)%.(.*)$")
    local made
    for _, one in ipairs(graph.nodes) do
      if one.name == node_name then made = one end
    end
    local wanted = made and param.find(graph.passes[made.pass].params, name)
    if wanted and wanted.wired then
      refuse(problems, dropped, set, "only the pipeline sets '%s' of node '%s'", name, node_name)
    elseif wanted then
      local value, wrong = native.check_value(wanted, set.value)
      if wrong then refuse(problems, dropped, set, "node '%s': %s", node_name, wrong) end
      if not wrong then made.params[name] = { value = value, place = set.place } end
    elseif node_name then
      local what = made and ("node '%s' has no parameter '%s'"):format(node_name, name)
      what = what or ("unknown node '%s'"):format(node_name)
      refuse(problems, dropped, set, "%s%s", what, native.nearest(set.name, settable_names(self, graph)))
    end
  end
end

local function in_order(by_name)
  local list = {}
  for _, item in pairs(by_name) do list[#list + 1] = item end
  return list
end

-- Runs `build` and returns the graph of the pipeline as plain data. `sets`: the settings, { { name = , value = }, ... }. If
-- `lenient` is true, settings that do not fit are left out and listed in the field `dropped`. Otherwise they are mistakes.
function pipeline.describe(self, name, file, sets, lenient)
  for _, set in ipairs(sets) do set.place = { file = ("--set %s=%s"):format(set.name, set.value), line = 0 } end
  local problems = check.problems()
  local dropped = lenient and {} or nil
  local values, unknown, presets, chosen = resolve(problems, self, sets, dropped)

  local used, noted = {}, {}
  local graph = { nodes = {}, passes = {}, loops = {}, records = {}, params = self.params }
  graph.p = parameters(self, values, used, noted)
  node.graph = graph
  local outputs = self.build(graph.p)
  node.graph = nil

  local sources = check_outputs(problems, outputs, self.build)
  local regions = regions_of(self, sources)
  apply_node_sets(problems, self, graph, sets, unknown, dropped)
  if #problems.list == 0 then check_unused(problems, self, graph, used) end
  problems:raise()
  return {
    name = name, file = file, doc = self.doc, kind = self.kind, breaks = self.breaks,
    compare_with = self.compare_with, equals = self.equals, params = self.params, graph_params = check.names(noted),
    presets = presets, preset = chosen, values = values, passes = in_order(graph.passes), nodes = graph.nodes,
    loops = graph.loops, outputs = sources, regions = regions, dropped = dropped or {},
  }
end

return pipeline
