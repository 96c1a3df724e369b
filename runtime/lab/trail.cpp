// SPDX-License-Identifier: MIT
#include "lab/trail.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/numbers.h"
#include "lab/session.h"
#include "page/table.h"
#include "plan/filled_images.h"

namespace strobe::lab {

namespace {

std::string shortest(double value) { return fmt::format("{}", float(value)); }

std::vector<double> listOf(const vec2& v) { return {v.x, v.y}; }
std::vector<double> listOf(const vec3& v) { return {v.x, v.y, v.z}; }

// Port `name` of a pass.
const plan::PortDesc& portOf(const plan::PassDesc& pass, const std::string& name) {
  for (const auto* ports : {&pass.writes, &pass.updates})
    for (const plan::PortDesc& port : *ports)
      if (port.name == name) return port;
  assertFailed("port", __FILE__, __LINE__, pass.name + "." + name);
}

void takeTexel(TrailRow& row, const graph::ReadImage& read) {
  if (row.divide == 0 && (row.width > 1 || row.height > 1)) return;
  const auto& floats = read.floats;
  for (int c = 0; c < floats.channels; ++c) row.values.push_back(floats.at(row.x, row.y, c));
  for (int c = 0; c < read.uints.channels; ++c) row.integers.push_back(read.uints.at(row.x, row.y, c));
}

TrailRow rowOf(const plan::PassDesc& pass, const plan::VirtualImage& image, const graph::ReadImage& read, int x,
               int y) {
  TrailRow row;
  size_t dot = image.name.rfind('.');
  row.node = image.name.substr(0, dot);
  row.port = image.name.substr(dot + 1);
  row.format = image.format;
  row.doc = portOf(pass, row.port).doc;
  row.width = image.width, row.height = image.height, row.divide = image.divide;
  if (row.divide > 0) row.x = x / row.divide, row.y = y / row.divide;
  takeTexel(row, read);
  return row;
}

// Removes the taps that only the trail requested, so that the picture equals the result of `render`.
void forget(Picture& picture, const std::vector<std::string>& wanted) {
  std::erase_if(picture.frame.taps,
                [&](const auto& tap) { return std::find(wanted.begin(), wanted.end(), tap.first) == wanted.end(); });
  Json taps = Json::object();
  for (const auto& [name, read] : picture.frame.taps) taps[name] = picture.record["taps"][name];
  if (taps.empty()) picture.record.erase("taps");
  else picture.record["taps"] = taps;
}

void requireInside(const Shot& shot, int x, int y) {
  if (x >= 0 && y >= 0 && x < shot.width && y < shot.height) return;
  throw Error(fmt::format("--pixel {},{} is outside of the picture of {}x{} (0,0 to {},{})", x, y, shot.width,
                          shot.height, shot.width - 1, shot.height - 1),
              {}, 2);
}

std::string texelText(const TrailRow& row) {
  if (row.divide == 1) return "";
  if (row.divide == 0) return fmt::format("whole image, {}x{}", row.width, row.height);
  return fmt::format("tile {},{} of {}x{} px", row.x, row.y, row.divide, row.divide);
}

page::Table imagesOf(const Trail& trail) {
  page::Table table{fmt::format("pixel {},{} of {}x{}, pipeline {}: outputs of every pass, in the order of execution",
                                trail.x, trail.y, trail.width, trail.height, trail.pipeline),
                    {"pass", "image", "format", "texel", "value", "meaning"}};
  for (const TrailRow& row : trail.rows)
    table.add({row.node, row.port, row.format, texelText(row), valuesText(row), row.doc});
  return table;
}

page::Table hitsOf(const Trail& trail) {
  page::Table table{"surfaces on the ray through the pixel, nearest first",
                    {"layer", "instance", "geometry", "primitive", "side", "depth [m]", "normal [world]",
                     "displacement [px]", "color [linear]"}};
  for (const TrailHit& hit : trail.hits)
    table.add({std::to_string(hit.layer), hit.instance, std::to_string(hit.geometry), std::to_string(hit.primitive),
               hit.front ? "front" : "back", shortest(hit.depth), numbersText(listOf(hit.normal), " "),
               numbersText(listOf(hit.velocity), " "), numbersText(listOf(hit.color), " ")});
  return table;
}

// JSON number with the shortest text that reads back to the same float; a text if not finite.
Json numberJson(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  return std::strtod(shortest(value).c_str(), nullptr);
}

Json numbersJson(const std::vector<double>& numbers) {
  Json json = Json::array();
  for (double number : numbers) json.push_back(numberJson(number));
  return json;
}

Json toJson(const TrailRow& row) {
  Json json = {{"node", row.node}, {"port", row.port}, {"format", row.format}, {"doc", row.doc}};
  json["size"] = {row.width, row.height};
  json["pixels_per_texel"] = row.divide;
  if (row.divide > 0) json["texel"] = {row.x, row.y};
  if (!row.integers.empty()) json["values"] = row.integers;
  else if (!row.values.empty()) json["values"] = numbersJson(row.values);
  return json;
}

Json toJson(const TrailHit& hit) {
  Json json = {
      {"layer", hit.layer}, {"instance", hit.instance}, {"geometry", hit.geometry}, {"primitive", hit.primitive}};
  json["side"] = hit.front ? "front" : "back";
  json["depth_m"] = numberJson(hit.depth);
  json["normal"] = numbersJson(listOf(hit.normal));
  json["displacement_px"] = numbersJson(listOf(hit.velocity));
  json["color"] = numbersJson(listOf(hit.color));
  return json;
}

// Trail without hits, from a frame with taps on all ports of the plan.
Trail trailOf(const plan::Plan& plan, const graph::FrameResult& frame, int x, int y) {
  STROBE_ASSERT(x >= 0 && y >= 0 && x < plan.width && y < plan.height, "{},{} of {}x{}", x, y, plan.width, plan.height);
  Trail trail = {plan.pipeline.name, x, y, plan.width, plan.height, {}, {}};
  plan::forFilledImages(plan, [&](const plan::PlanNode& node, const plan::VirtualImage& image) {
    auto tap = frame.taps.find(image.name);
    if (tap == frame.taps.end()) return;
    trail.rows.push_back(rowOf(plan.passOf(node), image, tap->second, x, y));
  });
  return trail;
}

// Hits in a frame of scripts/inspect/hits.lua.
std::vector<TrailHit> hitsOf(const scene::Scene& scene, const graph::FrameResult& frame) {
  const auto& ids = frame.outputs.at("hit").uints;
  const auto& where = frame.outputs.at("where").floats;
  const auto& velocity = frame.outputs.at("velocity").floats;
  const auto& color = frame.outputs.at("color").floats;
  std::vector<IdName> names = idNamesOf(scene);
  std::vector<TrailHit> hits;
  for (int i = 0; i < ids.width && ids.at(i, 0, 0) != 0; ++i) {
    TrailHit hit;
    hit.layer = i;
    hit.instance = nodeOf(names, ids.at(i, 0, 0));
    hit.geometry = ids.at(i, 0, 1) - 1;
    hit.primitive = ids.at(i, 0, 2);
    hit.front = ids.at(i, 0, 3) != 0;
    hit.depth = where.at(i, 0, 0);
    hit.normal = vec3(where.at(i, 0, 1), where.at(i, 0, 2), where.at(i, 0, 3));
    hit.velocity = vec2(velocity.at(i, 0, 0), velocity.at(i, 0, 1));
    hit.color = vec3(color.at(i, 0, 0), color.at(i, 0, 1), color.at(i, 0, 2));
    hits.push_back(hit);
  }
  return hits;
}

// Hits of the ray through a pixel centre in the present scene of a session.
std::vector<TrailHit> hitsAt(const Session& looked_at, int x, int y) {
  Shot shot = looked_at.shot();
  shot.sets = sceneSettings(shot.sets);
  shot.sets.push_back({"pixel_x", int64_t(x)});
  shot.sets.push_back({"pixel_y", int64_t(y)});
  shot.pipeline = looked_at.bench().home().at("scripts/inspect/hits.lua").string();
  shot.taps.clear();
  Session rays(looked_at.bench(), shot, "pixel");
  return hitsOf(rays.scene(), rays.draw());
}

}  // namespace

std::string numbersText(const std::vector<double>& numbers, const char* between) {
  std::vector<std::string> texts;
  for (double number : numbers) texts.push_back(shortest(number));
  return fmt::format("{}", fmt::join(texts, between));
}

std::string valuesText(const TrailRow& row) {
  if (!row.integers.empty()) return fmt::format("{}", fmt::join(row.integers, "  "));
  return row.values.empty() ? "-" : numbersText(row.values);
}

std::array<int, 2> parsePixel(const std::string& text) {
  auto pixel = numbersIn<int, 2>(text, ',');
  if (!pixel) throw Error(fmt::format("--pixel '{}' is not X,Y in pixels from the top left", text), {}, 2);
  return *pixel;
}

Followed follow(Workbench& bench, const Shot& shot, int x, int y, const std::function<void(int, int)>& progress,
                bool id_coverage) {
  Session session(bench, shot);
  requireInside(session.shot(), x, y);
  session.tap(session.ports());
  Followed result;
  result.picture = session.capture(progress, id_coverage);
  result.trail = trailOf(session.plan(), result.picture.frame, x, y);
  result.trail.hits = hitsAt(session, x, y);
  forget(result.picture, shot.taps);
  return result;
}

Json toJson(const Trail& trail) {
  Json json = {{"pipeline", trail.pipeline}, {"pixel", {trail.x, trail.y}}, {"size", {trail.width, trail.height}}};
  json["passes"] = Json::array();
  for (const TrailRow& row : trail.rows) json["passes"].push_back(toJson(row));
  json["hits"] = Json::array();
  for (const TrailHit& hit : trail.hits) json["hits"].push_back(toJson(hit));
  return json;
}

std::string tableOf(const Trail& trail) {
  std::string text = page::textOf(imagesOf(trail)) + "\n";
  return text + (trail.hits.empty() ? "no surface on the ray through the pixel\n" : page::textOf(hitsOf(trail)));
}

}  // namespace strobe::lab
