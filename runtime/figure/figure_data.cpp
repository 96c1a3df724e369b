// SPDX-License-Identifier: MIT
#include "figure/figure_data.h"

#include <array>

#include "base/json.h"
#include "base/strict.h"

namespace strobe::figure {

namespace {

template <class Value>
void take(const Json& from, const char* name, Value& into) {
  if (from.contains(name)) into = from.at(name).get<Value>();
}

dvec2 pointOf(const Json& json) {
  auto n = json.get<std::array<double, 2>>();
  return {n[0], n[1]};
}

Area areaOf(const Json& json) {
  if (json.at(0).is_string()) return {0, 0, json.at(1), json.at(2), json.at(0)};
  auto n = json.get<std::array<double, 4>>();
  return {n[0], n[1], n[2], n[3], ""};
}

void takeColour(const Json& from, const char* name, Colour& into) {
  if (from.contains(name)) into = from.at(name).get<Colour>();
}

Spot spotOf(const Json& json, const char* key) {
  Spot spot;
  take(json, "on", spot.node);
  if (json.contains(key)) spot.pixel = pointOf(json[key]);
  return spot;
}

void takeCommon(const Json& json, Mark& mark) {
  mark.place = placeOf(json, {});
  takeColour(json, "color", mark.colour);
  take(json, "width", mark.width);
  take(json, "text", mark.text);
}

void takeOwn(const Json& json, Arrow& arrow) {
  arrow.to = spotOf(json, "to");
  if (json.contains("from")) arrow.from = pointOf(json["from"]);
  if (json.contains("by")) arrow.by = pointOf(json["by"]);
}

void takeOwn(const Json& json, Circle& circle) {
  circle.at = spotOf(json, "at");
  take(json, "radius", circle.radius);
}

void takeOwn(const Json& json, Box& box) { box.area = areaOf(json.at("area")); }

void takeOwn(const Json& json, Range& range) {
  range.at = pointOf(json.at("at"));
  take(json, "anchor", range.anchor);
  take(json, "along", range.along);
  take(json, "samples", range.samples);
  take(json, "displacement", range.displacement);
}

void takeOwn(const Json& json, Words& words) { words.at = pointOf(json.at("at")); }

template <class Kind>
void takeMarks(const Json& json, const char* name, std::vector<Kind>& into) {
  if (!json.contains(name)) return;
  for (const Json& one : json[name]) {
    takeCommon(one, into.emplace_back());
    takeOwn(one, into.back());
  }
}

Marks marksOf(const Json& json) {
  Marks marks;
  takeMarks(json, "arrows", marks.arrows);
  takeMarks(json, "boxes", marks.boxes);
  takeMarks(json, "circles", marks.circles);
  takeMarks(json, "ranges", marks.ranges);
  takeMarks(json, "texts", marks.texts);
  return marks;
}

Inset insetOf(const Json& json) {
  Inset inset;
  inset.place = placeOf(json, {});
  inset.crop = areaOf(json.at("crop"));
  take(json, "zoom", inset.zoom);
  take(json, "at", inset.at);
  takeColour(json, "frame", inset.frame);
  inset.marks = marksOf(json);
  return inset;
}

CaptionPart partOf(const Json& json) {
  CaptionPart part;
  take(json, "text", part.text);
  take(json, "measure", part.measure);
  take(json, "region", part.region);
  take(json, "option", part.option);
  take(json, "setting", part.setting);
  take(json, "word", part.word);
  take(json, "digits", part.digits);
  if (json.contains("style")) part.style = json["style"].get<std::string>().at(0);
  return part;
}

std::vector<CaptionPart> partsOf(const Json& json, const char* name) {
  std::vector<CaptionPart> parts;
  if (!json.contains(name)) return parts;
  for (const Json& part : json.at(name)) parts.push_back(partOf(part));
  return parts;
}

Cell cellOf(const Json& json, const Place& otherwise) {
  Cell cell;
  cell.place = placeOf(json, otherwise);
  cell.row = json.at("row").get<int>() - 1, cell.column = json.at("column").get<int>() - 1;
  take(json, "shot", cell.shot);
  take(json, "arm", cell.arm);
  if (json.contains("step")) cell.step = json["step"].get<int>();
  take(json, "view", cell.view);
  take(json, "kind", cell.kind);
  take(json, "low", cell.low);
  take(json, "high", cell.high);
  if (json.contains("stops")) cell.stops = json["stops"].get<double>();
  take(json, "against", cell.against);
  take(json, "difference", cell.difference);
  take(json, "gain", cell.gain);
  if (json.contains("crop")) cell.crop = areaOf(json["crop"]);
  take(json, "zoom", cell.zoom);
  take(json, "shrink", cell.shrink);
  take(json, "key", cell.key);
  if (json.contains("frame")) cell.frame = json["frame"].get<Colour>();
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

FigureData read(const Json& data) {
  FigureData figure;
  figure.place = placeOf(data, {});
  take(data, "name", figure.name);
  take(data, "title", figure.title);
  take(data, "note", figure.note);
  take(data, "letters", figure.letters);
  take(data, "attribution", figure.attribution);
  take(data, "gap", figure.gap);
  take(data, "margin", figure.margin);
  take(data, "border", figure.border);
  take(data, "text_size", figure.text_size);
  take(data, "width_mm", figure.width_mm);
  take(data, "cell_width", figure.cell_width);
  take(data, "fps", figure.fps);
  take(data, "format", figure.format);
  auto size = data.at("size").get<std::array<double, 2>>();
  figure.width = int(size[0]), figure.height = int(size[1]);
  if (data.contains("drawn")) {
    auto drawn = data["drawn"].get<std::array<double, 2>>();
    figure.drawn_width = int(drawn[0]), figure.drawn_height = int(drawn[1]);
  }
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
    return read(data);
  } catch (const Json::exception& error) {
    throw Error(fmt::format("the data of a figure cannot be read: {}", error.what()), placeOf(data, {}));
  }
}

}  // namespace strobe::figure
