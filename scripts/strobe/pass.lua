-- SPDX-License-Identifier: MIT
-- Constructors of passes: `pass.compute { ... }`, `pass.raster { ... }`, `pass.trace { ... }`. A constructor checks its table,
-- which describes the pass, and returns the pass as an object. A pipeline calls this object with images and values; each call
-- makes a node.
local check   = require "strobe.check"
local native  = require "strobe.native"
local param   = require "strobe.param"
local stand_in = require "strobe.stand_in"

local pass = { int = param.int, float = param.float, bool = param.bool, choice = param.choice }

pass.keys = {
  "name", "shader", "doc", "fails", "breaks", "size", "scene", "reads", "writes", "updates", "params", "counters",
  "if_no", "dispatch_over", "group", "runs",
}
pass.read_keys  = { "doc", "uint", "optional", "absent", "linear", "needs", "buffer", "pointwise" }
pass.write_keys = { "doc", "format", "cleared", "each" }
pass.update_keys = { "doc", "format", "history", "each" }
pass.format_keys = { "by" }  -- keys of a table of formats; further keys: the choices of the parameter `by`
pass.counter_keys = { "doc", "limit" }
pass.size_keys  = { "of", "divide", 1, 2 }
pass.runs       = { "everywhere", "moving_rect", "moving_instances" }  -- pixels or instances that a pass is restricted to
pass.call_keys  = { "as", "time", "runs" }  -- arguments of every call: not allowed as names of ports and parameters

local MAX_SIDE, MAX_EACH = 32768, 4096
local formats = native.formats()

local function port_names(list)
  local names = {}
  for i, port in ipairs(list) do names[i] = port.name end
  return names
end

local function is_port_table(problems, name, port, place, what)
  if not check.is_name(name) then
    problems:add(place, "%s is not a name for %s (a-z, then a-z, 0-9 and _)", check.quoted(name), what)
    return false
  end
  if check.contains(pass.call_keys, name) or name == "get" then
    problems:add(place, "%s cannot be called '%s', which is a reserved name", what, name)
  end
  if type(port) ~= "table" then
    problems:add(place, "%s '%s' is a %s instead of a table like { doc = \"...\" }", what, name, type(port))
    return false
  end
  return true
end

-- Checks `needs` of an optional read: the name of a read, or a list of names. The optional read counts as unwired if each of
-- the named reads is unwired or contains only zeros. Returns the list.
local function check_needs(problems, reads, port, at, what)
  local needs = type(port.needs) == "string" and { port.needs } or port.needs or {}
  if type(needs) ~= "table" then
    problems:add(at, "'needs' of %s is %s, which is neither the name of a read nor a list of names", what,
                 check.quoted(port.needs))
    return {}
  end
  if #needs > 0 and not (port.optional or port.absent ~= nil) then
    problems:add(at, "%s has 'needs' but is not optional", what)
  end
  for _, needed in ipairs(needs) do
    if reads[needed] == nil then
      problems:add(at, "%s needs %s, which is not a read of the pass", what, check.quoted(needed))
    end
  end
  return needs
end

local function is_texel(value, uint)
  if type(value) ~= "table" or #value ~= 4 then return false end
  for i = 1, 4 do
    local n = value[i]
    local fits = type(n) == "number" and n == n and math.abs(n) < 1e38
    if not fits or (uint and (math.type(n) ~= "integer" or n < 0 or n > 4294967295)) then return false end
  end
  return true
end

-- True if the chain of replacements from the read `name` comes back to `name`. The field `absent` of a read may name
-- another read, which replaces the first one if that is not wired.
local function leads_back(reads, name)
  local at = reads[name].absent
  for _ in pairs(reads) do
    if at == name then return true end
    at = type(reads[at]) == "table" and reads[at].absent or nil
  end
  return false
end

