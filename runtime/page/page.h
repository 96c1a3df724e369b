// SPDX-License-Identifier: MIT
// Self-contained page as a value: a list of blocks. `htmlOf` converts the page to one HTML file with its pictures
// inside. The file opens from disk without a network, in light and dark, on screen and in print. Texts use the inline
// notation of markup.h.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/json.h"
#include "page/library.h"
#include "page/table.h"

namespace strobe::page {

// Heading of an HTML page, levels 2 to 4, with an optional link target.
struct Heading {
  std::string text;
  int level = 2;   // 2 to 4; the page's title is 1
  std::string id;  // target of links (#id); the navigation lists headings of level 2 with an id
};

// Paragraph of an HTML page: plain text, an aside, or a framed finding or failure.
struct Paragraph {
  enum class Kind { plain, soft, finding, failure };  // soft: aside; finding, failure: result in a frame
  std::string text;
  Kind kind = Kind::plain;
};

// Inline SVG from `svgOf`.
struct Figure {
  std::string svg;
  std::string caption;
  std::string name;  // file name beside a document (standalone.h), without ".svg"; "": only on pages
  std::string alt;   // alternative text in documents; on pages, the SVG has its own
};

// PNG or JPEG picture embedded in an HTML page: size in pixels, caption and alternative text.
struct PagePicture {
  std::string file;  // bytes of a PNG or JPEG
  int width = 0, height = 0;
  std::string caption;
  std::string alt;   // alternative text; "": the caption
  std::string name;  // used by comparisons, unique on the page
};

// Pictures side by side, in as many columns as fit.
struct Pictures {
  std::vector<PagePicture> pictures;
  bool pixels = false;  // enlarged without interpolation, for crops
};

// Pictures of the page over a reference. The pointer wipes between the two, or they alternate. The pictures have the
// same size and are on the page under these names. Without scripts, the page leaves out the comparison.
struct PictureComparison {
  std::string reference;            // name of a picture
  std::vector<std::string> others;  // names of pictures; their captions label the buttons
  std::string chosen;               // picture shown first; "": the first of `others`
};

// Text to copy: commands, files.
struct Code {
  std::string text;
};

// Interactive charts, table and pictures of points (assets/explorer_*.js), at most once on a page. Without scripts, the
// page leaves out the explorer.
struct Explorer {
  Json data;        // input of assets/explorer_model.js
  Library library;  // chart library, not empty; embedded completely
};

struct Details;  // blocks that a click on the summary unfolds
struct Still;    // blocks that an explorer replaces if scripts run

using Block =
    std::variant<Heading, Paragraph, Table, Figure, Pictures, PictureComparison, Code, Explorer, Details, Still>;

// Collapsible section of an HTML page; a click on its summary unfolds the blocks.
struct Details {
  std::string summary;
  std::vector<Block> blocks;
};

// Static part of an HTML page, shown if scripts do not run; with scripts, an interactive explorer replaces it.
struct Still {
  std::vector<Block> blocks;
};

// Content of one HTML page: title, note, blocks such as headings, tables and charts, and footer.
struct Page {
  std::string title;
  std::string note;  // below the title
  std::vector<Block> blocks;
  std::vector<std::string> footer;  // paragraphs
};

// HTML file of the page. Asserts that comparisons name pictures of the page.
std::string htmlOf(const Page& page);

std::string base64(std::string_view bytes);

}  // namespace strobe::page
