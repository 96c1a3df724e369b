// SPDX-License-Identifier: MIT
// The line of a key in the source of a table: Lua knows the line of a call, not of the fields in its braces.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace strobe::script {

// `path` {"reads", "depth"} is the field `depth` of the field `reads` of the table that opens on `line` or the next.
// The line of its last key, or of the last one that the source shows, or `line` itself.
int lineOfKey(std::string_view source, int line, const std::vector<std::string>& path);

// The same for the table behind the last `return` on the lines first..last; without a path the line of that `return`,
// 0 when there is none.
int lineOfReturn(std::string_view source, int first, int last, const std::vector<std::string>& path);

// Whether the source reads a field `name` of anything: x.name.
bool readsField(std::string_view source, std::string_view name);

}  // namespace strobe::script
