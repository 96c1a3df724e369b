// SPDX-License-Identifier: MIT
#include "session/home.h"

#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "common/source.h"
#include "lab/record.h"

namespace strobe::session {

namespace fs = std::filesystem;

EditableHome::EditableHome() {
  static int count = 0;
  folder_ = fs::temp_directory_path() / fmt::format("strobe_session_{}_{}", ::getpid(), count++);
  for (const char* part : {"passes", "shaders", "scripts"}) {
    fs::create_directories(folder_ / part);
    fs::copy(sourceFolder() / part, folder_ / part, fs::copy_options::recursive);
  }
  ::setenv("STROBE_HOME", folder_.c_str(), 1);
}

EditableHome::~EditableHome() {
  ::unsetenv("STROBE_HOME");
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
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
  ASSERT_NE(at, std::string::npos) << file << " does not say: " << from;
  write(file, text.replace(at, from.size(), to), save);
}

std::map<std::string, std::string> EditableHome::all() const {
  std::map<std::string, std::string> texts;
  for (const char* part : {"passes", "shaders", "scripts"})
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / part))
      if (entry.is_regular_file()) texts[entry.path().lexically_relative(folder_)] = readText(entry.path());
  return texts;
}

namespace {

std::unique_ptr<lab::Workbench> the_bench;

// The device must be gone before the libraries it came from are.
class BenchEnvironment : public testing::Environment {
 public:
  void TearDown() override { the_bench.reset(); }
};
const testing::Environment* const kEnvironment = testing::AddGlobalTestEnvironment(new BenchEnvironment);

}  // namespace

lab::Workbench& SessionTest::bench() {
  if (!the_bench) the_bench = std::make_unique<lab::Workbench>("", true);
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
  // Front and back move differently, so that every mask and every layer has something to do.
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, double>>{{"width", width},
                                                                                         {"height", height},
                                                                                         {"left", width * 3 / 8},
                                                                                         {"right", width * 11 / 16},
                                                                                         {"d_f", 5},
                                                                                         {"d_b", -3}})
    shot.sets.push_back({std::string("scene.") + name, fmt::format("{}", value)});
  return shot;
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
