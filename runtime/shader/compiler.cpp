// SPDX-License-Identifier: MIT
#include "shader/compiler.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include "base/hash.h"
#include "base/kept_files.h"
#include "base/version.h"
#include "shader/sources.h"

namespace strobe::shader {

namespace {

// Texts of a shader, each once: its file first, then all files that the file and the preamble include, in branches that
// are compiled or not.
struct Texts {
  struct One {
    Path file;
    const std::string* text;
  };
  std::vector<One> all;
  std::string included;  // per include, in the order found: the index of its text
};

void addIncludes(Sources& sources, const std::string& text, const Path& file, Texts& texts);

void addText(Sources& sources, const Path& file, Texts& texts) {
  auto known = std::find_if(texts.all.begin(), texts.all.end(), [&](const auto& one) { return one.file == file; });
  texts.included += fmt::format("{},", known - texts.all.begin());
  if (known != texts.all.end()) return;
  const std::string& text = sources.read(file);
  texts.all.push_back({file, &text});
  addIncludes(sources, text, file, texts);
}

void addIncludes(Sources& sources, const std::string& text, const Path& file, Texts& texts) {
  for (size_t at = 0; (at = text.find("#include", at)) != std::string::npos; ++at) {
    size_t open = text.find_first_of("\"<\n", at);
    size_t close = open == std::string::npos ? open : text.find_first_of("\">\n", open + 1);
    if (close == std::string::npos || text[open] == '\n' || text[close] == '\n') continue;
    Path found = sources.included(text.substr(open + 1, close - open - 1), file);
    if (!found.empty()) addText(sources, found, texts);
  }
}

class Includer : public glslang::TShader::Includer {
 public:
  Includer(Sources& sources, const Texts& texts) : sources_(sources), texts_(texts.all) {}

  IncludeResult* includeLocal(const char* name, const char* includer, size_t) override { return load(name, includer); }
  IncludeResult* includeSystem(const char* name, const char* includer, size_t) override { return load(name, includer); }
  void releaseInclude(IncludeResult* result) override { delete result; }

 private:
  IncludeResult* load(const char* name, const char* includer) {
    // glslang passes the names of included files, but not the name of the first file.
    std::error_code ignored;
    bool is_file = std::filesystem::is_regular_file(includer, ignored);
    Path file = sources_.included(name, is_file ? Path(includer) : texts_.front().file);
    auto found = std::find_if(texts_.begin(), texts_.end(), [&](const auto& one) { return one.file == file; });
    if (file.empty() || found == texts_.end()) return nullptr;
    return new IncludeResult(file.string(), found->text->data(), found->text->size(), nullptr);
  }
  Sources& sources_;
  const std::vector<Texts::One>& texts_;
};

EShLanguage language(ShaderStage stage) {
  switch (stage) {
    case ShaderStage::Vertex:
      return EShLangVertex;
    case ShaderStage::Fragment:
      return EShLangFragment;
    case ShaderStage::Compute:
      return EShLangCompute;
    case ShaderStage::RayGeneration:
      return EShLangRayGen;
    case ShaderStage::Miss:
      return EShLangMiss;
    case ShaderStage::ClosestHit:
      return EShLangClosestHit;
    case ShaderStage::AnyHit:
      return EShLangAnyHit;
  }
  return EShLangCompute;
}

// Names in glslang's messages for the code before and after a shader.
constexpr const char* kBefore = "generated declarations";
constexpr const char* kBehind = "generated code";

// Message for an error in the code after a shader. Its cause is in the shader: `run` is missing, or a block is not
// closed.
std::string errorBehind(const std::string& line, const std::string& message) {
  if (message.rfind("'run'", 0) == 0) return "no function 'void run(ivec2 pixel)'";
  return fmt::format("{} (line {} of the {} after the shader)", message, line, kBehind);
}

// Message for an include that is not found. glslang's own message does not have the reason.
std::string errorOfInclude(const Home& home, const std::string& message) {
  const std::string before = "for header name: ";
  size_t at = message.find(before);
  if (!message.starts_with("'#include'") || at == std::string::npos) return message;
  std::string name = message.substr(at + before.size());
  std::vector<std::string> names;
  for (const std::string& known : home.namesBelow("shaders", ".glsl")) names.push_back(known + ".glsl");
  return fmt::format("'#include': '{}' not found beside the file or in {}{}", name, placesText(home, "shaders"),
                     didYouMean(name, names));
}

// Line of the function main in a shader without a function run, otherwise 0.
int lineOfMain(const std::string& text) {
  static const std::regex main(R"((^|\n)[ \t]*void\s+main\s*\()"), run(R"((^|\n)[ \t]*void\s+run\s*\()");
  std::smatch found;
  if (std::regex_search(text, run) || !std::regex_search(text, found, main)) return 0;
  return 1 + int(std::count(text.begin(), text.begin() + found.position() + found.length(1), '\n'));
}

// glslang's log "ERROR: file:line: 'token' : message" as lines "file:line: 'token': message", with paths as shown to
// users.
std::string readable(const Home& home, const std::string& log, const Path& file) {
  static const std::regex form("^ERROR: (.*?):(\\d+): (.*?)\\s*$");
  std::set<std::string> seen;
  std::string text;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.rfind("ERROR:", 0) != 0 || line.find("compilation errors") != std::string::npos) continue;
    std::string message;
    if (std::regex_match(line, match, form) && match[1] == kBehind) {
      message = fmt::format("{}: {}", home.shown(file), errorBehind(match[2].str(), match[3].str()));
    } else if (!match.empty()) {
      message = fmt::format("{}:{}: {}", home.shown(Path(match[1].str())), match[2].str(),
                            errorOfInclude(home, match[3].str()));
    } else {
      message = fmt::format("{}: {}", home.shown(file), line.substr(std::min<size_t>(7, line.size())));
    }
    if (!seen.insert(message).second) continue;
    text += (text.empty() ? "" : "\n") + message;
  }
  return text.empty() ? home.shown(file) + ": " + log : text;
}

