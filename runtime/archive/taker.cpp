// SPDX-License-Identifier: MIT
// Pictures of a capture: drawing, and reading back.

#include <algorithm>
#include <filesystem>

#include "archive/capture_run.h"
#include "base/hash.h"
#include "base/log.h"
#include "base/process_name.h"
#include "base/sealed_json.h"
#include "image/png.h"
#include "lab/capture.h"
#include "lab/controls.h"
#include "lab/frame.h"
#include "lab/record.h"
#include "lab/shot_data.h"
#include "lab/views.h"
#include "math/bounds.h"
#include "plan/canonical.h"
#include "plan/filled_images.h"
#include "scene/bend.h"

namespace strobe::archive {

namespace fs = std::filesystem;

namespace {

const std::string& nameOf(const plan::Plan& plan, const plan::PlanNode& node) {
  return plan.pipeline.nodes[size_t(node.node)].name;
}

std::string portOf(const plan::VirtualImage& image) { return image.name.substr(image.name.rfind('.') + 1); }

// Every pass in the order of execution, with its outputs.
Json passesOf(const plan::Plan& plan, const lab::Picture& picture) {
  Json passes = Json::array();
  for (const plan::PlanNode& node : plan.nodes)
    passes.push_back({{"node", nameOf(plan, node)},
                      {"pass", plan.pipeline.passes[size_t(node.pass)].name},
                      {"shader", plan.pipeline.passes[size_t(node.pass)].shader},
                      {"outputs", Json::object()}});
  size_t at = 0;
  const plan::PlanNode* last = plan.nodes.data();
  plan::forFilledImages(plan, [&](const plan::PlanNode& node, const plan::VirtualImage& image) {
    if (&node != last) at = size_t(&node - plan.nodes.data()), last = &node;
    auto tap = picture.frame.taps.find(image.name);
    if (tap == picture.frame.taps.end()) return;
    passes[at]["outputs"][portOf(image)] = {
        {"format", image.format}, {"size", {image.width, image.height}}, {"hash", lab::hashOf(tap->second)}};
  });
  return passes;
}

// Parameters of the pipeline and its nodes, with their origin. A plan keeps only the parameters that a pass uses.
Json parametersOf(const lab::Shot& shot, const lab::Drawing& drawing) {
  std::map<std::string, std::string> origins;
  for (const auto& [name, value] : shot.sets) origins[name] = "capture";
  Json list = Json::array();
  for (const lab::Control& control : lab::controlsOf(shot, drawing, origins, "capture"))
    list.push_back({{"name", control.declaration.name},
                    {"value", plan::toJson(control.value)},
                    {"of", control.group},
                    {"set_by", control.origin}});
  return list;
}

// Record without the parts that a manifest states once for all pictures.
Json recordOf(const lab::Picture& picture, const CapturedShot& shot) {
  Json record = picture.record;
  for (const char* part : {"strobe", "device", "scripts", "shaders", "taps"}) record.erase(part);
  record["shot"]["scene"] = shot.scene_name;
  if (!shot.attribution.empty()) record["scene"]["attribution"] = {{"copyright", shot.attribution}};
  return record;
}

// Centre of the geometry of each node at the raster time, metres.
Json nodesOf(const lab::Shot& shot, const scene::Scene& scene) {
  scene::Pose pose = lab::frameOf(shot, scene).pose_at(shot.rasterTime());
  std::vector<scene::Instance> instances = scene::instancesOf(scene);
  std::map<std::string, Bounds> bounds;
  for (size_t i = 0; i < instances.size(); ++i)
    bounds[scene.nodes[size_t(instances[i].node)].name].add(scene::posedBounds(scene, instances, i, pose));
  Json nodes = Json::object();
  for (const auto& [name, own] : bounds)
    if (!name.empty() && !own.empty()) nodes[name] = {own.middle().x, own.middle().y, own.middle().z};
  return nodes;
}

Json matrixJson(const mat4& matrix) {
  Json numbers = Json::array();  // column by column
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) numbers.push_back(matrix[column][row]);
  return numbers;
}

mat4 matrixFrom(const Json& json) {
  mat4 matrix(0);
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = json.at(size_t(i)).get<float>();
  return matrix;
}

bool isThere(const Path& folder, const Json& files) {
  for (const auto& [name, file] : files.items()) {
    std::error_code missing;
    bool same = fs::file_size(folder / name, missing) == file.at("bytes").get<uint64_t>() && !missing;
    if (!same || file.at("sha256") != Json(sha256(readText(folder / name)))) return false;
  }
  return true;
}

// Images in the file of a picture, by name; always with the color.
Images layersIn(const lab::Picture& picture, const Layers& layers, const std::string& name) {
  Images all = picture.frame.outputs;
  all.insert(picture.frame.taps.begin(), picture.frame.taps.end());
  if (layers.all) return all;
  Images result = {{"color", all.at("color")}};
  std::vector<std::string> known;
  for (const auto& [layer, image] : all) known.push_back(layer);
  for (const std::string& layer : layers.names) {
    if (!all.count(layer)) throw Error(fmt::format("{} has no layer '{}'{}", name, layer, didYouMean(layer, known)));
    result[layer] = all.at(layer);
  }
  return result;
}

}  // namespace

