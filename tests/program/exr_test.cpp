// SPDX-License-Identifier: MIT
// OpenEXR files decoded by other programs: OpenImageIO and NumPy (exr_reference.py), and OpenEXR's own exrheader. These
// programs share no code with Strobe's writer.
#include <gtest/gtest.h>

#include <optional>

#include "base/hash.h"
#include "base/json.h"
#include "common/source.h"
#include "lab/capture.h"
#include "lab/record.h"
#include "program/run.h"

namespace strobe::testing {
namespace exr_test {

// A moving bar whose edges are within pixels.
const std::string kShot =
    " --scene oracles/bar --size 64x36 --fps 30 --exposure 0.75 --set scene.width=64 --set scene.height=36"
    " --set scene.left=20.4 --set scene.right=41.6";

class Exr : public ::testing::Test {
 protected:
  // Path of a picture of the shot drawn with these options.
  std::string drawn(const std::string& pipeline, const std::string& options) {
    std::string file = folder_ / "picture.exr";
    Outcome outcome = run("render " + pipeline + kShot + " " + options + " -o " + file);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    errors_ = outcome.err;
    return file;
  }
  Json record() const { return Json::parse(contentOf(folder_ / "picture.record.json")); }

  // Result of exr_reference.py, run with the first Python that has the modules.
  static std::optional<Json> reference(const std::string& what, const std::string& file) {
    std::string script = (sourceFolder() / "tests/program/exr_reference.py").string();
    for (const char* python : {"python3", "/usr/bin/python3"}) {
      if (runLine(std::string(python) + " -c 'import numpy, OpenImageIO'").exit_code != 0) continue;
      Outcome outcome = runLine(fmt::format("{} '{}' {} '{}'", python, script, what, file));
      EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
      return Json::parse(outcome.out);
    }
    return std::nullopt;
  }

