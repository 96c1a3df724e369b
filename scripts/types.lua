---@meta
-- SPDX-License-Identifier: MIT
-- Annotations that editors use to complete and check passes and pipelines. The program does not load this file.
-- A test compares the fields below with the fields that scripts/strobe accepts.

---@alias strobe.Format
---| "r8_unorm" | "rgba8_unorm" | "r32f" | "rg16f" | "rg32f" | "rgba16f" | "rgba32f" | "r32ui" | "rg32ui" | "rgba32ui"
---| "buffer32ui"

---@alias strobe.Time "raster" | "shutter_open" | "shutter_close" | "sample"

---Properties that every blur should have (docs/invariants.md).
---@alias strobe.Invariant
---| "constant" | "still" | "brief" | "mirrored" | "shifted" | "reversed" | "convex" | "uniform" | "linear" | "scaled"
---| "converging" | "unmasked" | "finite" | "permuted"

---Role of a parameter. Commands find a parameter by its role instead of its name. A pipeline has each role at most once.
---@alias strobe.Role
---| "tile" | "sample_count" | "reach" | "depth_tolerance" | "jitter" | "shading" | "sample_times" | "regions"
---| "static_once" | "quality"

---@class strobe.Param A declared parameter.

---A number or a boolean; the default is first: `{ 20, min = 1, max = 256, unit = "px", doc = "side of a tile" }`.
---@class strobe.ParamTable
---@field [1]? boolean|integer|number the default value
---@field default? boolean|integer|number the default value, in place of the first entry
---@field min? number smallest value; required for int and float
---@field max? number largest value; required for int and float
---@field unit? string unit of the value: "px", "m", "image widths"
---@field doc string meaning
---@field role? strobe.Role role, by which commands find the parameter
---@field wired? boolean (passes) the value describes the rest of the graph, so that only a pipeline may set it
---@field auto? boolean the parameter also accepts "auto" (for a float that is never negative)
---@field variant? boolean (int and float) the value is compiled into the shader instead of passed to the shader
---@field breaks? table<string, table<strobe.Invariant, string>> invariants that a value breaks; key of numbers: `other`

---The choices in order, `{ "a", "b", default = "b", doc = "which" }`. Without `default` the first choice is the default.
---@class strobe.ChoiceTable
---@field [integer] string the choices
---@field default? string the default choice
---@field unit? string unit of the choices
---@field doc string meaning
---@field role? strobe.Role role, by which commands find the parameter
---@field wired? boolean (passes) the value describes the rest of the graph, so that only a pipeline may set it
---@field values? table<string, string> effect of each choice, and its failures
---@field breaks? table<string, table<strobe.Invariant, string>> invariants that a choice breaks, with reasons

---@class strobe.Read
---@field doc string meaning, unit, range
---@field uint? boolean the texels are unsigned integers
---@field optional? boolean the read may be left unwired; then HAS_<name> is 0 in the shader
---@field absent? number|number[]|string replacement if the read is left unwired: 1 or 4 numbers, or another read's name
---@field linear? boolean the shader samples the image with a linear filter, instead of fetching texels
---@field pointwise? boolean the shader fetches the image only at the pixel of the invocation
---@field buffer? boolean the read is a buffer of unsigned integers instead of an image
---@field needs? string|string[] names of reads; if each of them is unwired or all zeros, this read counts as unwired

---A format chosen by a choice parameter of the pass: `{ by = "precision", fp32 = "rg32f", fp16 = "rg16f" }`.
---@class strobe.ChosenFormat
---@field by string name of the choice parameter
---@field [string] strobe.Format format for the choice of this name

---@class strobe.Write
---@field format strobe.Format|strobe.ChosenFormat
---@field doc string meaning, unit, range
---@field cleared? boolean (not raster) the image is zero when the pass begins, so that the pass may skip pixels
---@field each? integer (buffers) number of entries per output pixel of the pass

---@class strobe.Update
---@field format strobe.Format|strobe.ChosenFormat
---@field doc string meaning, unit, range
---@field history? boolean true: the image is kept from frame to frame; false: it is zero at the start of each frame
---@field each? integer (buffers) number of entries per output pixel of the pass

---@class strobe.Size
---@field of? string name of a read; the outputs have the size of its image
---@field divide? string name of an int parameter that divides the size of the image, rounding up
---@field [1]? integer width
---@field [2]? integer height

---@class strobe.Counter
---@field doc string counted event
---@field limit? string warning if the count is not 0: how the picture was changed, and the remedy

---@alias strobe.Runs "everywhere" | "moving_rect" | "moving_instances"

---A property that a frame has or lacks; key of `if_no` (docs/omission.md).
---@alias strobe.Fact
---| "motion" | "curves" | "alpha" | "blend" | "one_sided" | "shadows" | "deforms" | "before"
---| "after" | "weighted"

