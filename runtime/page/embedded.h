// SPDX-License-Identifier: MIT
// The files of runtime/page/assets/, as the build found them (runtime/page/embed.cmake writes the table).
#pragma once

#include <span>
#include <string_view>

namespace strobe::page {

struct EmbeddedFile {
  std::string_view name, content;
};

std::span<const EmbeddedFile> embeddedFiles();

}  // namespace strobe::page
