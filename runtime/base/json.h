// SPDX-License-Identifier: MIT
// JSON values that keep the order of their keys.
#pragma once

#include <nlohmann/json.hpp>

#include "base/json_fwd.h"

// Compiled once, in base/json_text.cpp.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
