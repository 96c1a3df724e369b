// SPDX-License-Identifier: MIT
#include "script/locate.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace strobe::script {

namespace {

struct Token {
  std::string_view text;  // contents of a string without its quotes
  int line;
  bool word;        // a name or keyword
  int nesting = 0;  // 1 if it opens a bracket or block, -1 if it closes one
};

bool opens(const Token& token) {
  if (!token.word) return token.text == "{" || token.text == "(" || token.text == "[";
  return token.text == "function" || token.text == "if" || token.text == "do" || token.text == "repeat";
}

bool closes(const Token& token) {
  if (!token.word) return token.text == "}" || token.text == ")" || token.text == "]";
  return token.text == "end" || token.text == "until";
}

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {}

  std::vector<Token> tokens() {
    while (skipBlank(), at_ < source_.size()) step();
    for (Token& token : tokens_) token.nesting = opens(token) - closes(token);
    return std::move(tokens_);
  }

 private:
  char peek(size_t ahead = 0) const { return at_ + ahead < source_.size() ? source_[at_ + ahead] : '\0'; }

  void skipBlank() {
    for (; at_ < source_.size() && std::isspace(static_cast<unsigned char>(peek())); ++at_) line_ += peek() == '\n';
  }

  void step() {
    if (peek() == '-' && peek(1) == '-') return comment();
    if (peek() == '"' || peek() == '\'') return quoted();
    if (peek() == '[' && longLevel() >= 0) return longText(true);
    size_t start = at_;
    auto wordly = [&] { return std::isalnum(static_cast<unsigned char>(peek())) || peek() == '_'; };
    bool word = wordly();
    while (word && wordly()) ++at_;
    if (!word) at_ += pairAhead() ? 2 : 1;
    tokens_.push_back({source_.substr(start, at_ - start), line_, word});
  }

  // True for "==", "~=", "<=" and ">=": their "=" is not the "=" of a field.
  bool pairAhead() const { return peek(1) == '=' && std::string_view("=~<>").find(peek()) != std::string_view::npos; }

  void comment() {
    at_ += 2;
    if (peek() == '[' && longLevel() >= 0) return longText(false);
    while (at_ < source_.size() && peek() != '\n') ++at_;
  }

  void quoted() {
    char quote = peek();
    int line = line_;
    size_t start = ++at_;
    for (; at_ < source_.size() && peek() != quote; ++at_) {
      if (peek() == '\\') ++at_;
      line_ += peek() == '\n';
    }
    at_ = std::min(at_, source_.size());
    tokens_.push_back({source_.substr(start, at_ - start), line, false});
    ++at_;
  }

  // Number of "=" in "[==["; -1 if no long bracket opens here.
  int longLevel() const {
    size_t level = 0;
    while (peek(1 + level) == '=') ++level;
    return peek(1 + level) == '[' ? static_cast<int>(level) : -1;
  }

  void longText(bool keep) {
    std::string close(1, ']');
    close.append(static_cast<size_t>(longLevel()), '=').append(1, ']');
    size_t end = std::min(source_.find(close, at_), source_.size());
    if (keep) tokens_.push_back({source_.substr(at_, end - at_), line_, false});
    line_ += static_cast<int>(std::count(source_.begin() + at_, source_.begin() + end, '\n'));
    at_ = end + close.size();
  }

  std::string_view source_;
  size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

// True if a field or an entry of a table may begin after the token.
bool precedesItem(const Token& token) { return token.text == "{" || token.text == "," || token.text == ";"; }

// True if the item at `i` is a field `key`; `value` is then the token after its "=".
bool fieldAt(const std::vector<Token>& tokens, size_t i, const std::string& key, size_t& value) {
  auto is = [&](size_t at, std::string_view text) { return at < tokens.size() && tokens[at].text == text; };
  value = is(i, "[") ? i + 4 : i + 2;
  return is(i, "[") ? is(i + 1, key) && is(i + 3, "=") : is(i, key) && is(i + 1, "=");
}

// True if the item at `i` is an entry of a list: a value without a name.
bool entryAt(const std::vector<Token>& tokens, size_t i) {
  auto is = [&](size_t at, std::string_view text) { return at < tokens.size() && tokens[at].text == text; };
  return !is(i, "}") && !is(i, "[") && !is(i + 1, "=");
}

struct Found {
  size_t keys = 0;  // number of keys of the path that are found
  int line = 0;     // line of the last of these keys
};

// Follows `path`, from key number `done` on, through the table that opens at tokens[open].
Found searchTable(const std::vector<Token>& tokens, size_t open, const std::vector<std::string>& path, size_t done) {
  Found found{done, tokens[open].line};
  int depth = 1, entries = 0;
  for (size_t i = open + 1; i < tokens.size() && depth > 0; ++i) {
    size_t value = i;
    const bool is_item = depth == 1 && precedesItem(tokens[i - 1]);
    const bool is_entry = is_item && entryAt(tokens, i) && std::to_string(++entries) == path[done];
    if (is_entry || (is_item && fieldAt(tokens, i, path[done], value))) {
      found = {done + 1, tokens[i].line};
      if (found.keys == path.size()) return found;
      auto is = [&](const char* text) { return tokens[value].text == text; };
      while (value < tokens.size() && !is("{") && !is(",") && !is("}")) ++value;
      bool nested = value < tokens.size() && tokens[value].text == "{";
      Found below = nested ? searchTable(tokens, value, path, done + 1) : found;
      return below.keys > found.keys ? below : found;
    }
    depth += tokens[i].nesting;
  }
  return found;
}

}  // namespace

