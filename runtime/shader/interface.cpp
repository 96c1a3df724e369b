// SPDX-License-Identifier: MIT
#include "shader/interface.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include "base/inputs.h"

namespace strobe::shader {

bool Interface::sizeIsGiven() const {
  return std::all_of(writes.begin(), writes.end(), [](const Write& write) { return write.buffer; });
}

const Interface::Read* Interface::over() const {
  auto found = std::find_if(reads.begin(), reads.end(), [](const Read& read) { return read.over && read.wired; });
  return found == reads.end() ? nullptr : &*found;
}

static std::string header(const Interface& in) {
  std::string text = "#version 460\n";
  for (const char* extension : {"GL_EXT_scalar_block_layout", "GL_EXT_nonuniform_qualifier", "GL_EXT_buffer_reference",
                                "GL_GOOGLE_include_directive", "GL_EXT_control_flow_attributes"})
    text += fmt::format("#extension {} : require\n", extension);
  if (in.backend != Backend::None) {
    const BackendRow& row = rowOf(in.backend);
    for (const char* extension : row.extensions) text += fmt::format("#extension {} : require\n", extension);
    text += fmt::format("#define {}\n#define STROBE_STRUCTURES_{}\n", row.define,
                        row.structures == StructureKind::Own ? "OWN" : "DRIVER");
    if (in.doubles) text += "#define STROBE_DOUBLES\n";
  }
  if (in.separate_triangles) text += "#define STROBE_SEPARATE_TRIANGLES\n";
  return text + fmt::format("#define STROBE_SLICES {}\n#define TIME_SLICE {}u\n", in.slices, in.time_slice);
}

static std::string variantText(const Interface& in) {
  std::string text;
  for (const auto& variant : in.variants) {
    text += fmt::format("#define PARAM_{} {}\n", variant.name, variant.index);
    for (size_t i = 0; i < variant.choices.size(); ++i)
      text += fmt::format("#define {}_{} {}\n", variant.name, variant.choices[i], i);
  }
  for (const auto& read : in.reads) text += fmt::format("#define HAS_{} {}\n", read.name, int(read.wired));
  return text;
}

static std::string factText(const Interface& in) {
  std::string text;
  for (const auto& [fact, holds] : in.facts) text += fmt::format("#define FACT_{} {}\n", fact, int(holds));
  return text;
}

static std::string frameText(const Interface& in) {
  std::string text = "#include \"shared/frame.h\"\n";
  text += "layout(set = 0, binding = 0, scalar) uniform Frame { FrameData frame; };\n";
  if (in.scene) text += "#include \"shared/bindings.glsl\"\n";
  return text;
}

// A buffer: its head (arguments of an indirect dispatch and the number of entries in use), then the entries.
static std::string bufferText(const char* access, uint32_t binding, const std::string& block, const std::string& name) {
  return fmt::format(
      "layout(set = 1, binding = {}, scalar) {}buffer {} {{ uvec3 groups; uint count; uint entries[]; }} {}_buf;\n",
      binding, access, block, name);
}

// `vec4 <name>_at(ivec2 at)` for each image: its texel, or the declared value if the read is not wired.
static std::string accessorText(const Interface& in) {
  std::string declared, defined;
  for (const auto& read : in.reads) {
    if (read.buffer || (!read.wired && read.absent.empty())) continue;
    std::string head = fmt::format("{}vec4 {}_at(ivec2 at)", read.uint ? "u" : "", read.name);
    std::string texel = read.wired ? fmt::format("texelFetch({}_tex, at, 0)", read.name) : read.absent;
    declared += head + ";\n";
    defined += fmt::format("{} {{ return {}; }}\n", head, texel);
  }
  return declared + defined;
}

static std::string resourceText(const Interface& in, ShaderStage stage) {
  std::string text;
  if (in.hasParams()) {
    text += fmt::format("layout(set = 1, binding = {}, scalar) uniform Params {{\n", Interface::kParamsBinding);
    for (const auto& param : in.params) text += fmt::format("  {} {};\n", param.integer ? "int" : "float", param.name);
    if (in.sizeIsGiven()) text += "  ivec2 size_;\n";
    text += "} params;\n";
  }
  if (!in.counters.empty()) {
    text += fmt::format("layout(set = 1, binding = {}, scalar) buffer Counters {{ uint values[{}]; }} counters_;\n",
                        Interface::kCountersBinding, in.counters.size());
    for (size_t i = 0; i < in.counters.size(); ++i)
      text += fmt::format("void count_{}(uint n) {{ atomicAdd(counters_.values[{}], n); }}\n", in.counters[i], i);
  }
  for (size_t i = 0; i < in.reads.size(); ++i) {
    const auto& read = in.reads[i];
    if (read.buffer) text += bufferText("readonly ", in.readBinding(i), read.name + "_read_", read.name);
    else
      text += fmt::format("layout(set = 1, binding = {}) uniform {}sampler2D {}_tex;\n", in.readBinding(i),
                          read.uint ? "u" : "", read.name);
  }
  text += accessorText(in);
  for (size_t i = 0; i < in.writes.size(); ++i) {
    const auto& write = in.writes[i];
    if (in.raster && stage == ShaderStage::Fragment)
      text += fmt::format("layout(location = {}) out {}vec4 {}_out;\n", i, write.uint ? "u" : "", write.name);
    if (in.raster) continue;
    if (write.buffer) text += bufferText("", in.writeBinding(i), write.name + "_write_", write.name);
    else
      text += fmt::format("layout(set = 1, binding = {}, {}) uniform {} {}image2D {}_img;\n", in.writeBinding(i),
                          write.format, write.update ? "" : "writeonly", write.uint ? "u" : "", write.name);
  }
  if (in.raster) return text;
  auto image = std::find_if(in.writes.begin(), in.writes.end(), [](const auto& write) { return !write.buffer; });
  std::string size = in.sizeIsGiven() ? "params.size_" : fmt::format("imageSize({}_img)", image->name);
  text += fmt::format("ivec2 pass_size() {{ return {}; }}\n", size);
  return text;
}

std::string preamble(const Interface& in, ShaderStage stage) {
  bool shared = stage == ShaderStage::Miss || stage == ShaderStage::ClosestHit || stage == ShaderStage::AnyHit;
  std::string text = header(in) + (shared ? "" : variantText(in)) + factText(in) + frameText(in);
  if (!shared) text += resourceText(in, stage);
  if (stage == ShaderStage::Compute)
    text += fmt::format("layout(local_size_x = {0}, local_size_y = {0}) in;\n", kGroupSize);
  return text;
}

// A software device gives each thread a run of consecutive work groups, and expensive pixels are often neighbours. So
// the rows of groups (in a list: the groups) are shuffled like cards, three times: each eighth of the dispatch then has
// every eighth row. Eight invocations run together. If the pass traces rays or runs in the moving rectangle, they are
// 4x2 pixels, because such pixels need the same work more often than eight pixels of a row.
static const char* kDealt = R"(uint dealt_(uint which, uint count) {
  uint half_ = (count + 1u) / 2u;
  for (int i = 0; i < 3; ++i) which = which < half_ ? 2u * which : 2u * (which - half_) + 1u;
  return which;
}
)";
// Pixel of an invocation, from its work group.
static const char* kGroupItself = "uvec2 pixel_of_(uvec2 group) { return group; }\n";
static const char* kInRows =
    "uvec2 pixel_of_(uvec2 group) { return group * gl_WorkGroupSize.xy + gl_LocalInvocationID.xy; }\n";
