// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>
#include <optional>
#include <set>

#include "app/commands.h"
#include "app/files.h"
#include "app/shot_options.h"
#include "base/leftovers.h"
#include "base/log.h"
#include "gpu/renderdoc.h"
#include "image/png.h"
#include "lab/arrays.h"
#include "lab/budget.h"
#include "lab/capture.h"
#include "lab/frame.h"
#include "lab/session.h"
#include "lab/tev.h"
#include "lab/trail.h"
#include "lab/views.h"
#include "scene/mitsuba.h"
#include "script/evaluate.h"

namespace strobe::app {

namespace {

struct RenderOptions {
  ShotOptions shot;
  std::string out, pixel, tev, views, arrays, mitsuba, renderdoc;
  lab::ExrOptions exr;
  bool json = false, verbose = false;
  double time_limit_s = gpu::kTimeLimit_s, budget_ms = 0;

  bool asksForPicture() const {
    return !out.empty() || !pixel.empty() || !tev.empty() || !views.empty() || !arrays.empty() || !renderdoc.empty();
  }
  bool asksForExr() const { return exr.half || exr.multipart || exr.cryptomatte; }
};

void printCounters(const Json& record) {
  if (!record.contains("counters")) return;
  for (const auto& [name, count] : record["counters"].items())
    if (count.get<uint64_t>() != 0) note(fmt::format("  {} {}", name, count.get<uint64_t>()));
}

// Default path of the picture; "" if another output was given.
std::string usualOut(const RenderOptions& options, const lab::Shot& shot) {
  if (options.asksForPicture()) return "";
  bool exr = !shot.taps.empty() || options.asksForExr();
  return (Path("out") / Path(shot.pipeline).stem()).string() + (exr ? ".exr" : ".png");
}

void checkRenderDocFile(const Path& file) {
  if (file.extension() != ".rdc")
    throw Error(fmt::format("--renderdoc: '{}' is not an .rdc file", file.string()), {}, 2);
  requireWritable(std::filesystem::absolute(file).parent_path(), "--renderdoc");
}

void checkOptions(const RenderOptions& options, const lab::Shot& shot) {
  if (!options.out.empty()) {
    lab::checkPictureName(options.out);
    const Path file = std::filesystem::absolute(options.out);
    requireWritable(file.parent_path());
    removeLeftovers(file.parent_path(), file.stem().string() + ".");
  }
  bool held = Path(options.out).extension() == ".exr" || !options.tev.empty() || !options.views.empty() ||
              !options.arrays.empty();
  if (!options.views.empty()) requireWritable(options.views, "--views");
  if (!options.renderdoc.empty()) checkRenderDocFile(options.renderdoc);
  if (!options.arrays.empty()) requireWritable(options.arrays, "--arrays");
  if (!shot.taps.empty() && !held)
    throw Error("--tap needs an .exr file, --views or --arrays: a .png has only the color", {}, 2);
  if (options.asksForExr() && Path(options.out).extension() != ".exr")
    throw Error("--half, --multipart and --cryptomatte need an .exr file; name one with -o", {}, 2);
}

// Draws frames until their times determine the pipeline's quality parameter. Sets the parameter in `shot`, like --set.
void settle(lab::Workbench& bench, double budget_ms, lab::Shot& shot) {
  constexpr int kMostFrames = 200;  // limit if the times do not settle
  static const std::set<std::string> kNoOutputs;
  lab::Session session(bench, shot);
  const plan::PipelineDesc& pipeline = session.running().evaluation().pipeline;
  const std::string name = lab::budgetedParam(pipeline).name;
  lab::Budget budget = lab::budgetOf(pipeline, budget_ms);
  auto line = std::make_unique<StatusLine>();
  int frames = 0;
  for (bool changed = true; frames < kMostFrames && !budget.isSettled(); ++frames) {
    line->show([&] { return fmt::format("{} {:g}, frame {}", name, budget.value(), frames + 1); });
    if (changed) session.set(name, budget.value(), "budget");
    changed = budget.add(session.draw(&kNoOutputs).gpu_ms);
  }
  line.reset();
  lab::putSetting(shot.sets, name, budget.value());
  const double cost_ms = budget.cost().value_or(0);
  std::string text = fmt::format("{}={:g}: a frame takes {:.4g} ms", name, budget.value(), cost_ms);
  if (budget.isMet()) note(fmt::format("{} of {:g} ms (chosen in {} frames)", text, budget_ms, frames));
  else warn(fmt::format("{}, more than the budget of {:g} ms", text, budget_ms));
}

// Renders the picture. With `--pixel`, also fills `trail` with the values of every pass at the pixel.
lab::Picture renderedBy(lab::KeptDrawings& drawings, const RenderOptions& options, const lab::Shot& shot,
                        lab::Trail& trail) {
  std::unique_ptr<Progress> progress;
  auto advance = [&](int done, int of) {
    if (!progress) progress = std::make_unique<Progress>(Path(shot.pipeline).stem().string(), of, "time samples");
    progress->reach(done);
  };
  if (options.pixel.empty()) return drawings.render(shot, advance, options.exr.cryptomatte);
  auto [x, y] = lab::parsePixel(options.pixel);
  lab::Followed followed = lab::follow(drawings.bench(), shot, x, y, advance, options.exr.cryptomatte);
  trail = std::move(followed.trail);
  return std::move(followed.picture);
}

void sendTo(lab::Tev& viewer, const lab::Picture& picture) {
  for (const auto* images : {&picture.frame.outputs, &picture.frame.taps})
    for (const auto& [name, read] : *images)
      if (!viewer.send(name, read)) return;
}

// Writes every output and tap as the window shows it. The port names the file.
std::vector<Path> writeViews(lab::Workbench& bench, lab::Shot shot, const lab::Picture& picture, const Path& folder) {
  image::Image color = lab::colorOf(picture);
  shot.width = color.width, shot.height = color.height;
  plan::Plan plan =
      lab::planOf(shot, bench.evaluate(shot.pipeline, shot.sets)->pipeline, bench.chooseBackend(shot.backend));
  std::vector<Path> files;
  for (const auto* images : {&picture.frame.outputs, &picture.frame.taps})
    for (const auto& [name, read] : *images) {
      files.push_back(folder / (name + ".png"));
      image::writePng(files.back(),
                      lab::shown(read, name, lab::divideOf(plan, name), color.width, color.height, {}, &color));
    }
  return files;
}

// Exports the shot for Mitsuba 3. Needs no device.
void exportShot(const Home& home, const RenderOptions& options, lab::Shot shot) {
  requireWritable(options.mitsuba, "--export-mitsuba");
  const std::shared_ptr<lab::HeldScene> held = lab::loadScene(home, shot);
  const graph::Frame frame = lab::frameOf(shot, held->scene);
  scene::MitsubaExport written = scene::exportMitsuba(held->scene, frame.pose_at, frame.view, options.mitsuba);
  if (shot.shutter_curve != "box")
    written.left_out.push_back(
        fmt::format("the shutter curve ({}): all times have the same weight", shot.shutter_curve));
  for (const std::string& warning : held->scene.warnings) warn(warning);
  for (const std::string& what : written.left_out) warn("--export-mitsuba leaves out: " + what);
  for (const Path& file : written.files)
    if (!options.json) std::printf("%s\n", file.c_str());
}

void print(const RenderOptions& options, const lab::Picture& picture, const lab::Trail& trail,
           const std::vector<Path>& files) {
  bool pixel = !options.pixel.empty();
  if (options.json) {
    std::printf("%s\n", (pixel ? lab::toJson(trail) : picture.record).dump(2).c_str());
    return;
  }
  if (pixel) std::printf("%s%s", lab::tableOf(trail).c_str(), files.empty() ? "" : "\n");
  if (options.verbose) printCounters(picture.record);
  for (const Path& file : files) std::printf("%s\n", file.c_str());
}

void render(const Home& home, KeptBench& kept, RenderOptions options) {
  lab::Shot shot = options.shot.resolve();
  if (!options.mitsuba.empty()) exportShot(home, options, shot);
  if (!options.mitsuba.empty() && !options.asksForPicture()) return;
  if (options.out.empty()) options.out = usualOut(options, shot);
  checkOptions(options, shot);
  std::unique_ptr<lab::Tev> viewer;
  if (!options.tev.empty()) viewer = std::make_unique<lab::Tev>(lab::parseTevAddress(options.tev));
  if (!options.pixel.empty()) lab::parsePixel(options.pixel);
  std::optional<gpu::RenderDoc> renderdoc;
  if (!options.renderdoc.empty()) renderdoc.emplace();
  lab::KeptDrawings& drawings = kept.on(shot.device, options.time_limit_s);
  lab::Workbench& bench = drawings.bench();
  if (options.budget_ms > 0) settle(bench, options.budget_ms, shot);
  lab::Trail trail;
  lab::Picture picture;
  auto draw = [&] { picture = renderedBy(drawings, options, shot, trail); };
  if (renderdoc) renderdoc->capture(options.renderdoc, draw);
  else draw();
  bench.device().refuseMessages();
  for (const std::string& warning : picture.warnings) warn(warning);
  std::vector<Path> files;
  if (!options.out.empty()) files = lab::writePicture(picture, options.out, options.exr);
  if (!options.views.empty())
    for (const Path& file : writeViews(bench, shot, picture, options.views)) files.push_back(file);
  if (renderdoc) files.push_back(options.renderdoc);
  if (!options.arrays.empty())
    for (const Path& file : lab::writeArrays(picture, options.arrays)) files.push_back(file);
  if (viewer) sendTo(*viewer, picture);
  print(options, picture, trail, files);
}

}  // namespace

void registerRender(CLI::App& program, const Home& home, KeptBench& bench) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = program.add_subcommand("render", "Render one picture of a scene with a pipeline");
  command->add_option(
      "-o,--out", options->out,
      "picture to write, .exr or .png; record and timings go beside it (default: out/PIPELINE.png; out/PIPELINE.exr "
      "with --tap or an option of .exr files; no picture with --pixel, --tev, --views, --arrays, --renderdoc or "
      "--export-mitsuba)");
  command->add_option("--views", options->views,
                      "folder: write every output and tap as PNG files, as the window shows them");
  command->add_option("--arrays", options->arrays, "folder: write every output and tap as a NumPy array, NAME.npy");
  command->add_option("--renderdoc", options->renderdoc,
                      "file (.rdc): capture the Vulkan commands of the picture with RenderDoc, labelled by pass; rays "
                      "use the backend 'bvh' if RenderDoc does not support ray queries");
  command->add_option("--export-mitsuba", options->mitsuba,
                      "folder: write the shot as a scene of Mitsuba 3, to check ground truth with another renderer");
  command->add_option("--pixel", options->pixel,
                      "X,Y from the top left: print the values of every pass at this pixel, and the hits of its ray");
  addTev(*command, options->tev);
  command->add_flag("--half", options->exr.half,
                    "write EXR in 16-bit floats (with rounding errors above the errors measured here)");
  command->add_flag("--multipart", options->exr.multipart,
                    "write EXR with a part for each output and tap, also for images of another size than the picture");
  command->add_flag("--cryptomatte", options->exr.cryptomatte,
                    "write EXR with mattes by node and by material, from the coverage of sub-pixel samples (--aa)");
  command->add_flag("--json", options->json,
                    "print the run record (with --pixel: the trail) instead of the names of written files");
  command->add_flag("-v,--verbose", options->verbose,
                    "print the counters of the passes, which the run record always has");
  addBudget(*command, options->budget_ms);
  addTimeLimit(*command, options->time_limit_s);
  options->shot.addWithPipeline(*command);
  command->callback([options, &home, &bench] { render(home, bench, *options); });
}

}  // namespace strobe::app