---@class strobe.PassTable
---@field name? string unique name; default: path below passes/ without .lua. Its last part is the default name of nodes
---@field shader? string path below shaders/, without .glsl (for a raster pass without .vert.glsl and .frag.glsl)
---@field doc string result of the pass
---@field fails? string where the result of the pass is wrong, and how
---@field breaks? table<strobe.Invariant, string> invariants that do not hold in a pipeline that uses the pass, with reasons
---@field size? "frame"|strobe.Size size of the outputs; default "frame"
---@field scene? boolean (compute) the shader reads the scene; raster and trace passes always do
---@field runs? strobe.Runs pixels or instances that the pass is restricted to; default "moving_rect", if `if_no` allows
---@field dispatch_over? string name of a buffer read; the pass runs for the pixels in this buffer
---@field group? boolean (compute) one work group per output pixel, instead of one invocation
---@field reads? table<string, strobe.Read> images that the shader samples
---@field writes? table<string, strobe.Write> images in which the shader writes every pixel
---@field updates? table<string, strobe.Update> images that the shader reads and writes; zero before the first execution
---@field params? table<string, strobe.Param>
---@field counters? table<string, string|strobe.Counter> counters, each with its counted event
---@field if_no? table<strobe.Fact|string, table<string, 0|string>> stand-ins if a fact is false or a read is all zeros

---An image that a node writes. It can be wired to reads of other nodes.
---@class strobe.Image

---Result of a call of a pass: its writes and updates by name.
---@class strobe.Ports
---@field [string] strobe.Image

---Arguments of a call: an image for each read, a constant or a parameter of the pipeline for each parameter.
---@class strobe.CallTable
---@field as? string name of the node
---@field time? strobe.Time time of the scene that the node reads; default "raster"
---@field runs? strobe.Runs restriction that replaces the restriction declared by the pass
---@field [string] strobe.Image|strobe.Parameter|boolean|number|string

---@class strobe.Pass
---@field params table<string, strobe.Param> declarations of its parameters, for use in a pipeline
---@field counters table<string, string|strobe.Counter> declarations of its counters, for use in another pass
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
---@return string[] sorted names of the folder's files
function pass.family(folder) end
---@param folder string below passes/
---@param name string a file of the folder
---@return strobe.Pass
function pass.member(folder, name) end
---@param called strobe.Pass
---@param images table<string, strobe.Image> images by the name of the read
---@param arguments? strobe.CallTable further arguments; these override the images
---@return strobe.CallTable the images that the pass reads, and the further arguments
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

---A parameter of a pipeline inside `build`. If it is passed to a pass, it stays adjustable. A call returns its present value.
---@class strobe.Parameter
---@overload fun(): boolean|integer|number|string

---@class strobe.PipelineTable
---@field doc string result and source of the method
---@field params? table<string, strobe.Param>
---@field kind? "method"|"sharp"|"truth"|"list" "truth" has an output `error`, a "list" is not a picture; default "method"
---@field presets? table<string, strobe.Preset> presets by name, for `--set preset=NAME`
---@field default_preset? string name of the preset that is used by default; without it, "none", which sets nothing
---@field breaks? table<strobe.Invariant, string> invariants that the pipeline breaks with all values, with reasons
---@field compare_with? string a pipeline that must not be nearer to truth than this one
---@field equals? strobe.EqualTable[] conditions under which another pipeline gives the same picture, bit for bit
---@field regions? table<string, string> outputs that are masks of error regions, each with a description
---@field build fun(p: table<string, strobe.Parameter>): table<string, strobe.Image> returns the images; `color` is required

---@class strobe.Preset
---@field doc string purpose
---@field set table<string, boolean|number|string> values by the name of the parameter

---@class strobe.EqualTable
---@field when table<string, boolean|number|string> parameter values of this pipeline
---@field pipeline string the other pipeline
---@field set? table<string, boolean|number|string> parameter values of the other pipeline

---@class strobe.Pipeline

---@class strobe.LoopTable
---@field name string
---@field count integer|strobe.Parameter number of iterations
---@field first? integer number of the first part of the exposure, 0-based; needs `parts`
---@field parts? integer number of parts of the exposure, of which the loop samples `count`; default: `count`
---@field times? "midpoint"|"stratified"|"even"|"frames"|strobe.Parameter scene times of the iterations; default "midpoint"
---@field slices? integer|strobe.Parameter scene times per iteration, of which each pixel uses a random one; default 1
---@field until_? strobe.Image|fun(results: strobe.Ports): strobe.Image 1x1 r32f image; the loop ends when it is not zero
---@field body fun(): table<string, strobe.Image> function that runs once and makes the nodes that the loop repeats

---@class strobe.PartsTable
---@field name string
---@field count integer|strobe.Parameter number of parts of the exposure
---@field body fun(): table<string, strobe.Image> function that runs once and makes the nodes that the loop repeats

---@class strobe.parts
local parts = {}
---A loop whose iterations are exposures of their own: the parts of the frame's exposure.
---@param t strobe.PartsTable
---@return strobe.Ports
function parts.loop(t) end

---@class strobe.pipeline
---@overload fun(t: strobe.PipelineTable): strobe.Pipeline
local pipeline = {}
---@param t strobe.LoopTable
---@return strobe.Ports
function pipeline.loop(t) end
---@param what string name of the records in messages
---@param optional? string[] fields that a record may lack
---@return fun(t: table): table makes `t` a record: reading a field that it lacks is an error, except by t:get(name)
function pipeline.record(what, optional) end
---Runs `body` and returns its result. The names of its nodes start with `prefix`, so that a part of a graph can be made twice.
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

---The values of `--set scene.NAME=VALUE` while a scene is evaluated; nil for names that are not set.
---@type table<string, boolean|number|string>
scene_params = {}

---@param level? integer 1 is the calling function, 2 its caller
---@return { file: string, line: integer }
function caller_place(level) end
