// SPDX-License-Identifier: MIT
// A copy of the project's passes, shaders and scripts that a test may edit while a session uses the copy.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "lab/session.h"

namespace strobe::session {

// Ways of saving in an editor.
enum class Save { InPlace, Rename, Twice };

// Only one may exist at a time: its folder is the same for the whole test program.
class EditableHome {
 public:
  static Home home();
  EditableHome();
  ~EditableHome();
  EditableHome(const EditableHome&) = delete;
  EditableHome& operator=(const EditableHome&) = delete;

  static Path path(const std::string& file) { return home().shipped() / file; }
  std::string read(const std::string& file) const { return readText(path(file)); }
  void write(const std::string& file, const std::string& text, Save save = Save::InPlace) const;
  void remove(const std::string& file) const;
  // Replaces the first `from` in a file; a missing `from` fails the test.
  void edit(const std::string& file, const std::string& from, const std::string& to, Save save = Save::InPlace) const;
  // Texts of all files below passes, shaders and scripts, by name.
  std::map<std::string, std::string> all() const;
};

// One device with validation serves the tests of a program; a message fails the test that caused it.
class SessionTest : public ::testing::Test {
 protected:
  void TearDown() override;
  static lab::Workbench& bench();

  EditableHome home_;
};

// A small picture of two moving bars that every pipeline can blur.
lab::Shot smallShot(const std::string& pipeline, int width = 64, int height = 36);

// The pipeline "running_mean": the mean of all frames since its creation, each with `weight`, and their "sum".
void writeRunningMean(const EditableHome& home);

// Hash of every output, by name.
std::map<std::string, std::string> hashes(const graph::FrameResult& frame);
std::string colorHash(lab::Session& session);

std::string joined(const std::vector<std::string>& lines);

}  // namespace strobe::session
