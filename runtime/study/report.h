// SPDX-License-Identifier: MIT
// Report of an experiment: one list of parts, written as terminal text, Markdown or a page. The content comes only from
// the results and from the pictures that the results name.
#pragma once

#include "page/page.h"
#include "study/gallery.h"

namespace strobe::study {

// A block and the media that show it. `still`: the explorer of the page replaces the block if scripts run. Terminal and
// Markdown show headings, paragraphs and tables; Markdown also shows figures, which have a name.
struct ReportPart {
  enum Media : uint32_t { kTerminal = 1, kDocument = 2, kPage = 4, kRead = kDocument | kPage, kEverywhere = 7 };

  page::Block block;
  uint32_t media = kEverywhere;
  bool still = false;
};
using Parts = std::vector<ReportPart>;

using Tone = page::Paragraph::Kind;
inline ReportPart text(const std::string& text, Tone tone = Tone::plain, uint32_t media = ReportPart::kEverywhere) {
  return {page::Paragraph{text, tone}, media};
}
inline ReportPart heading(const std::string& text, int level = 2, const std::string& id = "",
                          uint32_t media = ReportPart::kEverywhere) {
  return {page::Heading{text, level, id}, media};
}
void append(Parts& parts, Parts more);

// ---- sections

// Size of pictures on a page: 1/`divisor` of the width, JPEG of this quality; quality 0: PNG.
struct PictureSize {
  int divisor = 1, quality = 0;
};
// One section per shot: tables, pictures, crops, differences. Without a size: no pictures.
Parts pictureParts(const Results& results, const std::vector<Gallery>& galleries,
                   const std::optional<PictureSize>& size);
// One section per axis.
Parts curveParts(const Results& results);
// One section per shot, or one for all: Pareto front of the methods.
Parts frontParts(const Results& results);
// One table per axis, or one table of all points.
Parts tableParts(const Results& results);
// Effects of arms, shots and axes on the measure that the page shows first.
Parts effectParts(const Results& results);
// Outcomes of expectations: of a shot, of an axis, or of neither (both "").
Parts expectationParts(const Results& results, const std::string& shot, const std::string& axis);

// Contact sheet: for each shot, a row of pictures, rows of magnified crops and a row of differences from truth. Display
// image (sRGB-encoded values). `galleries`: one per shot, without pictures if the shot is missing.
image::Image sheetOf(const Results& results, const std::vector<Gallery>& galleries);

// ---- the interactive part of the page

// Points as JSON for page/assets/explorer_model.js: { title, command, software, size: [width, height], measures,
// regions, arms, shots, axes, front: { x, y, region, shot }, groups: [{ shot, at, truth, picture, sigma }], points: [{
// n, g, a, v, command, ... }], effects, pictures, notices: [text] }. `n` is the number of the point in table.csv. `v`
// has a number for each measure, or a list by region. Pictures are data URLs; other members refer to pictures by index.
// `most_bytes`: largest size of the text; pictures are reduced to fit.
Json explorerData(const Results& results, const Path& folder, size_t most_bytes);

// Initial view of the page: measures of the front's layout, else time and error.
struct FirstView {
  std::string x, y, region;
};
FirstView firstViewOf(const Results& results);

// ---- the report

// Report of results; `folder` has the pictures that the results name.
class Report {
 public:
  Report(const Results& results, const Path& folder);

  bool hasSheet() const;  // true with at least one picture
  image::Image sheet() const;
  std::string text() const;
  // `page`: path of the page, relative to the Markdown file; "": no link to a page.
  std::string markdown(const std::string& page) const;
  // Figures of the Markdown: name and content of each SVG file.
  std::vector<std::pair<std::string, std::string>> figures() const;
  // Self-contained HTML file. With a chart library, the points are interactive; without, the page has figures and
  // tables, and a note about the library. Pictures (not crops) are reduced if the file is larger than `most_bytes`; a
  // note on the page says how.
  std::string page(const page::Library& library = {}, size_t most_bytes = 8'000'000) const;

 private:
  Parts parts(const std::optional<PictureSize>& size = std::nullopt) const;
  Parts sections(const std::optional<PictureSize>& size) const;
  // Sections of one device after another, if times come from several devices.
  Parts sectionsByDevice(const std::optional<PictureSize>& size) const;
  page::Explorer explorer(const page::Library& library, size_t most_bytes) const;

  const Results& results_;
  Path folder_;
  std::vector<Gallery> galleries_;
};

}  // namespace strobe::study
