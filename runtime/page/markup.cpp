// SPDX-License-Identifier: MIT
#include "page/markup.h"

#include <fmt/format.h>

#include <functional>

namespace strobe::page {

std::string escaped(std::string_view text) {
  std::string result;
  for (char c : text) {
    if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '&') result += "&amp;";
    else if (c == '"') result += "&quot;";
    else if (c == '\'') result += "&#39;";
    else result += c;
  }
  return result;
}

namespace {

// Marked piece of a text: kind, content, address of a link, and index after the piece.
struct Piece {
  enum class Kind { code, strong, link } kind;
  std::string_view inside, address;
  size_t end;
};

bool leadsSomewhere(std::string_view address) {
  size_t colon = address.find(':');
  if (colon == std::string_view::npos || address.find('/') < colon || address.starts_with("#")) return true;
  std::string_view scheme = address.substr(0, colon);
  return scheme == "http" || scheme == "https" || scheme == "mailto";
}

bool between(std::string_view text, size_t at, std::string_view mark, Piece& piece) {
  size_t from = at + mark.size(), end = text.find(mark, from);
  if (!text.substr(at).starts_with(mark) || end == std::string_view::npos || end == from) return false;
  piece.inside = text.substr(from, end - from);
  piece.end = end + mark.size();
  return true;
}

bool link(std::string_view text, size_t at, Piece& piece) {
  size_t middle = text.find("](", at), end = text.find(')', middle);
  if (text[at] != '[' || middle == std::string_view::npos || end == std::string_view::npos) return false;
  piece = {Piece::Kind::link, text.substr(at + 1, middle - at - 1), text.substr(middle + 2, end - middle - 2), end + 1};
  return piece.inside.find('[') == std::string_view::npos && leadsSomewhere(piece.address);
}

bool pieceAt(std::string_view text, size_t at, Piece& piece) {
  piece.kind = Piece::Kind::code;
  if (between(text, at, "`", piece)) return true;
  piece.kind = Piece::Kind::strong;
  return between(text, at, "**", piece) || link(text, at, piece);
}

std::string walked(std::string_view text, const std::function<std::string(std::string_view)>& plain,
                   const std::function<std::string(const Piece&)>& marked) {
  std::string result;
  size_t written = 0;
  for (size_t at = 0; at < text.size();) {
    Piece piece{};
    if (!pieceAt(text, at, piece)) {
      ++at;
      continue;
    }
    result += plain(text.substr(written, at - written)) + marked(piece);
    written = at = piece.end;
  }
  return result + plain(text.substr(written));
}

}  // namespace

std::string inlineHtml(std::string_view text) {
  return walked(text, escaped, [](const Piece& piece) {
    if (piece.kind == Piece::Kind::code) return "<code>" + escaped(piece.inside) + "</code>";
    if (piece.kind == Piece::Kind::strong) return "<strong>" + inlineHtml(piece.inside) + "</strong>";
    return fmt::format("<a href=\"{}\">{}</a>", escaped(piece.address), inlineHtml(piece.inside));
  });
}

std::string inlinePlain(std::string_view text) {
  auto same = [](std::string_view plain) { return std::string(plain); };
  return walked(text, same, [](const Piece& piece) {
    return piece.kind == Piece::Kind::code ? fmt::format("`{}`", piece.inside) : inlinePlain(piece.inside);
  });
}

}  // namespace strobe::page
