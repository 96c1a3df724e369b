// SPDX-License-Identifier: MIT
#include "app/render.h"

#include <cstdio>
#include <memory>

#include "app/shot_options.h"
#include "base/log.h"
#include "lab/capture.h"

namespace strobe::app {

namespace {

struct Options {
  ShotOptions shot;
  std::string out;
  bool half = false, json = false;
};

void printCounters(const Json& record) {
  if (!record.contains("counters")) return;
  for (const auto& [name, count] : record["counters"].items())
    if (count.get<uint64_t>() != 0) note(fmt::format("  {} {}", name, count.get<uint64_t>()));
}

void render(const Options& options) {
  lab::checkPictureName(options.out);
  lab::Shot shot = options.shot.resolve();
  if (!shot.taps.empty() && Path(options.out).extension() != ".exr")
    throw Error("--tap needs an .exr file: a .png holds the color alone", {}, 2);
  lab::Workbench bench(shot.device, validationWanted());
  std::unique_ptr<Progress> progress;
  lab::Picture picture = bench.render(shot, [&](int, int of) {
    if (!progress) progress = std::make_unique<Progress>(shot.pipeline, of);
    progress->advance();
  });
  progress.reset();
  refuseMessages(bench.device());
  for (const std::string& warning : picture.warnings) warn(warning);
  std::vector<Path> files = lab::writePicture(picture, options.out, options.half);
  if (options.json) {
    std::printf("%s\n", picture.record.dump(2).c_str());
    return;
  }
  printCounters(picture.record);
  for (const Path& file : files) std::printf("%s\n", file.c_str());
}

}  // namespace

void registerRender(CLI::App& program) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("render", "Render one picture of a scene with a pipeline");
  command->add_option("-o,--out", options->out, "picture to write, .exr or .png; record and timings go beside it")->required();
  command->add_flag("--half", options->half, "EXR in 16-bit floats (rounds more than the errors measured here)");
  command->add_flag("--json", options->json, "print the run record instead of the files written");
  options->shot.addWithPipeline(*command);
  command->callback([options] { render(*options); });
}

}  // namespace strobe::app
