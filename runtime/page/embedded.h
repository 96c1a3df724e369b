// SPDX-License-Identifier: MIT
// Files of runtime/page/assets/, embedded at build time (runtime/page/embed.cmake writes the table).
#pragma once

#include <span>
#include <string_view>

namespace strobe::page {

// Style sheet, script or other asset of the HTML pages, as bytes in the program.
struct EmbeddedFile {
  std::string_view name, content;
};

std::span<const EmbeddedFile> embeddedFiles();

}  // namespace strobe::page
