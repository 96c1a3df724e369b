// SPDX-License-Identifier: MIT
#include "live/pinned_pixel.h"

namespace strobe::live {

void PinnedPixel::pin(const lab::Shot& shot, int x, int y) {
  if (x < 0 || y < 0 || x >= shot.width || y >= shot.height)
    throw Error(fmt::format("pixel {} {} lies outside the picture of {}x{}", x, y, shot.width, shot.height));
  at_ = {x, y};
  follow(shot);
  if (!problem_.empty()) throw Error(problem_);
}

void PinnedPixel::unpin() {
  at_.reset();
  trail_.reset();
  problem_.clear();
}

void PinnedPixel::follow(const lab::Shot& shot) {
  if (!at_) return;
  auto [x, y] = *at_;
  if (x >= shot.width || y >= shot.height) return unpin();
  trail_.reset();
  problem_.clear();
  try {
    trail_ = lab::follow(bench_, shot, x, y).trail;
  } catch (const Error& error) {
    problem_ = error.what();
  }
}

Json PinnedPixel::json() const {
  if (!trail_) throw Error(problem_.empty() ? "no pixel is pinned" : problem_);
  return lab::toJson(*trail_);
}

std::vector<TrailLine> PinnedPixel::lines() const {
  using lab::numbersText;
  std::vector<TrailLine> lines;
  if (!trail_) return lines;
  for (const lab::TrailRow& row : trail_->rows)
    lines.push_back({false, row.node + "." + row.port, lab::valuesText(row), row.doc,
                     fmt::format("{}, {}x{}, texel {}, {}", row.format, row.width, row.height, row.x, row.y)});
  for (const lab::TrailHit& hit : trail_->hits) {
    lines.push_back(
        {true, fmt::format("{}. {}", hit.layer, hit.instance), fmt::format("{:.4g} m", hit.depth),
         fmt::format("geometry {}, triangle {}, {} side", hit.geometry, hit.primitive, hit.front ? "front" : "back"),
         "surface hit by the ray, with its linear view depth"});
    lines.push_back(
        {false, "velocity px", numbersText({hit.velocity.x, hit.velocity.y}), "over the exposure, y down", ""});
    lines.push_back({false, "normal", numbersText({hit.normal.x, hit.normal.y, hit.normal.z}), "world space", ""});
    lines.push_back({false, "colour", numbersText({hit.color.x, hit.color.y, hit.color.z}), "linear radiance", ""});
  }
  return lines;
}

}  // namespace strobe::live