std::string CapturedFrame::name() const {
  std::string name = lab::fileNameOf(shot->name) + "." + lab::fileNameOf(arm->name);
  return shot->isSequence() ? fmt::format("{}.{:04}", name, step) : name;
}

std::vector<CapturedFrame> framesOf(const CaptureFile& capture, const std::string& only) {
  std::vector<CapturedFrame> frames;
  for (const CapturedShot& shot : capture.shots)
    for (const CapturedArm& arm : capture.arms)
      for (size_t step = 0; step < shot.steps.size() && shot.missing.empty() && arm.draws(shot.name); ++step)
        if (CapturedFrame frame{&shot, &arm, step}; frame.name().starts_with(only)) frames.push_back(frame);
  if (frames.empty() && !only.empty())
    throw Error(fmt::format("--only '{}': the capture has no picture with a name that starts with this text", only), {},
                2);
  return frames;
}

const Capturing::Place& Capturing::placeOf(const Path& files) {
  auto known = places_.find(files);
  if (known != places_.end()) return known->second;
  const Path copy = order_.folder / fmt::format(".inputs_{}.{}", places_.size() - 1, processName());
  auto home = std::make_unique<FrozenHome>(inputs().home(), copy, files);
  auto bench = std::make_unique<lab::Workbench>(home->home(), order_.device, order_.validation);
  InputNames names(home->home(), main().names, files);
  return places_.emplace(files, Place{std::move(home), std::move(bench), std::move(names)}).first->second;
}

// Drawing with the outputs of all passes tapped.
static std::unique_ptr<lab::Drawing> drawingOf(lab::Workbench& bench, lab::Shot& shot) {
  std::shared_ptr<const lab::Evaluation> evaluation = bench.evaluate(shot.pipeline, shot.sets);
  std::shared_ptr<lab::HeldScene> scene = bench.scene(shot, true);
  shot.taps = plan::filledImages(*lab::plannedOf(bench, shot, nullptr, evaluation->pipeline).plan);
  lab::Planned planned = lab::plannedOf(bench, shot, nullptr, evaluation->pipeline);
  return std::make_unique<lab::Drawing>(bench, scene, std::move(planned), evaluation);
}

// Hash of everything that determines the files: shot, inputs, program, device, and the kept layers.
std::string Capturing::keyOf(const CapturedFrame& frame, const lab::Drawing& drawing, const lab::Shot& shot) const {
  const gpu::DeviceInfo& device = main().bench->device().info();
  const Layers layers = layersOf(capture_, *frame.shot, *frame.arm);
  const image::ToneMap& tone = frame.shot->tone;
  std::string key = lab::canonical(shot) + drawing.planned().hash + drawing.scene().hash + lab::programHash();
  for (const auto* files : {&drawing.evaluation().scripts, &drawing.scene().dependencies})
    for (const script::Dependency& file : *files) key += file.hash;
  for (const auto& [node, pipeline] : drawing.graph().pipelines())
    for (const auto& [file, hash] : pipeline->sources) key += hash;
  key += fmt::format("|{}|{}|{}|{}", device.name, device.driver, layers.all, fmt::join(layers.names, " "));
  key += fmt::format("|{}|{}|{}|{}|{}", tone.stops, int(tone.curve), frame.shot->scene_name, frame.shot->attribution,
                     frame.shot->steps[frame.step].label);
  return hashText(key);
}

// The picture as drawn without taps.
static std::shared_ptr<const lab::Picture> withoutTaps(lab::Picture picture) {
  picture.frame.taps.clear();
  picture.record.erase("taps");
  return std::make_shared<const lab::Picture>(std::move(picture));
}

