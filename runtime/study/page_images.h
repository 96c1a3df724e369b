// SPDX-License-Identifier: MIT
// The pictures of all points, small enough for one page: as people see them, with their FLIP maps against truth.
#pragma once

#include "image/draw.h"
#include "study/results.h"

namespace strobe::study {

struct PointImages {
  int picture = -1, flip = -1;  // in `PageImages::sources`; -1: there is none
  image::Rectangle worst;       // where FLIP is largest, in pixels of the experiment's size; empty: no FLIP
};

// A picture, or the map between two of them.
struct ImageSource {
  std::string png, file;  // the file, and its name for errors
  bool is_flip = false;
};

struct PageImages {
  std::vector<ImageSource> sources;              // each content once
  std::vector<std::vector<PointImages>> points;  // by group and point
};

// Reads folder/points/KEY.png, else the picture of the layout. Leaves out files that differ from their hash. FLIP is of
// these display values. Throws `Error` if a file without a hash is not a PNG.
PageImages pageImagesOf(const Results& results, const Path& folder);

// As a page has them.
struct WrittenImages {
  std::vector<std::string> urls;  // "data:image/..." of each source
  std::string reduced;            // how they are less than what the sweep wrote; "": they are the same
};

// All together at most `most_bytes` of text, at falling quality and size, or as small as they get.
WrittenImages written(const std::vector<ImageSource>& sources, size_t most_bytes);

// Width and height of a worst crop, in pixels of the experiment's size.
inline constexpr int kWorstWidth = 48, kWorstHeight = 27;

}  // namespace strobe::study
