// SPDX-License-Identifier: MIT
#include "session/home.h"

#include <unistd.h>

#include <fstream>

#include "common/source.h"
#include "lab/record.h"

namespace strobe::session {

namespace fs = std::filesystem;

Home EditableHome::home() {
  const Home own = Home::fromEnvironment();
  return Home({fs::temp_directory_path() / fmt::format("strobe_session_{}", ::getpid())}, own.data(), own.program());
}

EditableHome::EditableHome() {
  for (const char* part : {"passes", "shaders", "scripts"}) {
    fs::create_directories(path(part));
    fs::copy(sourceFolder() / part, path(part), fs::copy_options::recursive);
  }
}

EditableHome::~EditableHome() {
  std::error_code ignored;
  fs::remove_all(home().shipped(), ignored);
}

static void writePlain(const Path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

void EditableHome::write(const std::string& file, const std::string& text, Save save) const {
  Path target = path(file);
  fs::create_directories(target.parent_path());
  if (save == Save::Rename) {
    Path other = target.string() + "~";
    writePlain(other, text);
    fs::rename(other, target);
    return;
  }
  if (save == Save::Twice) writePlain(target, text.substr(0, text.size() / 2));
  writePlain(target, text);
}

void EditableHome::remove(const std::string& file) const { fs::remove(path(file)); }

void EditableHome::edit(const std::string& file, const std::string& from, const std::string& to, Save save) const {
  std::string text = read(file);
  size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << file << " does not contain: " << from;
  write(file, text.replace(at, from.size(), to), save);
}

std::map<std::string, std::string> EditableHome::all() const {
  std::map<std::string, std::string> texts;
  for (const char* part : {"passes", "shaders", "scripts"})
    for (const auto& entry : fs::recursive_directory_iterator(path(part)))
      if (entry.is_regular_file()) texts[entry.path().lexically_relative(home().shipped())] = readText(entry.path());
  return texts;
}

namespace {

std::unique_ptr<lab::Workbench> the_bench;

// The device must be destroyed before the libraries that created it.
class BenchEnvironment : public ::testing::Environment {
 public:
  void TearDown() override { the_bench.reset(); }
};
const ::testing::Environment* const kEnvironment = ::testing::AddGlobalTestEnvironment(new BenchEnvironment);

}  // namespace

lab::Workbench& SessionTest::bench() {
  if (!the_bench) the_bench = std::make_unique<lab::Workbench>(EditableHome::home(), "", true);
  return *the_bench;
}

void SessionTest::TearDown() {
  if (!the_bench) return;
  for (const std::string& message : the_bench->device().takeMessages()) ADD_FAILURE() << "validation: " << message;
}

lab::Shot smallShot(const std::string& pipeline, int width, int height) {
  lab::Shot shot;
  shot.pipeline = pipeline;
  shot.scene = "oracles/textured_bar";
  shot.width = width;
  shot.height = height;
  shot.frame = 0;
  // Front and back move differently, so every mask marks pixels and every layer has pixels.
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{{"width", width},
                                                                                         {"height", height},
                                                                                         {"left", width * 3 / 8},
                                                                                         {"right", width * 11 / 16},
                                                                                         {"d_f", 5},
                                                                                         {"d_b", -3}})
    shot.sets.push_back({std::string("scene.") + name, fmt::format("{}", value)});
  return shot;
}

void writeRunningMean(const EditableHome& home) {
  home.write("passes/test/running_mean.lua", R"(local pass = require "strobe.pass"
return pass.compute {
  name = "running_mean", shader = "test/running_mean", doc = "mean of all frames so far",
  reads = { color = { doc = "linear" } },
  writes = { color = { format = "rgba32f", doc = "mean" } },
  updates = { sum = { format = "rgba32f", doc = "sum; a = weight of the frames", history = true } },
  params = { weight = pass.float { 1, min = 0, max = 10, doc = "of every frame" } },
}
)");
  home.write("shaders/test/running_mean.glsl", R"(void run(ivec2 pixel) {
  vec4 color = texelFetch(color_tex, pixel, 0);
  vec4 sum = imageLoad(sum_img, pixel) + params.weight * vec4(color.rgb, 1);
  imageStore(sum_img, pixel, sum);
  imageStore(color_img, pixel, vec4(sum.rgb / max(sum.a, 1e-6), 1));
}
)");
  home.write("scripts/pipelines/running_mean.lua",
             readText(sourceFolder() / "tests/session/pipelines/running_mean.lua"));
}

std::map<std::string, std::string> hashes(const graph::FrameResult& frame) {
  std::map<std::string, std::string> hashes;
  for (const auto& [name, image] : frame.outputs) hashes[name] = lab::hashOf(image);
  return hashes;
}

std::string colorHash(lab::Session& session) {
  std::set<std::string> wanted = {"color"};
  return lab::hashOf(session.draw(&wanted).outputs.at("color"));
}

std::string joined(const std::vector<std::string>& lines) { return fmt::format("{}", fmt::join(lines, "\n")); }

}  // namespace strobe::session
