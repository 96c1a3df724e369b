// SPDX-License-Identifier: MIT
// Forward declaration of JSON values.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace strobe {
using Json = nlohmann::ordered_json;
}