static const char* kInBlocks = R"(uvec2 pixel_of_(uvec2 group) {
  uint i = gl_LocalInvocationIndex, block = i / 8u;
  return group * gl_WorkGroupSize.xy + uvec2(i & 3u, (i >> 2) & 1u) + uvec2(block & 1u, block >> 1) * uvec2(4, 2);
}
)";

// Index of the buffer entry that an invocation runs for.
static const char* kGroup = "gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x";
static const char* kGroups = "gl_NumWorkGroups.x * gl_NumWorkGroups.y";
static const char* kIndexOfLaunch = "gl_LaunchIDEXT.y * gl_LaunchSizeEXT.x + gl_LaunchIDEXT.x";

std::string epilogue(const Interface& in, ShaderStage stage) {
  if (stage != ShaderStage::Compute && stage != ShaderStage::RayGeneration) return "";
  const bool compute = stage == ShaderStage::Compute;
  const bool dealt = compute && in.deal_rows;
  std::string pixel = compute ? "gl_GlobalInvocationID.xy" : "gl_LaunchIDEXT.xy";
  if (in.group) pixel = "gl_WorkGroupID.xy";
  if (dealt) pixel = "pixel_of_(uvec2(gl_WorkGroupID.x, dealt_(gl_WorkGroupID.y, gl_NumWorkGroups.y)))";
  const Interface::Read* over = in.over();
  if (over) pixel = "0";
  const bool in_blocks = in.backend != Backend::None || in.in_moving_rect;
  const char* pixel_of = in.group ? kGroupItself : in_blocks ? kInBlocks : kInRows;
  std::string text = dealt ? std::string(over ? "" : pixel_of) + kDealt : "";
  text += fmt::format("void main() {{\n  ivec2 pixel_ = ivec2({});\n", pixel);
  if (over) {
    std::string group = dealt ? fmt::format("dealt_({}, {})", kGroup, kGroups) : fmt::format("({})", kGroup);
    std::string index = group + " * (gl_WorkGroupSize.x * gl_WorkGroupSize.y) + gl_LocalInvocationIndex";
    if (!compute) index = kIndexOfLaunch;
    text += fmt::format(
        "  uint index_ = {0};\n  if (index_ >= min({1}_buf.count, uint({1}_buf.entries.length()))) return;\n"
        "  pixel_ = ivec2({1}_buf.entries[index_] & 0xffffu, {1}_buf.entries[index_] >> 16);\n",
        index, over->name);
  }
  if (in.static_once)
    text +=
        "  if (frame.iteration > 0u) {\n    pixel_ += frame.moving_rect.xy;\n"
        "    if (any(greaterThanEqual(pixel_, frame.moving_rect.zw))) return;\n  }\n";
  // Images smaller than the frame: begin at, or before, the first texel of the moving rectangle.
  if (in.in_moving_rect)
    text +=
        "  bool whole_ = pass_size() == ivec2(frame.size);\n"
        "  pixel_ += whole_ ? frame.moving_rect.xy : frame.moving_rect.xy * (pass_size() - 1) / ivec2(frame.size);\n"
        "  if (whole_ && any(greaterThanEqual(pixel_, frame.moving_rect.zw))) return;\n";
  text += "  if (any(greaterThanEqual(pixel_, pass_size()))) return;\n  run(pixel_);\n";
  if (in.backend != Backend::None) {
    text += "#ifdef STROBE_TRACE_GLSL\n";
    text += fmt::format("  count_rays_{}(launched_rays);\n#endif\n", backendName(in.backend));
  }
  return text + "}\n";
}

