// SPDX-License-Identifier: MIT
#include "mutate/glsl.h"

#include <algorithm>
#include <cctype>

namespace strobe::mutate {

namespace {

constexpr const char* kLongSigns[] = {"<<=", ">>=", "++", "--", "+=", "-=", "*=", "/=", "%=", "&=", "|=",
                                      "^=",  "<<",  ">>", "<=", ">=", "==", "!=", "&&", "||", "^^"};

bool isNameStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
bool isNamePart(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }
bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)); }

// Returns the end of the space, comment or preprocessor line that starts at `at`; returns `at` if code starts there.
size_t skipped(const std::string& text, size_t at, bool line_start) {
  auto until = [&](const char* end, size_t more) {
    size_t found = text.find(end, at);
    return found == std::string::npos ? text.size() : found + more;
  };
  if (std::isspace(static_cast<unsigned char>(text[at]))) return at + 1;
  if (text.compare(at, 2, "//") == 0) return until("\n", 0);
  if (text.compare(at, 2, "/*") == 0) return until("*/", 2);
  if (text[at] != '#' || !line_start) return at;
  size_t end = at;
  do end = text.find('\n', end + 1);
  while (end != std::string::npos && text[end - 1] == '\\');
  return end == std::string::npos ? text.size() : end;
}

size_t numberEnd(const std::string& text, size_t at) {
  size_t end = at;
  bool hex = text.compare(at, 2, "0x") == 0;
  while (end < text.size()) {
    bool exponent_sign = !hex && (text[end] == '+' || text[end] == '-') && std::tolower(text[end - 1]) == 'e';
    if (!isNamePart(text[end]) && text[end] != '.' && !exponent_sign) break;
    ++end;
  }
  return end;
}

Token tokenAt(const std::string& text, size_t at) {
  Token token;
  token.at = at;
  size_t end = at + 1;
  if (isNameStart(text[at])) {
    token.kind = Token::Kind::Name;
    while (end < text.size() && isNamePart(text[end])) ++end;
  } else if (isDigit(text[at]) || (text[at] == '.' && at + 1 < text.size() && isDigit(text[at + 1]))) {
    token.kind = Token::Kind::Number;
    end = numberEnd(text, at);
  } else {
    for (const char* sign : kLongSigns)
      if (text.compare(at, std::string_view(sign).size(), sign) == 0) {
        end = at + std::string_view(sign).size();
        break;
      }
  }
  token.text = text.substr(at, end - at);
  return token;
}

void joinBrackets(std::vector<Token>& tokens) {
  std::vector<size_t> open;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].kind != Token::Kind::Sign) continue;
    if (tokens[i].is("(") || tokens[i].is("[") || tokens[i].is("{")) open.push_back(i);
    if (open.empty() || !(tokens[i].is(")") || tokens[i].is("]") || tokens[i].is("}"))) continue;
    tokens[i].partner = int(open.back());
    tokens[open.back()].partner = int(i);
    open.pop_back();
  }
}

void fix(std::vector<Token>& tokens, size_t first, size_t last) {
  for (size_t i = first; i <= last; ++i) tokens[i].fixed = true;
}

// Fixes layout(...), struct X { ... }, and the array size of a declaration like "float x[5]".
void markDeclarations(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    auto closing = [&](size_t open) { return size_t(std::max(tokens[open].partner, int(open))); };
    if (tokens[i].is("layout") && tokens[i + 1].is("(")) fix(tokens, i, closing(i + 1));
    if (tokens[i].is("struct") && tokens[i + 2].is("{")) fix(tokens, i, closing(i + 2));
    bool named = tokens[i].kind == Token::Kind::Name && tokens[i + 1].kind == Token::Kind::Name;
    if (named && tokens[i + 2].is("[") && !tokens[i].is("return")) fix(tokens, i + 2, closing(i + 2));
  }
}

void markForHeaders(std::vector<Token>& tokens) {
  for (size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (!tokens[i].is("for") || !tokens[i + 1].is("(")) continue;
    int part = 0;
    for (int k = int(i) + 2; k < tokens[i + 1].partner; ++k) {
      if (tokens[size_t(k)].is(";")) ++part;
      else tokens[size_t(k)].for_part = part;
    }
  }
}

}  // namespace

std::vector<Token> tokensOf(const std::string& glsl) {
  std::vector<Token> tokens;
  bool line_start = true;
  for (size_t at = 0; at < glsl.size();) {
    size_t after = skipped(glsl, at, line_start);
    if (after != at) {
      line_start = line_start || glsl[at] == '\n';
      at = after;
      continue;
    }
    tokens.push_back(tokenAt(glsl, at));
    at = tokens.back().end();
    line_start = false;
  }
  joinBrackets(tokens);
  markDeclarations(tokens);
  markForHeaders(tokens);
  return tokens;
}

LinePlace placeOf(const std::string& text, size_t offset) {
  LinePlace place;
  for (size_t i = 0; i < offset && i < text.size(); ++i) {
    ++place.column;
    if (text[i] == '\n') place = {place.line + 1, 1};
  }
  return place;
}

std::string lineAt(const std::string& text, size_t offset) {
  size_t first = offset == 0 ? 0 : text.rfind('\n', offset - 1);
  first = first == std::string::npos ? 0 : first;
  size_t last = std::min(text.find('\n', offset), text.size());
  while (first < last && std::isspace(static_cast<unsigned char>(text[first]))) ++first;
  while (last > first && std::isspace(static_cast<unsigned char>(text[last - 1]))) --last;
  return text.substr(first, last - first);
}

}  // namespace strobe::mutate