-- Checks `absent` of the read `name`, which is used if the read is not wired. It is the value of each texel (four numbers, or
-- one number for all four components) or the name of another read that replaces this read. Returns four numbers or the name.
-- Returns nil without `absent` and after a mistake.
local function check_absent(problems, reads, name, at, what)
  local port = reads[name]
  local given = port.absent
  if given == nil then return nil end
  if port.buffer then problems:add(at, "%s is a buffer; only images can have 'absent'", what) end
  if type(given) ~= "string" then
    local texel = type(given) == "number" and { given, given, given, given } or given
    if is_texel(texel, port.uint) then return texel end
    local numbers = port.uint and "unsigned integer" or "number"
    problems:add(at, "'absent' of %s must be one %s, four of these, or the name of a read", what, numbers)
    return nil
  end
  local other = reads[given]
  if type(other) ~= "table" or given == name then
    local near = given == name and "" or native.nearest(given, check.names(reads))
    problems:add(at, "'absent' of %s is %s, which is not another read of the pass%s", what, check.quoted(given), near)
  elseif other.buffer or (other.uint or false) ~= (port.uint or false) then
    problems:add(at, "'absent' of %s is '%s', which has texels of another kind", what, given)
  elseif leads_back(reads, name) then
    problems:add(at, "'absent' of %s is '%s', which leads back to this read", what, given)
  elseif other.optional and other.absent == nil then
    problems:add(at, "'absent' of %s is '%s', which may be unwired too", what, given)
  else
    return given
  end
  return nil
end

