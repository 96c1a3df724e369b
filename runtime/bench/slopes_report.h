// SPDX-License-Identifier: MIT
// Report of slopes and demands: text for a terminal, and a page.
#pragma once

#include "bench/demand.h"
#include "bench/slopes.h"
#include "page/page.h"

namespace strobe::bench {

// Data of a report on scaling: timed runs along each axis, fitted lines, and the bandwidth and ray demand on a GPU.
struct Slopes {
  std::string command, title, question;
  std::vector<AxisRun> axes;           // at least one
  std::vector<std::vector<Fit>> fits;  // of each axis
  std::vector<Demand> demands;
  Gpu gpu;
};

Json toJson(const Slopes& slopes);

// For each axis the frames, the passes with an expectation by name, and the passes that fail their expectation.
std::string textOf(const Slopes& slopes);

// Self-contained page. For each axis: a chart of the frames with their lines, the same table, and a table of all
// passes.
page::Page pageOf(const Slopes& slopes);

}  // namespace strobe::bench
