// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <regex>

#include "repo/lint.h"

namespace strobe::repo {

// Statements of a class body, each up to its ';' or its own body; without the statements of nested types.
static std::vector<std::string> statementsIn(const std::string& text, size_t body) {
  std::vector<std::string> statements = {""};
  int depth = 1;
  for (size_t at = body; at < text.size() && depth > 0; ++at) {
    char c = text[at];
    bool ends = c == '}' ? depth == 2 : c == ';' && depth == 1;
    if (c == '{') ++depth;
    else if (c == '}') --depth;
    else if (depth == 1 && c != ';') statements.back() += c == '\n' ? ' ' : c;
    if (ends) statements.push_back("");
  }
  return statements;
}

static bool isMethod(std::string statement) {
  static const std::regex no_method("^\\s*(struct|class|enum|union|using|typedef|friend)\\b");
  static const std::regex arguments("<[^<>]*>"), method("^[^=(]*(\\w|operator\\W+)\\(");
  statement = std::regex_replace(statement, std::regex("\\b(public|protected|private)\\s*:"), "");
  if (std::regex_search(statement, no_method)) return false;
  for (std::string before; before != statement;) {
    before = statement;
    statement = std::regex_replace(statement, arguments, "");
  }
  return std::regex_search(statement, method);
}

Findings lintClasses(const std::vector<Source>& sources, int most) {
  static const std::regex comment("//[^\n]*"), begin("\\b(class|struct)\\s+(\\w+)[^;{}()<>]*\\{");
  Findings findings;
  for (const Source& source : sources) {
    if (!source.path.starts_with("runtime/") || !source.path.ends_with(".h")) continue;
    std::string text = std::regex_replace(source.text, comment, "");
    for (auto found = std::sregex_iterator(text.begin(), text.end(), begin); found != std::sregex_iterator(); ++found) {
      std::vector<std::string> statements = statementsIn(text, size_t(found->position() + found->length()));
      auto methods = std::count_if(statements.begin(), statements.end(), isMethod);
      auto line = 1 + std::count(text.begin(), text.begin() + found->position(), '\n');
      if (methods > most)
        findings.push_back(fmt::format("{}:{}: {} has {} methods, at most {} may it have", source.path, line,
                                       found->str(2), methods, most));
    }
  }
  return findings;
}

}  // namespace strobe::repo
