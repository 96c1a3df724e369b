// SPDX-License-Identifier: MIT
#include "lab/figures.h"

#include <algorithm>
#include <cmath>

namespace strobe::lab {

static const char* const kDash = "–";

std::string shownError(double value) {
  if (std::isnan(value)) return kDash;
  return value == 0 ? "0" : value < 1e-4 ? fmt::format("{:.1e}", value) : fmt::format("{:.5f}", value);
}

std::string shownMs(const Entry& entry) {
  if (!entry.ms) return kDash;
  return *entry.ms < 10 ? fmt::format("{:.2f} ms", *entry.ms) : fmt::format("{:.0f} ms", *entry.ms);
}

std::string describeShot(const ShotResult& result) {
  const Shot& shot = result.resolved;
  std::string text = fmt::format("{}x{}, exposure {:g} of 1/{:g} s, anchor {}", shot.width, shot.height, shot.exposure,
                                 shot.fps, shot.anchor);
  if (!std::isnan(result.displacement_px))
    text += fmt::format(", median displacement of what moves {:.1f} px over the exposure", result.displacement_px);
  return text;
}

std::string describeContrast(const ShotResult& result) {
  if (!result.contrast || result.contrast->pixels == 0) return "";
  const Contrast& c = *result.contrast;
  return fmt::format(
      "Behind the inner blur ({} px): the background's standard deviation is {:.4f}, its mean difference "
      "from the front {:.4f} (ratio {:.2f}).",
      c.pixels, c.deviation, c.difference, c.deviation / c.difference);
}

std::string describeDevice(const Exhibition& exhibition) {
  const gpu::DeviceInfo& device = exhibition.device;
  std::string text = fmt::format("{}, {}", device.name, device.driver);
  return text + (device.software ? "; a software device: its milliseconds are not a GPU's" : "; clocks not locked");
}

std::string describeRole(const DemoColumn& column) {
  switch (column.role) {
    case DemoColumn::Role::truth:
      return "truth; its numbers are its own standard error";
    case DemoColumn::Role::floor:
      return "sampling floor: truth at a method's own times";
    case DemoColumn::Role::method:
      break;
  }
  return "";
}

static const std::vector<std::pair<std::string, std::string>> kMeasureNames = {
    {"rmse", "RMSE"}, {"flip", "FLIP"}, {"hdr_flip", "HDR-FLIP"}};

static double valueOf(const Errors& errors, const std::string& measure) {
  return measure == "rmse" ? errors.rmse : measure == "flip" ? errors.flip : errors.hdr_flip;
}

static bool hasFullShading(const ShotResult& result) { return result.shot->full_shading.has_value(); }

Table tableOf(const Exhibition& exhibition, const ShotResult& result, const Group& group) {
  const Demo& demo = *exhibition.demo;
  Table table;
  table.head = {"method"};
  for (const auto& [measure, name] : kMeasureNames)
    for (const std::string& region : demo.regions)
      if (demo.measures.count(measure)) table.head.push_back(name + " " + region);
  if (hasFullShading(result)) table.head.push_back("RMSE whole, full shading");
  if (demo.measures.count("ms")) table.head.push_back(exhibition.device.software ? "time (software)" : "time");
  table.head.push_back("clamped px");
  for (const Entry& entry : group.entries) {
    std::vector<std::string> row = {entry.column->label};
    if (entry.column->role != DemoColumn::Role::method)
      row[0] += entry.column->role == DemoColumn::Role::truth ? " ±" : " (floor)";
    for (const auto& [measure, name] : kMeasureNames)
      for (const std::string& region : demo.regions)
        if (demo.measures.count(measure)) row.push_back(shownError(valueOf(entry.errors.at(region), measure)));
    if (hasFullShading(result))
      row.push_back(entry.errors.count("whole") ? shownError(entry.errors.at("whole").full_rmse) : kDash);
    if (demo.measures.count("ms")) row.push_back(shownMs(entry));
    row.push_back(std::to_string(entry.clamped));
    table.rows.push_back(row);
  }
  return table;
}

// Characters, not bytes.
static size_t lengthOf(const std::string& text) {
  return size_t(std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xc0) != 0x80; }));
}

static std::string alignedText(const Table& table) {
  std::vector<size_t> widths(table.head.size(), 0);
  auto widen = [&](const std::vector<std::string>& row) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], lengthOf(row[i]));
  };
  widen(table.head);
  for (const auto& row : table.rows) widen(row);
  std::string text;
  auto add = [&](const std::vector<std::string>& row) {
    for (size_t i = 0; i < row.size(); ++i) {
      std::string space(widths[i] - lengthOf(row[i]), ' ');
      text += i == 0 ? row[i] + space : "  " + space + row[i];
    }
    text += "\n";
  };
  add(table.head);
  for (const auto& row : table.rows) add(row);
  return text;
}

static std::string markdownTable(const Table& table) {
  auto line = [](const std::vector<std::string>& row) { return fmt::format("| {} |\n", fmt::join(row, " | ")); };
  std::string text = line(table.head) + "|---|";
  for (size_t i = 1; i < table.head.size(); ++i) text += "---:|";
  text += "\n";
  for (const auto& row : table.rows) text += line(row);
  return text;
}

