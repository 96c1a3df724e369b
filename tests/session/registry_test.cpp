// SPDX-License-Identifier: MIT
// Tries every parameter of every shipped pipeline and of its passes: each must change some picture, and each of the
// four ways of setting values must mean the same. A new parameter is covered without a new test; a parameter that takes
// effect only together with others needs a line in `kContexts`. The tests catch a parameter that a script or shader no
// longer reads, and a setting that one of the four ways loses or reads as another type.
//
// The short form tries a pass's parameter in one of the pipelines with the pass, and compares plans instead of
// pictures.
#include <random>

#include "common/all_cases.h"
#include "common/source.h"
#include "lab/record.h"
#include "plan/canonical.h"
#include "session/home.h"
#include "study/experiment.h"

namespace strobe::session {
namespace registry_test {

using lab::Session;
using lab::Shot;
using Settings = std::vector<std::string>;  // "name=value"

// Settings for a test of all parameters that no earlier context had; the parameters in `again` are tried once more.
// "scene", "frame" and "anchor" belong to the shot; "pan" turns its camera, in degrees per frame; "slide" moves the
// camera sideways so far that a mask makes every pixel a candidate.
struct Context {
  Settings settings;
  std::vector<std::string> again;
};

// Contexts for gathers: parameters that take effect only in another frame, or if the velocity changes at the raster
// time.
const Context kJitter = {{"jitter=hash", "frame=1"}, {"jitter_frame"}};
const Context kBent = {{"scene=bent", "anchor=centre"}, {"displacement", "trajectory"}};

const std::map<std::string, std::vector<Context>> kContexts = {
    {"none", {{{}, {}}}},
    {"mcguire2012",
     {{{}, {}},
      kJitter,
      kBent,
      {{"scene=bent", "weights=uniform", "anchor=centre"}, {"range"}},
      {{"weights=uniform"}, {}}}},
    {"guertin2014",
     {{{}, {}},
      kJitter,
      kBent,
      {{"tile=8"}, {"tile_rule", "second_share", "tile_jitter", "tile/direction_variance.rule"}},
      {{"jitter=hash"}, {"eta"}},
      {{"tile=8", "pan=20", "limit=1"}, {"uniform_path"}},
      {{"anchor=centre"}, {"uniform_ratio", "uniform_speed"}}}},
    {"jimenez2014",
     {{{}, {}},
      kJitter,
      kBent,
      {{"tile=8"}, {"tile_rule"}},
      {{"anchor=centre"}, {"mirror"}},
      {{"tile=8", "pan=10", "limit=1"}, {"cheap_ratio"}},
      {{"tile=8", "pan=10", "limit=1", "gather.cheap_ratio=0.5"}, {"cheap"}}}},
    {"bevy", {{{}, {}}, kJitter, kBent}},
    {"eevee",
     {{{}, {}},
      {{"steps=2", "jitter=hash", "frame=1"}, {"jitter_frame", "gather/guertin2014.eta"}},
      {{"steps=2", "scene=bent", "anchor=centre"}, {"displacement"}},
      {{"steps=1", "tile=8"}, {"tile_rule", "gather/guertin2014.tile_jitter"}}}},
    {"hdrp",
     {{{}, {}},
      kJitter,
      kBent,
      {{"anchor=centre"}, {"mirror"}},
      {{"tile=8", "pan=10", "limit=1"}, {"cheap_ratio"}},
      {{"tile=8", "pan=10", "limit=1", "cheap_ratio=0.5"}, {"cheap"}}}},
    {"lee2024",
     {{{}, {}},
      kJitter,
      kBent,
      {{"tile=8"}, {"tile_rule"}},
      {{"scene=solids", "slide=5", "limit=10", "layer_count=2"}, {"sides"}}}},
    {"adaptive",
     {{{"quality=0"}, {}},
      {{"quality=0", "jitter=hash", "frame=1"}, {"jitter_frame"}},
      {{"quality=0", "scene=bent", "anchor=centre"}, {"displacement"}},
      {{"quality=0", "anchor=centre"}, {"gather/jimenez2014.mirror"}},
      {{"quality=0", "tile=8"}, {"tile_rule"}},
      {{}, {"preset"}},
      {{"quality=0.1", "scene=solids"},
       {"time/adaptive_times.pace", "time/adaptive_times.allowance", "time/adaptive_times.hit_color",
        "time/adaptive_times.same_depth", "time/adaptive_times.cell_side", "time/coherent_cells.apart_px",
        "time/coherent_cells.validation_rays"}},
      {{"quality=0.8", "samples=4"}, {}}}},
    {"accumulation", {{{"scene=solids"}, {}}, {{"scene=solids", "samples=64"}, {"contrast", "detail_below"}}}},
    {"oberberger2022", {{{}, {}}, {{"frame=1"}, {"jitter_frame"}}, kBent, {{"tile=8"}, {"tile_rule"}}}},
    {"ue4", {{{}, {}}, kJitter, kBent, {{"tile=8"}, {"tile_rule"}}, {{"anchor=centre"}, {"mirror"}}}},
    {"ue5",
     {{{}, {}},
      {{"jitter=hash", "frame=1"}, {"jitter_frame"}},
      kBent,
      {{"tile=8"}, {"tile_rule"}},
      {{"anchor=centre"}, {"mirror"}},
      {{"tile=8", "pan=10", "limit=1"}, {"heavy_motion", "half_resolution", "filter/jimenez2014_listed.cheap_ratio"}},
      {{"tile=8", "pan=10", "limit=1", "gather.cheap_ratio=0.5"}, {"cheap"}}}},
    {"hybrid",
     {{{},
       {"edge", "own_edge", "mask_taps", "weights", "termination", "tolerance", "luminance_of", "advance", "max_layers",
        "on_cap", "depth_extent", "directions"}},
      kJitter,
      {{"preset=text"}, {}},
      {{"scene=solids", "slide=30", "limit=10"},
       {"edge/sobel.normal_threshold", "edge/sobel.combine", "edge/sobel.norm", "own_edge"}},
      {{"edge=canny", "scene=solids", "slide=30", "limit=10", "edge_gradient.depth_threshold=1",
        "edge_gradient.normal_threshold=1"},
       {}},
      {{"edge=plane", "scene=solids", "slide=30", "limit=10"}, {}},
      {{"edge=laplacian", "scene=solids", "slide=30", "limit=10"}, {}},
      {{"edge=prewitt", "scene=solids", "slide=30", "limit=10"}, {}},
      {{"edge=scharr", "scene=solids", "slide=30", "limit=10"}, {}},
      {{"edge=roberts", "scene=solids", "slide=30", "limit=10"}, {}},
      {{"edge=silhouette", "scene=solids", "slide=30", "limit=10"}, {}},
      {{"edge=id"}, {}},
      {{"scene=solids", "slide=30", "limit=10", "advance=origin_kept"}, {"advance", "max_layers"}},
      {{"scene=solids", "slide=30", "limit=10", "advance=origin_kept", "termination=motion"}, {"same_motion"}},
      {{"scene=solids", "slide=30", "limit=10", "advance=origin_kept", "max_layers=1", "tolerance=0.5"}, {"on_cap"}},
      {{"weights=mcguire2012"}, {"directions"}},
      {{"weights=guertin2014", "jitter=hash"}, {}},
      {{"weights=jimenez2014", "anchor=centre"}, {}},
      {{"tile=8"}, {"tile_rule"}}}},
    {"hybrid_layered",
     {{{}, {"layered/layered_composite.search_taps"}},
      kJitter,
      kBent,
      {{"scene=bent", "anchor=centre"}, {"range"}},
      {{"scene=solids", "termination=luminance", "advance=origin_kept"},
       {"tolerance", "max_layers", "advance", "luminance_of"}},
      {{"scene=solids", "termination=motion", "advance=origin_kept"}, {"same_motion"}},
      {{"scene=solids", "termination=luminance", "advance=origin_kept", "max_layers=1", "tolerance=0.5"}, {"on_cap"}},
      {{"tile=8"}, {"tile_rule"}}}},
    {"ground_truth",
     {{{"samples=8"}, {}},
      {{"samples=8", "times=stratified"}, {"slices"}},
      {{"samples=4", "mode=raster"}, {}},
      {{"samples=32", "pixel=box"}, {"validation_share", "first_samples", "even_within"}},
      {{"samples=256", "tolerance=0.1"}, {"tolerance"}}}},
};

// Parameters that change the way a picture is computed, but never the picture, with the reason.
const std::map<std::string, std::string> kNoPicture = {
    {"gbuffer/shade.shading", "at the raster time both kinds of shading are the same; truth shades at other times"},
    {"adaptive: gather/jimenez2014.cheap_ratio", "this pipeline never takes the cheap path"},
    {"ue4: gather/jimenez2014.cheap_ratio", "this pipeline never takes the cheap path"},
    {"hybrid: gather/jimenez2014.cheap_ratio", "this pipeline never takes the cheap path"},
    {"layered/cull_candidates.margin", "number of candidates that are tested without effect"},
    {"accumulation/accumulate_moving.skip_static", "skipped pixels add nothing"},
    {"truth/sample.static_once_per_loop", "static pixels are the same with any number of samples"},
    {"truth/half_difference.block", "group size of the sum of differences"},
    {"time/coherent_cells.validation_rays", "choice of the validated cells; cells without a mismatch do not change"},
    {"adaptive: truth/sample_consensus.even_within", "only pixel centres are sampled, whose rays are equal"},
    {"adaptive: truth/sample.validation_share", "choice of the validated pixels"},
    {"truth/stop.min_samples", "keeps truth from stopping on few samples; the tolerance decides after that"},
};

Shot shotIn(const std::string& pipeline, const Settings& context) {
  Shot shot;
  shot.pipeline = pipeline;
  shot.scene = (sourceFolder() / "tests/oracle/scenes/crowd.lua").string();
  shot.width = 64;
  shot.height = 40;
  shot.frame = 0;
  shot.backend = "bvh";  // light visibility of tiles needs the runtime's own tree
  for (const std::string& setting : context) {
    size_t equals = setting.find('=');
    std::string name = setting.substr(0, equals), value = setting.substr(equals + 1);
    if (name == "scene") shot.scene = (sourceFolder() / "tests/oracle/scenes" / (value + ".lua")).string();
    else if (name == "frame") shot.frame = std::stoi(value);
    else if (name == "anchor") shot.anchor = value;
    else if (name == "slide") shot.moves = {"camera=" + value + ",0,0"};
    else if (name == "pan") shot.spins = {"camera=0,1,0," + value};
    else shot.sets.push_back({name, value});
  }
  if (shot.scene.ends_with("bent.lua"))
    for (const char* size : {"width=64", "height=40", "before=20", "after=4"}) {
      std::string one = size;
      shot.sets.push_back({"scene." + one.substr(0, one.find('=')), one.substr(one.find('=') + 1)});
    }
  if (shot.scene.ends_with("solids.lua") && shot.moves.empty())
    shot.moves = {"ball=0.7,0.2,0", "box=0.6,0,0.3", "wall=-0.8,0,0", "camera=0.5,0,0"};
  return shot;
}

std::string text(const plan::Value& value) {
  if (const auto* name = std::get_if<std::string>(&value)) return *name;
  return plan::toJson(value).dump();
}

// Values to try, the most likely to change a picture first; none makes a frame expensive.
std::vector<std::string> otherValues(const lab::Control& control) {
  const plan::ParamDesc& param = control.declaration;
  std::vector<std::string> values;
  using Type = plan::ParamDesc::Type;
  if (param.type == Type::Bool) values = {text(control.value) == "true" ? "false" : "true"};
  if (param.type == Type::Choice) values = param.choices;
  if (param.type == Type::Int || param.type == Type::Float) {
    double now = param.type == Type::Int ? double(std::get<int64_t>(control.value)) : std::get<double>(control.value);
    for (double wanted :
         {now * 2 + (now == 0), now / 2, *param.min, now * 8 + 1, std::min(*param.max, now * 64 + 64)}) {
      double value = std::clamp(wanted, *param.min, *param.max);
      if (param.type == Type::Int) value = std::round(value);
      values.push_back(fmt::format("{}", value));
    }
  }
  std::erase(values, text(control.value));
  return values;
}

// Hashes of every image of a frame.
std::string outputsOf(Session& session) {
  session.tap(session.ports());
  graph::FrameResult frame = session.draw();
  std::string all;
  for (const auto* images : {&frame.outputs, &frame.taps})
    for (const auto& [name, image] : *images) all += name + lab::hashOf(image);
  return all;
}

struct Alive {
  std::string pipeline, name, value;
  Settings context;
};

class Registry : public SessionTest {
 protected:
  // Finds a value of each parameter that changes a picture, in the contexts of a pipeline.
  std::vector<Alive> aliveIn(const std::string& pipeline, std::set<std::string>& dead) {
    std::map<std::string, Alive> alive;  // by "parameter" or "pass.parameter"
    std::set<std::string> seen;
    for (const auto& [context, again] : kContexts.at(pipeline)) {
      Session session(bench(), shotIn(pipeline, context));
      std::string before = outputsOf(session);
      for (const lab::Control& control : session.controls()) {
        if (control.group == "shot" || control.origin.starts_with("follows ")) continue;
        std::string key = keyOf(session, control);
        bool wanted = seen.insert(key).second || std::find(again.begin(), again.end(), key) != again.end();
        if (alive.count(key) || isExempt(pipeline, key) || !wanted || isKnown(key)) continue;
        for (const std::string& value : otherValues(control)) {
          if (!changes(session, control, value, before)) continue;
          alive[key] = {pipeline, control.declaration.name, value, context};
          break;
        }
        if (!alive.count(key)) dead.insert(key);
      }
    }
    for (const auto& [key, where] : alive) dead.erase(key), known_.insert(key);
    std::vector<Alive> list;
    for (auto& [key, one] : alive) list.push_back(one);
    return list;
  }

