// SPDX-License-Identifier: MIT
// A self-contained page as a value: what it shows, in order. `htmlOf` makes one HTML file of it that opens from disk,
// without a network, in light and dark, on screen and in print; pictures are inside. Texts are in the inline notation
// of markup.h.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/json.h"
#include "page/library.h"
#include "page/table.h"

namespace strobe::page {

struct Heading {
  std::string text;
  int level = 2;   // 2 to 4; the page's title is 1
  std::string id;  // of links (#id); one of level 2 that has it is in the page's navigation
};

struct Paragraph {
  enum class Kind { plain, soft, finding, failure };  // soft: aside; finding and failure: what was found, in a frame
  std::string text;
  Kind kind = Kind::plain;
};

// Inline SVG of svgOf.
struct Figure {
  std::string svg;
  std::string caption;
  std::string name;  // of its file beside a document (standalone.h), without ".svg"; "": it is shown on pages alone
  std::string alt;   // for people who cannot see it, in a document; on pages the SVG says it
};

struct Picture {
  std::string file;  // the bytes of a PNG or JPEG
  int width = 0, height = 0;
  std::string caption;
  std::string alt;   // for people who cannot see it; "": the caption
  std::string name;  // by which a comparison refers to it, once on the page
};

// Beside each other, in as many columns as there is room for.
struct Pictures {
  std::vector<Picture> pictures;
  bool pixels = false;  // shown as squares: magnified crops
};

// Pictures of the page laid over a reference and wiped away by the pointer, or shown in turn. The pictures have the
// same size and are on the page by their names; where there is no script, the comparison is left out.
struct Comparison {
  std::string reference;            // name of a picture
  std::vector<std::string> others;  // names; their captions are on the buttons
  std::string chosen;               // the one shown first; "": the first
};

// Lines to copy: commands, files.
struct Code {
  std::string text;
};

// Points to click through: charts, table, pictures (assets/explorer_*.js), once on a page. Without a script it is left
// out.
struct Explorer {
  Json data;        // assets/explorer_model.js reads it
  Library library;  // of charts, that is found; it is put into the page whole
};

struct Details;  // blocks behind a line that unfolds them
struct Still;    // blocks that an explorer takes the place of where scripts run

using Block = std::variant<Heading, Paragraph, Table, Figure, Pictures, Comparison, Code, Explorer, Details, Still>;

struct Details {
  std::string summary;
  std::vector<Block> blocks;
};

struct Still {
  std::vector<Block> blocks;
};

struct Page {
  std::string title;
  std::string note;  // below the title
  std::vector<Block> blocks;
  std::vector<std::string> footer;  // paragraphs
};

// Asserts that comparisons name pictures of the page.
std::string htmlOf(const Page& page);

std::string base64(std::string_view bytes);

}  // namespace strobe::page