struct LuaSource::Read {
  std::vector<Token> tokens;
  std::set<std::string_view> fields;  // names of fields that are read
};

LuaSource::LuaSource(std::string text) : text_(std::move(text)) {}

LuaSource::~LuaSource() = default;

const LuaSource::Read& LuaSource::read() const {
  if (read_) return *read_;
  auto read = std::make_unique<Read>();
  read->tokens = Lexer(text_).tokens();
  const std::vector<Token>& tokens = read->tokens;
  for (size_t i = 1; i < tokens.size(); ++i) {
    bool of_something = tokens[i - 1].text == "." && (i < 2 || tokens[i - 2].text != ".");
    if (tokens[i].word && of_something) read->fields.insert(tokens[i].text);
  }
  read_ = std::move(read);
  return *read_;
}

void LuaSource::prepare() const { read(); }

int LuaSource::lineOfKey(int line, const std::vector<std::string>& path) const {
  const std::vector<Token>& tokens = read().tokens;
  auto firstOn = [&](int on) {
    return std::lower_bound(tokens.begin(), tokens.end(), on, [](const Token& t, int at) { return t.line < at; });
  };
  auto isTable = [](const Token& token) { return !token.word && token.text == "{"; };
  auto begin = firstOn(line), end = firstOn(line + 1);
  if (std::none_of(begin, end, isTable)) begin = end, end = firstOn(line + 2);
  Found best{0, line};
  for (auto token = begin; token != end && !path.empty(); ++token) {
    if (!isTable(*token)) continue;
    Found found = searchTable(tokens, size_t(token - tokens.begin()), path, 0);
    if (found.keys > best.keys) best = found;
  }
  return best.line;
}

int LuaSource::lineOfReturn(int first, int last, const std::vector<std::string>& path) const {
  const std::vector<Token>& tokens = read().tokens;
  int best = 0;
  for (size_t i = 0; i < tokens.size(); ++i) {
    if (!tokens[i].word || tokens[i].text != "return" || tokens[i].line < first || tokens[i].line > last) continue;
    best = tokens[i].line;
    bool table = !path.empty() && i + 1 < tokens.size() && tokens[i + 1].text == "{";
    Found found = table ? searchTable(tokens, i + 1, path, 0) : Found{};
    if (found.keys > 0) best = found.line;
  }
  return best;
}

bool LuaSource::readsField(std::string_view name) const { return read().fields.count(name) > 0; }

std::vector<int> LuaSource::conditionsOn(std::string_view name) const {
  static const std::set<std::string_view> before = {"if", "elseif", "while", "until", "not", "and", "or", "==", "~="};
  static const std::set<std::string_view> after = {"then", "do", "and", "or", "==", "~="};
  std::vector<int> lines;
  const std::vector<Token>& tokens = read().tokens;
  for (size_t i = 1; i + 3 < tokens.size(); ++i) {
    bool is_it = tokens[i].text == "p" && tokens[i + 1].text == "." && tokens[i + 2].text == name;
    if (!is_it || tokens[i - 1].text == ".") continue;
    const std::string_view next = tokens[i + 3].text;
    bool continues = next == "(" || next == "." || next == ":" || next == "[";
    if (!continues && (before.count(tokens[i - 1].text) || after.count(next))) lines.push_back(tokens[i].line);
  }
  return lines;
}

}  // namespace strobe::script
