---@meta
-- SPDX-License-Identifier: MIT
-- What editors complete and check passes and pipelines with. No code: nothing loads this file.
-- A test compares the fields below with the ones that the checks in scripts/strobe accept.

---@alias strobe.Format
---| "r8_unorm" | "rgba8_unorm" | "r32f" | "rg16f" | "rg32f" | "rgba16f" | "rgba32f" | "r32ui" | "rg32ui" | "rgba32ui"
---| "buffer32ui"

---@alias strobe.Time "capture" | "open" | "close" | "sample"

---Properties that every blur should have (docs/invariants.md).
---@alias strobe.Invariant
---| "constant" | "still" | "brief" | "mirrored" | "shifted" | "reversed" | "convex" | "uniform" | "linear" | "scaled"
---| "converging" | "unmasked" | "finite" | "permuted"

---What a parameter is, for commands that ask without knowing its name; at most one of each in a pipeline.
---@alias strobe.Role
---| "tile" | "sample_count" | "reach" | "depth_tolerance" | "jitter" | "shading" | "sample_times" | "regions"
---| "still_once" | "moving_alone" | "within_reach"

---@class strobe.Param A declared parameter.

---A number or true/false: the default first, `{ 20, min = 1, max = 256, unit = "px", doc = "side of a tile" }`.
---@class strobe.ParamTable
---@field [1]? boolean|integer|number the default value
---@field default? boolean|integer|number the default value, by name
---@field min? number smallest value; every int and float has one
---@field max? number largest value; every int and float has one
---@field unit? string "px", "m", "image widths"
---@field doc string what it means
---@field role? strobe.Role what it is
---@field wired? boolean of a pass: says what else is in the graph, so that the pipeline alone sets it
---@field auto? boolean "auto" is a value too (float that is never negative)
---@field variant? boolean compiled into the shader instead of passed to it (int and float)
---@field breaks? table<string, table<strobe.Invariant, string>> invariants that a value breaks, each with the reason; of a number `other`

---The choices in order, `{ "a", "b", default = "b", doc = "which" }`; the first is the default of the default.
---@class strobe.ChoiceTable
---@field [integer] string the choices
---@field default? string one of them
---@field unit? string
---@field doc string what it means
---@field role? strobe.Role what it is
---@field wired? boolean of a pass: says what else is in the graph, so that the pipeline alone sets it
---@field values? table<string, string> what each choice does, and where it fails
---@field breaks? table<string, table<strobe.Invariant, string>> invariants that a choice breaks, each with the reason

---@class strobe.Read
---@field doc string meaning, unit, range
---@field uint? boolean the texels are unsigned integers
---@field optional? boolean may be left unwired; the shader sees HAS_<name> 0
---@field linear? boolean sampled with a linear filter instead of fetched
---@field pointwise? boolean looked up at the pixel of the invocation alone
---@field buffer? boolean a buffer of unsigned integers instead of an image
---@field needs? string|string[] reads, perhaps itself, of which one must be wired, and to more than zeros, else it is not

---A format that a choice parameter of the pass decides: `{ by = "precision", fp32 = "rg32f", fp16 = "rg16f" }`.
---@class strobe.ChosenFormat
---@field by string name of the parameter
---@field [string] strobe.Format one for each of its choices

---@class strobe.Write
---@field format strobe.Format|strobe.ChosenFormat
---@field doc string meaning, unit, range
---@field cleared? boolean zero when the pass begins, which then writes where it has something (not of raster passes)
---@field each? integer entries of a buffer for each pixel of the size

---@class strobe.Update
---@field format strobe.Format|strobe.ChosenFormat
---@field doc string meaning, unit, range
---@field history? boolean kept from frame to frame (zero in the first) instead of zero at the start of each
---@field each? integer entries of a buffer for each pixel of the size

---@class strobe.Size
---@field of? string as large as the image wired to this read
---@field divide? string ... divided, rounding up, by this int parameter
---@field [1]? integer width
---@field [2]? integer height

---@class strobe.Counter
---@field doc string what it counts
---@field limit? string what was done to the picture there and what to do about it: a warning where the count is not 0

---@alias strobe.Fact "motion"|"curves"|"covered"|"arrives"|"alpha"|"blend"|"one_sided"|"shadows"|"bends"|"before"|"after"|"weighted"

---@class strobe.PassTable
---@field name string unique; nodes are called this unless `as` says otherwise
---@field shader string below shaders/, without .glsl (of a raster pass without .vert.glsl and .frag.glsl)
---@field doc string what it computes
---@field fails? string when its result is wrong, and how
---@field breaks? table<strobe.Invariant, string> invariants that do not hold where it is used, each with the reason
---@field size? "frame"|strobe.Size of what it writes; default "frame"
---@field scene? boolean (compute) the shader sees the scene; raster and trace passes always do
---@field over? string the read, a buffer, of the pixels that it runs for
---@field group? boolean (compute) a work group runs for each pixel of what it writes, instead of an invocation
---@field reads? table<string, strobe.Read> images it samples
---@field writes? table<string, strobe.Write> images of which it fills every pixel
---@field updates? table<string, strobe.Update> images it reads and writes; zero at the first execution in a frame
---@field params? table<string, strobe.Param>
---@field counters? table<string, string|strobe.Counter> counts of events: what each counts
---@field without? table<strobe.Fact|string, table<string, 0|string>> where a fact does not hold or a read is 0: its writes

