// SPDX-License-Identifier: MIT
#include "session/edits.h"

#include <regex>

namespace strobe::session {

namespace {

size_t below(std::mt19937& random, size_t n) { return n ? random() % n : 0; }

// Position of a random match, or npos.
size_t anyMatch(std::mt19937& random, const std::string& text, const std::string& pattern, size_t& length) {
  std::regex expression(pattern);
  std::vector<std::pair<size_t, size_t>> found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), none; it != none; ++it)
    found.push_back({size_t(it->position(1)), size_t(it->length(1))});
  if (found.empty()) return std::string::npos;
  auto [at, matched] = found[below(random, found.size())];
  length = matched;
  return at;
}

bool isLua(const std::string& file) { return file.ends_with(".lua"); }

std::string withSyntaxError(std::mt19937& random, const std::string& text) {
  static const char* const kBits[] = {"}", "{", ")", "((", "\"", "=", " end ", "@", ";;;)", "[[", "\\", "#if\n", "1x"};
  std::string broken = text;
  return broken.insert(below(random, text.size()), kBits[below(random, std::size(kBits))]);
}

std::string renamed(std::mt19937& random, const std::string& file, const std::string& text) {
  size_t length = 0;
  const char* pattern = isLua(file) ? "\\b([a-z_]{4,})\\b *=" : "\\b([a-z_]+)_(?:tex|img)\\b|params\\.([a-z_]+)";
  size_t at = anyMatch(random, text, pattern, length);
  std::string broken = text;
  return at == std::string::npos || !length ? text + "\nrenamed_nothing(" : broken.insert(at + length, "x");
}

std::string rebound(std::mt19937& random, const std::string& text) {
  size_t length = 0;
  size_t at = anyMatch(random, text, "format = \"([a-z0-9_]+)\"", length);
  static const char* const kFormats[] = {"r32ui", "rgba16f", "r32f", "rg32f", "rgba32ui", "rgb5"};
  std::string broken = text;
  if (at != std::string::npos) return broken.replace(at, length, kFormats[below(random, std::size(kFormats))]);
  at = anyMatch(random, text, "(doc = )", length);
  return at == std::string::npos ? text + "\nlocal local" : broken.insert(at, "uint = true, ");
}

}  // namespace

Edit randomEdit(std::mt19937& random, const std::map<std::string, std::string>& files) {
  auto chosen = std::next(files.begin(), std::ptrdiff_t(below(random, files.size())));
  const auto& [file, text] = *chosen;
  Edit edit;
  edit.file = file;
  edit.save = Save(below(random, 3));
  switch (below(random, isLua(file) ? 8 : 6)) {
    case 0:
      edit.kind = "syntax", edit.text = withSyntaxError(random, text);
      break;
    case 1:
      edit.kind = "truncated", edit.text = text.substr(0, below(random, text.size()));
      break;
    case 2:
      edit.kind = "renamed", edit.text = renamed(random, file, text);
      break;
    case 3:
      edit.kind = "deleted";
      break;
    case 4:
      edit.kind = "comment", edit.text = text + (isLua(file) ? "\n-- touched\n" : "\n// touched\n");
      break;
    case 5:
      edit.kind = "nonsense", edit.text = "this is not a program " + std::to_string(random());
      break;
    case 6:
      edit.kind = "binding", edit.text = rebound(random, text);
      break;
    default:
      edit.kind = "endless", edit.text = "while true do end\n" + text;
      break;
  }
  return edit;
}

}  // namespace strobe::session
