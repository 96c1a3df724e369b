// SPDX-License-Identifier: MIT
// What Lua hands over: passes and a pipeline as plain data, each field with the place where it was written.
// `fromJson` reads the canonical form (what scripts/strobe/run.lua hands over); `toJson` writes it back, key for key.
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

// Text that reads back as the same value: a whole double keeps its ".0".
std::string textOf(const Value& value);
// "true", "false", an integer, a finite number; any other text stays text.
Value valueFromText(const std::string& text);

// Properties that every blur should have, by name (docs/invariants.md), in the order of their numbers.
const std::vector<std::string>& invariantNames();

// Invariants that do not hold, by name, each with the reason.
using Breaks = std::vector<std::pair<std::string, std::string>>;

// What a parameter is, for those that ask without knowing its name: a pipeline has at most one of each.
enum class Role {
  None,
  Tile,            // side of a tile, px
  SampleCount,     // samples per pixel, along the motion or over the exposure
  Reach,           // longest displacement handled, in widths of the picture
  DepthTolerance,  // share of the depth over which two depths count as one
  Jitter,          // how samples are shifted from pixel to pixel
  Shading,         // the pose at which points are shaded: "frozen" or "full"
  SampleTimes,     // where in the exposure samples are: "midpoint" or "stratified"
  Regions,         // bool: find the regions in which errors are measured
  StillOnce,       // bool of a pass: iterations of a loop after the first do only what something in motion reaches
  Quality,         // float: from the cheapest picture to the best; a budget of time chooses it
};

// Their names, but for None, in that order.
const std::vector<std::string>& roleNames();

// One declaration that feeds validation, the GLSL parameter block, the command line, panels, sweeps and the record.
// What "auto" is held as, and what a shader sees of it. No other negative number is in the range of such a parameter.
inline constexpr double kAuto = -1;

// Stands for any number but the default where a parameter says what its values break.
inline constexpr const char* kOtherNumbers = "other";

struct ParamDesc {
  enum class Type { Bool, Int, Float, Choice };
  std::string name;
  Type type = Type::Float;
  Value default_value;
  std::optional<double> min, max;                           // of Int and Float, inclusive
  std::vector<std::string> choices;                         // of Choice
  std::vector<std::pair<std::string, std::string>> values;  // of Choice: what a choice does and where it fails
  std::vector<std::pair<std::string, Breaks>> breaks;       // what a value breaks; of numbers kOtherNumbers
  std::string unit;                                         // "px", "m", ... or ""
  std::string doc;
  Role role = Role::None;
  bool has_auto = false;  // of Float: "auto" is a value too, held as kAuto; what it stands for is the shader's to find
  bool wired = false;     // of a pass: says what else is in the graph, so that its pipeline alone sets it
  bool variant = false;   // compiled into the shader instead of passed to it (always so for Choice and Bool)
  Place place;
};

// Whether a value of it makes another shader.
inline bool isCompiledIn(const ParamDesc& param) {
  return param.variant || param.type == ParamDesc::Type::Bool || param.type == ParamDesc::Type::Choice;
}

// Throws `Error` (with `where` as its place) if `value` is of another type or out of range; an integer is accepted
// where a number is wanted, and text as typed on a command line is converted.
Value checkValue(const ParamDesc& param, const Value& value, const Place& where);

// An image port of a pass, or one of a buffer: a write or update of the format kBufferFormat (plan/formats.h).
struct PortDesc {
  std::string name;
  std::string doc;
  std::string format;  // of writes and updates: "r32f", "rgba16f", "rg32ui", ...; "" for reads
  // Writes and updates whose format a choice parameter of the pass decides: its name and a format for each choice, all
  // of them unsigned integers or none. `format` is then the one of its default; ask `formatOf` for a node's.
  std::string format_by;
  std::vector<std::pair<std::string, std::string>> formats;
  bool uint = false;       // reads: the texels are unsigned integers
  bool optional = false;   // reads: may be left unwired; the shader then sees HAS_<name> 0
  bool linear = false;     // reads: sampled with a linear filter instead of texel fetches
  bool buffer = false;     // reads: a buffer (of unsigned integers) instead of an image
  bool pointwise = false;  // reads: at the pixel that the pass runs for, and nowhere else
  // Reads that are optional: reads, it itself perhaps among them, of which one at least must be wired, and to more than
  // nothing but zeros, for it to be of use; otherwise it is not wired either. Empty: it is of use alone.
  std::vector<std::string> needs;
  // Optional reads of images: value of every texel if the read is not wired. Four numbers, or the name of another read
  // whose texels stand in; both empty: shaders test HAS_<name> instead.
  std::vector<double> absent;
  std::string absent_read;
  int each = 1;          // writes and updates, of a buffer: entries for each pixel of the pass's size
  bool cleared = false;  // writes: zero when the pass begins, which writes only where it has something
  bool history = false;  // updates: kept from frame to frame instead of zero at the start of each
  Place place;
};

