// SPDX-License-Identifier: MIT
#include "app/kept_bench.h"

#include "app/shot_options.h"
#include "script/server.h"

namespace strobe::app {

lab::KeptDrawings& KeptBench::on(const std::string& device, double time_limit_s) {
  if (!bench_ || device != device_) {
    // Start the script server while the device is created.
    script::startServer(home_);
    drawings_.reset();
    bench_.reset();
    bench_ = std::make_unique<lab::Workbench>(home_, device, validationWanted());
    drawings_.emplace(*bench_);
    device_ = device;
  }
  bench_->device().setTimeLimit(time_limit_s);
  return *drawings_;
}

}  // namespace strobe::app