// True if `text` is == or !=, with or without spaces around it.
static bool isComparison(std::string_view text) {
  size_t first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  if (first == std::string_view::npos) return false;
  text = text.substr(first, last - first + 1);
  return text == "==" || text == "!=";
}

// All names in the code. Members are also listed as "params.x"; names that are compared with a parameter also as
// "PARAM_x==name".
static std::unordered_set<std::string> namesIn(const std::string& code) {
  auto in_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  std::unordered_set<std::string> names;
  std::string last;
  size_t last_end = 0;
  bool after_dot = false;
  for (size_t at = 0; at < code.size();) {
    size_t end = at;
    while (end < code.size() && in_name(code[end])) ++end;
    if (end > at) {
      std::string name = code.substr(at, end - at);
      names.insert(after_dot ? last + "." + name : name);
      std::string_view between = std::string_view(code).substr(last_end, at - last_end);
      if (last.starts_with("PARAM_") && isComparison(between)) names.insert(last + "==" + name);
      last = name, last_end = end;
      after_dot = false;
      at = end;
    } else if (char c = code[at++]; !std::isspace(static_cast<unsigned char>(c))) {
      after_dot = c == '.';
    }
  }
  return names;
}

// Parses the text, because the compiler's reflection covers one choice of the variants at a time and no macros.
std::unordered_set<std::string> namesUsed(const Home& home, const std::vector<Path>& shader_files, Sources* sources) {
  std::string code;
  for (const Path& file : shader_files)
    code += withoutComments(textWithIncludes(home, file, nullptr, sources), Language::glsl);
  return namesIn(code);
}

// Names in GLSL.
static std::string spelled(const Interface::Read& read) { return read.name + (read.buffer ? "_buf" : "_tex"); }
static std::string spelled(const Interface& in, const Interface::Write& write) {
  return write.name + (write.buffer ? "_buf" : in.raster ? "_out" : "_img");
}