  TemporaryFolder folder_;
  std::string errors_;
};

std::string typeOf(image::ExrKind kind) {
  if (kind == image::ExrKind::uint) return "uint";
  return kind == image::ExrKind::half ? "half" : "float";
}

// Hash of a channel as in `exr_reference.py`.
std::string hashOf(const image::ExrChannel& channel) {
  auto text = [](const auto& values) {
    return std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof values[0]);
  };
  return sha256(channel.kind == image::ExrKind::uint ? text(channel.ids) : text(channel.values));
}

// OpenImageIO and Strobe's reader find the same content.
void expectTheSame(const Json& found, const image::ExrFile& read) {
  ASSERT_EQ(found.size(), read.parts().size());
  for (size_t i = 0; i < found.size(); ++i) {
    const image::ExrPart& part = *read.parts()[i];
    EXPECT_EQ(found[i]["name"], part.name);
    EXPECT_EQ(found[i]["size"], Json({part.width, part.height})) << part.name;
    EXPECT_EQ(found[i]["full"], Json({read.width, read.height})) << part.name;
    EXPECT_EQ(found[i]["channels"].size(), part.channels.size()) << part.name;
    for (const image::ExrChannel& channel : part.channels) {
      ASSERT_TRUE(found[i]["channels"].contains(channel.name)) << channel.name << " " << found[i]["channels"].dump();
      EXPECT_EQ(found[i]["channels"][channel.name]["type"], typeOf(channel.kind)) << channel.name;
      EXPECT_EQ(found[i]["channels"][channel.name]["sha256"], hashOf(channel)) << channel.name;
    }
    for (const auto& [name, text] : part.texts) EXPECT_EQ(found[i]["attributes"][name], text) << name;
  }
}

TEST_F(Exr, OpenImageIoReadsOnePart) {
  std::string file = drawn("mcguire2012", "--tap gbuffer.depth --cryptomatte");
  auto found = reference("parts", file);
  if (!found) GTEST_SKIP() << "no Python with NumPy and OpenImageIO (python3-openimageio)";
  expectTheSame(*found, image::readExr(file));
  const Json& channels = (*found)[0]["channels"];
  for (const char* name : {"R", "G", "B", "A", "Z", "velocity.X", "velocity.Y", "N.X", "N.Y", "N.Z", "gbuffer.depth.Y",
                           "CryptoObject00.R", "CryptoMaterial02.A", "coverage.Y"})
    EXPECT_EQ(channels[name]["type"], "float") << name;
  for (const char* name : {"id", "geometry"}) EXPECT_EQ(channels[name]["type"], "uint") << name;
  const Json& attributes = (*found)[0]["attributes"];
  EXPECT_EQ(attributes["compression"], "zip");
  EXPECT_FALSE(attributes.contains("DateTime")) << attributes.dump();
  EXPECT_NEAR(attributes["ExposureTime"].get<double>(), 0.75 / 30, 1e-7);
  EXPECT_EQ(attributes["shutterAngle"], 270);
  EXPECT_EQ(attributes["framesPerSecond"], Json({30, 1}));
  EXPECT_EQ(attributes["worldToCamera"].size(), 16u);
  EXPECT_EQ(attributes["worldToNDC"].size(), 16u);
  EXPECT_EQ(Json::parse(attributes["strobe"].get<std::string>())["shot"]["exposure"], 0.75);
}

// The file has the images with the hashes in the record.
TEST_F(Exr, OpenImageIoReadsParts) {
  std::string taps = "--tap neighbour_max.dominant --tap tile_max.longest --tap mask_bounds.bounds --tap ray_reveal.id";
  std::string file = drawn("hybrid_layered", "--multipart --cryptomatte " + taps);
  image::ExrFile read = image::readExr(file);
  std::set<std::string> sizes;
  for (const image::ExrPart* part : read.parts()) sizes.insert(fmt::format("{}x{}", part->width, part->height));
  EXPECT_TRUE(sizes.count("64x36") && sizes.count("7x4")) << fmt::format("{}", fmt::join(sizes, " "));
  EXPECT_GE(sizes.size(), 3u);
  auto images = lab::imagesOf(read, file);
  Json known = record();
  for (const char* kind : {"outputs", "taps"})
    for (const auto& [name, hash] : known[kind].items()) EXPECT_EQ(Json(lab::hashOf(images.at(name))), hash) << name;
  auto found = reference("parts", file);
  if (!found) GTEST_SKIP() << "no Python with NumPy and OpenImageIO (python3-openimageio)";
  expectTheSame(*found, read);
  EXPECT_EQ((*found)[0]["name"], "color");
  for (const Json& part : *found) EXPECT_NEAR(part["attributes"]["ExposureTime"].get<double>(), 0.75 / 30, 1e-7);
}

// Float channels have 16 bits; ids and mattes keep 32 bits.
TEST_F(Exr, OpenImageIoReadsHalfFloats) {
  std::string file = drawn("none", "--half --cryptomatte");
  auto found = reference("parts", file);
  if (!found) GTEST_SKIP() << "no Python with NumPy and OpenImageIO (python3-openimageio)";
  expectTheSame(*found, image::readExr(file));
  for (const auto& [name, channel] : (*found)[0]["channels"].items()) {
    bool matte = name.starts_with("Crypto") || name.starts_with("coverage");
    EXPECT_EQ(channel["type"], name == "id" || name == "geometry" ? "uint" : matte ? "float" : "half") << name;
  }
}

TEST_F(Exr, IndependentDecoderReadsMattes) {
  for (const char* options : {"", "--multipart", "--aa 5", "--aa 5 --multipart"}) {
    bool several = std::string(options).find("--aa") != std::string::npos;
    auto found = reference("mattes", drawn("none", std::string("--cryptomatte ") + options));
    if (!found) GTEST_SKIP() << "no Python with NumPy and OpenImageIO (python3-openimageio)";
    ASSERT_EQ(found->size(), 2u) << found->dump();
    for (const auto& [kind, mattes] : found->items()) {
      EXPECT_EQ(mattes["hash"], "MurmurHash3_32");
      EXPECT_EQ(mattes["conversion"], "uint32_to_float32");
      EXPECT_EQ(mattes["names"], Json({"background", "bar"})) << kind;
      EXPECT_EQ(mattes["sorted"], true) << kind << options;
      EXPECT_EQ(mattes["unnamed"], 0) << kind << options;
      EXPECT_LE(mattes["sum"].get<double>(), 1e-6) << kind << options;
      EXPECT_EQ(mattes["missing"], 0) << kind << options;
      if (several) EXPECT_GE(mattes["partial"].get<int>(), 36) << kind << options;
      else EXPECT_EQ(mattes["difference"], 0) << kind << options;
    }
  }
}

// exrheader is a program of the OpenEXR library.
TEST_F(Exr, ExrheaderReadsIt) {
  if (runLine("command -v exrheader").exit_code != 0) GTEST_SKIP() << "no exrheader (the package openexr)";
  Outcome outcome = runLine("exrheader '" + drawn("mcguire2012", "--multipart --tap tile_max.longest") + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* line :
       {"type (type string): \"scanlineimage\"", "name (type string): \"tile_max.longest\"", "id, 32-bit unsigned",
        "Z, 32-bit floating-point", "velocity.Y, 32-bit floating-point", "worldToCamera (type m44f)",
        "framesPerSecond (type rational): 30/1", "strobeFormat (type string): \"rg32ui\""})
    EXPECT_NE(outcome.out.find(line), std::string::npos) << line << "\n" << outcome.out.substr(0, 4000);
}

// A layer of another size (bounds of 10 px cells) is compared by its name.
TEST_F(Exr, CompareReadsALayer) {
  std::string file = drawn("hybrid_layered", "--multipart --tap mask_bounds.bounds");
  for (const char* layer : {"mask_bounds.bounds", "color"}) {
    Outcome outcome = run(fmt::format("compare --json {} {} --layer {}", file, file, layer));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(Json::parse(outcome.out)["pixels"], std::string(layer) == "color" ? 64 * 36 : 7 * 4);
  }
  Outcome missing = run(fmt::format("compare {} {} --layer mask_bounds.bound", file, file));
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.err.find("has no colour in a layer 'mask_bounds.bound'"), std::string::npos) << missing.err;
}

TEST_F(Exr, ExrOptionsNeedAnExrFile) {
  for (const char* option : {"--half", "--multipart", "--cryptomatte"}) {
    Outcome outcome = run("render none" + kShot + " " + option + " -o " + (folder_ / "picture.png"));
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("need an .exr file"), std::string::npos) << outcome.err;
  }
  writeText(folder_ / "bare.lua", R"lua(
local pipeline = require "strobe.pipeline"
local scene = require "scripts.pipelines.lib.scene"
return pipeline { doc = "no ids", build = function() return { color = scene.raster().color } end }
)lua");
  Outcome outcome = run("render " + (folder_ / "bare.lua") + kShot + " --cryptomatte -o " + (folder_ / "bare.exr"));
  EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
  EXPECT_NE(outcome.err.find("has no output 'id' of integers"), std::string::npos) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "bare.exr"));
}

}  // namespace exr_test
}  // namespace strobe::testing
