// SPDX-License-Identifier: MIT
// JSON whose keys keep the order in which they were written.
#pragma once

#include <nlohmann/json.hpp>

#include "base/json_fwd.h"
