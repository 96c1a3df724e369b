// SPDX-License-Identifier: MIT
// Runs the program like a user: exit code, standard output and standard error.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "base/process.h"
#include "common/temporary_folder.h"

namespace strobe::testing {

namespace fs = std::filesystem;

struct Outcome {
  int exit_code = -1;  // 128 + signal for a crash
  std::string out, err;
};

inline std::string contentOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void writeText(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

inline std::string programPath() {
  const char* program = std::getenv("STROBE_PROGRAM");
  return program ? program : "strobe";
}

// A scene for 64 x 36 px: a red card that moves 6 px per 0.6 m in front of a checkerboard.
inline const char* const kCardScene = R"lua(
local scene = require "strobe.scene"
local red = scene.material { color = { 0.8, 0.1, 0.1 }, unlit = true }
local checker = scene.texture.checker { colors = { { 0.9, 0.9, 0.9 }, { 0.1, 0.1, 0.4 } }, count = 8 }
local wall = scene.material { color_texture = checker, unlit = true }
return scene { name = "small", nodes = {
  scene.node { name = "card", shape = scene.quad { size = { 1, 1 } }, material = red },
  scene.node { name = "wall", shape = scene.quad { size = { 8, 8 } }, material = wall, position = { 0, 0, -1 } },
  scene.node { name = "eye", camera = scene.camera { name = "main", fov = 60 }, position = { 0, 0, 2 } },
} }
)lua";

// Runs a shell line.
inline Outcome runLine(const std::string& line, const std::vector<std::string>& environment = {}) {
  ProgramEnd end = strobe::run({.arguments = {"sh", "-c", line}, .environment = environment, .wall_s = 600});
  return {end.code(), end.output, end.errors};
}

// `arguments` as in a shell; `environment` like "NAME=value NAME2=value2". Validation is on unless `environment` sets
// it.
inline Outcome run(const std::string& arguments, const std::string& environment = "STROBE_VALIDATION=1") {
  return runLine("exec env " + environment + " '" + programPath() + "' " + arguments);
}

// Folder of a command's copy of the home; "" if it does not exist.
inline fs::path copyIn(const fs::path& out) {
  std::error_code missing;
  for (const auto& entry : fs::directory_iterator(out, missing))
    if (entry.path().filename().string().starts_with(".inputs.")) return entry.path();
  return {};
}

// Starts a thread that damages `files` after a command has copied them to its folder `out`.
inline std::thread spoilOnceCopied(const fs::path& folder, const fs::path& out, std::vector<std::string> files) {
  return std::thread([folder, out, files = std::move(files)] {
    fs::path copies;
    auto isCopied = [&](const std::string& file) { return contentOf(copies / file) == contentOf(folder / file); };
    for (int waited = 0; waited < 30000; ++waited) {
      copies = copyIn(out) / "0";
      if (std::all_of(files.begin(), files.end(), isCopied)) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    for (const std::string& file : files) writeText(folder / file, "error 'edited'");
  });
}

}  // namespace strobe::testing
