// SPDX-License-Identifier: MIT
// JSON values that keep the order of their keys.
#pragma once

#include <nlohmann/json.hpp>

#include "base/json_fwd.h"