  // True in the short form if the parameter of a pass changed a picture of an earlier pipeline.
  static bool isKnown(const std::string& key) {
    return !allCases() && key.find('/') != std::string::npos && known_.count(key);
  }

  static bool isExempt(const std::string& pipeline, const std::string& key) {
    return kNoPicture.count(key) || kNoPicture.count(pipeline + ": " + key);
  }

  // Nodes are identified by their pass: two uses of one pass share its parameters.
  static std::string keyOf(const Session& session, const lab::Control& control) {
    if (control.group == "pipeline") return control.declaration.name;
    const plan::PipelineDesc& pipeline = session.plan().pipeline;
    for (const auto& node : pipeline.nodes)
      if (node.name == control.group) return node.pass + control.declaration.name.substr(control.group.size());
    return control.declaration.name;
  }

  static bool changes(Session& session, const lab::Control& control, const std::string& value,
                      const std::string& before) {
    const std::string& name = control.declaration.name;
    std::string given;
    for (const auto& [set, to] : session.shot().sets)
      if (set == name) given = plan::textOf(to);
    bool changed = false;
    try {
      session.set(name, value, "window");
      changed = outputsOf(session) != before;
    } catch (const Error&) {
      return false;  // a value that the context refuses
    }
    if (given.empty()) session.unset(name);
    else session.set(name, given, "window");
    return changed;
  }

