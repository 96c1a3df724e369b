// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "base/lists.h"
#include "study/effects.h"
#include "study/page_images.h"
#include "study/report.h"

namespace strobe::study {

namespace {

const char* nameOf(Better better) {
  return better == Better::lower ? "lower" : better == Better::higher ? "higher" : "neither";
}

Json measuresJson(const Results& results) {
  Json list = Json::array();
  for (const std::string& name : results.measures) {
    const Measure& one = measureNamed(name);
    list.push_back({{"name", name},
                    {"title", one.title},
                    {"unit", one.unit},
                    {"better", nameOf(one.better)},
                    {"per_region", one.per_region},
                    {"is_time", one.isTime()},
                    {"doc", one.doc}});
  }
  return list;
}

Json shotsJson(const Results& results) {
  Json list = Json::array();
  for (const ShotSummary& shot : results.shots) {
    if (!shot.missing.empty()) continue;
    list.push_back({{"name", shot.name}, {"title", shot.title}, {"crops", toJson(shot.crops)}});
  }
  return list;
}

Json axesJson(const Results& results) {
  Json list = Json::array();
  for (const AxisSummary& axis : results.axes)
    list.push_back({{"name", axis.name}, {"title", axis.title}, {"values", axis.values}, {"labels", axis.labels}});
  return list;
}

// ---- points

std::string labelOf(const Results& results, const std::string& axis, const Json& value) {
  for (const AxisSummary& one : results.axes)
    for (size_t i = 0; i < one.values.size() && one.name == axis; ++i)
      if (one.values[i] == value) return one.labels[i];
  return value.is_string() ? value.get<std::string>() : value.dump();
}

// Command that sweeps this point alone into another folder; "" for results without a sweep.
std::string sweepOf(const Results& results, const PointGroup& group, const Point& point) {
  std::string command = results.command;
  if (command.starts_with("strobe demo ")) command.replace(7, 4, "sweep");
  if (!command.starts_with("strobe sweep ")) return "";
  std::string only = "arm=" + point.arm + ",shot=" + group.shot;
  for (const auto& [axis, value] : group.at) only += "," + axis + "=" + labelOf(results, axis, value);
  for (size_t at = only.find('\''); at != std::string::npos; at = only.find('\'', at + 4)) only.replace(at, 1, "'\\''");
  command = command.substr(0, std::min(command.find(" --only "), command.find(" -o ")));
  return command + " --only '" + only + "' -o out/again";
}

Json valuesJson(const Results& results, const Point& point) {
  Json values = Json::object();
  for (const std::string& name : results.measures) {
    if (!point.values.count(name)) continue;
    if (!measureNamed(name).per_region) {
      values[name] = numberJson(point.value(name));
      continue;
    }
    for (const std::string& region : results.regions) values[name].push_back(numberJson(point.value(name, region)));
  }
  return values;
}

void putImages(Json& json, const PointImages& images) {
  if (images.picture >= 0) json["picture"] = images.picture;
  if (images.flip < 0) return;
  json["flip"] = images.flip;
  json["worst"] = {images.worst.x, images.worst.y, images.worst.width, images.worst.height};
}

struct PointCounts {
  size_t undrawn = 0, failed = 0, without_picture = 0;
};

// Points have the same numbers as in table.csv.
Json pointsJson(const Results& results, const PageImages& images, PointCounts& counts) {
  Json list = Json::array();
  size_t row = 0;
  for (size_t g = 0; g < results.groups.size(); ++g)
    for (size_t i = 0; i < results.groups[g].points.size(); ++i) {
      const PointGroup& group = results.groups[g];
      const Point& point = group.points[i];
      if (point.role == ArmRole::truth) continue;
      auto arm =
          std::find_if(results.arms.begin(), results.arms.end(), [&](const auto& a) { return a.name == point.arm; });
      Json json = {{"n", ++row},
                   {"g", g},
                   {"a", arm - results.arms.begin()},
                   {"v", valuesJson(results, point)},
                   {"command", point.command},
                   {"sweep", sweepOf(results, group, point)}};
      if (!point.limits.empty()) json["limits"] = point.limits;
      if (std::string lack = group.lackOf(point); lack.starts_with("truth: ")) json["limits"].push_back(lack);
      for (const PassTime& pass : point.passes)
        json["passes"].push_back({pass.pass, numberJson(pass.ms), numberJson(pass.low), numberJson(pass.high)});
      if (!point.failed.empty()) json["failed"] = point.failed, ++counts.failed;
      else if (point.values.empty()) json["undrawn"] = true, ++counts.undrawn;
      else if (images.points[g][i].picture < 0) ++counts.without_picture;
      putImages(json, images.points[g][i]);
      list.push_back(std::move(json));
    }
  return list;
}

Json groupsJson(const Results& results, const PageImages& images) {
  Json list = Json::array();
  for (size_t g = 0; g < results.groups.size(); ++g) {
    const PointGroup& group = results.groups[g];
    Json json = {{"shot", group.shot}, {"at", Json::object()}, {"truth", group.truth().command}};
    for (const auto& [axis, value] : group.at) json["at"][axis] = value;
    if (images.points[g].front().picture >= 0) json["picture"] = images.points[g].front().picture;
    for (const std::string& region : results.regions)
      json["sigma"].push_back(numberJson(group.truth().value("rmse", region)));
    list.push_back(std::move(json));
  }
  return list;
}

// ---- effects

Json estimateJson(const Estimate& estimate) {
  auto rounded = [](double value) -> Json {
    if (!std::isfinite(value)) return nullptr;
    return std::strtod(fmt::format("{:.7g}", value).c_str(), nullptr);
  };
  return {rounded(estimate.value), rounded(estimate.low), rounded(estimate.high)};
}

Json mainJson(const FactorEffect& one) {
  static const char* const kComparisons[] = {"paired", "unpaired", "slope"};
  Json json = {{"factor", one.factor}, {"comparison", kComparisons[int(one.comparison)]}};
  if (one.comparison == LevelComparison::slope) {
    json["slope"] = estimateJson(one.slope);
    json["doubling"] = one.doubling;
    return json;
  }
  json["blocks"] = one.effect.blocks, json["incomplete"] = one.effect.incomplete;
  for (const Estimate& level : one.effect.levels) json["levels"].push_back(estimateJson(level));
  return json;
}

Json pairJson(const PairEffect& one, size_t columns) {
  Json json = {{"first", one.first},
               {"second", one.second},
               {"blocks", one.interaction.blocks},
               {"incomplete", one.interaction.incomplete}};
  for (size_t i = 0; i < one.interaction.levels.size(); ++i)
    json["cells"][i / columns].push_back(estimateJson(one.interaction.levels[i]));
  return json;
}

Json effectsJson(const Results& results) {
  Json list = Json::array();
  std::vector<std::string> shots;
  if (results.shots.size() > 1) shots.push_back("");
  for (const ShotSummary& shot : results.shots) shots.push_back(shot.name);
  for (const std::string& shot : shots)
    for (const std::string& name : results.measures) {
      const Measure& measure = measureNamed(name);
      if (measure.better == Better::neither) continue;
      for (const std::string& region : measure.per_region ? results.regions : std::vector<std::string>{""}) {
        Effects effects = effectsOf(results, shot, name, region);
        if (effects.factors.empty()) continue;
        Json json = {{"shot", shot}, {"measure", name}, {"region", region}, {"points", effects.points}};
        for (const Factor& factor : effects.factors)
          json["factors"].push_back({{"name", factor.name}, {"labels", factor.labels}, {"numbers", factor.numbers}});
        json["main"] = json["pairs"] = Json::array();
        for (const FactorEffect& one : effects.main) json["main"].push_back(mainJson(one));
        for (const PairEffect& one : effects.pairs)
          json["pairs"].push_back(pairJson(one, effects.factors[one.second].levels()));
        list.push_back(std::move(json));
      }
    }
  return list;
}

Json noticesOf(const PointCounts& counts, const std::string& reduced) {
  Json notices = Json::array();
  auto say = [&](size_t count, const char* one, const char* more, const char* what) {
    if (count) notices.push_back(fmt::format("{} {}{}", count, count == 1 ? one : more, what));
  };
  say(counts.undrawn, "point is", "points are", " not drawn yet; run the same sweep again to draw them");
  say(counts.failed, "point", "points", " failed");
  say(counts.without_picture, "point has", "points have", " no picture beside the results, in points/");
  if (!reduced.empty())
    notices.push_back("pictures are reduced to keep the page small (" + reduced + "); points/ has them in full size");
  return notices;
}

}  // namespace

FirstView firstViewOf(const Results& results) {
  FirstView view{"", "rmse", contains(results.regions, std::string("inner")) ? "inner" : "whole"};
  for (const std::string name : {"ms", "ms_ratio"})  // times of a software device are comparable only as ratios
    if (contains(results.measures, name) && (view.x.empty() || results.software)) view.x = name;
  if (const auto& front = results.layout.front) view = {front->x, front->y, front->region};
  if (!contains(results.measures, view.y) && !results.measures.empty()) view.y = results.measures.front();
  return view;
}

Json explorerData(const Results& results, const Path& folder, size_t most_bytes) {
  PageImages images = pageImagesOf(results, folder);
  FirstView view = firstViewOf(results);
  PointCounts counts;
  Json data = {{"title", results.title},       {"command", results.command},
               {"software", results.software}, {"size", {results.width, results.height}},
               {"regions", results.regions},   {"measures", measuresJson(results)},
               {"shots", shotsJson(results)},  {"axes", axesJson(results)}};
  for (const ArmSummary& arm : results.arms)
    data["arms"].push_back({{"name", arm.name}, {"role", study::nameOf(arm.role)}});
  data["front"] = {{"x", view.x}, {"y", view.y}, {"region", view.region}};
  data["front"]["shot"] = data["shots"].empty() ? Json("") : data["shots"][0]["name"];
  data["points"] = pointsJson(results, images, counts);
  data["groups"] = groupsJson(results, images);
  data["effects"] = effectsJson(results);
  data["how_to_read_effects"] = kHowToReadEffects;
  size_t rest = data.dump().size();
  WrittenImages pictures = written(images.sources, most_bytes - std::min(most_bytes, rest));
  data["pictures"] = pictures.urls;
  data["notices"] = noticesOf(counts, pictures.reduced);
  return data;
}

}  // namespace strobe::study
