// SPDX-License-Identifier: MIT
// Reports of extremes: where a method is trusted, that what is measured is what closed forms say, and that the report
// in docs/ is made of its own numbers.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>

#include "base/files.h"
#include "common/home.h"
#include "oracle/render.h"
#include "stability/curves_page.h"
#include "stability/curves_run.h"

namespace strobe::stability::curves {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

// ---- reports

Measured of(double rmse, std::vector<std::string> limits = {}, uint64_t broken = 0) {
  return {{rmse, rmse / 2, kNothing, rmse}, std::move(limits), broken, "strobe render x"};
}

// Contrast 0.5, floor 0.01: one method that is always good, one that is bad everywhere, one that ends on both sides.
Report made() {
  Report report{"0", "A report", "A note.", "strobe bench",           "device", "driver", true, 64, 36,
                2,   "truth",    "floor",   {"good", "bad", "mixed"}, {}};
  ReportAxis axis{"speed", "Speed", "px", "log", "whole", "All else stays.", "", "", 10, true, 0.5, {}};
  for (double value : {1.0, 3.0, 10.0, 30.0, 100.0}) {
    ReportPoint point;
    point.value = value;
    point.label = fmt::format("{:g}", value);
    point.floor = of(0.01);
    point.drift = 1e-6 * value;
    point.methods = {of(0.015), of(0.1 + (value == 100 ? 0.2 : 0)),
                     of(value == 1 ? 0.05 : 0.01,
                        value >= 30 ? std::vector<std::string>{"blur: 7 pixels"} : std::vector<std::string>())};
    axis.points.push_back(point);
  }
  report.axes = {axis};
  return report;
}

TEST(Report, TrustEndsWhereErrorOrLimitBegin) {
  Report report = made();
  const ReportAxis& axis = report.axes[0];
  Trusted good = trustedOf(report, axis, 0, Measure::floor);
  EXPECT_EQ(good.count, 5u);
  EXPECT_EQ(trustedOf(report, axis, 1, Measure::floor).count, 0u) << "ten times the floor";
  Trusted usual = trustedOf(report, axis, 1, Measure::own);
  EXPECT_EQ(usual.first, 0u);
  EXPECT_EQ(usual.count, 4u);
  EXPECT_EQ(usual.above, Doubt::error);
  Trusted mixed = trustedOf(report, axis, 2, Measure::floor);
  EXPECT_EQ(mixed.first, 1u);
  EXPECT_EQ(mixed.count, 2u);
  EXPECT_EQ(mixed.below, Doubt::error);
  EXPECT_EQ(mixed.above, Doubt::limit);
}

TEST(Report, NotFiniteIsNeverTrusted) {
  Report report = made();
  report.axes[0].points[3].methods[0] = of(kNothing, {}, 12);
  EXPECT_EQ(trustedOf(report, report.axes[0], 0, Measure::own).above, Doubt::broken);
  EXPECT_NE(pageOf(report).find("not finite"), std::string::npos);
}

// Truth that is unsure of itself condemns nobody.
TEST(Report, ErrorsWithinThoseOfTruthAreAllowed) {
  Report report = made();
  for (ReportPoint& point : report.axes[0].points) point.sigma = {0.03, 0.03, 0.03, 0.03};
  EXPECT_EQ(trustedOf(report, report.axes[0], 1, Measure::floor).count, 4u) << "0.1 < 2 * 0.01 + 3 * 0.03";
}

TEST(Report, IsTheSameFromDisk) {
  Report report = made();
  Json json = toJson(report);
  Report read = reportFrom(Json::parse(json.dump()), "report.json");
  EXPECT_EQ(toJson(read).dump(), json.dump());
  EXPECT_EQ(pageOf(read), pageOf(report));
  EXPECT_EQ(markdownOf(read, "x.html"), markdownOf(report, "x.html"));
  json.erase("factor");
  EXPECT_THROW(reportFrom(json, "report.json"), Error);
}

TEST(Report, ReadingsAreFilledWithNumbers) {
  Report report = made();
  const ReportAxis& axis = report.axes[0];
  EXPECT_EQ(filled(report, axis, "{good @ 30} of {floor @ 1}; {from mixed} to {to mixed}"),
            "3.00 % of 2.00 %; 3 to 10");
  for (const char* wrong : {"{god @ 30}", "{good @ 31}", "{good}"})
    EXPECT_THROW(filled(report, axis, wrong), Error) << wrong;
}

TEST(Report, ReadingsOfVariantsAreFilledToo) {
  Report report = made();
  report.cases = {"slow", "fast"};
  report.variants = {{"format", "Formats", "fp32", "", {{"good", "fp16", 1, 2, 1, {0.01, 0.02}, {0, 0.5}, {{}, {}}}}}};
  const ReportVariant& variant = report.variants[0];
  EXPECT_EQ(filled(report, variant, "{good, fp16 @ fast} and {change good, fp16 @ fast}"), "2.00 % and 0.5");
  EXPECT_THROW(filled(report, variant, "{good, fp8 @ fast}"), Error);
}

TEST(Report, PageNeedsNoNetwork) {
  std::string page = pageOf(made());
  for (const char* foreign : {"http:", "https:", "<script", "@import", "url(", " src="})
    EXPECT_EQ(page.find(foreign), std::string::npos) << foreign;
  for (const char* wanted : {"nowhere", "3 (error below) to 10 (limit above)", "everywhere", "strobe render x", "<svg"})
    EXPECT_NE(page.find(wanted), std::string::npos) << wanted;
}

// ---- what is measured

class Measuring : public oracle::RenderTest {
 protected:
  static Report measured(const std::string& text) {
    Path file = std::filesystem::temp_directory_path() / fmt::format("strobe_curves_{}.lua", ::getpid());
    writeFileAtomically(file, text);
    Report report = measure(readExperiment(bench().home(), file), bench());
    std::filesystem::remove(file);
    return report;
  }
};

// A white half-plane x < 80 that moves to the right over black. Only its edge blurs, so that no closed form is needed
// for anything but the edge.
const char* const kHalfPlane = R"lua(
local extremes = require "strobe.extremes"
return extremes {
  title = "Half a plane", size = { 160, 4 }, size_params = { "width", "height" }, factor = 2,
  truth = { label = "truth", pipeline = "ground_truth", set = { samples = 512 } },
  floor = { label = "floor", pipeline = "ground_truth", set = { samples = 16 } },
  methods = { { label = "no blur", pipeline = "none", lacks = { "samples" } } },
  axes = {
    { name = "speed", title = "Speed", unit = "px", scale = "log", values = { 5.3, 12.7, 31.9 }, benign = 12.7,
      region = "whole", scene = "oracles/half_plane", fixed = "The edge.", at = function(v) return { scene = { d_f = v } } end },
    { name = "samples", title = "Samples", unit = "", scale = "log", values = { 2, 8, 32 }, benign = 8,
      region = "inner", scene = "oracles/half_plane", fixed = "The edge moves by 12.7 px.",
      at = function(v) return { scene = { d_f = 12.7 }, set = { samples = v }, floor = { samples = v } } end },
  },
}
)lua";

