// SPDX-License-Identifier: MIT
#include "lab/value_bench.h"

#include <algorithm>
#include <cmath>

#include "image/metrics.h"
#include "math/statistics.h"

namespace strobe::lab {

std::vector<std::pair<std::string, std::string>> settingsOf(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> settings;
  for (size_t start = 0; start < text.size();) {
    size_t end = std::min(text.find(',', start), text.size());
    std::string one = text.substr(start, end - start);
    size_t equals = one.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Error(fmt::format("'{}' is not NAME=VALUE or several of them with commas between", text), {}, 2);
    settings.emplace_back(one.substr(0, equals), one.substr(equals + 1));
    start = end + 1;
  }
  return settings;
}

namespace {

struct Runner {
  std::unique_ptr<Session> session;
  std::vector<double> times_ms;
  image::Image color;
};

Runner runnerFor(Workbench& bench, Shot shot, const std::string& settings) {
  for (const auto& [name, value] : settingsOf(settings)) putSetting(shot.sets, name, plan::valueFromText(value));
  return {std::make_unique<Session>(bench, shot), {}, {}};
}

// Counts of passes that declare what was done where they counted.
std::map<std::string, uint64_t> limitsIn(const plan::Plan& plan, const graph::FrameResult& frame) {
  std::map<std::string, uint64_t> limits;
  for (const auto& node : plan.nodes)
    for (const auto& counter : plan.pipeline.passes[size_t(node.pass)].counters) {
      std::string name = plan.pipeline.nodes[size_t(node.node)].name + "." + counter.name;
      for (const auto& [counted, count] : frame.counters)
        if (counted == name && count > 0 && !counter.limit.empty()) limits[name] = count;
    }
  return limits;
}

void compare(const image::Image& color, const image::Image& first, ValueCost& cost) {
  cost.rms = image::rootMeanSquaredError(color, first);
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x)
      for (int c = 0; c < std::min(color.channels, 3); ++c) {
        double difference = std::abs(double(color.at(x, y, c)) - first.at(x, y, c));
        if (difference <= cost.largest) continue;
        cost.largest = difference;
        cost.largest_x = x, cost.largest_y = y;
      }
}

}  // namespace

std::vector<ValueCost> benchValues(Workbench& bench, const Shot& shot, const std::vector<std::string>& settings,
                                   int rounds, const image::Image& reference) {
  std::vector<std::string> tried = {""};
  tried.insert(tried.end(), settings.begin(), settings.end());
  std::vector<Runner> runners;
  std::vector<ValueCost> costs;
  static const std::set<std::string> kColor = {"color"};
  for (const std::string& one : tried) {
    runners.push_back(runnerFor(bench, shot, one));
    graph::FrameResult frame = runners.back().session->draw(&kColor);
    const plan::Plan& plan = runners.back().session->plan();
    runners.back().color = frame.outputs.at("color").floats;
    ValueCost cost;
    cost.settings = one;
    cost.image_bytes = plan::bytesAliased(plan);
    cost.bytes_per_pixel = double(cost.image_bytes) / (double(plan.width) * plan.height);
    cost.limits = limitsIn(plan, frame);
    compare(runners.back().color, runners.front().color, cost);
    if (reference.width > 0) cost.error = image::rootMeanSquaredError(runners.back().color, reference);
    costs.push_back(std::move(cost));
  }
  for (int round = 0; round < rounds; ++round)
    for (Runner& runner : runners) runner.times_ms.push_back(runner.session->draw(&kColor).gpu_ms);
  for (size_t i = 0; i < costs.size(); ++i) costs[i].gpu_ms = median(runners[i].times_ms);
  return costs;
}

std::string tableOf(const std::vector<ValueCost>& costs) {
  bool judged = !costs.empty() && costs.front().error;
  std::string text = "| settings | bytes per pixel | MiB | ms | rms difference | largest (pixel) |";
  text += judged ? " error |\n|---|---|---|---|---|---|---|\n" : "\n|---|---|---|---|---|---|\n";
  for (const ValueCost& cost : costs) {
    std::string name = cost.settings.empty() ? "as it is" : "`" + cost.settings + "`";
    text += fmt::format("| {} | {:.1f} | {:.2f} | {:.1f} | {:.2e} | {:.2e} ({}, {}) |", name, cost.bytes_per_pixel,
                        double(cost.image_bytes) / (1024 * 1024), cost.gpu_ms, cost.rms, cost.largest, cost.largest_x,
                        cost.largest_y);
    text += cost.error ? fmt::format(" {:.6f} |\n", *cost.error) : "\n";
  }
  for (const ValueCost& cost : costs)
    for (const auto& [name, count] : cost.limits)
      text += fmt::format("\n{}: {} = {}", cost.settings.empty() ? "as it is" : cost.settings, name, count);
  return text;
}

Json jsonOf(const std::vector<ValueCost>& costs) {
  Json list = Json::array();
  for (const ValueCost& cost : costs) {
    Json json = {{"settings", cost.settings},
                 {"image_bytes", cost.image_bytes},
                 {"bytes_per_pixel", cost.bytes_per_pixel},
                 {"gpu_ms", cost.gpu_ms},
                 {"rms", cost.rms},
                 {"largest", cost.largest},
                 {"largest_at", {cost.largest_x, cost.largest_y}}};
    if (cost.error) json["error"] = *cost.error;
    json["limits"] = cost.limits;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace strobe::lab
