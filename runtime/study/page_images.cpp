// SPDX-License-Identifier: MIT
#include "study/page_images.h"

#include <algorithm>
#include <cmath>

#include "base/cores.h"
#include "base/hash.h"
#include "image/draw.h"
#include "image/flip.h"
#include "image/png.h"
#include "page/page.h"
#include "study/store.h"

namespace strobe::study {

namespace {

using image::Image;

// Size and quality of written pictures; quality 0 is PNG.
struct UrlQuality {
  int divisor, quality, flip_divisor, flip_quality;
};
constexpr UrlQuality kUrlQualities[] = {{1, 0, 1, 0},   {1, 92, 1, 85}, {1, 85, 1, 70}, {1, 75, 2, 70},
                                        {1, 60, 2, 60}, {2, 80, 2, 60}, {2, 60, 3, 50}, {3, 60, 4, 50},
                                        {4, 50, 6, 40}, {8, 50, 12, 40}};

std::string qualityText(const UrlQuality& level) {
  if (level.quality == 0) return "";
  std::string size = level.divisor == 1 ? "" : fmt::format(" and 1/{} of the width", level.divisor);
  return fmt::format("JPEG of quality {}{}", level.quality, size);
}

std::string urlOf(const ImageSource& source, const UrlQuality& level) {
  int divisor = source.is_flip ? level.flip_divisor : level.divisor;
  int quality = source.is_flip ? level.flip_quality : level.quality;
  if (quality == 0) return "data:image/png;base64," + page::base64(source.png);
  Image display = image::decodePng(source.png, source.file);
  if (divisor > 1) {
    Image linear = source.is_flip ? display : image::decodeSrgb(display);
    linear = image::shrunk(linear, display.width / divisor, display.height / divisor);
    display = source.is_flip ? linear : image::encodeSrgb(linear);
  }
  return "data:image/jpeg;base64," + page::base64(image::encodeJpeg(display, quality));
}

// True if a sample of the pictures predicts a total size below 1.2 * `most_bytes`. Other levels are not tried.
bool mayFit(const std::vector<ImageSource>& sources, const UrlQuality& level, size_t most_bytes) {
  size_t step = std::max<size_t>(1, sources.size() / 24), bytes = 0, tried = 0;
  for (size_t i = 0; i < sources.size(); i += step, ++tried) bytes += urlOf(sources[i], level).size();
  return tried == 0 || double(bytes) / double(tried) * double(sources.size()) < 1.2 * double(most_bytes);
}

// Pictures and maps of the points, without duplicates.
class Collection {
 public:
  Collection(const Results& results, const Path& folder) : results_(results), files_(folder) {}

  PageImages collected();

 private:
  struct Pair {
    int picture, truth;
    std::string png;
    image::Rectangle worst;
  };

  int pictureOf(const Point& point);
  void map(Pair& pair) const;

  const Results& results_;
  PointFiles files_;
  std::vector<ImageSource> sources_;
  std::map<std::string, int> by_content_;
  std::vector<Pair> pairs_;
};

int Collection::pictureOf(const Point& point) {
  std::vector<std::string> names;
  if (!point.key.empty()) names.push_back("points/" + point.key + ".png");
  if (!point.picture.empty()) names.push_back(point.picture);
  for (const std::string& name : names) {
    std::optional<std::string> png = checkedFile(point, files_, name);
    if (!png) continue;
    auto [found, added] = by_content_.emplace(hashText(*png), int(sources_.size()));
    if (added) sources_.push_back({std::move(*png), name});
    return found->second;
  }
  return -1;
}

void Collection::map(Pair& pair) const {
  auto linear = [this](int i) {
    const ImageSource& source = sources_[size_t(i)];
    return image::decodeSrgb(image::threeChannels(image::decodePng(source.png, source.file)));
  };
  Image test = linear(pair.picture), reference = linear(pair.truth);
  if (test.width != reference.width || test.height != reference.height) return;
  Image flip = image::ldrFlip(test, reference);
  double scale_x = double(flip.width) / results_.width, scale_y = double(flip.height) / results_.height;
  auto scaled = [](int value, double scale) { return int(std::lround(value * scale)); };
  image::Rectangle window = image::worstWindow(flip, scaled(kWorstWidth, scale_x), scaled(kWorstHeight, scale_y));
  pair.worst = {scaled(window.x, 1 / scale_x), scaled(window.y, 1 / scale_y), scaled(window.width, 1 / scale_x),
                scaled(window.height, 1 / scale_y)};
  pair.png = image::encodePng(flip);
}

PageImages Collection::collected() {
  PageImages images;
  std::map<std::pair<int, int>, int> pair_of;
  for (const PointGroup& group : results_.groups) {
    std::vector<PointImages>& points = images.points.emplace_back();
    for (const Point& point : group.points) {
      PointImages one;
      one.picture = pictureOf(point);
      int truth = points.empty() ? -1 : points.front().picture;
      if (one.picture >= 0 && truth >= 0) {
        auto [found, added] = pair_of.emplace(std::pair(one.picture, truth), int(pairs_.size()));
        if (added) pairs_.push_back({one.picture, truth, "", {}});
        one.flip = found->second;  // index of the pair, until the maps are made
      }
      points.push_back(one);
    }
  }
  forEachOnAllCores(pairs_.size(), [this](size_t i) { map(pairs_[i]); });
  std::vector<int> flips;
  for (Pair& pair : pairs_) {
    flips.push_back(pair.png.empty() ? -1 : int(sources_.size()));
    if (!pair.png.empty()) sources_.push_back({std::move(pair.png), "a FLIP map", true});
  }
  for (std::vector<PointImages>& points : images.points)
    for (PointImages& one : points) {
      if (one.flip < 0) continue;
      one.worst = pairs_[size_t(one.flip)].worst;
      one.flip = flips[size_t(one.flip)];
    }
  images.sources = std::move(sources_);
  return images;
}

}  // namespace

PageImages pageImagesOf(const Results& results, const Path& folder) { return Collection(results, folder).collected(); }

WrittenImages written(const std::vector<ImageSource>& sources, size_t most_bytes) {
  WrittenImages images;
  const UrlQuality& last = *std::rbegin(kUrlQualities);
  for (const UrlQuality& level : kUrlQualities) {
    if (&level != &last && !mayFit(sources, level, most_bytes)) continue;
    images.urls.assign(sources.size(), "");
    forEachOnAllCores(sources.size(), [&](size_t i) { images.urls[i] = urlOf(sources[i], level); });
    images.reduced = qualityText(level);
    size_t bytes = 0;
    for (const std::string& url : images.urls) bytes += url.size();
    if (bytes <= most_bytes) break;
  }
  return images;
}

}  // namespace strobe::study
