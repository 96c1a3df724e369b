// SPDX-License-Identifier: MIT
// Reference pages in Markdown, from the declarations of passes and pipelines: the files below docs/reference and the
// output of `strobe help`.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/home.h"
#include "base/json.h"
#include "plan/description.h"

namespace strobe::lab {

// One Markdown page of the generated reference: its relative path and its text.
struct ReferencePage {
  std::string path;  // relative to the folder of the pages: "passes/tile/largest.md"
  std::string text;
};

// Pages of every pass and pipeline of the home folder, and the index. Throws `Error` for an invalid declaration.
std::vector<ReferencePage> referencePages(const Home& home);

// Writes the reference pages below `folder`. Removes pages whose pass or pipeline no longer exists.
void writeReference(const Home& home, const Path& folder);

// All topics, one line each.
std::string helpTopics(const Home& home);

// Help on a pass ("tile_largest", "tile/largest" or "largest"), a pipeline, or a parameter of either
// ("tile_largest.tile"). A parameter name alone selects all pipelines that have it. Throws `Error` (exit code 2) with
// the nearest topic for any other topic.
std::string helpOn(const Home& home, const std::string& topic);

// Declarations as JSON: of one pass or pipeline; for "" of all. Throws `Error` (exit code 2) with the nearest topic for
// any other topic.
Json helpJson(const Home& home, const std::string& topic);

}  // namespace strobe::lab
