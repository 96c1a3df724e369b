// SPDX-License-Identifier: MIT
// Mustache templates filled from JSON, and the embedded files of runtime/page/assets/.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/json_fwd.h"

namespace strobe::page {

// Names and contents of the files of assets/, embedded at build time (runtime/page/embed.cmake writes the table).
using EmbeddedFile = std::pair<std::string_view, std::string_view>;
std::span<const EmbeddedFile> embeddedFiles();

// Content of a file of assets/. Asserts that the file exists.
std::string_view asset(std::string_view name);

// Template `name`, filled with `values`, an object. Sections are off for null, false, "" and empty lists; numbers are
// written by fmt.
std::string rendered(std::string_view name, const Json& values);

}  // namespace strobe::page
