// SPDX-License-Identifier: MIT
// Text in a subset of Markdown's inline notation: `code`, **strong** and [text](address). One text serves terminal,
// documents and pages. All other characters stand for themselves.
#pragma once

#include <string>
#include <string_view>

namespace strobe::page {

// Replaces <, >, &, " and ' by entities; the result is safe as text and as the value of an attribute.
std::string escaped(std::string_view text);

// Converts to HTML with <code>, <strong> and <a>, and escapes all else. A link leads to a place in the page (#x), a
// file beside the page or the web (http, https, mailto); links to other addresses (javascript:) stay text.
std::string inlineHtml(std::string_view text);

// Text for a terminal: keeps `code` as written, and drops the marks of **strong** and the address of [text](address).
std::string inlinePlain(std::string_view text);

}  // namespace strobe::page