// True if shaders can read the texels of an optional read that is not wired.
bool hasAbsent(const PortDesc& read);

// Is a write zero when the pass begins? Of buffers each is.
bool isCleared(const PortDesc& port);

// The format that a write or update has in a node with these values of the pass's parameters.
const std::string& formatOf(const PortDesc& port, const std::vector<std::pair<std::string, Value>>& params);

// Sizes of what a pass writes.
struct SizeDesc {
  enum class Kind { Frame, Port, Fixed };
  Kind kind = Kind::Frame;
  std::string port;           // Kind::Port: as large as the image wired to this read
  std::string divide;         // ... divided (rounding up) by this integer parameter of the pass, or ""
  int width = 0, height = 0;  // Kind::Fixed
  Place place;                // of the field; of the pass where a file does not have it
};

struct CounterDesc {
  std::string name;
  std::string doc;
  std::string limit;  // what was done to the picture where it counted, and what to do about it; or "": just an event
};

// The name of what stands in at each pixel in which nothing that moves is seen at any time.
inline const char* const kReached = "moving_rect";

// What stands in for a pass where a fact of the frame does not hold (plan/facts.h), or where a read is nothing but
// zeros: bit for bit what it would write. It does not run then; of `kReached`, it may run on the other pixels alone.
struct WithoutDesc {
  std::string name;                                         // of the fact or the read
  std::vector<std::pair<std::string, std::string>> writes;  // each write in order -> the read that it equals; "": zeros
  Place place;
};

struct PassDesc {
  enum class Kind { Raster, Compute, Trace };
  std::string name;
  Kind kind = Kind::Compute;
  std::string shader;  // below shaders/; of a raster pass "<shader>.vert.glsl" and "<shader>.frag.glsl"
  std::string doc;
  std::string fails;  // when what it computes is wrong, and how; or ""
  Breaks breaks;      // invariants that do not hold where it is used
  SizeDesc size;
  // The read, a buffer, whose entries are the pixels that it runs for, once each; all pixels where that is not wired.
  // Its writes are all cleared. "": it runs for all pixels.
  std::string over;
  bool group = false;             // compute: a work group runs for each pixel, instead of an invocation
  bool scene = false;             // the shader sees the scene's buffers, textures and acceleration structures
  std::vector<PortDesc> reads;    // images it samples
  std::vector<PortDesc> writes;   // images it fills; every pixel is written
  std::vector<PortDesc> updates;  // images it reads and writes; zero before the first execution in a frame, or ever
  std::vector<ParamDesc> params;
  std::vector<CounterDesc> counters;  // 32-bit event counts, read back into the run record
  std::vector<WithoutDesc> without;   // in the order in which they are tried
  Place place;
};

// A node's parameter is a value, or follows a parameter of the pipeline.
struct Binding {
  std::optional<Value> value;
  std::string follows;  // name of a pipeline parameter, or ""
  Place place;
};

// Pixels or instances that a node may be restricted to.
enum class Runs {
  Everywhere,       // all pixels, all instances
  MovingRect,       // pixels of the moving rectangle; elsewhere the stand-in kReached of its pass holds
  MovingInstances,  // raster: instances that move, if the camera is static
};

// One use of a pass.
struct NodeDesc {
  std::string name;  // unique: the pass's name, or what `as` gave it
  std::string pass;
  std::vector<std::pair<std::string, std::string>> inputs;  // read port -> "node.port"
  std::vector<std::pair<std::string, Binding>> params;
  std::string time =
      "raster";      // pose of the scene it sees: "raster", "shutter_open", "shutter_close" or "sample" (its loop's)
  std::string loop;  // name of the loop it is repeated in, or ""
  Runs runs = Runs::MovingRect;
  Place place;
};