std::shared_ptr<const lab::Picture> Capturing::draw(const CapturedFrame& frame, const Progress& progress) {
  const std::string name = frame.name();
  if (entries_.count(name)) return nullptr;
  lab::Shot shot = this->shot(frame);
  const Place& place = placeOf(frame.arm->files);
  std::unique_ptr<lab::Drawing> drawing = drawingOf(*place.bench, shot);
  addInputs(used_, place.names, place.home->home(), *drawing, shot.allow_outside);
  std::string key = keyOf(frame, *drawing, shot);
  Path file = order_.folder / "pictures" / (name + ".json");
  if (fs::exists(file)) {
    std::optional<Json> known = unsealed(readText(file));
    if (!known)
      warn(fmt::format("{}: is damaged or from an earlier program; its picture is taken again", file.string()));
    if (known && known->value("key", "") == key && isThere(order_.folder, known->at("files"))) {
      entries_[name] = *known;
      return nullptr;
    }
  }
  uint64_t before = drawing->graph().runs();
  lab::Picture picture = drawing->capture(shot, nullptr, progress);
  ++drawn_;
  Json entry = take(frame, shot, *drawing, picture, drawing->graph().runs() - before);
  entry["key"] = key;
  writeFileAtomically(file, sealed(entry));
  entries_[name] = std::move(entry);
  return withoutTaps(std::move(picture));
}

Json Capturing::take(const CapturedFrame& frame, const lab::Shot& shot, lab::Drawing& drawing,
                     const lab::Picture& picture, uint64_t runs) {
  const std::string name = frame.name();
  timings_[name] = picture.timings;
  lab::Shot untapped = shot;
  untapped.taps.clear();
  plan::Plan plan = lab::planOf(untapped, drawing.evaluation().pipeline, drawing.planned().backend);
  Images layers = layersIn(picture, layersOf(capture_, *frame.shot, *frame.arm), name);
  Json divides = Json::object();
  for (const auto& [layer, image] : layers) divides[layer] = lab::divideOf(drawing.plan(), layer);

  const Path stem = Path("pictures") / name;
  const std::string exr = stem.string() + ".exr", png = stem.string() + ".png";
  image::writePng(order_.folder / png, image::toneMap(lab::colorOf(picture), frame.shot->tone));
  const Json record = recordOf(picture, *frame.shot);
  writeLayers(order_.folder / exr, picture, record, layers);
  return {{"name", name},
          {"shot", frame.shot->name},
          {"arm", frame.arm->name},
          {"step", frame.step},
          {"label", frame.shot->steps[frame.step].label},
          {"runs", runs},
          {"record", record},
          {"parameters", parametersOf(shot, drawing)},
          {"plan", plan::toJson(plan)},
          {"passes", passesOf(drawing.plan(), picture)},
          {"layers", layersJson(layers)},
          {"images", {{"exr", exr}, {"png", png}}},
          {"divides", divides},
          {"nodes", nodesOf(shot, drawing.scene().scene)},
          {"camera_from_world", matrixJson(picture.camera_from_world)},
          {"ndc_from_world", matrixJson(picture.ndc_from_world)},
          {"files", {{png, fileEntry(order_.folder / png)}, {exr, fileEntry(order_.folder / exr)}}}};
}

// ---- read back

figure::Taken Capturing::readBack(const Json& entry) const {
  auto picture = std::make_shared<lab::Picture>();
  picture->record = entry.at("record");
  for (auto& [layer, image] :
       readLayers(order_.folder / entry.at("images").at("exr").get<std::string>(), entry.at("layers"))) {
    bool is_output = layer.find('.') == std::string::npos;
    (is_output ? picture->frame.outputs : picture->frame.taps)[layer] = std::move(image);
  }
  picture->camera_from_world = matrixFrom(entry.at("camera_from_world"));
  picture->ndc_from_world = matrixFrom(entry.at("ndc_from_world"));
  figure::Taken taken{entry.at("shot"), entry.at("arm"), entry.at("step"), std::move(picture), {}, {}, {}};
  taken.tone = capture_.shot(taken.shot).tone;
  taken.divides = entry.at("divides").get<std::map<std::string, int>>();
  for (const auto& [node, at] : entry.at("nodes").items()) taken.nodes_ws[node] = {at[0], at[1], at[2]};
  return taken;
}

const figure::Taken& Capturing::find(const std::string& shot, const std::string& arm, int step) {
  auto known = std::find_if(kept_.begin(), kept_.end(), [&](const figure::Taken& one) {
    return one.shot == shot && one.arm == arm && one.step == step;
  });
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
    return kept_.front();
  }
  CapturedFrame frame{&capture_.shot(shot), &capture_.arm(arm), size_t(step)};
  if (size_t(step) >= frame.shot->steps.size())
    throw Error(fmt::format("shot '{}' has {} steps, but no step {}", shot, frame.shot->steps.size(), step));
  draw(frame);
  kept_.push_front(readBack(entries_.at(frame.name())));
  if (kept_.size() > figure::kPicturesFound) kept_.pop_back();
  return kept_.front();
}

}  // namespace strobe::archive
