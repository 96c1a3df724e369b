// SPDX-License-Identifier: MIT
// The results of an experiment as files: numbers, tables, page, figures.
#pragma once

#include "study/results.h"

namespace strobe::app {

// The files that results consist of, by the names they have in their folder; "" for a sheet that is not written.
struct ResultNames {
  std::string page = "report.html", sheet = "report.png", results = "result.json", text = "result.md",
              table = "table.csv", passes = "passes.csv";
  std::string outline =
      "unfinished.json";  // while they are made: every point, of which numbers are in the folder's points
};

// Writes them and gives their names. `still`: the page has figures and tables, without points to click through.
std::vector<Path> writeResults(const study::Results& results, const Path& folder, const ResultNames& names = {},
                               bool still = false);

}  // namespace strobe::app