local function declare_reads(problems, t, place, owner)
  local list = {}
  for name, port in pairs(t.reads or {}) do
    local at = native.key_place(place, "reads", name)
    if is_port_table(problems, name, port, at, "a read of " .. owner) then
      local what = "read '" .. name .. "' of " .. owner
      check.keys(problems, port, pass.read_keys, place, what, { "reads", name })
      local result = { name = name, place = at, doc = check.doc(problems, port, place, what, { "reads", name }) }
      for _, key in ipairs { "uint", "optional", "linear", "buffer", "pointwise" } do
        result[key] = port[key] or false
        if port[key] ~= nil then check.field(problems, port, key, "boolean", place, what, { "reads", name }) end
      end
      if port.buffer and port.linear then problems:add(at, "%s cannot be both buffer and linear", what) end
      if port.pointwise and (port.buffer or port.linear) then
        problems:add(at, "%s cannot be both pointwise and %s", what, port.buffer and "buffer" or "linear")
      end
      if port.buffer then result.uint = true end
      result.absent = check_absent(problems, t.reads, name, at, what)
      result.optional = result.optional or port.absent ~= nil
      result.needs = check_needs(problems, t.reads, port, at, what)
      if port.uint and port.linear then problems:add(at, "%s cannot be both uint and linear", what) end
      list[#list + 1] = result
    end
  end
  return list
end

local function is_format(problems, format, at, what)
  if check.contains(formats, format) then return true end
  local near = type(format) == "string" and native.nearest(format, formats) or ""
  if near == "" then near = "; formats are " .. table.concat(formats, ", ") end
  problems:add(at, "%s has no known format: %s%s", what, check.quoted(format), near)
  return false
end

-- Returns the declaration of the choice parameter that decides the format, named by `format.by`; nil after a mistake.
local function deciding_parameter(problems, format, params, declared, at, what)
  local by = type(format.by) == "string" and param.find(params, format.by)
  if by and by.type == "choice" then return by end
  if not by and declared and format.by ~= nil and declared[format.by] ~= nil then return nil end  -- reported already
  local names = {}
  for i, one in ipairs(params) do names[i] = one.name end
  local near = type(format.by) == "string" and not by and native.nearest(format.by, names) or ""
  local reason = by and "which is not a choice parameter" or "which is not a parameter of the pass"
  problems:add(at, "the format of %s is chosen by %s, %s%s", what, check.quoted(format.by), reason, near)
  return nil
end

-- Checks `format = { by = "PARAMETER", CHOICE = "FORMAT", ... }`, which gives an image one format for each choice of a
-- parameter. Returns the format for the default choice, the name of the parameter, and the table of formats by choice. Returns
-- nil after a mistake.
local function chosen_format(problems, format, params, declared, path, place, what)
  local function at(key) return native.key_place(place, table.unpack(check.joined(path, key))) end
  local by = deciding_parameter(problems, format, params, declared, at("by"), what)
  if not by then return nil end
  local by_choice, first, sound = {}, nil, true
  for choice in pairs(format) do
    if choice ~= "by" and not check.contains(by.choices, choice) then
      local near = type(choice) == "string" and native.nearest(choice, by.choices) or ""
      problems:add(at(choice), "%s has a format for %s, which is not a choice of '%s'%s", what, check.quoted(choice),
                   by.name, near)
      sound = false
    end
  end
  for _, choice in ipairs(by.choices) do
    local one = format[choice]
    if choice == "by" then
      problems:add(by.place, "choice 'by' of '%s' cannot have a format in %s: there 'by' names the parameter", by.name, what)
      sound = false
    elseif one == nil then
      problems:add(at("by"), "%s has no format for '%s' = '%s'", what, by.name, choice)
      sound = false
    elseif not is_format(problems, one, at(choice), what) then
      sound = false
    elseif check.is_buffer(one) then
      problems:add(at(choice), "%s has a format per choice, so it must be an image, but '%s' gives %s", what, choice, one)
      sound = false
    elseif first and check.is_uint(one) ~= check.is_uint(first) then
      problems:add(at(choice), "the formats of %s mix unsigned integers and numbers: %s and %s", what, first, one)
      sound = false
    end
    first = first or (sound and one or nil)
    by_choice[choice] = one
  end
  if not sound then return nil end
  return by_choice[by.default], by.name, by_choice
end

local function format_of(problems, port, params, declared, path, place, what)
  if type(port.format) == "table" then
    return chosen_format(problems, port.format, params, declared, path, place, what)
  end
  is_format(problems, port.format, native.key_place(place, table.unpack(path)), what)
  return port.format
end

-- Checks the rules for the port `port` if its format is a buffer: a buffer is not kept from frame to frame, and raster passes
-- cannot write one. An image cannot have `each`, the number of buffer entries per pixel.
local function check_buffer(problems, port, kind, at, what)
  local each = port.each or 1
  if math.type(each) ~= "integer" or each < 1 or each > MAX_EACH then
    problems:add(at, "'each' of %s is not an integer from 1 to %d", what, MAX_EACH)
  end
  if not check.is_buffer(port.format) then
    if port.each then problems:add(at, "%s has 'each' but is an image, which has one texel per pixel", what) end
    return
  end
  if kind == "raster" then problems:add(at, "%s is a buffer; a raster pass writes images", what) end
  if port.history then problems:add(at, "%s is a buffer, which is not kept from frame to frame", what) end
end

local function declare_writes(problems, t, key, params, kind, place, owner)
  local list = {}
  for name, port in pairs(t[key] or {}) do
    local at = native.key_place(place, key, name)
    if is_port_table(problems, name, port, at, key .. " of " .. owner) then
      local what = "'" .. name .. "' of the " .. key .. " of " .. owner
      check.keys(problems, port, key == "updates" and pass.update_keys or pass.write_keys, place, what, { key, name })
      for _, flag in ipairs { "history", "cleared" } do
        if port[flag] ~= nil then check.field(problems, port, flag, "boolean", place, what, { key, name }) end
      end
      local result = { name = name, place = at, doc = check.doc(problems, port, place, what, { key, name }) }
      result.history, result.cleared, result.each = port.history, port.cleared, port.each
      result.format, result.format_by, result.formats =
        format_of(problems, port, params, t.params, { key, name, "format" }, place, what)
      check_buffer(problems, port, kind, at, what)
      list[#list + 1] = result
    end
  end
  return list
end

local function has_text(value)
  return type(value) == "string" and value:find("%S") ~= nil
end

-- Checks the counters of a pass and returns them as a list. The declaration of a counter is the text `doc` or a table { doc =,
-- limit = }. `doc` names the counted event. `limit` is the text of a warning, shown if the count is not 0: how the events
-- change the picture, and the remedy.
local function declare_counters(problems, t, place, owner)
  local list = {}
  for name, given in pairs(t.counters or {}) do
    local at = native.key_place(place, "counters", name)
    local what = ("counter %s of %s"):format(check.quoted(name), owner)
    local counter = type(given) == "table" and given or { doc = given }
    if not check.is_name(name) then problems:add(at, "%s is not a name for a counter", check.quoted(name)) end
    if type(given) == "table" then check.keys(problems, given, pass.counter_keys, place, what, { "counters", name }) end
    if not has_text(counter.doc) then problems:add(at, "%s needs a text that names the counted event", what) end
    if counter.limit ~= nil and not has_text(counter.limit) then
      problems:add(at, "'limit' of %s needs a text: how the events changed the picture, and the remedy", what)
    end
    list[#list + 1] = { name = name, doc = counter.doc, limit = counter.limit }
  end
  return list
end

-- Checks `dispatch_over` and returns it; "" without this field. The field names a read that is a buffer with a list of
-- pixels. The pass then runs once for each pixel of the list, instead of once for each pixel of the picture.
local function declare_over(problems, t, kind, result, place, owner)
  if t.dispatch_over == nil then return "" end
  local at = native.key_place(place, "dispatch_over")
  local read
  for _, port in ipairs(result.reads) do
    if port.name == t.dispatch_over then read = port end
  end
  if not read or not read.buffer then
    local is_unknown = type(t.dispatch_over) == "string" and not read
    local near = is_unknown and native.nearest(t.dispatch_over, port_names(result.reads)) or ""
    problems:add(at, "%s runs over %s, which is not a buffer read of the pass%s", owner, check.quoted(t.dispatch_over), near)
  end
  if kind == "raster" then problems:add(at, "%s is a raster pass, and runs over triangles, not over a list", owner) end
  for _, write in ipairs(result.writes) do
    if not write.cleared and not check.is_buffer(write.format or "") then
      problems:add(write.place, "'%s' of %s, which runs over '%s', needs cleared = true: pixels outside of the list stay 0",
                   write.name, owner, t.dispatch_over)
    end
  end
  return t.dispatch_over
end

-- Checks `group` and returns its value. With group = true, the pass runs one work group of invocations for each output
-- pixel, instead of a single invocation.
local function declare_group(problems, t, kind, result, place, owner)
  if t.group == nil or not check.field(problems, t, "group", "boolean", place, owner) or not t.group then return false end
  local at = native.key_place(place, "group")
  if kind ~= "compute" then problems:add(at, "%s is a %s pass; only compute passes have groups", owner, kind) end
  if result.over ~= "" then
    problems:add(at, "%s runs over '%s' with one invocation per entry, so it cannot have group = true", owner, result.over)
  end
  for _, one in ipairs(result.params) do
    if one.role == "static_once" then
      problems:add(one.place, "'%s' of %s cannot have the role static_once, because the pass has group = true", one.name, owner)
    end
  end
  return true
end

-- True if `runs` is one of pass.runs and is allowed for the kind of the pass `result`. Otherwise reports a mistake at the place
-- `at`.
function pass.check_runs(problems, runs, result, at, owner)
  if not check.contains(pass.runs, runs) then
    local near = type(runs) == "string" and native.nearest(runs, pass.runs) or ""
    problems:add(at, "runs = %s of %s is not one of %s%s", check.quoted(runs), owner, table.concat(pass.runs, ", "), near)
  elseif runs == "moving_instances" and result.kind ~= "raster" then
    problems:add(at, "%s is a %s pass; only raster passes run for moving instances", owner, result.kind)
  else
    return true
  end
  return false
end

local restrictions = setmetatable({}, { __mode = "k" })  -- description of a pass -> its restriction `runs`

-- Returns the restriction `runs` that the pass with this description declares.
function pass.restriction_of(description) return restrictions[description] end

-- Checks `runs` and returns it. The field `runs` restricts a pass to some pixels or instances; a call of the pass in a
-- pipeline may give another restriction. The default "moving_rect" has no effect unless `if_no.moving_rect` has
-- stand-ins, which fill the pixels outside of the moving rectangle.
local function declare_runs(problems, t, result, place, owner)
  if t.runs == nil then return "moving_rect" end
  return pass.check_runs(problems, t.runs, result, native.key_place(place, "runs"), owner) and t.runs or "moving_rect"
end

local function check_divide(problems, size, params, declared, at, owner)
  local names = {}
  for i, one in ipairs(params) do names[i] = one.name end
  local divide = type(size.divide) == "string" and param.find(params, size.divide)
  if not divide and declared and declared[size.divide] ~= nil then return end  -- reported already
  if not divide then
    local near = type(size.divide) == "string" and native.nearest(size.divide, names) or ""
    problems:add(at, "size of %s divides by %s, which is not a parameter of the pass%s", owner, check.quoted(size.divide),
                 near)
  elseif divide.type ~= "int" or divide.min < 1 then
    problems:add(at, "size of %s divides by '%s', which is not an int of at least 1", owner, size.divide)
  end
end

local function size_of_port(problems, size, result, declared, at, owner)
  local read
  for _, port in ipairs(result.reads) do
    if port.name == size.of then read = port end
  end
  if not read then
    local near = type(size.of) == "string" and native.nearest(size.of, port_names(result.reads)) or ""
    problems:add(at, "size of %s is the size of %s, which is not a read of the pass%s", owner, check.quoted(size.of), near)
  elseif read.optional then
    problems:add(at, "size of %s is the size of '%s', which is optional and may be absent", owner, size.of)
  end
  if size.divide ~= nil then check_divide(problems, size, result.params, declared, at, owner) end
  return { kind = "port", port = size.of, divide = size.divide, place = at }
end

local function declare_size(problems, t, place, result, owner)
  local size = t.size
  local at = native.key_place(place, "size")
  if size == nil or size == "frame" then return { kind = "frame" } end
  if type(size) ~= "table" then
    problems:add(at, "size of %s is %s; it must be \"frame\", { of = \"<read>\" } or { width, height }", owner,
                 check.quoted(size))
    return { kind = "frame" }
  end
  check.keys(problems, size, pass.size_keys, place, "size of " .. owner, { "size" })
  if size.of ~= nil and size[1] == nil and size[2] == nil then
    return size_of_port(problems, size, result, t.params, at, owner)
  end
  local width, height = math.tointeger(size[1]), math.tointeger(size[2])
  local fits = width and height and width >= 1 and height >= 1 and width <= MAX_SIDE and height <= MAX_SIDE
  if size.of ~= nil or size.divide ~= nil or not fits then
    problems:add(at, "size of %s is neither { of = \"<read>\" } nor { width, height } from 1 to %d", owner, MAX_SIDE)
  end
  return { kind = "fixed", width = width, height = height, place = at }
end

-- Reports equal names. Reads and parameters are arguments of one call, so their names must differ. Writes and updates are
-- fields of the result of one call, so their names must differ too.
local function check_twins(problems, result, owner)
  local seen = {}
  for _, list in ipairs { result.reads, result.params } do
    for _, one in ipairs(list) do
      if seen[one.name] then problems:add(one.place, "%s has a read and a parameter called '%s'", owner, one.name) end
      seen[one.name] = true
    end
  end
  seen = {}
  for _, list in ipairs { result.writes, result.updates } do
    for _, one in ipairs(list) do
      if seen[one.name] then problems:add(one.place, "%s both writes and updates '%s'", owner, one.name) end
      seen[one.name] = true
    end
  end
  if next(result.writes) == nil and next(result.updates) == nil then
    problems:add(result.place, "%s writes nothing", owner)
  end
end

-- Returns the path below passes/ of the file at `place`, without .lua. Returns nil for a file outside of passes/ and for a file
-- of passes/lib: a pass that is declared there must state its name.
local function path_of(place)
  -- The name of a file may begin with "strobe:" or "project:", as in "strobe:passes/tile/tile_max.lua".
  local path = ("/" .. place.file):match(".*[/:]passes/(.+)%.lua$")
  return path and not path:find("^lib/") and path or nil
end

-- Returns the name and the shader of a pass. The default of both is the path of the file that declares the pass. For a file
-- outside of passes/, the name is required, and the default of the shader is the name.
local function named_by_file(problems, t, place)
  local name = t.name or path_of(place)
  if name == nil then
    problems:add(place, "the pass needs a field 'name', because its file is not in passes/, where the path gives the name")
    return nil, t.shader
  end
  if not check.is_path(name) then
    problems:add(native.key_place(place, "name"), "%s is not a name of a pass (parts of a-z, 0-9 and _, separated by /)",
                 check.quoted(name))
  end
  return name, t.shader or path_of(place) or name
end

local function check_shader(problems, shader, place, owner)
  local at = native.key_place(place, "shader")
  if type(shader) ~= "string" then
    problems:add(at, "shader of %s is a %s instead of a string", owner, type(shader))
    return
  end
  local plain = shader:find("^[%w_][%w_%-./]*$") and not shader:find("..", 1, true)
  if not plain then problems:add(at, "shader '%s' of %s is not a path below shaders/", shader, owner) end
  if shader:find("%.glsl$") then
    problems:add(at, "shader '%s' of %s must be written without the ending .glsl", shader, owner)
  end
end

-- List of the descriptions of all passes that files declare when they are loaded. A pass that is declared inside a `build` is
-- left out, because it may differ each time that `build` runs.
pass.declared = {}

-- Returns a copy of `declared`, a table of parameters or counters by name, as a record: reading an unknown name is an error.
-- Pipelines read it as `.params` and `.counters` of a pass. `what` and `owner` name the table in messages.
local function named(what, owner, declared)
  local copy = {}
  for name, one in pairs(declared) do copy[name] = one end
  return check.record(("'%s' of %s"):format(what, owner))(copy)
end

local Pass = check.index_of_records({}, "a pass")


local function declare(kind, place, t)
  if type(t) ~= "table" then check.fail(place, "pass.%s takes a table: pass.%s { ... }", kind, kind) end
  t = check.with_merged(t, "params")
  local problems = check.problems()
  local owner = ("pass '%s'"):format(tostring(t.name or path_of(place)))
  check.keys(problems, t, pass.keys, place, owner)
  local name, shader = named_by_file(problems, t, place)
  check_shader(problems, shader, place, owner)
  for _, key in ipairs { "reads", "writes", "updates", "params", "counters", "if_no" } do
    if t[key] ~= nil then check.field(problems, t, key, "table", place, owner) end
  end
  if t.scene ~= nil then check.field(problems, t, "scene", "boolean", place, owner) end
  if kind ~= "compute" and t.scene == false then
    problems:add(native.key_place(place, "scene"), "%s is a %s pass, which always reads the scene; remove scene = false",
                 owner, kind)
  end
  local doc = check.doc(problems, t, place, owner)
  if t.fails ~= nil then check.field(problems, t, "fails", "string", place, owner) end
  problems:raise()

  local result = { name = name, kind = kind, shader = shader, doc = doc, fails = t.fails or "", place = place }
  result.scene    = kind ~= "compute" or t.scene == true
  result.params   = param.declare_all(problems, t.params or {}, place, owner)
  result.reads    = declare_reads(problems, t, place, owner)
  result.writes   = declare_writes(problems, t, "writes", result.params, kind, place, owner)
  result.updates  = declare_writes(problems, t, "updates", result.params, kind, place, owner)
  result.counters = declare_counters(problems, t, place, owner)
  result.breaks   = check.breaks(problems, t.breaks, place, owner, { "breaks" })
  result.size     = declare_size(problems, t, place, result, owner)
  result.over     = declare_over(problems, t, kind, result, place, owner)
  result.group    = declare_group(problems, t, kind, result, place, owner)
  restrictions[result] = declare_runs(problems, t, result, place, owner)
  result.without  = stand_in.declare(problems, t.if_no, result, place, owner)
  check_twins(problems, result, owner)
  problems:raise()
  param.note_pass(result.params)
  if not require("strobe.node").graph then pass.declared[#pass.declared + 1] = result end
  local params, counters = named("params", owner, t.params or {}), named("counters", owner, t.counters or {})
  return setmetatable({ description = result, params = params, counters = counters }, Pass)
end

for _, kind in ipairs { "compute", "raster", "trace" } do
  pass[kind] = native.at_caller(function(place, t) return declare(kind, place, t) end)
end

Pass.__call = native.at_caller(function(place, self, arguments)
  return require("strobe.node").create(place, self.description, arguments)
end)

function pass.is_pass(value)
  return getmetatable(value) == Pass
end

-- Returns the sorted names of the files in passes/`folder`. Their passes are a family, alternatives for one task. A new file in
-- the folder adds an alternative.
function pass.family(folder)
  return native.files("passes/" .. folder)
end

-- Returns the pass that the file `name` in passes/`folder` declares.
function pass.member(folder, name)
  return require(("passes.%s.%s"):format(folder, name))
end

-- Returns the table of arguments for a call of the pass `called`: the table `arguments`, completed by those images of the table
-- `images` that have the name of a read. Example: `sobel(pass.wired(sobel, raster, { as = "edge" }))` wires `raster.depth` to
-- the read `depth`, and likewise the other reads of `sobel`. It also names the node "edge".
function pass.wired(called, images, arguments)
  local result = {}
  for key, value in pairs(arguments or {}) do result[key] = value end
  for _, read in ipairs(called.description.reads) do
    if result[read.name] == nil then result[read.name] = require("strobe.node").optional(images, read.name) end
  end
  return result
end

-- True if the pass `called` has a read with the name `name`.
function pass.reads(called, name)
  for _, read in ipairs(called.description.reads) do
    if read.name == name then return true end
  end
  return false
end

check.closed(pass, "pass")

return pass
