// SPDX-License-Identifier: MIT
#include "mutate/shader_code.h"

#include "script/evaluate.h"

namespace strobe::mutate {

static std::set<std::string> filesOf(const Home& home, const plan::PassDesc& pass) {
  const Path shaders = home.shipped() / "shaders";
  std::vector<Path> roots = graph::shaderFiles(home, pass);
  if (pass.kind == plan::PassDesc::Kind::Trace)
    for (const std::string& name : namesIn(shaders / "backend", ".glsl"))
      roots.push_back(shaders / "backend" / (name + ".glsl"));
  std::set<std::string> names;
  for (const Path& root : roots) {
    std::vector<Path> reached;
    shader::textWithIncludes(home, root, &reached);
    for (const Path& file : reached) names.insert(file.lexically_relative(shaders));
  }
  return names;
}

ShaderCode::ShaderCode(const Home& home)
    : home_(home), copy_(home.shipped()), passes_(script::evaluateAllPasses(home)) {
  for (const plan::PassDesc& pass : passes_) {
    files_[&pass] = filesOf(home, pass);
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

// Hash of the compiled code; "" if the pass does not compile.
static std::string hashIn(const Home& home, const shader::Interface& interface, const plan::PassDesc& pass) {
  try {
    return graph::compileAlone(home, interface, pass).hash;
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
    std::string hash = hashIn(Home(copy_.folder()), unit.interface, *unit.pass);
    if (hash == original(unit)) continue;
    change = hash.empty() ? CodeChange::Refused : CodeChange::Different;
    break;
  }
  writeFileAtomically(file, text);
  return change;
}

}  // namespace strobe::mutate
