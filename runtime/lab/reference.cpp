// SPDX-License-Identifier: MIT
#include "lab/reference.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>

#include "base/lists.h"
#include "base/utf8.h"
#include "lab/limits.h"
#include "lab/shot.h"
#include "page/table.h"
#include "plan/formats.h"
#include "plan/named.h"
#include "script/evaluate.h"

namespace strobe::lab {

namespace {

using page::Table;
using plan::ParamDesc;
using plan::PassDesc;
using plan::PipelineDesc;
using plan::PortDesc;

const char* const kNote =
    "<!-- Written by `strobe help --write docs/reference` from the declarations; edit those. -->\n\n";

// --- Markdown

std::string code(const std::string& text) { return "`" + text + "`"; }

// Markdown table without columns that are empty in every row. Empty for a table without rows.
std::string tableText(const Table& table) {
  std::string text = page::markdownOf(page::withoutEmptyColumns(table));
  return text.empty() ? "" : text + "\n";
}

// Table with one row per list entry.
template <class List, class RowOf>
std::string tableText(std::vector<page::Column> columns, const List& list, RowOf rowOf) {
  Table table{"", std::move(columns)};
  for (const auto& entry : list) table.add(rowOf(entry));
  return tableText(table);
}

// Text with an initial capital and a full stop.
std::string sentence(std::string text) {
  bool word = text.size() > 1 && std::islower(static_cast<unsigned char>(text[1]));
  if (word) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  bool ended = text.ends_with(".") || text.ends_with("!") || text.ends_with("?");
  return ended ? text : text + ".";
}

std::string section(const std::string& title, const std::string& text) {
  return text.empty() ? "" : fmt::format("## {}\n\n{}", title, text);
}

// --- Parameters

std::string rangeOf(const ParamDesc& param) {
  if (param.min && param.max)
    return fmt::format("{} to {}{}", *param.min, *param.max, param.has_auto ? ", or auto" : "");
  if (param.min) return fmt::format("at least {}", *param.min);
  if (param.max) return fmt::format("at most {}", *param.max);
  std::vector<std::string> choices;
  for (const std::string& choice : param.choices) choices.push_back(code(choice));
  return fmt::format("{}", fmt::join(choices, ", "));
}

std::string paramInGlsl(const ParamDesc& param) {
  if (!plan::isCompiledIn(param)) return code("params." + param.name);
  if (param.type != ParamDesc::Type::Choice) return code("PARAM_" + param.name);
  return code(fmt::format("PARAM_{0} == {0}_{1}", param.name, param.choices.front()));
}

std::string paramTable(const std::vector<ParamDesc>& params, bool in_glsl) {
  return tableText({"name", "type", "default", "range", "unit", "description", "in GLSL"}, params,
                   [&](const ParamDesc& param) -> page::Row {
                     return {code(param.name),
                             plan::kParamTypes[size_t(param.type)],
                             plainText(param, param.default_value),
                             rangeOf(param),
                             param.unit,
                             param.wired ? param.doc + "; set only by the pipeline" : param.doc,
                             in_glsl ? paramInGlsl(param) : ""};
                   });
}

// Choices that have a description or a page, in the order of the choices. `link` returns the page of a choice that is a
// pass, or "".
template <class Link>
std::string valueTable(const ParamDesc& param, const Link& link) {
  Table table{"", {"value", "effect and failures"}};
  for (const std::string& choice : param.choices) {
    const std::string* text = plan::valueIn(param.values, choice);
    std::string page = link(param, choice);
    std::string name = page.empty() ? code(choice) : fmt::format("[`{}`]({})", choice, page);
    bool listed = !param.values.empty() || !page.empty();
    if (listed) table.add({name, text ? *text : ""});
  }
  return tableText(table);
}

// Invariants of a blur that do not hold, by parameter and value if they depend on one.
std::string breaksText(const plan::Breaks& own, const std::vector<ParamDesc>& params) {
  Table table{"", {"with", "invariant", "reason"}};
  for (const auto& [invariant, reason] : own) table.add({"", invariant, reason});
  for (const ParamDesc& param : params)
    for (const auto& [value, breaks] : param.breaks)
      for (const auto& [invariant, reason] : breaks) table.add({code(param.name + " = " + value), invariant, reason});
  return tableText(table);
}

// Stand-ins for the writes of a pass, for frames that do not require the pass.
std::string withoutText(const PassDesc& pass) {
  Table table{"", {"without", "write", "stand-in"}};
  for (const plan::WithoutDesc& without : pass.without)
    for (const auto& [write, read] : without.writes)
      table.add({without.name == plan::kMovingRect ? "motion that reaches the pixel" : code(without.name), code(write),
                 read.empty() ? "0" : code(read)});
  return tableText(table);
}

std::string noLink(const ParamDesc&, const std::string&) { return ""; }

template <class Link>
std::string paramsText(const std::vector<ParamDesc>& params, bool in_glsl, const Link& link) {
  std::string text = paramTable(params, in_glsl);
  for (const ParamDesc& param : params) {
    std::string values = valueTable(param, link);
    if (!values.empty()) text += fmt::format("### Values of `{}`\n\n{}", param.name, values);
  }
  return text;
}

// --- Passes

std::string kindText(const PassDesc& pass) {
  if (pass.kind == PassDesc::Kind::Raster) return "A raster pass: draws the scene's triangles";
  if (pass.kind == PassDesc::Kind::Trace) return "A trace pass: sends rays from every pixel";
  return pass.scene ? "A compute pass that reads the scene" : "A compute pass";
}

std::string sizeText(const plan::SizeDesc& size) {
  if (size.kind == plan::SizeDesc::Kind::Frame) return "as large as the frame";
  if (size.kind == plan::SizeDesc::Kind::Fixed) return fmt::format("{} x {} pixels large", size.width, size.height);
  std::string divided = size.divide.empty() ? "" : fmt::format(" divided by `{}`, rounded up", size.divide);
  return fmt::format("as large as `{}`{}", size.port, divided);
}

std::string filesText(const PassDesc& pass) {
  const std::string& file = pass.place.file;
  std::string root = file.substr(0, file.size() - Home::withoutRoot(file).size());
  std::string shader = root + "shaders/" + pass.shader;
  bool raster = pass.kind == PassDesc::Kind::Raster;
  std::string files = raster ? fmt::format("`{0}.vert.glsl`, `{0}.frag.glsl`", shader) : code(shader + ".glsl");
  return fmt::format("`{}`, {}", file, files);
}

// "absent: 0" for four equal numbers.
std::string absentText(const std::vector<double>& texel) {
  const bool equal = std::all_of(texel.begin(), texel.end(), [&](double one) { return one == texel[0]; });
  return equal ? fmt::format("absent: {}", texel[0]) : fmt::format("absent: {}", fmt::join(texel, ", "));
}

std::string readsText(const PassDesc& pass) {
  Table table{"", {"name", "description", "", "in GLSL"}};
  for (const PortDesc& read : pass.reads) {
    std::vector<std::string> notes;
    if (read.uint) notes.push_back("unsigned integers");
    if (read.linear) notes.push_back("filtered");
    if (read.pointwise) notes.push_back("only at the same pixel");
    if (read.optional) notes.push_back(fmt::format("optional: `HAS_{}`", read.name));
    if (!read.absent_read.empty()) notes.push_back(fmt::format("absent: `{}`", read.absent_read));
    if (!read.absent.empty()) notes.push_back(absentText(read.absent));
    if (!read.needs.empty()) notes.push_back(fmt::format("used only with `{}`", fmt::join(read.needs, "` or `")));
    std::string texel = read.buffer ? "{}_buf.entries[i]" : read.linear ? "textureLod({}_tex, uv, 0)" : "{}_at(p)";
    table.add({code(read.name), read.doc, fmt::format("{}", fmt::join(notes, "; ")),
               code(fmt::format(fmt::runtime(texel), read.name))});
  }
  return tableText(table);
}

std::string outputInGlsl(const PassDesc& pass, const PortDesc& port, bool updated) {
  if (pass.kind == PassDesc::Kind::Raster) return code(port.name + "_out");
  if (plan::isBuffer(port.format)) return code(port.name + "_buf.entries[i]");
  std::string store = code(fmt::format("imageStore({}_img, p, v)", port.name));
  return updated ? code(fmt::format("imageLoad({}_img, p)", port.name)) + ", " + store : store;
}

std::string formatText(const PortDesc& port) {
  if (port.format_by.empty()) return code(port.format);
  std::vector<std::string> cases;
  for (const auto& [choice, format] : port.formats)
    cases.push_back(fmt::format("{} (`{} = {}`)", code(format), port.format_by, choice));
  return fmt::format("{}", fmt::join(cases, ", "));
}

std::string outputsText(const PassDesc& pass, const std::vector<PortDesc>& ports, bool updated) {
  return tableText({"name", "format", "description", "", "in GLSL"}, ports, [&](const PortDesc& port) -> page::Row {
    return {code(port.name), formatText(port), port.doc, port.history ? "kept from frame to frame" : "",
            outputInGlsl(pass, port, updated)};
  });
}

std::string countersText(const PassDesc& pass) {
  return tableText(
      {"name", "description", "if not 0", "in GLSL"}, pass.counters, [](const plan::CounterDesc& counter) -> page::Row {
        return {code(counter.name), counter.doc, counter.limit.empty() ? "" : "a warning: " + counter.limit,
                code(fmt::format("count_{}(n)", counter.name))};
      });
}

// Folder and file of a pass: "tile/largest" for passes/tile/largest.lua.
std::string memberOf(const PassDesc& pass) {
  Path file = Path(Home::withoutRoot(pass.place.file)).lexically_relative("passes").replace_extension();
  return file.generic_string();
}

std::string stemOf(const PassDesc& pass) { return Path(pass.place.file).stem().generic_string(); }

std::string familyOf(const PassDesc& pass) { return Path(memberOf(pass)).parent_path().generic_string(); }

std::string pathOf(const PassDesc& pass) { return "passes/" + memberOf(pass) + ".md"; }

std::vector<PassDesc> allPasses(const Home& home) {
  std::vector<PassDesc> passes = script::evaluateAllPasses(home);
  std::sort(passes.begin(), passes.end(), [](const auto& a, const auto& b) { return memberOf(a) < memberOf(b); });
  return passes;
}

// --- Pipelines

using Presets = std::vector<std::pair<std::string, PipelineDesc>>;

Presets presetsOf(const Home& home, const PipelineDesc& pipeline) {
  Presets presets;
  for (const plan::PresetDesc& preset : pipeline.presets)
    presets.push_back(
        {preset.name, script::evaluatePipeline(home, {pipeline.name, {{plan::kPresetSetting, preset.name}}})});
  return presets;
}

// Table of the presets and their purpose.
std::string presetList(const PipelineDesc& pipeline) {
  return tableText({"`--set preset=`", "description", ""}, pipeline.presets,
                   [](const plan::PresetDesc& preset) -> page::Row {
                     return {code(preset.name), preset.doc, preset.is_default ? "the default" : ""};
                   });
}

// Parameters that differ from the declared default in at least one preset.
std::string presetsText(const PipelineDesc& pipeline, const Presets& presets) {
  Table table{"", {"parameter", "default"}};
  for (const auto& [name, preset] : presets) table.columns.push_back(code(name));
  for (const ParamDesc& param : pipeline.params) {
    std::vector<std::string> cells = {code(param.name), plainText(param, param.default_value)};
    for (const auto& [name, preset] : presets) {
      const plan::Value* value = plan::valueOf(preset, param.name);
      cells.push_back(value ? plainText(param, *value) : "");
    }
    bool differs = std::any_of(cells.begin() + 2, cells.end(), [&](const auto& value) { return value != cells[1]; });
    if (differs) table.add({cells.begin(), cells.end()});
  }
  return presetList(pipeline) + tableText(table);
}

// Node parameters that follow no pipeline parameter. Only `--set node.param=...` changes them.
std::string ownParams(const plan::NodeDesc& node) {
  std::vector<std::string> names;
  for (const auto& [name, binding] : node.params)
    if (binding.follows.empty()) names.push_back(code(node.name + "." + name));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string nodesText(const PipelineDesc& pipeline, const std::vector<PassDesc>& passes) {
  Table table{"", {"node", "pass", "loop", "own parameters"}};
  for (const auto& node : pipeline.nodes) {
    std::string pass = code(node.pass);
    if (const PassDesc* linked = plan::find(passes, node.pass))
      pass = fmt::format("[`{}`](../{})", node.pass, pathOf(*linked));
    table.add({code(node.name), pass, node.loop.empty() ? "" : code(node.loop), ownParams(node)});
  }
  return tableText(table);
}

std::string outputsText(const PipelineDesc& pipeline) {
  return tableText({"output", "image"}, pipeline.outputs, [](const auto& output) -> page::Row {
    return {code(output.first), code(output.second)};
  });
}

// Folder of the passes that the choices name: the folder named like the parameter, otherwise a folder with a file for
// every choice, or "".
std::string familyOf(const ParamDesc& param, const std::vector<PassDesc>& passes) {
  std::map<std::string, size_t> found;
  for (const PassDesc& pass : passes)
    found[familyOf(pass)] += std::count(param.choices.begin(), param.choices.end(), stemOf(pass));
  if (found.count(param.name)) return param.name;
  for (const auto& [family, count] : found)
    if (count > 0 && count == param.choices.size()) return family;
  return "";
}

// Page of the pass that a choice stands for.
auto linkToMembers(const std::vector<PassDesc>& passes) {
  return [&passes](const ParamDesc& param, const std::string& choice) -> std::string {
    std::string member = familyOf(param, passes) + "/" + choice;
    for (const PassDesc& pass : passes)
      if (memberOf(pass) == member) return "../" + pathOf(pass);
    return "";
  };
}

std::string pathOf(const PipelineDesc& pipeline) { return "pipelines/" + pipeline.name + ".md"; }

// --- All of them

std::vector<PipelineDesc> allPipelines(const Home& home) {
  std::vector<PipelineDesc> pipelines;
  for (const std::string& name : script::pipelineNames(home))
    pipelines.push_back(script::evaluatePipeline(home, {name, {}}));
  return pipelines;
}

std::map<std::string, std::vector<const PassDesc*>> families(const std::vector<PassDesc>& passes) {
  std::map<std::string, std::vector<const PassDesc*>> result;
  for (const PassDesc& pass : passes) result[familyOf(pass)].push_back(&pass);
  return result;
}

// Markdown link to the page of a pass or pipeline.
template <class Described>
std::string linkOf(const Described& described) {
  return fmt::format("[`{}`]({})", described.name, pathOf(described));
}

std::string indexPage(const std::vector<PipelineDesc>& pipelines, const std::vector<PassDesc>& passes) {
  std::string text =
      "# Reference\n\nDeclarations of all pipelines and passes. `strobe help NAME` prints a page, "
      "`strobe help NAME.PARAM` one parameter. The limits of passes and of the program: [limits](limits.md).\n\n"
      "## Pipelines\n\n";
  text += tableText({"name", "description"}, pipelines, [](const auto& one) -> page::Row {
    return {linkOf(one), one.doc};
  });
  for (const auto& [family, members] : families(passes))
    text += fmt::format("## passes/{}\n\n{}", family,
                        tableText({"name", "description"}, members, [](const PassDesc* pass) -> page::Row {
                          return {linkOf(*pass), pass->doc};
                        }));
  return text;
}

// --- Limits

std::string limitsOfPasses(const std::vector<PassDesc>& passes) {
  Table table{"", {"pass", "count", "condition", "consequence and remedy"}};
  for (const PassDesc& pass : passes)
    for (const auto& counter : pass.counters)
      if (!counter.limit.empty())
        table.add({linkOf(pass), code(counter.name), sentence(counter.doc), sentence(counter.limit)});
  return tableText(table);
}

std::string limitsOfProgram(Limit::Kind kind) {
  Table table{"", {"name", "condition", "consequence and remedy"}};
  for (const Limit& limit : allLimits())
    if (limit.kind == kind)
      table.add({code(std::string(limit.name)), sentence(std::string(limit.met)), sentence(std::string(limit.result))});
  return tableText(table);
}

std::string limitsPage(const std::vector<PassDesc>& passes) {
  std::string text =
      "# Limits\n\nWithin these limits, no scene and no parameter gives a wrong picture without a message. If a limit "
      "is exceeded, Strobe reports it: in `warnings` of the run record and on the terminal, or with an error before "
      "anything is drawn. Ground truth has only the limits of the program. The last table has the limits that are "
      "not reported.\n\n";
  text +=
      "## Of passes\n\nCounted per pixel (or as said) while the picture is made. Declared in the pass, beside its "
      "counters.\n\n" +
      limitsOfPasses(passes);
  text +=
      "## Of the program\n\nDeclared in `limits.h` of `runtime/gpu`, `runtime/scene`, `runtime/world` and "
      "`runtime/lab`.\n\n";
  text += "### With a warning\n\n" + limitsOfProgram(Limit::Kind::Warned);
  text += "### Refused: nothing is drawn\n\n" + limitsOfProgram(Limit::Kind::Refused);
  text += "### Not reported, since nearly every picture meets them or they cannot be detected\n\n" +
          limitsOfProgram(Limit::Kind::Known);
  text.pop_back();
  return text;
}

// --- Topics

// Finds a pass by its name, by folder and file, or by file name alone if it is unique; null if not found.
const PassDesc* findPass(const std::vector<PassDesc>& passes, const std::string& name) {
  std::vector<const PassDesc*> alike;
  for (const PassDesc& pass : passes) {
    if (pass.name == name || memberOf(pass) == name) return &pass;
    if (stemOf(pass) == name) alike.push_back(&pass);
  }
  return alike.size() == 1 ? alike.front() : nullptr;
}

[[noreturn]] void refuse(const std::string& topic, const std::vector<std::string>& known) {
  std::string hint = didYouMean(topic, known);
  if (hint.empty()) hint = "; strobe help lists the topics";
  throw Error(fmt::format("unknown help topic '{}'{}", topic, hint), {}, 2);
}

std::string helpOnParam(const std::string& topic, const std::string& owner, const std::vector<ParamDesc>& params,
                        bool in_glsl) {
  std::vector<std::string> known;
  for (const ParamDesc& param : params) known.push_back(owner + "." + param.name);
  const ParamDesc* param = plan::find(params, topic.substr(owner.size() + 1));
  if (!param) refuse(topic, known);
  return fmt::format("# {}\n\n{}", topic, paramsText({*param}, in_glsl, noLink));
}

std::string listed(const std::string& title, const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string text = title + "\n";
  for (const auto& [name, doc] : entries) text += "  " + paddedRight(name, 26) + " " + doc + "\n";
  return text;
}

// --- JSON

Json jsonOf(const ParamDesc& param) {
  Json json = {{"name", param.name}, {"type", plan::kParamTypes[size_t(param.type)]}};
  json["default"] = param.has_auto && param.default_value == plan::Value(plan::kAuto)
                        ? Json("auto")
                        : plan::toJson(param.default_value);
  if (param.min) json["min"] = *param.min;
  if (param.max) json["max"] = *param.max;
  if (!param.choices.empty()) json["choices"] = param.choices;
  json["unit"] = param.unit;
  json["doc"] = param.doc;
  return json;
}

Json jsonOf(const PortDesc& port) { return {{"name", port.name}, {"format", port.format}, {"doc", port.doc}}; }

Json jsonOf(const PassDesc& pass);
Json jsonOf(const PipelineDesc& pipeline);

template <class List>
Json listOf(const List& list) {
  Json json = Json::array();
  for (const auto& entry : list) json.push_back(jsonOf(entry));
  return json;
}

Json jsonOf(const PassDesc& pass) {
  return {{"name", memberOf(pass)},
          {"doc", pass.doc},
          {"fails", pass.fails},
          {"kind", plan::kPassKinds[size_t(pass.kind)]},
          {"reads", listOf(pass.reads)},
          {"writes", listOf(pass.writes)},
          {"updates", listOf(pass.updates)},
          {"params", listOf(pass.params)}};
}

Json jsonOf(const PipelineDesc& pipeline) {
  Json presets = Json::array();
  for (const auto& preset : pipeline.presets)
    presets.push_back({{"name", preset.name}, {"default", preset.is_default}, {"doc", preset.doc}});
  return {{"name", pipeline.name},
          {"doc", pipeline.doc},
          {"file", pipeline.file},
          {"presets", presets},
          {"params", listOf(pipeline.params)}};
}

}  // namespace

// Page of a pass: description, failures, inputs, outputs, parameters, names in GLSL.
static std::string passPage(const PassDesc& pass) {
  std::string text = fmt::format("# {}\n\n{}\n\n", pass.name, sentence(pass.doc));
  text +=
      fmt::format("{}; its outputs are {}.\n\nFiles: {}.\n\n", kindText(pass), sizeText(pass.size), filesText(pass));
  text += section("Failures", pass.fails.empty() ? "" : sentence(pass.fails) + "\n\n");
  text += section("Reads", readsText(pass));
  text += section("Writes", outputsText(pass, pass.writes, false));
  text += section("Updates", outputsText(pass, pass.updates, true));
  text += section("Parameters", paramsText(pass.params, true, noLink));
  text += section("Counters", countersText(pass));
  text += section("Not required", withoutText(pass));
  text += section("Broken invariants", breaksText(pass.breaks, pass.params));
  text.pop_back();
  return text;
}

// `presets`: the pipeline evaluated with each of its presets, by name. `passes`: all passes.
static std::string pipelinePage(const PipelineDesc& pipeline, const Presets& presets,
                                const std::vector<PassDesc>& passes) {
  std::string text = fmt::format("# {}\n\n{}\n\nFile: `{}`.\n\n", pipeline.name, sentence(pipeline.doc), pipeline.file);
  text += section("Presets", presetsText(pipeline, presets));
  text += section("Parameters", paramsText(pipeline.params, false, linkToMembers(passes)));
  text += section("Broken invariants", breaksText(pipeline.breaks, pipeline.params));
  text += section("Nodes with default parameters", nodesText(pipeline, passes));
  text += section("Outputs with default parameters", outputsText(pipeline));
  text.pop_back();
  return text;
}

std::vector<ReferencePage> referencePages(const Home& home) {
  std::vector<PassDesc> passes = allPasses(home);
  std::vector<PipelineDesc> pipelines = allPipelines(home);
  std::vector<ReferencePage> pages = {{"README.md", kNote + indexPage(pipelines, passes)}};
  pages.front().text.pop_back();
  pages.push_back({"limits.md", kNote + limitsPage(passes)});
  for (const PassDesc& pass : passes) pages.push_back({pathOf(pass), kNote + passPage(pass)});
  for (const PipelineDesc& one : pipelines)
    pages.push_back({pathOf(one), kNote + pipelinePage(one, presetsOf(home, one), passes)});
  return pages;
}

void writeReference(const Home& home, const Path& folder) {
  std::vector<ReferencePage> pages = referencePages(home);
  std::set<std::string> current;
  for (const ReferencePage& page : pages) {
    writeFileAtomically(folder / page.path, page.text);
    current.insert(page.path);
  }
  std::vector<Path> gone;
  for (const char* part : {"passes", "pipelines"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / part)) {
      bool known = current.count(entry.path().lexically_relative(folder).generic_string()) > 0;
      bool ours = entry.is_regular_file() && readText(entry.path()).starts_with(kNote);
      if (ours && !known) gone.push_back(entry.path());
    }
  for (const Path& file : gone) std::filesystem::remove(file);
}

std::string helpTopics(const Home& home) {
  std::vector<PassDesc> passes = allPasses(home);
  auto marked = [&home](const std::string& file, const std::string& doc) {
    bool own = home.hasProject() && Home::withoutRoot(file) == file;
    return (own ? "[project] " : "") + doc;
  };
  std::vector<std::pair<std::string, std::string>> entries;
  for (const PipelineDesc& one : allPipelines(home)) entries.push_back({one.name, marked(one.file, one.doc)});
  std::string text =
      "strobe help NAME prints the page of a pipeline or pass, NAME.PARAM one of its parameters, PARAM the parameter "
      "with this name in all pipelines.\n\n";
  if (home.hasProject())
    text +=
        fmt::format("[project] marks the files in {}; the other files ship with Strobe.\n\n", home.project().string());
  text += listed("pipelines", entries);
  for (const auto& [family, members] : families(passes)) {
    entries.clear();
    for (const PassDesc* pass : members) entries.push_back({pass->name, marked(pass->place.file, pass->doc)});
    text += "\n" + listed("passes/" + family, entries);
  }
  return text + "\nOptions of commands: strobe COMMAND --help\n";
}

// Help on a parameter name alone, such as `edge`, in each pipeline that has it; empty without such a pipeline.
static std::string helpOnParamOfPipelines(const Home& home, const std::string& name) {
  std::string text;
  for (const PipelineDesc& pipeline : allPipelines(home))
    if (plan::find(pipeline.params, name))
      text +=
          (text.empty() ? "" : "\n") + helpOnParam(pipeline.name + "." + name, pipeline.name, pipeline.params, false);
  return text;
}

std::string helpOn(const Home& home, const std::string& topic) {
  std::string owner = topic.substr(0, topic.find('.'));
  bool of_param = owner.size() < topic.size();
  std::vector<std::string> known = script::pipelineNames(home);
  std::vector<PassDesc> passes = allPasses(home);
  if (contains(known, owner)) {
    PipelineDesc pipeline = script::evaluatePipeline(home, {owner, {}});
    if (of_param) return helpOnParam(topic, owner, pipeline.params, false);
    return pipelinePage(pipeline, presetsOf(home, pipeline), passes);
  }
  const PassDesc* pass = findPass(passes, owner);
  if (pass) return of_param ? helpOnParam(topic, owner, pass->params, true) : passPage(*pass);
  std::string anywhere = of_param ? "" : helpOnParamOfPipelines(home, topic);
  if (!anywhere.empty()) return anywhere;
  for (const PassDesc& one : passes) known.insert(known.end(), {one.name, memberOf(one), stemOf(one)});
  refuse(owner, known);
}

Json helpJson(const Home& home, const std::string& topic) {
  std::vector<PassDesc> passes = allPasses(home);
  if (topic.empty()) return {{"pipelines", listOf(allPipelines(home))}, {"passes", listOf(passes)}};
  std::vector<std::string> known = script::pipelineNames(home);
  if (contains(known, topic)) return jsonOf(script::evaluatePipeline(home, {topic, {}}));
  if (const PassDesc* pass = findPass(passes, topic)) return jsonOf(*pass);
  for (const PassDesc& one : passes) known.insert(known.end(), {memberOf(one), stemOf(one)});
  refuse(topic, known);
}

}  // namespace strobe::lab
