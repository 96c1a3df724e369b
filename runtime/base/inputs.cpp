// SPDX-License-Identifier: MIT
#include "base/inputs.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include "base/hash.h"

namespace strobe {

namespace {

constexpr size_t kNone = std::string::npos;

// Position after the next `close` from `at` on; the end of the text if there is no `close`.
size_t behind(const std::string& text, const std::string& close, size_t at) {
  size_t found = text.find(close, at);
  return found == kNone ? text.size() : found + close.size();
}

size_t endOfLine(const std::string& text, size_t at) { return std::min(text.find('\n', at), text.size()); }

// Position after the long bracket "[==[ ... ]==]" that begins at `at`; std::nullopt without one.
std::optional<size_t> behindLongBracket(const std::string& text, size_t at) {
  if (at >= text.size() || text[at] != '[') return std::nullopt;
  size_t second = text.find_first_not_of('=', at + 1);
  if (second == kNone || text[second] != '[') return std::nullopt;
  return behind(text, "]" + std::string(second - at - 1, '=') + "]", second + 1);
}

// Position after the Lua string that begins at `at`; `at` without one.
size_t behindString(const std::string& text, size_t at) {
  const char quote = text[at];
  if (quote != '"' && quote != '\'') return behindLongBracket(text, at).value_or(at);
  for (++at; at < text.size() && text[at] != quote; ++at) at += text[at] == '\\';
  return std::min(at + 1, text.size());
}

size_t behindBlanks(const std::string& text, size_t at) {
  return std::min(text.find_first_not_of(" \t\r\n", at), text.size());
}

bool isWordCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// Strings joined by "..", from the string that begins at `at`. `end`: position after the last string; `at` without one.
// `is_prose`: one of the quoted strings has three words or more.
struct Joined {
  size_t end;
  bool is_prose = false;
};

Joined joinedStrings(const std::string& text, size_t at) {
  Joined joined{at};
  for (size_t string = at, end; string < text.size() && (end = behindString(text, string)) > string;) {
    const auto first = text.begin() + std::ptrdiff_t(string), last = text.begin() + std::ptrdiff_t(end);
    joined.is_prose = joined.is_prose || (text[string] != '[' && std::count(first, last, ' ') >= 2);
    joined.end = end;
    const size_t dots = behindBlanks(text, end);
    if (text.compare(dots, 2, "..") != 0) break;
    string = behindBlanks(text, dots + 2);
  }
  return joined;
}

// Position after the text for people that begins at `at`: a field `doc` or `fails`, or strings with prose; `at` without
// one.
size_t behindProse(const std::string& text, size_t at) {
  if (const Joined joined = joinedStrings(text, at); joined.is_prose) return joined.end;
  if (at > 0 && isWordCharacter(text[at - 1])) return at;
  for (const std::string field : {"doc", "fails"}) {
    size_t equals = behindBlanks(text, at + field.size());
    if (text.compare(at, field.size(), field) != 0 || text.compare(equals, 1, "=") != 0) continue;
    const size_t value = behindBlanks(text, equals + 1);
    const Joined joined = joinedStrings(text, value);
    if (joined.end > value) return joined.end;
  }
  return at;
}

// Position after the comment that begins at `at`; `at` without one.
size_t behindComment(const std::string& text, Language language, size_t at) {
  auto is = [&](const char* mark) { return text.compare(at, 2, mark) == 0; };
  if (language == Language::lua) return is("--") ? behindLongBracket(text, at + 2).value_or(endOfLine(text, at)) : at;
  return is("//") ? endOfLine(text, at) : is("/*") ? behind(text, "*/", at + 2) : at;
}

std::optional<Language> languageOf(const Path& file) {
  const Path ending = file.extension();
  if (ending == ".lua") return Language::lua;
  if (ending == ".glsl" || ending == ".h") return Language::glsl;
  return std::nullopt;
}

// Lines without blanks at their ends, and without empty lines.
std::string withoutBlankEnds(const std::string& text) {
  std::string lines;
  for (size_t at = 0, end; at < text.size(); at = end + 1) {
    end = endOfLine(text, at);
    std::string line = text.substr(at, end - at);
    line.resize(line.find_last_not_of(" \t\r") + 1);
    if (!line.empty()) lines += line + "\n";
  }
  return lines;
}

// Code without the blanks that separate no words.
std::string withoutBlanks(const std::string& text) {
  std::string code;
  for (size_t at = 0; at < text.size();) {
    const size_t next = behindBlanks(text, at);
    const bool separates =
        !code.empty() && isWordCharacter(code.back()) && next < text.size() && isWordCharacter(text[next]);
    if (next > at && separates) code += ' ';
    if (next < text.size()) code += text[next];
    at = next + 1;
  }
  return code;
}

}  // namespace

std::string withoutComments(const std::string& text, Language language) {
  std::string code;
  for (size_t at = 0; at < text.size();) {
    size_t ignored = behindComment(text, language, at);
    if (language == Language::lua) ignored = std::max(ignored, behindProse(text, at));
    if (ignored > at) {
      code += ' ', at = ignored;
      continue;
    }
    size_t end = language == Language::lua ? behindString(text, at) : at;
    end = std::max(end, at + 1);
    code.append(text, at, end - at), at = end;
  }
  return code;
}

std::string inputHash(const Path& file) {
  const std::string text = readText(file);
  const std::optional<Language> language = languageOf(file);
  if (!language) return sha256(text);
  const std::string code = withoutComments(text, *language);
  return sha256(*language == Language::lua ? withoutBlanks(code) : withoutBlankEnds(code));
}

}  // namespace strobe