// Comparisons of a parameter with a name that is not one of its choices. The preprocessor would replace such a name by
// 0 without a message.
static std::vector<std::string> unknownChoices(const Interface& in, const std::string& file,
                                               const std::unordered_set<std::string>& used) {
  std::vector<std::string> problems;
  for (const auto& variant : in.variants) {
    if (variant.choices.empty()) continue;
    std::vector<std::string> known;
    for (const std::string& choice : variant.choices) known.push_back(variant.name + "_" + choice);
    const std::string compared = "PARAM_" + variant.name + "==";
    for (const std::string& name : used) {
      if (!name.starts_with(compared)) continue;
      std::string given = name.substr(compared.size());
      bool is_known = std::find(known.begin(), known.end(), given) != known.end();
      if (is_known || given.find_first_not_of("0123456789u") == std::string::npos) continue;
      problems.push_back(fmt::format("{}: pass '{}' compares PARAM_{} with {} in {}, which is not a choice of '{}'{}",
                                     in.place, in.pass, variant.name, given, file, variant.name,
                                     didYouMean(given, known)));
    }
  }
  std::sort(problems.begin(), problems.end());
  return problems;
}

std::vector<std::string> nameProblems(const Home& home, const Interface& in, const std::vector<Path>& shader_files,
                                      const std::unordered_set<std::string>& used) {
  std::vector<std::string> problems = unknownChoices(in, home.shown(shader_files.front()), used);
  auto expect = [&](const std::string& spelled, const char* kind, const std::string& name) {
    if (used.count(spelled)) return;
    problems.push_back(fmt::format("{}: pass '{}' declares the {} '{}', but {} never uses {}", in.place, in.pass, kind,
                                   name, home.shown(shader_files.front()), spelled));
  };
  for (const auto& read : in.reads)
    if (!read.over && !used.count(read.name + "_at")) expect(spelled(read), "read", read.name);
  for (const auto& write : in.writes) expect(spelled(in, write), write.update ? "update" : "write", write.name);
  for (const auto& param : in.params) expect("params." + param.name, "parameter", param.name);
  for (const auto& variant : in.variants)
    if (!variant.decides_format) expect("PARAM_" + variant.name, "parameter", variant.name);
  for (const std::string& counter : in.counters)
    if (counter.rfind("rays_", 0) != 0) expect("count_" + counter, "counter", counter);
  return problems;
}

static std::vector<std::string> declaredNames(const Interface& in) {
  std::vector<std::string> names;
  for (const auto& read : in.reads) names.push_back(spelled(read));
  for (const auto& read : in.reads)
    if (!read.buffer) names.push_back(read.name + "_at");
  for (const auto& write : in.writes) names.push_back(spelled(in, write));
  for (const std::string& counter : in.counters) names.push_back("count_" + counter);
  for (const auto& variant : in.variants) names.push_back("PARAM_" + variant.name);
  return names;
}

// Adds similar declared names of the pass to each message about an unknown name.
static std::string withDeclarations(const Interface& in, const std::string& log) {
  static const std::regex unknown("'(\\w+)' : (undeclared identifier|no matching overloaded function found)");
  static const std::regex member("'(\\w+)' : no such field in structure 'params'");
  std::string text, last_unknown_place;
  std::istringstream lines(log);
  std::vector<std::string> params;
  for (const auto& param : in.params) params.push_back(param.name);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    std::string place = line.substr(0, line.find(": "));
    if (std::regex_search(line, match, unknown)) {
      std::string name = match[1];
      // An error about the call with the unknown name is a consequence of that name.
      if (place == last_unknown_place && match[2] != "undeclared identifier") continue;
      last_unknown_place = place;
      bool generated = name.ends_with("_tex") || name.ends_with("_img") || name.ends_with("_buf") ||
                       name.ends_with("_at") || name.ends_with("_out") || name.starts_with("count_");
      if (generated)
        line += fmt::format(": pass '{}' ({}) declares no such name{}", in.pass, in.place,
                            didYouMean(name, declaredNames(in)));
    } else if (std::regex_search(line, match, member)) {
      line += fmt::format(": pass '{}' ({}) declares no parameter '{}'{}", in.pass, in.place, match[1].str(),
                          didYouMean(match[1].str(), params));
    }
    text += (text.empty() ? "" : "\n") + line;
  }
  return text;
}

std::vector<uint32_t> compilePass(const Home& home, const Interface& in, const Path& file, ShaderStage stage,
                                  Output output, Sources* sources) {
  try {
    return compile(home, {preamble(in, stage), file, epilogue(in, stage)}, stage, output, sources);
  } catch (const Error& error) {
    throw Error(withDeclarations(in, error.what()));
  }
}

}  // namespace strobe::shader
