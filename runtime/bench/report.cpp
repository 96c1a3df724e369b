// SPDX-License-Identifier: MIT
#include "bench/report.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "bench/texts.h"
#include "page/number.h"
#include "page/waterfall.h"

namespace strobe::bench {

namespace {

using page::shownShare;
using page::TableCell;

// ---- numbers

std::string shownRatio(double ratio) {
  if (std::isnan(ratio)) return page::kNotMeasured;
  return ratio < 10 ? fmt::format("{:.3f}", ratio) : fmt::format("{:.1f}", ratio);
}

TableCell shareCell(uint64_t part, uint64_t whole) {
  double share = whole > 0 && part > 0 ? double(part) / double(whole) : std::nan("");
  return TableCell(share, shownShare(share));
}

// ---- places

// Shots grouped by scene and size, in the order of the run.
std::vector<std::vector<const ShotTimes*>> placesOf(const Run& run) {
  std::vector<std::vector<const ShotTimes*>> places;
  for (const ShotTimes& shot : run.shots) {
    if (places.empty() || places.back().front()->place() != shot.place()) places.emplace_back();
    places.back().push_back(&shot);
  }
  return places;
}

// ---- tables

page::Table timesTable(const Run& run, const std::vector<const ShotTimes*>& shots) {
  const std::string base = shots.front()->method;
  page::Table table;
  table.columns = {"method",
                   {"frame, median", true},
                   {"95 % interval", true},
                   {"ratio to " + base, true},
                   {"95 % interval", true},
                   {"bytes touched", true},
                   {"rays", true}};
  const bool has_intervals = run.frames_in_flight > 1;
  if (has_intervals)
    table.columns.insert(table.columns.begin() + 3, {{"from frame to frame", true}, {"frames/s", true}});
  for (const ShotTimes* shot : shots) {
    Estimate ms = estimatedMedian(shot->ms), ratio = ratioToBase(run, *shot);
    bool is_base = shot == shots.front();
    std::vector<TableCell> row = {shot->method, timeCell(ms.value), shownRange(ms, shownTime)};
    if (has_intervals) {
      const double interval_ms = median(shot->interval_ms);
      row.push_back(timeCell(interval_ms));
      row.push_back(TableCell(1000 / interval_ms, fmt::format("{:.1f}", 1000 / interval_ms)));
    }
    row.push_back(TableCell(ratio.value, is_base ? "1" : shownRatio(ratio.value)));
    row.push_back(is_base ? "base" : shownRange(ratio, shownRatio));
    row.push_back(bytesCell(bytesOf(shot->passes)));
    row.push_back(countCell(raysOf(shot->passes)));
    table.add(std::move(row));
  }
  return table;
}

page::Table passTable(const ShotTimes& shot) {
  page::Table table;
  table.columns = {"pass",
                   {"median", true},
                   {"95 % interval", true},
                   {"share of the frame", true},
                   {"read", true},
                   {"written", true},
                   {"share of bytes", true},
                   {"rays", true},
                   {"share of rays", true}};
  const double frame_ms = median(shot.ms);
  for (const PassTimes& pass : shot.parts()) {
    Estimate ms = estimatedMedian(pass.ms);
    std::string times = pass.executions > 1 ? fmt::format(", {} times", pass.executions) : "";
    table.add({pass.name + times, timeCell(ms.value), shownRange(ms, shownTime),
               TableCell(ms.value / frame_ms, shownShare(ms.value / frame_ms)), bytesCell(pass.bytes_read),
               bytesCell(pass.bytes_written), shareCell(pass.bytes(), bytesOf(shot.passes)), countCell(pass.rays),
               shareCell(pass.rays, raysOf(shot.passes))});
  }
  return table;
}

// ---- waterfalls

// One bar per part at its median, one after the other.
page::Waterfall waterfallOf(const ShotTimes& shot) {
  page::Waterfall waterfall;
  waterfall.about = fmt::format("{}: passes in order; the table below has the numbers", shot.name());
  waterfall.x.title = "milliseconds, medians";
  double start_ms = 0;
  for (const PassTimes& pass : shot.parts()) {
    Estimate ms = estimatedMedian(pass.ms);
    page::Waterfall::Bar bar{pass.name, start_ms, ms.value, {start_ms + ms.low, start_ms + ms.high}};
    bar.text = shownTime(ms.value);
    bar.tip = fmt::format("{}: {}, {}", pass.name, shownTime(ms.value), shownRange(ms, shownTime));
    bar.hollow = pass.name == kRest;
    waterfall.bars.push_back(std::move(bar));
    start_ms += ms.value;
  }
  return waterfall;
}

// ---- the comparison

std::string basisOf(const TimeComparison& comparison) {
  using Kind = TimeComparison::Kind;
  std::string moved = fmt::format(
      "A time counts as moved if its ratio differs from 1 by more than {} and the 95 % interval excludes 1. Intervals "
      "are not corrected for multiple comparisons, so a few of a hundred exclude 1 by chance.",
      shownShare(comparison.share));
  if (comparison.kind == Kind::blocks)
    return fmt::format(
        "Both programs ran in this session, {} blocks of each in turn. A ratio divides the median of a block, in "
        "milliseconds, by the median of the paired block of the other program. {}",
        comparison.blocks, moved);
  if (comparison.kind == Kind::milliseconds)
    return "The same device at another time: ratios are ratios of milliseconds, so another clock or load changes all "
           "ratios. For a fair comparison, use a program instead of the file: both programs then run alternately. " +
           moved;
  return "The speed of a software device or of another machine changes from session to session, so each time is first "
         "divided by the frame time of the base in the same round. This removes changes that affect all methods alike. "
         "A part counts as moved only if its milliseconds moved too. A difference between sessions can still look like "
         "a difference between programs, because the intervals do not include it. The frame of a base is compared in "
         "milliseconds only, so a change can come from the base or from the machine. For a fair comparison, use a "
         "program instead of the file: both programs then run alternately. " +
         moved;
}

std::string verdictOf(const Change& change) {
  if (change.moved) return change.ratio.value > 1 ? "slower" : "faster";
  return "";
}

void addChange(page::Table& table, const Change& change, bool names_shot) {
  page::Emphasis mark = !change.moved            ? page::Emphasis::none
                        : change.ratio.value > 1 ? page::Emphasis::bad
                                                 : page::Emphasis::best;
  std::string frame = change.is_base ? "frame of the base" : "frame";
  table.add({names_shot ? change.shot->name() : "", change.pass.empty() ? frame : change.pass,
             timeCell(change.before_ms), timeCell(change.now_ms),
             TableCell(change.ratio.value, shownRatio(change.ratio.value), mark),
             TableCell(shownRange(change.ratio, shownRatio), mark), TableCell(verdictOf(change), mark)});
}

// Frames and moved passes, or all.
page::Table changesTable(const TimeComparison& comparison, bool all) {
  page::Table table;
  table.columns = {"shot", "pass", {"before", true}, {"now", true}, {"ratio", true}, {"95 % interval", true}, "moved"};
  for (const Change& change : comparison.changes)
    if (all || change.pass.empty() || change.moved) addChange(table, change, change.pass.empty());
  return table;
}

std::string summaryOf(const TimeComparison& comparison) {
  size_t moved = comparison.moved(), all = comparison.changes.size();
  std::string text = moved ? fmt::format("{} of {} frames and passes moved.", moved, all)
                           : fmt::format("None of {} frames and passes moved.", all);
  auto add = [&](const char* what, const std::vector<std::string>& names) {
    if (!names.empty()) text += fmt::format(" {}: {}.", what, fmt::join(names, "; "));
  };
  add("The runs also differ", comparison.differ);
  add("Removed", comparison.gone);
  add("New", comparison.added);
  return text;
}

// ---- the page

page::Block paragraph(const std::string& text, page::Paragraph::Kind kind) { return page::Paragraph{text, kind}; }

void addComparison(std::vector<page::Block>& blocks, const TimeComparison& comparison) {
  blocks.push_back(page::Heading{"Against " + comparison.against, 2, "against"});
  blocks.push_back(paragraph(summaryOf(comparison), page::Paragraph::Kind::finding));
  blocks.push_back(paragraph(basisOf(comparison), page::Paragraph::Kind::soft));
  blocks.push_back(changesTable(comparison, false));
  blocks.push_back(page::Details{"All frames and passes", {changesTable(comparison, true)}});
}

void addPlace(std::vector<page::Block>& blocks, const Run& run, const std::vector<const ShotTimes*>& shots,
              size_t index) {
  blocks.push_back(page::Heading{shots.front()->place(), 2, fmt::format("place-{}", index + 1)});
  blocks.push_back(timesTable(run, shots));
  if (!run.timesPasses()) return;
  std::vector<page::Waterfall> waterfalls;
  for (const ShotTimes* shot : shots) waterfalls.push_back(waterfallOf(*shot));
  page::align(waterfalls);
  for (size_t i = 0; i < shots.size(); ++i) {
    blocks.push_back(page::Heading{shots[i]->method, 3});
    blocks.push_back(page::Figure{page::svgOf(waterfalls[i]), ""});
    blocks.push_back(passTable(*shots[i]));
  }
}

}  // namespace

std::string textOf(const Run& run, const TimeComparison* comparison) {
  std::string text;
  for (const auto& shots : placesOf(run))
    text += fmt::format("{}\n{}\n", shots.front()->place(), page::textOf(timesTable(run, shots)));
  text += fmt::format("{}.\n{}. {}\n{}\n", deviceOf(run), roundsOf(run), cautionOf(run), kWorkNote);
  if (!comparison) return text;
  return text + fmt::format("\nAgainst {}\n{}\n{}\n{}\n", comparison->against,
                            page::textOf(changesTable(*comparison, false)), summaryOf(*comparison),
                            basisOf(*comparison));
}

page::Page pageOf(const Run& run, const TimeComparison* comparison) {
  page::Page page;
  page.title = "Frame times";
  page.note = fmt::format("{}. {} {}", roundsOf(run), cautionOf(run), kWorkNote);
  if (comparison) addComparison(page.blocks, *comparison);
  std::vector<std::vector<const ShotTimes*>> places = placesOf(run);
  for (size_t i = 0; i < places.size(); ++i) addPlace(page.blocks, run, places[i], i);
  page.footer = {fmt::format("Strobe {} on {}.", run.version, deviceOf(run)), "Made by `" + run.command + "`."};
  return page;
}

// ---- the trace

static constexpr int kThread = 1;

static Json nameEvent(const char* what, int process, const std::string& name) {
  return {{"name", what}, {"ph", "M"}, {"pid", process}, {"tid", kThread}, {"args", {{"name", name}}}};
}

static Json completeEvent(const std::string& name, int process, double start_us, double length_us, const Json& args) {
  return {{"name", name},   {"ph", "X"},      {"cat", "gpu"},     {"pid", process},
          {"tid", kThread}, {"ts", start_us}, {"dur", length_us}, {"args", args}};
}

static Json argumentsOf(const PassTimes& pass) {
  return {{"executions", pass.executions},
          {"bytes_read", pass.bytes_read},
          {"bytes_written", pass.bytes_written},
          {"rays", pass.rays}};
}

static void addShot(Json& events, const ShotTimes& shot, int process) {
  const size_t round = shot.typicalRound();
  events.push_back(nameEvent("process_name", process, shot.name()));
  events.push_back(nameEvent("thread_name", process, shot.method));
  const size_t at = events.size();
  double end_us = 0;
  for (const PassTimes& part : shot.parts()) {
    double length_us = 1000 * part.ms[round];
    events.push_back(completeEvent(part.name, process, end_us, length_us, argumentsOf(part)));
    end_us += length_us;
  }
  events.insert(events.begin() + std::ptrdiff_t(at),
                completeEvent("frame", process, 0, std::max(end_us, 1000 * shot.ms[round]),
                              {{"round", round}, {"ms", shot.ms[round]}}));
}

Json traceOf(const Run& run) {
  Json trace = {{"displayTimeUnit", "ms"},
                {"otherData", {{"device", run.device}, {"driver", run.driver}, {"command", run.command}}},
                {"traceEvents", Json::array()}};
  for (size_t i = 0; i < run.shots.size(); ++i) addShot(trace["traceEvents"], run.shots[i], int(i) + 1);
  return trace;
}

}  // namespace strobe::bench
