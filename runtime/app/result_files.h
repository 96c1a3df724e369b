// SPDX-License-Identifier: MIT
// Results of an experiment as files: numbers, tables, page, figures.
#pragma once

#include "study/results.h"

namespace strobe::app {

// Names of the result files in their folder. An empty `sheet` is not written.
struct ResultNames {
  std::string page = "report.html", sheet = "report.png", results = "result.json", text = "result.md",
              table = "table.csv", passes = "passes.csv";
  std::string outline =
      "unfinished.json";  // of an unfinished run: every point; the numbers drawn so far are in the folder "points"
};

// Writes the result files and returns their paths. `still`: the page has figures and tables, without points to click.
std::vector<Path> writeResults(const study::Results& results, const Path& folder, const ResultNames& names = {},
                               bool still = false);

}  // namespace strobe::app
