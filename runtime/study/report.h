// SPDX-License-Identifier: MIT
// What the results of an experiment say, as one list of parts; terminal, Markdown and page are three ways to write it.
// Everything in it comes from the results and the pictures that they name.
#pragma once

#include "page/page.h"
#include "study/gallery.h"

namespace strobe::study {

// A block, and where it is shown; `still`: where scripts run the explorer of the page stands in its place. Terminal and
// Markdown have headings, paragraphs and tables; figures of a document have a name.
struct Part {
  enum Media : uint32_t { kTerminal = 1, kDocument = 2, kPage = 4, kRead = kDocument | kPage, kEverywhere = 7 };

  page::Block block;
  uint32_t media = kEverywhere;
  bool still = false;
};
using Parts = std::vector<Part>;

using Tone = page::Paragraph::Kind;
inline Part text(const std::string& text, Tone tone = Tone::plain, uint32_t media = Part::kEverywhere) {
  return {page::Paragraph{text, tone}, media};
}
inline Part heading(const std::string& text, int level = 2, const std::string& id = "",
                    uint32_t media = Part::kEverywhere) {
  return {page::Heading{text, level, id}, media};
}
void append(Parts& parts, Parts more);

// ---- what the layouts show

// How pictures of a layout are written: by 1/divisor of their width, as JPEG of this quality; 0: as PNG.
struct PictureSize {
  int divisor = 1, quality = 0;
};
// One section per shot: tables, pictures, crops, differences. Without a size: no pictures.
Parts pictureParts(const Results& results, const std::vector<Gallery>& galleries,
                   const std::optional<PictureSize>& size);
// One section per axis.
Parts curveParts(const Results& results);
// One section per shot: the best methods for each cost.
Parts frontParts(const Results& results);
// Tables by axis, or one of all points.
Parts tableParts(const Results& results);
// What arms, shots and axes do to the measure that the page shows first.
Parts effectParts(const Results& results);
// Expectations of a shot, of an axis, or of neither, as outcomes.
Parts expectationParts(const Results& results, const std::string& shot, const std::string& axis);

// ---- the report

// Below `folder` lie the pictures that the results name.
class Report {
 public:
  Report(const Results& results, const Path& folder);

  bool hasSheet() const;  // are there pictures?
  image::Image sheet() const;
  std::string text() const;
  // `page`: where the page is from there.
  std::string markdown(const std::string& page) const;
  // What the Markdown shows: names of SVG files beside it, and what is in them.
  std::vector<std::pair<std::string, std::string>> figures() const;
  // One self-contained HTML file: with a chart library the points can be clicked through, without one it has figures
  // and tables, and says so. Pictures are smaller where it would be larger than `most_bytes` (crops never); the page
  // says that too.
  std::string page(const page::Library& library = {}, size_t most_bytes = 8'000'000) const;

 private:
  Parts parts(const std::optional<PictureSize>& size = std::nullopt) const;
  page::Explorer explorer(const page::Library& library, size_t most_bytes) const;

  const Results& results_;
  Path folder_;
  std::vector<Gallery> galleries_;
};

}  // namespace strobe::study