// Times of a loop whose iterations are exposures of their own: the parts of the frame's exposure, each drawn anew.
inline constexpr const char* kPartTimes = "parts";

// Nodes repeated for k = first .. first+count-1, each time with its own scene times.
struct LoopDesc {
  std::string name;
  Binding count;
  // Choice "midpoint" | "stratified" (of equal weights) | "even" (of equal lengths) | "frames" (captures of earlier
  // frames, the last one first) | kPartTimes.
  Binding times;
  Binding slices;     // scene times per iteration among which a pixel may draw one; 1 for midpoint times
  std::string until;  // "node.port" of a 1x1 r32f image in the loop, non-zero to stop early; or ""
  // Of how many parts of the exposure this loop takes `count`, from which on, in an order in which any run of them lies
  // all over the exposure. 0 parts: all of them, one after another.
  int first = 0, parts = 0;
  Place place;
};

// Where the values of `when` are set, the picture is bit for bit that of another pipeline with the values of `set`.
struct EqualDesc {
  std::vector<std::pair<std::string, Value>> when, set;
  std::string pipeline;
};

// A named set of values, which single settings override: `--set preset=NAME`.
struct PresetDesc {
  std::string name;
  std::string doc;
  std::vector<std::pair<std::string, Value>> values;
  bool is_default = false;  // taken where no preset is named: one of them is, where there are any
};

// The name of the setting that takes a preset.
inline constexpr const char* kPresetSetting = "preset";

// An output that is the mask of a region in which errors are measured.
struct RegionDesc {
  std::string name;  // of the output
  std::string doc;   // what is in it
};

struct PipelineDesc {
  // What it is to other pipelines: one of many methods; the capture as it is, without blur; what is true, which has an
  // output "error", the standard error of its colour per pixel; a list, whose texels are not pixels of the frame.
  enum class Kind { Method, Sharp, Truth, List };
  std::string name;  // "mine" of mine.lua
  std::string file;  // as shown to people
  std::string doc;
  Kind kind = Kind::Method;
  Breaks breaks;             // invariants that do not hold, for any of its values
  std::string compare_with;  // a pipeline to which the truth is no nearer than to this one; or ""
  std::vector<EqualDesc> equals;
  std::vector<ParamDesc> params;
  std::vector<std::string> graph_params;  // whose values its scripts looked at: they may have decided the graph
  std::vector<PresetDesc> presets;
  std::string preset;                                 // the one that was taken; "" where there are none
  std::vector<std::pair<std::string, Value>> values;  // every pipeline parameter, resolved, in declaration order
  std::vector<PassDesc> passes;                       // each pass in use once
  std::vector<NodeDesc> nodes;                        // in the order of the calls
  std::vector<LoopDesc> loops;
  std::vector<std::pair<std::string, std::string>> outputs;  // output -> "node.port"
  std::vector<RegionDesc> regions;                           // those of its outputs that are regions
};

// "method", "sharp", "truth", "list".
const std::vector<std::string>& pipelineKindNames();

// The pipeline's parameter of that name or role; null where there is none.
const ParamDesc* paramNamed(const PipelineDesc& pipeline, const std::string& name);
const ParamDesc* paramOf(const PipelineDesc& pipeline, Role role);

// The value of a parameter of the pipeline; null where there is none.
const Value* valueOf(const PipelineDesc& pipeline, const std::string& name);
// How many frames before the capture its loops of times "frames" look back at; 64 stands for more.
int earlierFrames(const PipelineDesc& pipeline);
// True if a loop of the pipeline draws the parts of the exposure (kPartTimes).
bool hasParts(const PipelineDesc& pipeline);

// They read what another process wrote and so trust nothing: names, references, types and ranges are checked, and
// `Error` is thrown at the place of the first mistake.
PassDesc passFromJson(const Json& json);
// What descriptions of one pipeline have in common, for which they have a number n in the place of a pass, the nth of
// these from 1, and no "params".
struct Known {
  std::vector<PassDesc> passes;
  std::vector<ParamDesc> params;
};
Known knownFromJson(const Json& json);
PipelineDesc pipelineFromJson(const Json& json, const Known& known = {});

Json toJson(const PipelineDesc& pipeline);
Json toJson(const PassDesc& pass);

// The image formats a pass may write.
const std::vector<std::string>& formatNames();

}  // namespace strobe::plan