---An image port of a node, to be wired to a read.
---@class strobe.Image

---What the call of a pass yields: its writes and updates by name.
---@class strobe.Ports
---@field [string] strobe.Image

---A call: reads get images; parameters get a literal or a pipeline's parameter.
---@class strobe.CallTable
---@field as? string name of the node
---@field time? strobe.Time pose of the scene that it sees
---@field [string] strobe.Image|strobe.Parameter|boolean|number|string

---@class strobe.Pass
---@field params table<string, strobe.Param> its declarations, for use in a pipeline
---@field counters table<string, string|strobe.Counter> the same of its counters, for use in another pass
---@overload fun(arguments: strobe.CallTable): strobe.Ports

---@class strobe.pass
local pass = {}
---@param t strobe.PassTable
---@return strobe.Pass
function pass.compute(t) end
---@param t strobe.PassTable
---@return strobe.Pass
function pass.raster(t) end
---@param t strobe.PassTable
---@return strobe.Pass
function pass.trace(t) end
---@param folder string below passes/
---@return string[] names of its files, sorted
function pass.family(folder) end
---@param folder string below passes/
---@param name string a file of it
---@return strobe.Pass
function pass.member(folder, name) end
---@param called strobe.Pass
---@param images table<string, strobe.Image> by name
---@param arguments? strobe.CallTable more arguments, which win
---@return strobe.CallTable those of the images that the pass reads, and the arguments
function pass.wired(called, images, arguments) end
---@param t strobe.ParamTable
---@return strobe.Param
function pass.bool(t) end
---@param t strobe.ParamTable
---@return strobe.Param
function pass.int(t) end
---@param t strobe.ParamTable
---@return strobe.Param
function pass.float(t) end
---@param t strobe.ChoiceTable
---@return strobe.Param
function pass.choice(t) end

---A parameter of a pipeline inside its build: passed on it stays live, called it yields its value now.
---@class strobe.Parameter
---@overload fun(): boolean|integer|number|string

---@class strobe.PipelineTable
---@field doc string what it computes, and whose method it is
---@field params? table<string, strobe.Param>
---@field kind? "method"|"sharp"|"truth"|"list" truth has an output `error`; of a list texels are not pixels; default "method"
---@field presets? table<string, strobe.Preset> by name, for `--set preset=NAME`
---@field default_preset? string without it the default is "none"
---@field breaks? table<strobe.Invariant, string> invariants that do not hold, whatever its values, each with the reason
---@field compare_with? string a pipeline that is no nearer to the truth than this one
---@field equals? strobe.EqualTable[] values under which another pipeline gives the same picture, bit for bit
---@field regions? table<string, string> outputs that are masks in which errors are measured: what is in each
---@field build fun(p: table<string, strobe.Parameter>): table<string, strobe.Image> the images; `color` is required

---@class strobe.Preset
---@field doc string what it is for
---@field set table<string, boolean|number|string> values by parameter

---@class strobe.EqualTable
---@field when table<string, boolean|number|string> values of parameters
---@field pipeline string the other pipeline
---@field set? table<string, boolean|number|string> its values

---@class strobe.Pipeline

---@class strobe.LoopTable
---@field name string
---@field count integer|strobe.Parameter how often
---@field first? integer the part of the exposure it begins with, from 0; with `parts`
---@field parts? integer parts of the exposure of which it takes `count`; default all, one after another
---@field times? "midpoint"|"stratified"|"even"|"frames"|strobe.Parameter where in the exposure an iteration is; default "midpoint"
---@field slices? integer|strobe.Parameter scene times among which a pixel draws one; default 1
---@field until_? strobe.Image|fun(results: strobe.Ports): strobe.Image 1x1 r32f image that ends the loop when not zero
---@field body fun(): table<string, strobe.Image> runs once to make the nodes that are repeated

---@class strobe.pipeline
---@overload fun(t: strobe.PipelineTable): strobe.Pipeline
local pipeline = {}
---@param t strobe.LoopTable
---@return strobe.Ports
function pipeline.loop(t) end
---@param what string names the records in messages
---@param optional? string[] fields that a record may lack
---@return fun(t: table): table makes a table a record: reading a field that it lacks is an error
function pipeline.record(what, optional) end
---@param t strobe.Ports|table
---@param name string
---@return any the field of that name, nil where there is none
function pipeline.optional(t, name) end
---What `body` returns; the names of the nodes made in it start with `prefix`. For a part of a graph that is made twice.
---@generic T
---@param prefix string
---@param body fun(): T
---@return T
function pipeline.prefixed(prefix, body) end
---@param t strobe.ParamTable
---@return strobe.Param
function pipeline.bool(t) end
---@param t strobe.ParamTable
---@return strobe.Param
function pipeline.int(t) end
---@param t strobe.ParamTable
---@return strobe.Param
function pipeline.float(t) end
---@param t strobe.ChoiceTable
---@return strobe.Param
function pipeline.choice(t) end

---A preset in a file of its own, for `--set preset=FILE.lua`.
---@class strobe.preset
---@overload fun(t: strobe.Preset): strobe.FilePreset
local preset = {}
---@class strobe.FilePreset

---The values of `--set scene.NAME=VALUE` while a scene is evaluated; nil where there is none.
---@type table<string, boolean|number|string>
scene_params = {}

---@param level? integer 1 is the function that asks, 2 its caller
---@return { file: string, line: integer }
function caller_place(level) end
