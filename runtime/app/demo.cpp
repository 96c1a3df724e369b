// SPDX-License-Identifier: MIT
#include "app/demo.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/files.h"
#include "app/shot_options.h"
#include "base/log.h"
#include "image/png.h"
#include "lab/figures.h"
#include "lab/html.h"
#include "lab/sheet.h"

namespace strobe::app {

namespace {

struct Options {
  std::string file = "scripts/captures/demo.lua", out = "out/demo", size, device, markdown;
  bool json = false;
};

void demo(const Home& home, const Options& options) {
  double started_s = clockSeconds();
  requireWritable(options.out);
  if (!options.markdown.empty())
    requireWritable(std::filesystem::absolute(options.markdown).parent_path(), "--markdown");
  lab::Demo demo = lab::readDemo(home, hereOrAtHome(home, options.file));
  int file_width = demo.width, file_height = demo.height;
  if (!options.size.empty()) {
    auto [width, height] = lab::parseSize(options.size);
    demo.width = width, demo.height = height;
    for (lab::DemoShot& shot : demo.shots) shot.shot.width = width, shot.shot.height = height;
  }
  lab::Workbench bench(home, options.device, validationWanted());
  Path folder = options.out;
  lab::Exhibition exhibition = lab::exhibit(demo, bench, folder, file_width, file_height);
  refuseMessages(bench.device());

  std::vector<Path> files = {folder / "demo.png", folder / "demo.html", folder / "demo.json"};
  Json json = lab::toJson(exhibition);
  image::writePng(files[0], lab::sheetOf(exhibition));
  writeFileAtomically(files[1], lab::pageOf(exhibition));
  writeFileAtomically(files[2], json.dump(2) + "\n");
  if (!options.markdown.empty()) {
    files.push_back(options.markdown);
    writeFileAtomically(files.back(), lab::tablesMarkdown(exhibition));
  }
  std::string text = options.json ? json.dump(2) + "\n" : lab::tablesText(exhibition) + "\n";
  std::fputs(text.c_str(), stdout);
  for (const Path& file : files)
    if (!options.json) std::printf("%s\n", file.c_str());
  note(fmt::format("done in {:.0f} s ({:.0f} s rendering and measuring)", clockSeconds() - started_s,
                   exhibition.render_s));
}

}  // namespace

void registerDemo(CLI::App& program, const Home& home) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      program.add_subcommand("demo", "Render the shots of a demo file and show every method beside truth");
  command->add_option("file", options->file, "a demo file (scripts/strobe/demo.lua)")->capture_default_str();
  command->add_option("-o,--out", options->out, "folder for the sheet, the page, numbers, pictures and records")
      ->capture_default_str();
  command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (default: the file's)");
  command->add_option("--markdown", options->markdown, "write the tables as Markdown as well")->type_name("FILE");
  command->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  command->add_flag("--json", options->json, "print the numbers as JSON instead of tables");
  command->callback([options, &home] { demo(home, *options); });
}

}  // namespace strobe::app
