// SPDX-License-Identifier: MIT
// The interactive page of a report: its contents, its size, and its behaviour in a browser.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/source.h"
#include "image/png.h"
#include "program/run.h"
#include "study/page_images.h"
#include "study/report.h"

namespace strobe::study {
namespace report_page_test {

using image::Image;

constexpr int kWidth = 64, kHeight = 36;

// Stripes; noise of deviation `error` in the right half.
Image pictureOf(int width, int height, double error, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> noise(0, float(error));
  Image picture(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        picture.at(x, y, c) = 0.5f + 0.3f * std::sin(float(x + c * y) * 0.2f) + (x > width / 2 ? noise(random) : 0);
  return picture;
}

// Two shots, three arms, samples and tiles, with pictures in `folder`; one point failed, one is not drawn yet.
Results made(const Path& folder, int width, int height, const std::vector<int>& samples,
             const std::vector<int>& tiles) {
  Results results;
  results.strobe = "0", results.title = "Made </script> up", results.command = "strobe sweep made.lua -o out/made";
  results.device = "device", results.driver = "driver", results.width = width, results.height = height;
  results.regions = {"whole", "inner"}, results.measures = {"rmse", "flip", "ms", "psnr"};
  results.arms = {
      {{"first", "none"}}, {{"second <b>", "none"}}, {{"third", "none"}}, {{"truth", "ground_truth"}, ArmRole::truth}};
  results.shots = {{"near", "Near", "", "", "", 24, 0.5, {{4, 4, 16, 9}}, {}},
                   {"far", "Far", "", "", "", 24, 0.5, {}, {}}};
  results.layout =
      layoutFrom({{"front", {{"x", "ms"}, {"y", "rmse"}, {"region", "inner"}}}, {"table", Json::object()}});
  results.expectations = {{"more is better", "", "", "holds", "1 < 2", ""}};
  for (const auto& [name, values] : {std::pair("samples", samples), std::pair("tile", tiles)}) {
    AxisSummary axis;
    axis.name = axis.title = name;
    for (int value : values) axis.values.push_back(value), axis.labels.push_back(std::to_string(value));
    results.axes.push_back(axis);
  }
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(0.8, 1.25);
  for (const ShotSummary& shot : results.shots)
    for (int sample : samples)
      for (int tile : tiles) {
        PointGroup group{shot.name, "end", {{"samples", sample}, {"tile", tile}}, {}};
        auto add = [&](const std::string& arm, ArmRole role, double error, double ms) {
          Point point;
          point.arm = arm, point.role = role;
          point.key =
              role == ArmRole::truth ? "truth_" + shot.name : fmt::format("{}{}", arm[0], results.groups.size());
          point.command = fmt::format("strobe render {} --set samples={}", arm, sample);
          point.values["rmse"] = {{"whole", error / 4}, {"inner", error}};
          if (role != ArmRole::truth) {
            point.values["flip"] = {{"whole", error / 3}, {"inner", error * 1.2}};
            point.values["psnr"] = {{"whole", -20 * std::log10(error / 4)}, {"inner", -20 * std::log10(error)}};
            point.values["ms"] = {{"all", ms}};
          }
          double spoilt = role == ArmRole::truth ? 0 : error;
          Image picture = pictureOf(width, height, spoilt, unsigned(results.groups.size() * 7 + group.points.size()));
          writeFileAtomically(folder / "points" / (point.key + ".png"), image::encodePng(picture));
          group.points.push_back(point);
        };
        add("truth", ArmRole::truth, 1e-5, 0);
        add("first", ArmRole::method, 0.3 * noise(random), 2 + 0.01 * sample * noise(random));
        add("second <b>", ArmRole::method, 0.8 / sample * noise(random), 3 + 0.1 * sample * noise(random));
        add("third", ArmRole::method, 0.1 * noise(random), 4 + 0.01 * tile * noise(random));
        results.groups.push_back(group);
      }
  Point &failed = results.groups[1].points[1], &undrawn = results.groups[1].points[2];
  failed.values.clear(), failed.failed = "the device was lost", failed.key = "";
  undrawn.values.clear(), undrawn.key = "";
  return resultsFrom(toJson(results), "made");
}

Results small(const Path& folder) { return made(folder, kWidth, kHeight, {2, 4, 8, 16}, {10, 20}); }

page::Library library() { return {"window.d3 = {};", "a library", "its licence */ goes on"}; }

// ---- Data

size_t bytesOf(const WrittenImages& images) {
  size_t bytes = 0;
  for (const std::string& url : images.urls) bytes += url.size();
  return bytes;
}

TEST(PageImages, AreStoredOnceAndExactlyIfTheyFit) {
  testing::TemporaryFolder folder;
  Results results = small(folder.path());
  PageImages images = pageImagesOf(results, folder.path());
  EXPECT_EQ(images.points[0][0].picture, images.points[2][0].picture) << "groups share the truth's picture";
  EXPECT_EQ(images.points[1][1].picture, -1);
  EXPECT_EQ(images.points[0][0].flip, images.points[2][0].flip) << "FLIP of truth against itself is shared";
  EXPECT_GE(images.points[0][1].worst.x, kWidth / 2 - kWorstWidth + 1);
  EXPECT_EQ(images.points[0][1].worst.width, kWorstWidth);

  WrittenImages whole = written(images.sources, 10'000'000), fewer = written(images.sources, bytesOf(whole) / 4);
  EXPECT_EQ(whole.reduced, "");
  for (const std::string& url : whole.urls) EXPECT_TRUE(url.starts_with("data:image/png;base64,"));
  EXPECT_NE(fewer.reduced.find("JPEG"), std::string::npos);
  EXPECT_LE(bytesOf(fewer), bytesOf(whole) / 4);

  writeFileAtomically(folder.path() / "points/f0.png", "no picture");
  EXPECT_THROW(pageImagesOf(results, folder.path()), Error);
}

TEST(ExplorerData, HasPointsNumberedLikeTheTable) {
  testing::TemporaryFolder folder;
  Results results = small(folder.path());
  Json data = explorerData(results, folder.path(), 1'000'000);
  ASSERT_EQ(data["points"].size(), 48u);
  const Json& point = data["points"][8];  // group 2, third arm: "9,third,near,whole,4,10,..."
  EXPECT_EQ(point["n"], 9);
  EXPECT_EQ(point["v"]["ms"], results.groups[2].points[3].value("ms"));
  EXPECT_EQ(point["v"]["rmse"][1], results.groups[2].points[3].value("rmse", "inner"));
  EXPECT_EQ(point["sweep"], "strobe sweep made.lua --only 'arm=third,shot=near,samples=4,tile=10' -o out/again");
  EXPECT_EQ(data["groups"][0]["sigma"][1], 1e-5);
  results.command = "strobe demo made.lua --size 64x36 -o out/demo", results.groups[2].points[3].arm = "it's";
  results.arms[2].name = "it's";
  EXPECT_EQ(explorerData(results, folder.path(), 1'000'000)["points"][8]["sweep"],
            "strobe sweep made.lua --size 64x36 --only 'arm=it'\\''s,shot=near,samples=4,tile=10' -o out/again");
  EXPECT_TRUE(data["points"][4].value("undrawn", false));
  ASSERT_EQ(data["notices"].size(), 2u);
  EXPECT_EQ(data["notices"][0], "1 point is not drawn yet; run the same sweep again to draw them");
  EXPECT_EQ(data["front"]["shot"], "near");
}

// Numbers without pictures, as in an old folder or a copy of result.json.
TEST(ExplorerData, WorksWithoutPictures) {
  testing::TemporaryFolder folder, elsewhere;
  Json data = explorerData(small(folder.path()), elsewhere.path(), 1'000'000);
  EXPECT_TRUE(data["pictures"].empty());
  EXPECT_EQ(data["notices"][2], "46 points have no picture beside the results, in points/");
}

// ---- The page

TEST(ReportPage, ContainsItsLibraryAndData) {
  testing::TemporaryFolder folder;
  std::string page = Report(small(folder.path()), folder.path()).page(library());
  EXPECT_NE(page.find("/*\nits licence * / goes on*/\nwindow.d3 = {};"), std::string::npos);
  EXPECT_NE(page.find("Interactive charts by a library"), std::string::npos);
  EXPECT_NE(page.find("Made \\u003c/script> up"), std::string::npos) << "escaped text cannot end the script";
  EXPECT_NE(page.find("<div class=\"still\">"), std::string::npos) << "static version for print and without scripts";
}

// The worst case for size: 300 points with noise in half of every picture. Scaled down to a quarter of the pixels of
// 320x180 and a quarter of eight megabytes.
TEST(ReportPage, OfThreeHundredPointsMeetsItsSizeLimit) {
  testing::TemporaryFolder folder;
  Results results = made(folder.path(), 160, 90, {1, 2, 4, 8, 16}, {8, 10, 12, 14, 16, 20, 24, 28, 32, 40});
  std::string page = Report(results, folder.path()).page(library(), 2'000'000);
  EXPECT_LE(page.size(), 2'000'000u);
  EXPECT_GT(page.size(), 1'000'000u);
  EXPECT_NE(page.find("pictures are reduced"), std::string::npos);
}

// report_page.py controls the browser and prints its findings.
TEST(ReportPage, WorksInABrowser) {
  page::Library d3 = page::findLibrary();
  if (!d3.found()) GTEST_SKIP() << "no chart library (" << page::kLibraryPackage << ")";
  if (testing::runLine("command -v chromium").exit_code != 0) GTEST_SKIP() << "no Chromium";
  testing::TemporaryFolder folder;
  Results results = small(folder.path());
  writeFileAtomically(folder / "report.html", Report(results, folder.path()).page(d3));
  writeFileAtomically(folder / "still.html", Report(results, folder.path()).page());
  writeFileAtomically(folder / "table.csv", csvOf(results));
  Path script = sourceFolder() / "tests/study/report_page.py";
  testing::Outcome outcome = testing::runLine("python3 '" + script.string() + "' '" + folder.path().string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find("checks, all passed"), std::string::npos) << outcome.out;
}

}  // namespace report_page_test
}  // namespace strobe::study
