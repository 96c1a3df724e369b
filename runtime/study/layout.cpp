// SPDX-License-Identifier: MIT
#include "study/layout.h"

#include <array>

#include "base/json.h"

namespace strobe::study {

std::optional<PicturesLayout> picturesLayoutOf(const Json& layout) {
  if (!layout.contains("pictures")) return std::nullopt;
  const Json& json = layout["pictures"];
  PicturesLayout result;
  if (!json.is_object()) return result;  // empty Lua table
  std::array<double, 2> crop = json.value("crop_size", std::array<double, 2>{120, 68});
  result.crop_width = int(crop[0]), result.crop_height = int(crop[1]);
  result.difference_gain = json.value("difference_gain", result.difference_gain);
  return result;
}

std::optional<CurvesLayout> curvesOf(const Json& layout) {
  if (!layout.contains("curves")) return std::nullopt;
  CurvesLayout result;
  if (layout["curves"].is_object()) result.factor = layout["curves"].value("factor", result.factor);
  return result;
}

std::optional<FrontLayout> frontOf(const Json& layout) {
  if (!layout.contains("front")) return std::nullopt;
  FrontLayout result;
  const Json& json = layout["front"];
  if (!json.is_object()) return result;
  result.title = json.value("title", ""), result.note = json.value("note", "");
  result.x = json.value("x", result.x), result.y = json.value("y", result.y);
  result.region = json.value("region", result.region);
  result.together = json.value("together", result.together);
  return result;
}

std::optional<TableLayout> tableOf(const Json& layout) {
  if (!layout.contains("table") && !layout.empty()) return std::nullopt;
  TableLayout result;
  if (!layout.contains("table") || !layout["table"].is_object()) return result;
  const Json& json = layout["table"];
  using Names = std::vector<std::string>;
  result.title = json.value("title", "");
  result.note = json.value("note", "");
  result.axes = json.value("axes", Names());
  result.cells = json.value("cells", Names());
  result.once = json.value("once", Names());
  result.share = json.value("share", false);
  return result;
}

}  // namespace strobe::study
