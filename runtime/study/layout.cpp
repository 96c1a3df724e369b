// SPDX-License-Identifier: MIT
#include "study/layout.h"

#include <array>

namespace strobe::study {

namespace {

PicturesLayout picturesFrom(const Json& json) {
  PicturesLayout pictures;
  std::array<double, 2> crop = {double(pictures.crop_width), double(pictures.crop_height)};
  take(json, "crop_size", crop);
  pictures.crop_width = int(crop[0]), pictures.crop_height = int(crop[1]);
  take(json, "difference_gain", pictures.difference_gain);
  return pictures;
}

CurvesLayout curvesFrom(const Json& json) {
  CurvesLayout curves;
  take(json, "factor", curves.factor);
  return curves;
}

FrontLayout frontFrom(const Json& json) {
  FrontLayout front;
  take(json, "title", front.title), take(json, "note", front.note);
  take(json, "x", front.x), take(json, "y", front.y), take(json, "region", front.region);
  take(json, "together", front.together);
  return front;
}

TableLayout tableFrom(const Json& json) {
  TableLayout table;
  take(json, "title", table.title), take(json, "note", table.note);
  take(json, "axes", table.axes), take(json, "cells", table.cells), take(json, "once", table.once);
  take(json, "share", table.share);
  return table;
}

}  // namespace

ReportLayout layoutFrom(const Json& json) {
  ReportLayout layout;
  if (!json.is_object() || json.empty()) return layout;
  layout.json = json;
  layout.table.reset();
  // An empty Lua table is an array.
  auto part = [&](const char* name) { return json[name].is_object() ? json[name] : Json::object(); };
  if (json.contains("pictures")) layout.pictures = picturesFrom(part("pictures"));
  if (json.contains("curves")) layout.curves = curvesFrom(part("curves"));
  if (json.contains("front")) layout.front = frontFrom(part("front"));
  if (json.contains("table")) layout.table = tableFrom(part("table"));
  return layout;
}

}  // namespace strobe::study
