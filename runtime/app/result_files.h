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

// Names of the files of `demo`. No sheet: the capture has its own figure.
inline const ResultNames kDemoNames = {"demo.html", "",           "demo.json",           "demo.md",
                                       "table.csv", "passes.csv", "demo.unfinished.json"};

// Names of the files of the experiment in a folder. Throws `Error` (exit code 2) if it has no experiment.
ResultNames namesIn(const Path& folder);
// File of the results in a folder, finished or not.
Path resultsFile(const Path& folder, const ResultNames& names);

// Writes the result files and returns their paths. `still`: the page has figures and tables, without points to click.
std::vector<Path> writeResults(const study::Results& results, const Path& folder, const ResultNames& names = {},
                               bool still = false);

}  // namespace strobe::app
