// SPDX-License-Identifier: MIT
// Pictures of all points, small enough for one page: display images and their FLIP maps against truth.
#pragma once

#include "image/draw.h"
#include "study/results.h"

namespace strobe::study {

// Picture and FLIP map of one measured point, as indices into a common list, and the rectangle of largest error.
struct PointImages {
  int picture = -1, flip = -1;  // indices of `PageImages::sources`; -1: no image
  image::Rectangle worst;       // largest FLIP, in pixels at the experiment's size; empty: no FLIP
};

// Picture, or FLIP map.
struct ImageSource {
  std::string png, file;  // content, and file name for errors
  bool is_flip = false;
};

// Images of an HTML report: all pictures and FLIP maps without duplicates, and the images of each point.
struct PageImages {
  std::vector<ImageSource> sources;              // without duplicates
  std::vector<std::vector<PointImages>> points;  // by group and point
};

// Reads folder/points/KEY.png, else the picture of the layout. Leaves out files that differ from their hash. FLIP is
// computed from these display values. Throws `Error` if a file without a hash is not a PNG.
PageImages pageImagesOf(const Results& results, const Path& folder);

// Pictures in the form that a page embeds.
struct WrittenImages {
  std::vector<std::string> urls;  // "data:image/..." of each source
  std::string reduced;            // reduction of the files of the sweep, as text; "": not reduced
};

// Reduces quality and size until all URLs together have at most `most_bytes`, or to the smallest level.
WrittenImages written(const std::vector<ImageSource>& sources, size_t most_bytes);

// Size of a worst crop, in pixels at the experiment's size.
inline constexpr int kWorstWidth = 48, kWorstHeight = 27;

}  // namespace strobe::study
