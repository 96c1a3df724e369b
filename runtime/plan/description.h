// SPDX-License-Identifier: MIT
// Data that Lua returns: passes and a pipeline as plain data. Each field has the place where it was written.
// `...FromJson` reads the canonical form (made by scripts/strobe/run.lua).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/error.h"
#include "base/json_fwd.h"

namespace strobe::plan {

// A parameter's value: bool, integer, number, or the name of a choice.
using Value = std::variant<bool, int64_t, double, std::string>;

Json toJson(const Value& value);
Value valueFromJson(const Json& json);

// Text that reads back as the same value: an integral double keeps its ".0".
std::string textOf(const Value& value);
// Value of "true", "false", an integer or a finite number; any other text stays text.
Value valueFromText(const std::string& text);

// Properties that every blur should have, by name (docs/invariants.md), in the order of their numbers.
const std::vector<std::string>& invariantNames();

// Invariants that do not hold, by name, each with the reason.
using Breaks = std::vector<std::pair<std::string, std::string>>;

// Meaning of a parameter, for code that does not depend on its name. A pipeline has at most one parameter per role.
enum class Role {
  None,
  Tile,            // side of a tile, px
  SampleCount,     // samples per pixel, along the motion or over the exposure
  Reach,           // longest displacement that filters handle, in image widths
  DepthTolerance,  // two depths are equal if they differ by less than this share of the depth
  Jitter,          // pattern of sample offsets from pixel to pixel
  Shading,         // pose at which points are shaded: "frozen" or "full"
  SampleTimes,     // sample times within the exposure: "midpoint" or "stratified"
  Regions,         // bool: compute the masks of the error regions
  StillOnce,       // bool of a pass: after the first iteration of a loop, run in the moving rectangle only
  Quality,         // float: from the cheapest picture to the best; chosen to fit a time budget
};

// Names of the roles except None, in the order of the enumeration.
const std::vector<std::string>& roleNames();

// Stored value of "auto"; shaders read the same number. The range of a parameter with "auto" is above this number.
inline constexpr double kAuto = -1;

// Key in `ParamDesc::breaks` for all numbers except the default.
inline constexpr const char* kOtherNumbers = "other";

// A parameter. Validation, the GLSL parameter block, the command line, panels, sweeps and the record all use this
// declaration.
struct ParamDesc {
  enum class Type { Bool, Int, Float, Choice };
  std::string name;
  Type type = Type::Float;
  Value default_value;
  std::optional<double> min, max;                           // Int and Float, inclusive
  std::vector<std::string> choices;                         // Choice
  std::vector<std::pair<std::string, std::string>> values;  // Choice: effect and failures of each choice
  std::vector<std::pair<std::string, Breaks>> breaks;  // invariants that a value breaks; key kOtherNumbers for numbers
  std::string unit;                                    // "px", "m", ... or ""
  std::string doc;
  Role role = Role::None;
  bool has_auto = false;  // Float: may be "auto", stored as kAuto; the shader computes the number
  bool wired = false;     // pass: describes the rest of the graph, so only the pipeline may set it
  bool variant = false;   // compiled into the shader instead of passed to it (always for Choice and Bool)
  Place place;
  bool operator==(const ParamDesc&) const = default;
};

// Names of the values of an enumeration, in its order.
inline const std::vector<std::string> kParamTypes = {"bool", "int", "float", "choice"};

// True if the value is compiled into the shader.
inline bool isCompiledIn(const ParamDesc& param) {
  return param.variant || param.type == ParamDesc::Type::Bool || param.type == ParamDesc::Type::Choice;
}

// Returns `value` as the type of `param`. An integer is converted to a number, and text as typed on a command line to a
// value. Throws `Error` at the place `where` if the type does not fit or the value is out of range.
Value checkValue(const ParamDesc& param, const Value& value, const Place& where);

// A port of a pass: an image, or a buffer (a write or update of the format kBufferFormat, plan/formats.h).
struct PortDesc {
  std::string name;
  std::string doc;
  std::string format;  // writes and updates: "r32f", "rgba16f", "rg32ui", ...; "" for reads
  // Writes and updates: `format_by` is a choice parameter of the pass that decides the format, and `formats` has the
  // format of each choice. Either all or none of these formats have unsigned integers. `format` is the format of the
  // default; `formatOf` returns the format in a node.
  std::string format_by;
  std::vector<std::pair<std::string, std::string>> formats;
  bool uint = false;       // reads: the texels are unsigned integers
  bool optional = false;   // reads: may be unwired; HAS_<name> is 0 in the shader then
  bool linear = false;     // reads: sampled with a linear filter instead of texel fetches
  bool buffer = false;     // reads: a buffer (of unsigned integers) instead of an image
  bool pointwise = false;  // reads: the pass reads only the pixel that it runs for
  // Optional reads: names of reads, possibly including this one. If all these reads are unwired or only zeros, this
  // read is unwired too. Empty: no condition.
  std::vector<std::string> needs;
  // Optional images: value of every texel if the read is not wired. Either four numbers, or the name of another read
  // whose texels are used. Both empty: shaders test HAS_<name>.
  std::vector<double> absent;
  std::string absent_read;
  int each = 1;          // writes and updates that are buffers: entries per pixel of the pass's size
  bool cleared = false;  // writes: zero when the pass begins, so the pass need not write every texel
  bool history = false;  // updates: kept from frame to frame; otherwise zero at the start of each frame
  Place place;
  bool operator==(const PortDesc&) const = default;
};

// True if shaders can read the texels of an optional read that is not wired.
bool hasAbsent(const PortDesc& read);

// True if a write is zero when the pass begins; true for every buffer.
bool isCleared(const PortDesc& port);

// Format of a write or update in a node with the parameter values `params`.
const std::string& formatOf(const PortDesc& port, const std::vector<std::pair<std::string, Value>>& params);

// Largest side of an image or a frame, pixels: the limit of every device with ray tracing.
inline constexpr int kMaxSide = 16384;

// Size of the images that a pass writes.
struct SizeDesc {
  enum class Kind { Frame, Port, Fixed };
  Kind kind = Kind::Frame;
  std::string port;           // Kind::Port: as large as the image wired to this read
  std::string divide;         // Kind::Port: integer parameter that divides this size, rounding up; or ""
  int width = 0, height = 0;  // Kind::Fixed
  Place place;                // the field `size`; the pass if the field is missing
  bool operator==(const SizeDesc&) const = default;
};

inline const std::vector<std::string> kSizeKinds = {"frame", "port", "fixed"};

// Declaration of a 32-bit counter that a pass increments per event, such as an overflowed list, with the event's effect
// on the picture.
struct CounterDesc {
  std::string name;
  std::string doc;
  std::string limit;  // effect of the counted event on the picture, and the remedy; "" if the event has no effect
  bool operator==(const CounterDesc&) const = default;
};

// Name in `WithoutDesc` of the condition "pixel outside of the moving rectangle".
inline const char* const kMovingRect = "moving_rect";

// Stand-ins for the writes of a pass if a fact of the frame does not hold (plan/facts.h), or if a read is only zeros. A
// stand-in equals the result of the pass bit for bit, so the pass does not run. With the name `kMovingRect` the pass
// may run within the moving rectangle only.
struct WithoutDesc {
  std::string name;  // a fact, a read or kMovingRect
  std::vector<std::pair<std::string, std::string>>
      writes;  // each write in order -> the read that stands in; "" for zeros
  Place place;
  bool operator==(const WithoutDesc&) const = default;
};

// Declaration of a GPU pass: raster, compute or ray tracing shader, images that it reads and writes, their size,
// parameters and counters.
struct PassDesc {
  enum class Kind { Raster, Compute, Trace };
  std::string name;
  Kind kind = Kind::Compute;
  std::string shader;  // path below shaders/; a raster pass has "<shader>.vert.glsl" and "<shader>.frag.glsl"
  std::string doc;
  std::string fails;  // cases in which the result is wrong, and the error; or ""
  Breaks breaks;      // invariants that do not hold if a pipeline uses the pass
  SizeDesc size;
  // Name of a read that is a buffer: the pass runs once for each entry, which is a pixel. The pass runs for all pixels
  // if the read is not wired, or if `over` is "". All writes of such a pass are cleared.
  std::string over;
  bool group = false;            // compute: one work group per pixel instead of one invocation
  bool scene = false;            // the shader has the scene's buffers, textures and acceleration structures
  std::vector<PortDesc> reads;   // sampled images
  std::vector<PortDesc> writes;  // every pixel is written
  // Read and written; zero before the first execution in a frame, or with `history` before the first frame.
  std::vector<PortDesc> updates;
  std::vector<ParamDesc> params;
  std::vector<CounterDesc> counters;  // 32-bit event counts for the run record
  std::vector<WithoutDesc> without;   // in the order of the tests
  Place place;
  bool operator==(const PassDesc&) const = default;
};

inline const std::vector<std::string> kPassKinds = {"raster", "compute", "trace"};

// Names of the writes, then of the updates.
std::vector<std::string> outputsOf(const PassDesc& pass);

// Value of a parameter of a node: either a constant, or the value of a parameter of the pipeline.
struct Binding {
  std::optional<Value> value;
  std::string follows;  // name of a pipeline parameter, or ""
  Place place;
  bool operator==(const Binding&) const = default;
};

// Pixels or instances that a node runs for.
enum class Runs {
  Everywhere,       // all pixels, all instances
  MovingRect,       // pixels of the moving rectangle; the other pixels get the stand-in kMovingRect of the pass
  MovingInstances,  // raster: instances that move, if the camera is static
};

inline const std::vector<std::string> kNodeRuns = {"everywhere", "moving_rect", "moving_instances"};
inline const std::vector<std::string> kNodeTimes = {"raster", "shutter_open", "shutter_close", "sample"};

// One use of a pass.
struct NodeDesc {
  std::string name;  // unique: the name of the pass, or the name given by `as`
  std::string pass;
  std::vector<std::pair<std::string, std::string>> inputs;  // read port -> "node.port"
  std::vector<std::pair<std::string, Binding>> params;
  // Pose of the scene, one of kNodeTimes; "sample": the times of its loop.
  std::string time = "raster";
  std::string loop;  // name of the loop that repeats the node, or ""
  Runs runs = Runs::MovingRect;
  Place place;
  bool operator==(const NodeDesc&) const = default;
};

// Times of a loop whose iterations draw the parts of the frame's exposure, each as an exposure of its own.
inline constexpr const char* kPartTimes = "parts";
inline const std::vector<std::string> kSampleTimes = {"midpoint", "stratified", "even", "frames", kPartTimes};

// Nodes repeated for k = first .. first+count-1, with other scene times in each iteration.
struct LoopDesc {
  std::string name;
  Binding count;
  // Choice of kSampleTimes: "stratified" (parts of equal weight), "even" (parts of equal length), "frames" (raster
  // times of earlier frames, the latest first).
  Binding times;
  Binding slices;     // scene times per iteration; a pixel may draw one; 1 for midpoint times
  std::string until;  // "node.port" of a 1x1 r32f image in the loop, non-zero to stop early; or ""
  // The exposure has `parts` parts, and the loop takes `count` parts, from number `first` on. Parts with consecutive
  // numbers are spread over the whole exposure. If `parts` is 0, the loop takes all parts, one after another.
  int first = 0, parts = 0;
  Place place;
  bool operator==(const LoopDesc&) const = default;
};

// With the values of `when`, the picture equals the picture of another pipeline with the values of `set`, bit for bit.
struct EqualDesc {
  std::vector<std::pair<std::string, Value>> when, set;
  std::string pipeline;
  bool operator==(const EqualDesc&) const = default;
};

// A named set of values: `--set preset=NAME`. Values that are set separately override the preset.
struct PresetDesc {
  std::string name;
  std::string doc;
  std::vector<std::pair<std::string, Value>> values;
  bool is_default = false;  // used if no preset is named; exactly one preset is the default
  bool operator==(const PresetDesc&) const = default;
};

// Name of the setting that selects a preset.
inline constexpr const char* kPresetSetting = "preset";

// An output that is the mask of an error region, where errors are measured.
struct RegionDesc {
  std::string name;  // name of the output
  std::string doc;   // description of the pixels in the region
  bool operator==(const RegionDesc&) const = default;
};

// Render graph as declared in Lua, before compilation: parameters, presets, passes, nodes, loops and outputs.
struct PipelineDesc {
  // Role among the pipelines. Method: one of many methods. Sharp: the raster image without blur. Truth: ground truth,
  // with an output "error", the standard error of the colour per pixel. List: texels are not pixels of the frame.
  enum class Kind { Method, Sharp, Truth, List };
  std::string name;  // "mine" of mine.lua
  std::string file;  // as shown to users
  std::string doc;
  Kind kind = Kind::Method;
  Breaks breaks;             // invariants that fail for all parameter values
  std::string compare_with;  // a pipeline whose error against ground truth is not smaller; or ""
  std::vector<EqualDesc> equals;
  std::vector<ParamDesc> params;
  // Parameters whose values the scripts read. These values may have decided the graph.
  std::vector<std::string> graph_params;
  std::vector<PresetDesc> presets;
  std::string preset;                                 // the preset in use; "" without presets
  std::vector<std::pair<std::string, Value>> values;  // every pipeline parameter, resolved, in declaration order
  std::vector<PassDesc> passes;                       // each pass that is used, once
  std::vector<NodeDesc> nodes;                        // in the order of the calls
  std::vector<LoopDesc> loops;
  std::vector<std::pair<std::string, std::string>> outputs;  // output -> "node.port"
  std::vector<RegionDesc> regions;                           // outputs that are regions
  bool operator==(const PipelineDesc&) const = default;
};

// "method", "sharp", "truth", "list".
const std::vector<std::string>& pipelineKindNames();

// The parameter of the pipeline with that name or role; null if it does not exist.
const ParamDesc* paramNamed(const PipelineDesc& pipeline, const std::string& name);
const ParamDesc* paramOf(const PipelineDesc& pipeline, Role role);

// The value of a parameter of the pipeline, or of a binding; null if the parameter does not exist.
const Value* valueOf(const PipelineDesc& pipeline, const std::string& name);
const Value* valueOf(const PipelineDesc& pipeline, const Binding& binding);
// Number of earlier frames that loops with the times "frames" read, at most 64.
int earlierFrames(const PipelineDesc& pipeline);
// True if a loop of the pipeline draws the parts of the exposure (kPartTimes).
bool hasParts(const PipelineDesc& pipeline);

// Readers of the canonical form. Its text comes from another process, so names, references, types and ranges are
// checked. Throws `Error` with the place of a mistake.
PassDesc passFromJson(const Json& json);
std::vector<ParamDesc> paramsFromJson(const Json& list);
// Parts that descriptions of pipelines often have in common. A description without "passes" and "params" takes these.
struct SharedParts {
  std::vector<PassDesc> passes;
  std::vector<ParamDesc> params;
};
PipelineDesc pipelineFromJson(const Json& json, SharedParts parts = {});

// The checks of `passFromJson` that concern several fields. Throws `Error` at the place of the first mistake.
void checkPass(const PassDesc& pass);

}  // namespace strobe::plan