static std::string regionsText(const Exhibition& exhibition, const Group& group) {
  std::vector<std::string> parts;
  for (const std::string& region : exhibition.demo->regions)
    parts.push_back(fmt::format("{} {} px", region, group.pixels.at(region)));
  return fmt::format("anchor {}; {}", group.anchor, fmt::join(parts, ", "));
}

std::string tablesText(const Exhibition& exhibition) {
  std::string text;
  for (const ShotResult& result : exhibition.shots) {
    text += result.shot->title + "\n";
    if (!result.shot->missing.empty()) {
      text += "skipped: " + result.shot->missing + "\n\n";
      continue;
    }
    text += describeShot(result) + "\n";
    for (const Group& group : result.groups)
      text += regionsText(exhibition, group) + "\n" + alignedText(tableOf(exhibition, result, group)) + "\n";
    if (std::string contrast = describeContrast(result); !contrast.empty()) text += contrast + "\n";
    if (result.verdict) text += result.verdict->text + "\n";
    text += "\n";
  }
  return text + describeDevice(exhibition) + "\n";
}

std::string tablesMarkdown(const Exhibition& exhibition) {
  std::string text = "# " + exhibition.demo->title + "\n\n" + exhibition.demo->note + "\n";
  for (const ShotResult& result : exhibition.shots) {
    text += "\n## " + result.shot->title + "\n\n";
    if (!result.shot->missing.empty()) {
      text += "Skipped: " + result.shot->missing + ".\n";
      continue;
    }
    if (!result.shot->note.empty()) text += result.shot->note + "\n\n";
    text += describeShot(result) + ".\n";
    for (const Group& group : result.groups)
      text +=
          "\nRegions: " + regionsText(exhibition, group) + ".\n\n" + markdownTable(tableOf(exhibition, result, group));
    if (std::string contrast = describeContrast(result); !contrast.empty()) text += "\n" + contrast + "\n";
    if (result.verdict) text += "\n" + result.verdict->text + ".\n";
    if (!result.attribution.empty()) text += "\n" + result.attribution + "\n";
  }
  return text + "\n" + describeDevice(exhibition) + ".\n";
}

// JSON has no NaN: null is "not measured".
static Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

static Json entryJson(const Entry& entry) {
  Json json;
  json["label"] = entry.column->label;
  json["pipeline"] = entry.column->pipeline;
  json["role"] = entry.column->role == DemoColumn::Role::truth   ? "truth"
                 : entry.column->role == DemoColumn::Role::floor ? "floor"
                                                                 : "method";
  for (const auto& [region, errors] : entry.errors)
    json["errors"][region] = {{"rmse", number(errors.rmse)},
                              {"flip", number(errors.flip)},
                              {"hdr_flip", number(errors.hdr_flip)},
                              {"rmse_full_shading", number(errors.full_rmse)}};
  json["gpu_ms"] = entry.ms ? Json(*entry.ms) : Json(nullptr);
  json["clamped_px"] = entry.clamped;
  for (const Path& file : entry.files) json["files"].push_back(file.filename().string());
  json["record"] = entry.record;
  return json;
}

static Json groupJson(const Group& group) {
  Json json;
  json["anchor"] = group.anchor;
  for (const auto& [region, pixels] : group.pixels) json["pixels"][region] = pixels;
  json["flip_exposures"] = {{"start", group.exposures.start},
                            {"stop", group.exposures.stop},
                            {"count", group.exposures.count},
                            {"source", image::exposureSourceName(group.exposures.source)}};
  for (const Entry& entry : group.entries) json["columns"].push_back(entryJson(entry));
  return json;
}

static Json shotJson(const ShotResult& result) {
  Json json;
  json["title"] = result.shot->title;
  json["folder"] = fileNameOf(result.shot->title);
  if (!result.shot->missing.empty()) {
    json["skipped"] = result.shot->missing;
    return json;
  }
  json["exposure"] = result.resolved.exposure;
  json["fps"] = result.resolved.fps;
  json["anchor"] = result.resolved.anchor;
  json["median_displacement_px"] = number(result.displacement_px);
  for (const auto& crop : result.crops) json["crops"].push_back({crop.x, crop.y, crop.width, crop.height});
  if (result.contrast)
    json["background"] = {{"deviation", result.contrast->deviation},
                          {"difference", result.contrast->difference},
                          {"pixels", result.contrast->pixels}};
  if (result.verdict)
    json["expectation"] = {
        {"applies", result.verdict->applies}, {"holds", result.verdict->holds}, {"text", result.verdict->text}};
  if (!result.attribution.empty()) json["attribution"] = result.attribution;
  for (const Group& group : result.groups) json["groups"].push_back(groupJson(group));
  return json;
}

Json toJson(const Exhibition& exhibition) {
  Json json;
  json["strobe"] = STROBE_VERSION;
  json["title"] = exhibition.demo->title;
  json["size"] = {exhibition.demo->width, exhibition.demo->height};
  json["device"] = {
      {"name", exhibition.device.name}, {"driver", exhibition.device.driver}, {"software", exhibition.device.software}};
  for (const auto& dependency : exhibition.demo->dependencies) json["scripts"][dependency.shown] = dependency.hash;
  json["shots"] = Json::array();
  for (const ShotResult& result : exhibition.shots) json["shots"].push_back(shotJson(result));
  return json;
}

}  // namespace strobe::lab
