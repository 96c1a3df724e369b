// SPDX-License-Identifier: MIT
#include "shader/compiler.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "shader/start.h"

namespace strobe::shader {

namespace {

bool isFile(const Path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

// Beside the including file, then in the shaders folders of the home; empty if in neither. A file outside of the home
// (a test's) includes what lies in its own folder.
Path findInclude(const Home& home, const std::string& name, const Path& from) {
  Path folder = std::filesystem::absolute(from.parent_path()).lexically_normal();
  Path beside = (folder / name).lexically_normal();
  if (isFile(beside)) {
    if (std::optional<std::string> known = home.nameOf(beside)) return home.find(*known).value_or(Path());
    if (liesIn(beside, folder)) return beside;
  }
  Path shared = home.at(Path("shaders") / name);
  return isFile(shared) && home.nameOf(shared.lexically_normal()) ? shared.lexically_normal() : Path();
}

void addOnce(std::vector<Path>& files, const Path& file) {
  if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
}

class Includer : public glslang::TShader::Includer {
 public:
  // `files` already holds the file that is compiled.
  Includer(const Home& home, std::vector<Path>& files) : home_(home), main_(files.front()), files_(files) {}

  IncludeResult* includeLocal(const char* name, const char* includer, size_t) override { return load(name, includer); }
  IncludeResult* includeSystem(const char* name, const char* includer, size_t) override { return load(name, includer); }
  void releaseInclude(IncludeResult* result) override {
    if (!result) return;
    delete static_cast<std::string*>(result->userData);
    delete result;
  }

 private:
  IncludeResult* load(const char* name, const char* includer) {
    // glslang knows the names of included files, not that of the first.
    std::error_code ignored;
    bool included = std::filesystem::is_regular_file(includer, ignored);
    Path file = findInclude(home_, name, included ? Path(includer) : main_);
    if (file.empty()) return nullptr;
    addOnce(files_, file);
    auto* text = new std::string(home_.read(file));
    return new IncludeResult(file.string(), text->data(), text->size(), text);
  }
  const Home& home_;
  Path main_;
  std::vector<Path>& files_;
};

EShLanguage language(Stage stage) {
  switch (stage) {
    case Stage::Vertex:
      return EShLangVertex;
    case Stage::Fragment:
      return EShLangFragment;
    case Stage::Compute:
      return EShLangCompute;
    case Stage::RayGeneration:
      return EShLangRayGen;
    case Stage::Miss:
      return EShLangMiss;
    case Stage::ClosestHit:
      return EShLangClosestHit;
    case Stage::AnyHit:
      return EShLangAnyHit;
  }
  return EShLangCompute;
}

// glslang says "ERROR: file:line: 'token' : message"; users read "file:line: 'token': message", paths as they know
// them.
std::string readable(const Home& home, const std::string& log, const Path& file) {
  static const std::regex form("^ERROR: (.*?):(\\d+): (.*?)\\s*$");
  std::set<std::string> seen;
  std::string text;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (line.rfind("ERROR:", 0) != 0 || line.find("compilation errors") != std::string::npos) continue;
    std::string message;
    if (std::regex_match(line, match, form)) {
      message = fmt::format("{}:{}: {}", home.shown(Path(match[1].str())), match[2].str(), match[3].str());
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

void setRules(glslang::TShader& shader, EShLanguage stage) {
  shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 460);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
}

constexpr auto kRules = EShMessages(EShMsgSpvRules | EShMsgVulkanRules | EShMsgCascadingErrors | EShMsgDebugInfo);

}  // namespace

void startCompiler() {
  startOnce();
  for (Stage stage : {Stage::Vertex, Stage::Fragment, Stage::Compute}) {
    glslang::TShader shader(language(stage));
    const char* text = "#version 460\nvoid main() {}\n";
    shader.setStrings(&text, 1);
    setRules(shader, language(stage));
    shader.parse(GetDefaultResources(), 460, false, kRules);
  }
}

Compiled compile(const Home& home, const Source& source, Stage stage, Output output) {
  startOnce();
  Compiled result;
  result.files.push_back(source.file);
  std::string body = home.read(source.file);
  std::string end = "\n" + source.epilogue;
  std::string name = source.file.string();
  const char* strings[] = {source.preamble.c_str(), body.c_str(), end.c_str()};
  const char* names[] = {"generated declarations", name.c_str(), "generated code"};

  glslang::TShader shader(language(stage));
  shader.setStringsWithLengthsAndNames(strings, nullptr, names, 3);
  setRules(shader, language(stage));
  Includer includer(home, result.files);
  if (!shader.parse(GetDefaultResources(), 460, false, kRules, includer))
    throw Error(readable(home, shader.getInfoLog(), source.file));
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(kRules)) throw Error(readable(home, program.getInfoLog(), source.file));
  if (output == Output::None) return result;
  glslang::SpvOptions options;
  options.disableOptimizer = true;
  glslang::GlslangToSpv(*program.getIntermediate(language(stage)), result.spirv, &options);
  return result;
}

static void appendText(const Home& home, const Path& file, std::vector<Path>& files, std::string& text) {
  if (std::find(files.begin(), files.end(), file) != files.end()) return;
  files.push_back(file);
  std::string own = home.read(file);
  text += own;
  for (size_t at = 0; (at = own.find("#include", at)) != std::string::npos; ++at) {
    size_t open = own.find_first_of("\"<\n", at);
    size_t close = open == std::string::npos ? open : own.find_first_of("\">\n", open + 1);
    if (close == std::string::npos || own[open] == '\n' || own[close] == '\n') continue;
    Path found = findInclude(home, own.substr(open + 1, close - open - 1), file);
    if (!found.empty()) appendText(home, found, files, text);
  }
}

std::string textWithIncludes(const Home& home, const Path& file, std::vector<Path>* files) {
  std::vector<Path> local;
  std::vector<Path>& reached = files ? *files : local;
  reached.clear();
  std::string text;
  appendText(home, file, reached, text);
  return text;
}

}  // namespace strobe::shader
