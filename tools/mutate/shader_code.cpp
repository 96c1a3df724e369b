// SPDX-License-Identifier: MIT
#include "mutate/shader_code.h"

#include "base/hash.h"
#include "script/evaluate.h"
#include "shared/scene.h"

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

// A compile-time decision: a parameter's value, or a read wired or not.
struct Decision {
  bool read = false;
  size_t index = 0;
  std::vector<plan::Value> values;  // default first
};

static std::vector<Decision> decisionsOf(const plan::PassDesc& pass) {
  std::vector<Decision> decisions;
  for (size_t i = 0; i < pass.params.size(); ++i) {
    const plan::ParamDesc& param = pass.params[i];
    if (!isCompiledIn(param)) continue;
    Decision decision{false, i, {param.default_value}};
    for (const std::string& choice : param.choices) decision.values.push_back(choice);
    if (param.type == plan::ParamDesc::Type::Bool) decision.values.push_back(!std::get<bool>(param.default_value));
    for (auto bound : {param.min, param.max})
      if (param.type == plan::ParamDesc::Type::Int && bound) decision.values.push_back(int64_t(*bound));
    decisions.push_back(decision);
  }
  for (size_t i = 0; i < pass.reads.size(); ++i)
    if (pass.reads[i].optional) decisions.push_back({true, i, {true, false}});
  return decisions;
}

// Interfaces of a pass for pairwise tests, without a plan: for each pair of compile-time decisions (choices, switches,
// optional reads) all combinations of their values. The other decisions have their declared values.
static std::vector<shader::Interface> interfacesOf(const plan::PassDesc& pass, graph::Backend backend) {
  std::vector<Decision> decisions = decisionsOf(pass);
  decisions.push_back({true, pass.reads.size(), {true}});  // so that a single decision forms a pair
  decisions.push_back({true, pass.reads.size(), {true}});
  std::vector<shader::Interface> interfaces;
  std::set<std::string> seen;
  auto add = [&](const std::vector<bool>& wired, const graph::ParamValues& values) {
    shader::Interface in = graph::interfaceOf(pass, backend, wired, values);
    in.slices = SLICE_SAMPLE + 1;
    in.time_slice = SLICE_SHUTTER_CLOSE;  // the slice of one name only
    if (seen.insert(graph::textOf(in)).second) interfaces.push_back(in);
  };
  for (size_t a = 0; a < decisions.size(); ++a)
    for (size_t b = 0; b < a; ++b)
      for (const plan::Value& value_a : decisions[a].values)
        for (const plan::Value& value_b : decisions[b].values) {
          std::vector<bool> wired(pass.reads.size() + 1, true);
          graph::ParamValues values;
          for (const plan::ParamDesc& param : pass.params) values.push_back({param.name, param.default_value});
          for (const auto& [decision, value] : {std::pair(decisions[a], value_a), std::pair(decisions[b], value_b)}) {
            if (decision.read) wired[decision.index] = std::get<bool>(value);
            else values[decision.index].second = value;
          }
          add(wired, values);
        }
  return interfaces;
}

ShaderCode::ShaderCode(const Home& home)
    : home_(home), copy_(home.shipped()), passes_(script::evaluateAllPasses(home)) {
  for (const plan::PassDesc& pass : passes_) {
    files_[&pass] = filesOf(home, pass);
    bool traces = pass.kind == plan::PassDesc::Kind::Trace;
    for (graph::Backend backend : {graph::Backend::Query, graph::Backend::Pipeline}) {
      if (backend == graph::Backend::Pipeline && !traces) continue;
      for (const shader::Interface& interface : interfacesOf(pass, backend)) units_.push_back({&pass, interface, {}});
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
    std::string hashes;
    for (const gpu::Spirv& stage : graph::compileStages(home, interface, pass)) hashes += graph::hashOfCode(stage);
    return hashText(hashes);
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
