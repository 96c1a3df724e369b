// SPDX-License-Identifier: MIT
#include "repo/text_units.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>

namespace strobe::repo {
namespace {

struct Syntax {
  std::string line_comment, block_open, block_close;
  std::optional<std::string> join;  // between two literals of one text; nullopt: literals are not prose
};

std::optional<Syntax> syntaxOf(const Source& source) {
  const Syntax cpp{"//", "/*", "*/", ""}, lua{"--", "--[[", "]]", ".."};
  const Syntax python{"#", "\"\"\"", "\"\"\"", {}}, shell{"#", "", "", {}};
  auto ends = [&](const char* end) { return source.path.ends_with(end); };
  if (ends(".cpp") || ends(".h") || ends(".inc") || ends(".glsl")) return cpp;
  if (ends(".lua")) return lua;
  if (ends(".py")) return python;
  if (ends(".sh")) return shell;
  if (!source.text.starts_with("#!")) return std::nullopt;
  return source.text.substr(0, source.text.find('\n')).find("python") == std::string::npos ? shell : python;
}

std::string trimmed(const std::string& text, const char* characters) {
  size_t first = text.find_first_not_of(characters);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(characters) - first + 1);
}

std::string withSingleSpaces(const std::string& text) {
  std::istringstream words(text);
  std::string joined;
  for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
  return joined;
}

bool isShort(const TextUnit& unit) { return std::count(unit.text.begin(), unit.text.end(), ' ') < 3; }

// True if a literal has source code, markup or a regular expression.
bool isCode(const std::string& literal) {
  static const std::regex code(R"([{};]\n|void |#include|<svg|</|\\)");
  return std::regex_search(literal, code);
}

bool isAnnotation(const std::string& comment) {
  return comment.starts_with("---@") || comment.starts_with("#!") ||
         comment.find("SPDX-License-Identifier") != std::string::npos;
}

// Comments and literals of one file. A comment or literal that continues the previous one extends its unit.
class CodeReader {
 public:
  CodeReader(const Source& source, const Syntax& syntax)
      : path_(source.path), text_(source.text + "\n"), syntax_(syntax) {}

  std::vector<TextUnit> units() {
    while (at_ < text_.size()) readNext();
    return units_;
  }

 private:
  struct Place {
    size_t unit = 0;  // index in units_
    size_t end = 0;   // offset after the last character; literals only
    int line = -1;
    size_t column = 0;
    bool is_alone = false;  // no code before it on its line
  };

  void readNext() {
    char c = text_[at_];
    bool is_word = at_ > 0 && std::isalnum(static_cast<unsigned char>(text_[at_ - 1]));
    bool after_space = at_ == 0 || std::isspace(static_cast<unsigned char>(text_[at_ - 1]));
    bool is_block = !syntax_.block_open.empty() && startsWith(syntax_.block_open);
    if (is_block) return readBlockComment();
    if (after_space && startsWith(syntax_.line_comment)) return readLineComment();
    if (startsWith("R\"") && syntax_.join == "") return readRawLiteral();
    if (c == '"' || (c == '\'' && !is_word)) return readLiteral(c);
    advanceTo(at_ + 1);
  }

  bool startsWith(const std::string& text) const { return text_.compare(at_, text.size(), text) == 0; }

  void advanceTo(size_t end) {
    end = std::min(end, text_.size());
    for (; at_ < end; ++at_)
      if (text_[at_] == '\n') ++line_, line_start_ = at_ + 1;
  }

  Place here() const {
    size_t first = text_.find_first_not_of(" \t", line_start_);
    return {units_.size(), at_, line_, at_ - line_start_, first == at_};
  }

  void readLineComment() {
    size_t end = text_.find('\n', at_);
    std::string comment = text_.substr(at_, end - at_);
    if (!isAnnotation(comment)) addComment(trimmed(comment, "-/#! \t"));
    advanceTo(end);
  }

  // Continues the comment of the line above if neither line has code before it, or both comments start in one column.
  void addComment(const std::string& text) {
    Place place = here();
    bool continues = place.is_alone && comment_.line + 1 == line_;
    if (continues && (comment_.is_alone || comment_.column == place.column)) {
      units_[comment_.unit].text += " " + text;
      place.unit = comment_.unit;
      place.is_alone = comment_.is_alone;
    } else {
      units_.push_back({path_, line_, text});
    }
    comment_ = place;
  }

