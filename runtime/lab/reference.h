// SPDX-License-Identifier: MIT
// Reference pages, in Markdown, from what passes and pipelines declare: the files below docs/reference and what
// `strobe help` prints.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/home.h"
#include "plan/description.h"

namespace strobe::lab {

struct ReferencePage {
  std::string path;  // "passes/tile/largest.md", relative to the folder of the pages
  std::string text;
};

// The page of a pass: what it computes, where it fails, what it reads and writes, its parameters, names in GLSL.
std::string passPage(const plan::PassDesc& pass);

// Every pass, every pipeline and the index, of the home folder as it is. Throws `Error` for what is unsound.
std::vector<ReferencePage> referencePages(const Home& home);

// Writes them below `folder`; removes pages there whose pass or pipeline is gone.
void writeReference(const Home& home, const Path& folder);

// The command that brings the pages that ship up to date.
inline const char* const kReferenceCommand = "strobe help --write docs/reference";

// All topics, a line each.
std::string helpTopics(const Home& home);

// On a pass ("tile_largest", "tile/largest" or "largest"), a pipeline, or a parameter of either ("tile_largest.tile").
// Throws `Error` with exit code 2 and the nearest topic for anything else.
std::string helpOn(const Home& home, const std::string& topic);

}  // namespace strobe::lab