  plan::Plan planOf(const Shot& shot) {
    Shot filled = shot;
    bench().scene(filled);
    plan::PipelineDesc pipeline = script::evaluatePipeline(bench().home(), {filled.pipeline, filled.sets});
    return lab::planOf(filled, pipeline, bench().chooseBackend("auto"));
  }

  // Shots with a value set in each of the four ways.
  std::map<std::string, Shot> inEveryWay(const Alive& one) {
    std::map<std::string, Shot> shots;
    Session session(bench(), shotIn(one.pipeline, one.context));
    session.set(one.name, one.value, "window");
    shots["window"] = session.shot();

    Shot typed = shotIn(one.pipeline, one.context);
    typed.sets.push_back({one.name, one.value});
    shots["command line"] = typed;

    Path file = home_.path("way.record.json");
    writeFileAtomically(file, Json{{"shot", lab::toJson(session.shot())}}.dump());
    shots["record"] = lab::shotFromRecord(file);

    Shot scripted = shotIn(one.pipeline, one.context);
    std::string sets;
    lab::putSetting(scripted.sets, one.name, one.value);
    for (const auto& [name, value] : scripted.sets)
      if (!name.starts_with("scene.")) sets += fmt::format("[\"{}\"] = {}, ", name, asLua(plan::textOf(value)));
    home_.write("way.lua",
                "return require \"strobe.experiment\" { title = \"t\", truth = { pipeline = \"ground_truth\" },\n"
                "shots = { { name = \"s\", scene = \"oracles/bar\" } },\n"
                "arms = { { name = \"a\", pipeline = \"" +
                    one.pipeline + "\", set = { " + sets + "} } } }\n");
    study::Experiment experiment = study::readExperiment(bench().home(), home_.path("way.lua").string());
    std::erase_if(scripted.sets, [](const auto& set) { return !set.first.starts_with("scene."); });
    for (const auto& set : experiment.arms.front().sets) scripted.sets.push_back(set);
    shots["Lua"] = scripted;
    return shots;
  }