  void readBlockComment() {
    size_t from = at_ + syntax_.block_open.size();
    size_t end = std::min(text_.find(syntax_.block_close, from), text_.size());
    units_.push_back({path_, line_, trimmed(text_.substr(from, end - from), " *\t\n")});
    advanceTo(end + syntax_.block_close.size());
  }

  // Reads up to the closing quotation mark or the end of the line.
  void readLiteral(char quote) {
    std::string literal;
    size_t end = at_ + 1;
    for (; end < text_.size() && text_[end] != quote && text_[end] != '\n'; ++end) {
      if (text_[end] != '\\') literal += text_[end];
      else literal += text_[++end] == 'n' ? '\n' : text_[end];
    }
    addLiteral(literal, end + 1);
    advanceTo(text_[end] == '\n' ? end : end + 1);
  }

  // A literal of several lines counts as code.
  void readRawLiteral() {
    size_t open = text_.find('(', at_);
    std::string close = ")" + text_.substr(at_ + 2, open - at_ - 2) + "\"";
    size_t end = std::min(text_.find(close, open), text_.size());
    std::string literal = text_.substr(open + 1, end - open - 1);
    if (literal.find('\n') == std::string::npos) addLiteral(literal, end + close.size());
    advanceTo(end + close.size());
  }

  void addLiteral(const std::string& literal, size_t end) {
    if (!syntax_.join) return;
    std::string gap = literal_.end ? trimmed(text_.substr(literal_.end, at_ - literal_.end), " \t\n") : "code";
    Place place = here();
    if (gap == *syntax_.join) place.unit = literal_.unit;
    else units_.push_back({path_, line_, ""});
    if (!isCode(literal)) units_[place.unit].text += literal;
    place.end = end;
    literal_ = place;
  }

  std::string path_, text_;
  Syntax syntax_;
  size_t at_ = 0, line_start_ = 0;
  int line_ = 1;
  Place comment_, literal_;
  std::vector<TextUnit> units_;
};

class MarkdownReader {
 public:
  explicit MarkdownReader(const Source& source) : path_(source.path) {
    std::istringstream lines(withoutHtmlComments(source.text));
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      read(line);
    }
  }

  std::vector<TextUnit> units() { return units_; }

 private:
  // Removes HTML comments and keeps line breaks.
  static std::string withoutHtmlComments(std::string text) {
    for (size_t from = 0; (from = text.find("<!--", from)) != std::string::npos;) {
      size_t end = std::min(text.find("-->", from), text.size() - 3) + 3;
      text.replace(from, end - from, std::count(text.begin() + from, text.begin() + end, '\n'), '\n');
    }
    return text;
  }

  void read(const std::string& line) {
    std::string text = trimmed(line, " \t\r");
    bool is_fence = text.starts_with("```");
    bool is_indented_code = !in_paragraph_ && line.starts_with("    ");
    is_fenced_ = is_fenced_ != is_fence;
    bool is_text = !is_fence && !is_fenced_ && !is_indented_code && !text.empty() && text[0] != '#';
    if (is_text && text[0] == '|') readCells(text);
    else if (is_text && in_paragraph_) units_.back().text += " " + text;
    else if (is_text) units_.push_back({path_, line_, text});
    in_paragraph_ = is_text && text[0] != '|';
  }

  void readCells(const std::string& row) {
    std::istringstream cells(row);
    for (std::string cell; std::getline(cells, cell, '|');) units_.push_back({path_, line_, trimmed(cell, " \t")});
  }

  std::string path_;
  int line_ = 0;
  bool is_fenced_ = false, in_paragraph_ = false;
  std::vector<TextUnit> units_;
};

}  // namespace

std::vector<TextUnit> textUnits(const Source& source) {
  std::vector<TextUnit> units;
  std::optional<Syntax> syntax = syntaxOf(source);
  if (syntax) units = CodeReader(source, *syntax).units();
  else if (source.path.ends_with(".md")) units = MarkdownReader(source).units();
  for (TextUnit& unit : units) unit.text = withSingleSpaces(unit.text);
  std::erase_if(units, isShort);
  return units;
}

}  // namespace strobe::repo
