// SPDX-License-Identifier: MIT
// Slopes and demands for people: as text for a terminal, and as a page.
#pragma once

#include "bench/demand.h"
#include "bench/slopes.h"
#include "page/page.h"

namespace strobe::bench {

struct Slopes {
  std::string command, title, question;
  std::vector<AxisRun> axes;           // one at least
  std::vector<std::vector<Fit>> fits;  // of each axis
  std::vector<Demand> demands;
  Gpu gpu;
};

Json toJson(const Slopes& slopes);

// Of each axis the frames, and the passes for which something is expected by name or fails.
std::string textOf(const Slopes& slopes);

// Self-contained: of each axis a chart of the frames with their lines, the same table, and one of all passes.
page::Page pageOf(const Slopes& slopes);

}  // namespace strobe::bench
