// SPDX-License-Identifier: MIT
// Words of the canonical form, in the order of the enumerations.
#pragma once

#include <string>
#include <vector>

#include "plan/description.h"

namespace strobe::plan {

inline const std::vector<std::string> kParamTypes = {"bool", "int", "float", "choice"};
inline const std::vector<std::string> kPassKinds = {"raster", "compute", "trace"};
inline const std::vector<std::string> kSizeKinds = {"frame", "port", "fixed"};
inline const std::vector<std::string> kNodeTimes = {"raster", "shutter_open", "shutter_close", "sample"};
inline const std::vector<std::string> kNodeRuns = {"everywhere", "moving_rect", "moving_instances"};
inline const std::vector<std::string> kSampleTimes = {"midpoint", "stratified", "even", "frames", kPartTimes};

}  // namespace strobe::plan
