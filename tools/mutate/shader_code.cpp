// SPDX-License-Identifier: MIT
#include "mutate/shader_code.h"

#include <cstdlib>

#include "script/evaluate.h"

namespace strobe::mutate {

HomeOverride::HomeOverride(const Path& folder) {
  if (const char* before = std::getenv("STROBE_HOME")) before_ = before;
  ::setenv("STROBE_HOME", folder.c_str(), 1);
}

HomeOverride::~HomeOverride() {
  if (before_) ::setenv("STROBE_HOME", before_->c_str(), 1);
  else ::unsetenv("STROBE_HOME");
}

static std::set<std::string> filesOf(const plan::PassDesc& pass) {
  const Path shaders = homeFolder() / "shaders";
  std::vector<Path> roots = graph::shaderFiles(pass);
  if (pass.kind == plan::PassDesc::Kind::Trace)
    for (const std::string& name : namesIn(shaders / "backend", ".glsl"))
      roots.push_back(shaders / "backend" / (name + ".glsl"));
  std::set<std::string> names;
  for (const Path& root : roots) {
    std::vector<Path> reached;
    shader::textWithIncludes(root, &reached);
    for (const Path& file : reached) names.insert(file.lexically_relative(shaders));
  }
  return names;
}

ShaderCode::ShaderCode() : home_(homeFolder()), passes_(script::evaluateAllPasses()) {
  for (const plan::PassDesc& pass : passes_) {
    files_[&pass] = filesOf(pass);
    bool traces = pass.kind == plan::PassDesc::Kind::Trace;
    for (graph::Backend backend : {graph::Backend::Query, graph::Backend::Pipeline}) {
      if (backend == graph::Backend::Pipeline && !traces) continue;
      for (const shader::Interface& interface : graph::interfacesOf(pass, backend))
        units_.push_back({&pass, interface, {}});
    }
  }
}

std::vector<std::string> ShaderCode::files() const {
  std::set<std::string> all;
  for (const auto& [pass, files] : files_) all.insert(files.begin(), files.end());
  return {all.begin(), all.end()};
}

// "" where it does not compile.
static std::string hashIn(const Path& home, const shader::Interface& interface, const plan::PassDesc& pass) {
  HomeOverride here(home);
  try {
    return graph::compileAlone(interface, pass).hash;
  } catch (const Error&) {
    return "";
  }
}

std::string ShaderCode::original(Unit& unit) const {
  if (!unit.hash) unit.hash = hashIn(home_, unit.interface, *unit.pass);
  return *unit.hash;
}

CodeChange ShaderCode::changeBy(const Mutant& mutant) {
  const Path file = copy_.folder() / "shaders" / mutant.file;
  const std::string text = readText(file);
  writeFileAtomically(file, mutated(text, mutant));
  CodeChange change = CodeChange::Same;
  for (Unit& unit : units_) {
    if (!files_.at(unit.pass).count(mutant.file) || original(unit).empty()) continue;
    std::string hash = hashIn(copy_.folder(), unit.interface, *unit.pass);
    if (hash == original(unit)) continue;
    change = hash.empty() ? CodeChange::Refused : CodeChange::Different;
    break;
  }
  writeFileAtomically(file, text);
  return change;
}

}  // namespace strobe::mutate
