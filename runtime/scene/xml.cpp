// SPDX-License-Identifier: MIT
#include "scene/xml.h"

#include <fmt/format.h>

namespace strobe::scene {

// XML allows no control characters except tab and line ends.
static char allowed(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r' ? '?' : c;
}

static std::string escaped(std::string_view text) {
  std::string result;
  for (char c : text) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '"') result += "&quot;";
    else if (c == '\t' || c == '\n' || c == '\r') result += fmt::format("&#{};", int(c));
    else result += allowed(c);
  }
  return result;
}

std::string Xml::text(const Attributes& attributes) {
  std::string result;
  for (const auto& [name, value] : attributes) result += fmt::format(" {}=\"{}\"", name, escaped(value));
  return result;
}

void Xml::line(const std::string& text) { document_ += std::string(2 * open_.size(), ' ') + text + "\n"; }

void Xml::open(const std::string& tag, const Attributes& attributes) {
  line("<" + tag + text(attributes) + ">");
  open_.push_back(tag);
}

void Xml::close() {
  const std::string tag = open_.back();
  open_.pop_back();
  line("</" + tag + ">");
}

void Xml::comment(std::string_view text) {
  std::string result;
  for (char c : text)
    if (c != '-' || result.empty() || result.back() != '-') result += allowed(c);
  line("<!-- " + result + " -->");
}

}  // namespace strobe::scene