// Truth of 512 midpoints is off by at most 1 / (2 * 512) where one edge passes.
constexpr double kOfTruth = 0.5 / 512;

TEST_F(Measuring, ErrorsAreThoseOfTheClosedForm) {
  Report report = measured(kHalfPlane);
  for (const ReportPoint& point : report.axes[0].points) {
    double squares = 0;
    for (int i = 0; i < 160; ++i) {
      double missed = (i + 0.5 < 80 ? 1 : 0) - oracle::halfPlaneAtCentre(80, point.value, oracle::kCloseAnchor, i);
      squares += missed * missed;
    }
    EXPECT_NEAR(point.methods[0].rmse[0], std::sqrt(squares / 160), kOfTruth) << point.value;
  }

  // The floor of N midpoints against the exact exposure, pixels of the inner blur alone.
  const oracle::Strips plane = {{-oracle::kInfinity, 80, 12.7, {1}}, {-oracle::kInfinity, oracle::kInfinity, 0, {0}}};
  for (const ReportPoint& point : report.axes[1].points) {
    double squares = 0;
    int count = 0, samples = int(point.value);
    for (int i = 67; i < 80; ++i) {
      double mean = 0;
      for (int m = 0; m < samples; ++m)
        mean += oracle::seenAt(plane, i + 0.5, (m + 0.5) / samples - 1).colour / samples;
      double off = mean - oracle::halfPlaneAtCentre(80, 12.7, oracle::kCloseAnchor, i);
      squares += off * off;
      ++count;
    }
    EXPECT_EQ(point.pixels[1], 4u * unsigned(count)) << "inner pixels: those the edge passes";
    EXPECT_NEAR(point.floor.rmse[1], std::sqrt(squares / count), 2 * kOfTruth) << point.value;
  }
  // One over N: 16 times as many samples have a 16th of the error, give or take where the edge happens to lie.
  double ratio = report.axes[1].points[0].floor.rmse[1] / report.axes[1].points[2].floor.rmse[1];
  EXPECT_GT(ratio, 16 / 1.5);
  EXPECT_LT(ratio, 16 * 1.5);
  EXPECT_EQ(report.axes[1].points[0].methods[0].rmse[0], report.axes[1].points[2].methods[0].rmse[0])
      << "lacks samples";
}

// ---- what ships

TEST(Committed, PageAndReadingAreMadeOfTheirNumbers) {
  Path folder = home().shipped() / "docs";
  Report report = reportFrom(Json::parse(readText(folder / "extremes/extremes.json")), "extremes.json");
  EXPECT_EQ(readText(folder / "extremes/extremes.html"), pageOf(report))
      << report.command << " --from docs/extremes/extremes.json";
  EXPECT_EQ(readText(folder / "extremes.md"), markdownOf(report, "extremes/extremes.html"));
  EXPECT_LT(readText(folder / "extremes/extremes.html").size(), 1'500'000u);
}

TEST(Committed, NumbersAreOfTheExperimentAsItIs) {
  Report report = reportFrom(Json::parse(readText(home().shipped() / "docs/extremes/extremes.json")), "extremes.json");
  Experiment experiment = readExperiment(home(), home().at("experiments/extremes.lua").string());
  EXPECT_EQ(report.width, experiment.width);
  ASSERT_EQ(report.methods.size(), experiment.methods.size());
  for (size_t m = 0; m < report.methods.size(); ++m) EXPECT_EQ(report.methods[m], experiment.methods[m].label);
  ASSERT_EQ(report.axes.size(), experiment.axes.size());
  for (size_t a = 0; a < report.axes.size(); ++a) {
    ASSERT_EQ(report.axes[a].points.size(), experiment.axes[a].points.size()) << report.axes[a].name;
    for (size_t i = 0; i < report.axes[a].points.size(); ++i) {
      const AxisPoint& point = experiment.axes[a].points[i];
      EXPECT_EQ(report.axes[a].points[i].value, point.value);
      for (size_t m = 0; m < report.methods.size(); ++m)
        EXPECT_EQ(report.axes[a].points[i].methods[m].command,
                  lab::commandOf(shotOf(experiment, experiment.axes[a], point, experiment.methods[m])));
    }
    EXPECT_EQ(report.axes[a].reading, experiment.axes[a].reading);
  }
}

}  // namespace
}  // namespace strobe::stability::curves