  static std::string asLua(const std::string& value) {
    bool plain = value == "true" || value == "false" || value.find_first_not_of("0123456789.e+-") == std::string::npos;
    return plain ? value : "\"" + value + "\"";
  }

  void walk(const std::string& pipeline, unsigned seed) {
    std::set<std::string> dead;
    std::vector<Alive> alive = aliveIn(pipeline, dead);
    for (const std::string& name : dead)
      ADD_FAILURE() << pipeline << ": no value of '" << name << "' changes any image";
    for (const Alive& one : alive) {
      std::set<std::string> plans;
      for (const auto& [way, shot] : inEveryWay(one)) plans.insert(plan::hashOf(planOf(shot)));
      EXPECT_EQ(plans.size(), 1u) << pipeline << ": " << one.name << " = " << one.value;
      EXPECT_NE(*plans.begin(), plan::hashOf(planOf(shotIn(pipeline, one.context)))) << pipeline << ": " << one.name;
    }
    if (!allCases()) return;
    std::mt19937 random(seed);
    for (int i = 0; i < 2 && !alive.empty(); ++i) {
      const Alive& one = alive[random() % alive.size()];
      std::set<std::string> images;
      for (const auto& [way, shot] : inEveryWay(one)) {
        Session session(bench(), shot);
        images.insert(outputsOf(session));
      }
      EXPECT_EQ(images.size(), 1u) << pipeline << ": " << one.name << " = " << one.value;
      Session otherwise(bench(), shotIn(pipeline, one.context));
      EXPECT_NE(*images.begin(), outputsOf(otherwise)) << pipeline << ": " << one.name;
    }
  }

