// SPDX-License-Identifier: MIT
#include "figure/figure_data.h"

#include <array>

#include "base/json.h"
#include "base/strict.h"

namespace strobe::figure {

namespace {

dvec2 pointOf(const Json& json) {
  auto n = json.get<std::array<double, 2>>();
  return {n[0], n[1]};
}

Area areaOf(const Json& json) {
  if (json.at(0).is_string()) return {0, 0, json.at(1), json.at(2), json.at(0)};
  auto n = json.get<std::array<double, 4>>();
  return {n[0], n[1], n[2], n[3], ""};
}

void read(const Json& json, dvec2& into) { into = pointOf(json); }
void read(const Json& json, Area& into) { into = areaOf(json); }
void read(const Json& json, char& into) { into = json.get<std::string>().at(0); }
template <class Value>
void read(const Json& json, Value& into) {
  json.get_to(into);
}
template <class Value>
void read(const Json& json, std::optional<Value>& into) {
  read(json, into.emplace());
}

// Reads members into variables: name, variable, name, variable ... Members that are missing leave their variables.
template <class Value, class... More>
void take(const Json& from, const char* name, Value& into, More&&... more) {
  if (from.contains(name)) read(from.at(name), into);
  if constexpr (sizeof...(more) > 0) take(from, more...);
}

std::vector<FigureMark> marksOf(const Json& json) {
  using Kind = FigureMark::Kind;
  constexpr std::pair<const char*, Kind> kLists[] = {{"boxes", Kind::box},
                                                     {"circles", Kind::circle},
                                                     {"ranges", Kind::range},
                                                     {"arrows", Kind::arrow},
                                                     {"texts", Kind::text}};
  std::vector<FigureMark> marks;
  for (const auto& [list, kind] : kLists) {
    if (!json.contains(list)) continue;
    for (const Json& one : json[list]) {
      FigureMark& mark = marks.emplace_back();
      mark.kind = kind;
      mark.place = placeOf(one, {});
      take(one, "color", mark.colour, "width", mark.width, "text", mark.text, "on", mark.at.node, "at", mark.at.pixel,
           "to", mark.at.pixel, "from", mark.from, "by", mark.by, "radius", mark.radius, "area", mark.area, "anchor",
           mark.anchor, "along", mark.along, "samples", mark.samples, "displacement", mark.displacement);
    }
  }
  return marks;
}

Inset insetOf(const Json& json) {
  Inset inset;
  inset.place = placeOf(json, {});
  inset.crop = areaOf(json.at("crop"));
  take(json, "zoom", inset.zoom, "at", inset.at, "frame", inset.frame);
  inset.marks = marksOf(json);
  return inset;
}

std::vector<CaptionPart> partsOf(const Json& json, const char* name) {
  std::vector<CaptionPart> parts;
  if (!json.contains(name)) return parts;
  for (const Json& one : json.at(name)) {
    CaptionPart& part = parts.emplace_back();
    take(one, "text", part.text, "measure", part.measure, "region", part.region, "option", part.option, "setting",
         part.setting, "word", part.word, "digits", part.digits, "style", part.style);
  }
  return parts;
}

FigureCell cellOf(const Json& json, const Place& otherwise) {
  FigureCell cell;
  cell.place = placeOf(json, otherwise);
  cell.row = json.at("row").get<int>() - 1, cell.column = json.at("column").get<int>() - 1;
  take(json, "shot", cell.shot, "arm", cell.arm, "step", cell.step, "view", cell.view, "kind", cell.kind, "low",
       cell.low, "high", cell.high, "stops", cell.stops, "against", cell.against, "difference", cell.difference, "gain",
       cell.gain, "crop", cell.crop, "zoom", cell.zoom, "shrink", cell.shrink, "key", cell.key, "frame", cell.frame);
  cell.caption = partsOf(json, "caption");
  if (json.contains("insets"))
    for (const Json& inset : json["insets"]) cell.insets.push_back(insetOf(inset));
  cell.marks = marksOf(json);
  return cell;
}

std::vector<std::string> labelsOf(const Json& lines) {
  std::vector<std::string> labels;
  for (const Json& line : lines) take(line, "label", labels.emplace_back());
  return labels;
}

FigureData figureIn(const Json& data) {
  FigureData figure;
  figure.place = placeOf(data, {});
  dvec2 size = pointOf(data.at("size")), drawn(0);
  take(data, "name", figure.name, "title", figure.title, "note", figure.note, "letters", figure.letters, "attribution",
       figure.attribution, "gap", figure.gap, "margin", figure.margin, "border", figure.border, "text_size",
       figure.text_size, "width_mm", figure.width_mm, "cell_width", figure.cell_width, "fps", figure.fps, "format",
       figure.format, "drawn", drawn);
  figure.width = int(size.x), figure.height = int(size.y);
  figure.drawn_width = int(drawn.x), figure.drawn_height = int(drawn.y);
  figure.rows = labelsOf(data.at("rows")), figure.columns = labelsOf(data.at("columns"));
  for (const Json& row : data["rows"]) {
    figure.headings.push_back({"", partsOf(row, "note")});
    take(row, "title", figure.headings.back().title);
  }
  for (const Json& cell : data.at("cells")) figure.cells.push_back(cellOf(cell, figure.place));
  return figure;
}

}  // namespace

dvec2 FigureData::scale() const {
  if (drawn_width <= 0) return dvec2(1);
  return {double(drawn_width) / width, double(drawn_height) / height};
}

FigureData figureFrom(const Json& data) {
  try {
    return figureIn(data);
  } catch (const Json::exception& error) {
    throw Error(fmt::format("the data of a figure cannot be read: {}", error.what()), placeOf(data, {}));
  }
}

}  // namespace strobe::figure
