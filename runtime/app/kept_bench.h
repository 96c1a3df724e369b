// SPDX-License-Identifier: MIT
// Workbench of this process, made for the first command that draws and kept for later commands.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lab/kept_drawings.h"

namespace strobe::app {

// Workbench with the device of the last request. `strobe serve` keeps it from one command to the next.
class KeptBench {
 public:
  explicit KeptBench(const Home& home) : home_(home) {}

  // Workbench on `device` with its drawings, and with a time limit of a submission in seconds. A request for another
  // device makes another workbench. Throws `Error` without a sufficient device.
  lab::KeptDrawings& on(const std::string& device, double time_limit_s);

 private:
  const Home& home_;
  std::string device_;
  std::unique_ptr<lab::Workbench> bench_;
  std::optional<lab::KeptDrawings> drawings_;
};

}  // namespace strobe::app