  static inline std::set<std::string> known_;  // parameters that changed a picture
};

TEST_F(Registry, EveryShippedPipelineIsTested) {
  for (const std::string& name : script::pipelineNames(bench().home()))
    EXPECT_TRUE(kContexts.count(name)) << name << " is walked by no test";
}

// The seed draws two parameters of each pipeline for a comparison of pictures.
TEST_F(Registry, McGuire2012) { walk("mcguire2012", 1); }
TEST_F(Registry, Guertin2014) { walk("guertin2014", 2); }
TEST_F(Registry, Jimenez2014) { walk("jimenez2014", 3); }
TEST_F(Registry, Ue4) { walk("ue4", 4); }
TEST_F(Registry, Ue5) { walk("ue5", 16); }
TEST_F(Registry, Bevy) { walk("bevy", 7); }
TEST_F(Registry, Eevee) { walk("eevee", 15); }
TEST_F(Registry, Hdrp) { walk("hdrp", 9); }
TEST_F(Registry, Oberberger2022) { walk("oberberger2022", 10); }
TEST_F(Registry, Lee2024) { walk("lee2024", 8); }
TEST_F(Registry, Adaptive) { walk("adaptive", 11); }
TEST_F(Registry, Accumulation) { walk("accumulation", 12); }
TEST_F(Registry, Hybrid) { walk("hybrid", 5); }
TEST_F(Registry, HybridLayered) { walk("hybrid_layered", 13); }
TEST_F(Registry, GroundTruth) { walk("ground_truth", 6); }

TEST_F(Registry, OptionsOfTheShotChangeThePicture) {
  Session session(bench(), shotIn("mcguire2012", {"jitter=hash", "jitter_frame=per_frame"}));
  session.set("camera", session.scene().nodes[size_t(scene::cameraNode(session.scene(), ""))].name, "window");
  std::string before = outputsOf(session);
  for (const auto& [name, value] : std::map<std::string, std::string>{{"frame", "3"},
                                                                      {"fps", "12"},
                                                                      {"exposure", "0.2"},
                                                                      {"anchor", "start"},
                                                                      {"width", "32"},
                                                                      {"height", "20"},
                                                                      {"seed", "7"}}) {
    std::string given;
    for (const auto& control : session.controls())
      if (control.declaration.name == name) given = text(control.value);
    session.set(name, value, "window");
    EXPECT_NE(outputsOf(session), before) << name;
    session.set(name, given, "window");
    EXPECT_EQ(outputsOf(session), before) << name;
  }
}

}  // namespace registry_test
}  // namespace strobe::session