void startOnce() {
  static const bool started = glslang::InitializeProcess();
  STROBE_ASSERT(started, "glslang");
}

// Settings of all compilations. They are part of the cache key.
constexpr int kDialect = 460;
constexpr auto kClient = glslang::EShTargetVulkan_1_3;
constexpr auto kTarget = glslang::EShTargetSpv_1_6;
constexpr bool kOptimizes = false;

void setRules(glslang::TShader& shader, EShLanguage stage) {
  shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, kDialect);
  shader.setEnvClient(glslang::EShClientVulkan, kClient);
  shader.setEnvTarget(glslang::EShTargetSpv, kTarget);
}

constexpr auto kRules = EShMessages(EShMsgSpvRules | EShMsgVulkanRules | EShMsgCascadingErrors | EShMsgDebugInfo);

}  // namespace

// Cache key of all inputs of a compilation: the compiler and its settings, the stage, every text, and the text of each
// include.
static std::string keyOf(const ShaderSource& source, ShaderStage stage, const Texts& texts) {
  const glslang::Version compiler = glslang::GetVersion();
  std::string key = fmt::format("SPIR-V {} {}.{}.{}{} {} ", kVersion, compiler.major, compiler.minor, compiler.patch,
                                compiler.flavor, glslang::GetSpirvGeneratorVersion());
  for (int rule : {kDialect, int(kClient), int(kTarget), int(kOptimizes), int(kRules), int(stage)})
    key += fmt::format("{} ", rule);
  key += texts.included;
  auto add = [&](const std::string& text) { key += fmt::format("\n{}\n", text.size()) + text; };
  add(source.preamble);
  add(source.epilogue);
  for (const auto& one : texts.all) add(*one.text);
  return hashText(key);
}

static std::vector<uint32_t> compileAnew(const Home& home, const ShaderSource& source, ShaderStage stage,
                                         Sources& sources, const Texts& texts, Output output) {
  startOnce();
  bool calls_run = source.epilogue.find("run(") != std::string::npos;
  if (int line = calls_run ? lineOfMain(*texts.all.front().text) : 0)
    throw Error("'main': the shader of a pass defines 'void run(ivec2 pixel)' instead; main is generated and calls it",
                {home.shown(source.file), line});
  std::string end = "\n" + source.epilogue;
  std::string name = source.file.string();
  const char* strings[] = {source.preamble.c_str(), texts.all.front().text->c_str(), end.c_str()};
  const char* names[] = {kBefore, name.c_str(), kBehind};

  glslang::TShader shader(language(stage));
  shader.setStringsWithLengthsAndNames(strings, nullptr, names, 3);
  setRules(shader, language(stage));
  Includer includer(sources, texts);
  if (!shader.parse(GetDefaultResources(), kDialect, false, kRules, includer))
    throw Error(readable(home, shader.getInfoLog(), source.file));
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(kRules)) throw Error(readable(home, program.getInfoLog(), source.file));
  std::vector<uint32_t> spirv;
  if (output == Output::None) return spirv;
  glslang::SpvOptions options;
  options.disableOptimizer = !kOptimizes;
  glslang::GlslangToSpv(*program.getIntermediate(language(stage)), spirv, &options);
  return spirv;
}

// The cache has an empty file for a shader that was only checked.
std::vector<uint32_t> compile(const Home& home, const ShaderSource& source, ShaderStage stage, Output output,
                              Sources* shared) {
  Sources own(home);
  Sources& sources = shared ? *shared : own;
  Texts texts;
  addText(sources, source.file, texts);
  addIncludes(sources, source.preamble, source.file, texts);
  const KeptFiles cache(home.cache().empty() ? Path() : home.cache() / "spirv");
  const std::string key = keyOf(source, stage, texts);
  const std::optional<std::string> kept = cache.find(key);
  std::vector<uint32_t> spirv;
  if (kept && (!kept->empty() || output == Output::None)) {
    spirv.resize(kept->size() / sizeof(uint32_t));
    std::memcpy(spirv.data(), kept->data(), spirv.size() * sizeof(uint32_t));
  } else {
    spirv = compileAnew(home, source, stage, sources, texts, output);
    cache.keep(key, {reinterpret_cast<const char*>(spirv.data()), spirv.size() * sizeof(uint32_t)});
  }
  return spirv;
}

std::vector<uint32_t> compileText(const std::string& glsl, ShaderStage stage) {
  startOnce();
  glslang::TShader shader(language(stage));
  const char* text = glsl.c_str();
  shader.setStrings(&text, 1);
  setRules(shader, language(stage));
  glslang::TProgram program;
  program.addShader(&shader);
  if (!shader.parse(GetDefaultResources(), kDialect, false, kRules)) throw Error(shader.getInfoLog());
  if (!program.link(kRules)) throw Error(program.getInfoLog());
  std::vector<uint32_t> spirv;
  glslang::GlslangToSpv(*program.getIntermediate(language(stage)), spirv);
  return spirv;
}

std::string textWithIncludes(const Home& home, const Path& file, std::vector<Path>* files, Sources* shared) {
  Sources own(home);
  Texts texts;
  addText(shared ? *shared : own, file, texts);
  std::string joined;
  if (files) files->clear();
  for (const auto& one : texts.all) {
    joined += *one.text;
    if (files) files->push_back(one.file);
  }
  return joined;
}

}  // namespace strobe::shader
