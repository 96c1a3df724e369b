// SPDX-License-Identifier: MIT
// Text in a small part of Markdown's inline notation, `code`, **strong** and [text](address), so that one text serves
// terminal, documents and pages. Everything else stands for itself.
#pragma once

#include <string>
#include <string_view>

namespace strobe::page {

// <, >, &, " and ' as entities: safe as text and as the value of an attribute.
std::string escaped(std::string_view text);

// With <code>, <strong> and <a>, all else escaped. Addresses lead to a place in the page (#x), a file beside it or the
// web (http, https, mailto); others (javascript:) stay text.
std::string inlineHtml(std::string_view text);

// As a terminal shows it: `code` as it is written, **strong** and [text](address) without their marks and address.
std::string inlinePlain(std::string_view text);

}  // namespace strobe::page
