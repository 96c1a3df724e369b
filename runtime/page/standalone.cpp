// SPDX-License-Identifier: MIT
#include "page/standalone.h"

#include <fmt/format.h>

#include <map>
#include <regex>

#include "base/error.h"
#include "page/templates.h"

namespace strobe::page {

namespace {

// Custom properties of the light style by name: "--ink".
std::map<std::string, std::string> lightColours() {
  static const std::regex property(R"((--[a-z0-9-]+):\s*([^;]+);)");
  std::string style(asset("light.css"));
  std::map<std::string, std::string> colours;
  for (std::sregex_iterator at(style.begin(), style.end(), property), end; at != end; ++at)
    colours[(*at)[1]] = (*at)[2];
  return colours;
}

// Replaces every var(--NAME) by its value, because some programs do not read custom properties.
std::string resolved(const std::string& style) {
  static const std::regex use(R"(var\((--[a-z0-9-]+)\))");
  std::map<std::string, std::string> colours = lightColours();
  std::string result;
  size_t from = 0;
  for (std::sregex_iterator at(style.begin(), style.end(), use), end; at != end; ++at) {
    auto colour = colours.find((*at)[1]);
    STROBE_ASSERT(colour != colours.end(), "{}", (*at)[1].str());
    result += style.substr(from, size_t(at->position()) - from) + colour->second;
    from = size_t(at->position() + at->length());
  }
  return result + style.substr(from);
}

}  // namespace

std::string standaloneSvg(const std::string& svg) {
  static const std::regex start(R"rx(^<svg class="chart" viewBox="0 0 ([0-9]+) ([0-9]+)"([^>]*)>\n)rx");
  std::smatch found;
  STROBE_ASSERT(std::regex_search(svg, found, start), "a figure of svgOf");
  std::string style = resolved(std::string(asset("chart.css")) + ".paper { fill: var(--paper); }\n");
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"chart\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\"{2}>\n"
      "<style>\n{3}</style>\n<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n{4}",
      found[1].str(), found[2].str(), found[3].str(), style, found.suffix().str());
}

}  // namespace strobe::page
