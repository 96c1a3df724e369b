// SPDX-License-Identifier: MIT
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/files.h"
#include "app/shot_options.h"
#include "archive/capture_run.h"
#include "archive/verify.h"
#include "base/interruption.h"
#include "base/log.h"
#include "base/process.h"
#include "gpu/choice.h"

namespace strobe::app {

namespace {

struct CaptureOptions {
  std::string file, out, only, size, device;
  bool bundle = false, zip = false, json = false;
};

// Describes and packs a capture. Returns the path of the packed file.
std::string packed(const Home& home, const Path& folder) {
  const ProgramEnd end = run({.arguments = {"python3", home.shipped() / "tools/crate.py", folder, "--zip"},
                              .errors = Program::Errors::inherited});
  if (!end.succeeded()) throw Error("the capture was taken, but it could not be packed");
  return end.output;
}

void capture(const Home& home, const CaptureOptions& options) {
  archive::Order order;
  order.file = hereOrAtHome(home, options.file);
  order.folder = options.out;
  order.only = options.only;
  if (!options.size.empty()) order.size = lab::parseSize(options.size);
  order.bundle = options.bundle || options.zip;
  order.device = options.device, order.validation = validationWanted();
  requireWritable(order.folder);
  archive::readCapture(home, order.file, order.size);  // report mistakes before anything is written
  Interruption interruption;
  archive::Captured captured = archive::runCapture(home, order, [](const std::string& line) { note(line); });
  const std::string zip = options.zip ? packed(home, order.folder) : "";
  if (options.json) {
    std::printf("%s\n", captured.manifest.json.dump(1).c_str());
    return;
  }
  for (const auto* files : {&captured.figures, &captured.pictures})
    for (const Path& file : *files) std::printf("%s\n", file.c_str());
  std::printf("%s\n", (order.folder / archive::kManifestFile).c_str());
  std::fputs(zip.c_str(), stdout);
}

struct VerifyOptions {
  std::string manifest, out, device;
  bool json = false;
};

// Result of `work`. Throws `Error` if a field of a manifest is missing.
template <class Work>
auto ofManifests(const std::string& manifests, const Work& work) {
  try {
    return work();
  } catch (const Json::exception&) {
    throw Error("is damaged: a field of the manifest is missing or has the wrong type", {manifests});
  }
}

void verify(const Home& home, const VerifyOptions& options) {
  if (!options.out.empty()) requireWritable(options.out);
  archive::Manifest manifest = archive::readManifest(options.manifest);
  const Json verification = ofManifests(options.manifest, [&] {
    return archive::verify(home, manifest, options.device, validationWanted(), options.out,
                           [](const std::string& line) { note(line); });
  });
  const std::string text = archive::textOf(verification) + archive::verdictOf(verification);
  std::fputs((options.json ? verification.dump(1) + "\n" : text).c_str(), stdout);
  if (!verification.at("holds").get<bool>()) throw Error("the repeated capture differs from its manifest");
}

struct DiffOptions {
  std::string first, second, out;
  bool json = false;
};

void diff(const DiffOptions& options) {
  if (!options.out.empty()) requireWritable(options.out);
  archive::Manifest first = archive::readManifest(options.first), second = archive::readManifest(options.second);
  const Json differences = ofManifests(options.first + " or " + options.second,
                                       [&] { return archive::differencesOf(first, second, options.out); });
  std::string text = archive::textOf(differences);
  if (text.empty()) text = "no differences\n";
  std::fputs((options.json ? differences.dump(1) + "\n" : text).c_str(), stdout);
  if (!archive::identical(differences)) throw Error("the two captures differ");
}

}  // namespace

void registerCapture(CLI::App& program, const Home& home) {
  auto order = std::make_shared<CaptureOptions>();
  CLI::App* command = program.add_subcommand(
      "capture", "Take the pictures and figures of a capture script, with a manifest to repeat them");
  command->add_option("file", order->file, "a capture (docs/captures.md), such as scripts/captures/figure1.lua")
      ->required();
  order->out = "out/capture";
  command->add_option("-o,--out", order->out, "folder for pictures, figures, films and manifest.json")
      ->capture_default_str();
  command->add_option("--only", order->only, "only pictures with names that start with NAME (SHOT.ARM)")
      ->type_name("NAME");
  command->add_option("--size", order->size, "WIDTHxHEIGHT in pixels: scales the whole capture (default: the file's)");
  command->add_flag("--bundle", order->bundle, "copy every used file, so that the folder can be verified anywhere");
  command->add_flag("--zip", order->zip, "write a bundle, and a copy as one file, FOLDER.zip (needs Python 3)");
  command->add_option("--device", order->device, gpu::kDeviceHelp);
  command->add_flag("--json", order->json, "print the manifest");
  command->callback([order, &home] { capture(home, *order); });

  auto asked = std::make_shared<VerifyOptions>();
  command = program.add_subcommand("verify", "Take a capture again and compare it with its manifest, bit for bit");
  command->add_option("manifest", asked->manifest, "the folder of a capture, or its manifest.json")->required();
  command->add_option("-o,--out", asked->out, "folder for pictures of the differences");
  command->add_option("--device", asked->device, gpu::kDeviceHelp);
  command->add_flag("--json", asked->json, "print the differences as JSON");
  command->callback([asked, &home] { verify(home, *asked); });

  auto pair = std::make_shared<DiffOptions>();
  command = program.add_subcommand("diff", "Show why two captures differ: inputs, parameters, device, first pass");
  command->add_option("first", pair->first, "the folder of a capture, or its manifest.json")->required();
  command->add_option("second", pair->second, "the folder of another capture, or its manifest.json")->required();
  command->add_option("-o,--out", pair->out, "folder for pictures of the differences");
  command->add_flag("--json", pair->json, "print the differences as JSON");
  command->callback([pair] { diff(*pair); });
}

}  // namespace strobe::app
