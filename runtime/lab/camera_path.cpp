// SPDX-License-Identifier: MIT
#include "lab/camera_path.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/numbers.h"

namespace strobe::lab {

using PathView = std::array<double, 6>;

static CameraKey keyOf(const std::string& text) {
  auto refuse = [&] {
    throw Error(
        fmt::format(
            "--path '{}' is not FRAME=ex,ey,ez,tx,ty,tz: the position of the camera, and a different point to look at",
            text),
        {}, 2);
  };
  size_t equals = text.find('=');
  if (equals == std::string::npos) refuse();
  auto frame = finiteNumber(std::string_view(text).substr(0, equals));
  auto view = numbersIn<double, 6>(std::string_view(text).substr(equals + 1), ',');
  if (!frame || !view) refuse();
  bool finite = std::all_of(view->begin(), view->end(), [](double number) { return std::isfinite(number); });
  if (!finite || std::equal(view->begin(), view->begin() + 3, view->begin() + 3)) refuse();
  return {*frame, *view};
}

std::vector<CameraKey> cameraKeys(const std::vector<std::string>& texts) {
  std::vector<CameraKey> keys;
  for (const std::string& text : texts) keys.push_back(keyOf(text));
  std::stable_sort(keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.frame < b.frame; });
  for (size_t i = 1; i < keys.size(); ++i)
    if (keys[i].frame == keys[i - 1].frame)
      throw Error(fmt::format("--path has two keys of frame {}", keys[i].frame), {}, 2);
  return keys;
}

// Rate of change per frame at key i.
static PathView rateAt(const std::vector<CameraKey>& keys, size_t i) {
  const CameraKey &before = keys[i == 0 ? 0 : i - 1], &after = keys[std::min(i + 1, keys.size() - 1)];
  PathView rate{};
  for (size_t c = 0; c < 6; ++c) rate[c] = (after.view[c] - before.view[c]) / (after.frame - before.frame);
  return rate;
}

static PathView beyond(const std::vector<CameraKey>& keys, size_t i, double frame) {
  PathView view = keys[i].view, rate = rateAt(keys, i);
  for (size_t c = 0; c < 6; ++c) view[c] += rate[c] * (frame - keys[i].frame);
  return view;
}

PathView viewAt(const std::vector<CameraKey>& keys, double frame) {
  if (keys.size() == 1) return keys.front().view;
  if (frame <= keys.front().frame) return beyond(keys, 0, frame);
  if (frame >= keys.back().frame) return beyond(keys, keys.size() - 1, frame);
  size_t next = 1;
  while (keys[next].frame < frame) ++next;
  const CameraKey &a = keys[next - 1], &b = keys[next];
  const PathView rate_a = rateAt(keys, next - 1), rate_b = rateAt(keys, next);
  double length = b.frame - a.frame, t = (frame - a.frame) / length, s = 1 - t;
  PathView view{};
  for (size_t c = 0; c < 6; ++c)  // cubic Hermite form
    view[c] = s * s * (1 + 2 * t) * a.view[c] + t * t * (3 - 2 * t) * b.view[c] +
              length * s * t * (s * rate_a[c] - t * rate_b[c]);
  return view;
}

}  // namespace strobe::lab
