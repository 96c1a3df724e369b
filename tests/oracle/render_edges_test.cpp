// SPDX-License-Identifier: MIT
// The renderer's edge detectors: pixel by pixel against their formulas in double precision, on the rendered depths,
// normals and ids; and their main properties, on depths given by formulas.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "common/source.h"
#include "math/constants.h"
#include "oracle/render.h"

namespace strobe::oracle {
namespace render_edges_test {

const std::vector<std::string> kDetectors = {"canny",   "id",     "laplacian",  "plane", "prewitt",
                                             "roberts", "scharr", "silhouette", "sobel"};

lab::Shot detected(const lab::Shot& shot, const std::string& edge, std::vector<std::string> settings = {}) {
  settings.push_back("edge=" + edge);
  return with(shot, sourceFolder().string() + "/tests/oracle/pipelines/edges_alone.lua", settings);
}

// --- Response of a detector in double precision: above 1 is an edge

using Kernel = std::array<std::array<double, 3>, 3>;

// Depth, normal and id of a picture, clamped at its border.
class Seen {
 public:
  explicit Seen(const lab::Picture& picture)
      : width(imageOf(picture, "depth").width),
        height(imageOf(picture, "depth").height),
        depth_(imageOf(picture, "depth")),
        normal_(imageOf(picture, "normal")),
        id_(picture.frame.outputs.at("id").uints) {}

  double depth(int x, int y) const { return depth_.at(column(x), row(y), 0); }
  dvec3 normal(int x, int y) const {
    const float* n = normal_.pixel(column(x), row(y));
    return dvec3(n[0], n[1], n[2]);
  }
  uint32_t id(int x, int y) const { return id_.at(column(x), row(y), 0); }
  bool isInside(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  bool isSurface(int x, int y) const { return std::isfinite(depth(x, y)); }

  const int width, height;

 private:
  int column(int x) const { return std::clamp(x, 0, width - 1); }
  int row(int y) const { return std::clamp(y, 0, height - 1); }
  image::Image depth_, normal_;
  image::UintImage id_;
};

constexpr double kDepthThreshold = .05, kNormalThreshold = .8, kPlaneThreshold = .02;

// Gradient lengths of depth and normal by two kernels, given as functions of the offset.
using Weight = std::function<double(int x, int y)>;
struct Steps {
  double depth = 0, normal = 0;
  double answer() const { return std::max(depth / kDepthThreshold, normal / kNormalThreshold); }
};

Steps gradientAt(const Seen& seen, int x, int y, int radius, const Weight& in_x, const Weight& in_y) {
  double own = seen.depth(x, y), depth[2] = {0, 0};
  dvec3 normal[2] = {dvec3(0), dvec3(0)};
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        double weight = axis == 0 ? in_x(i, j) : in_y(i, j);
        depth[axis] += weight * std::min(seen.depth(x + i, y + j) / own, 16.);
        normal[axis] += weight * seen.normal(x + i, y + j);
      }
  return {std::hypot(depth[0], depth[1]), std::hypot(length(normal[0]), length(normal[1]))};
}

double byKernel(const Seen& seen, int x, int y, const Kernel& kernel) {
  auto in_x = [&](int i, int j) { return kernel[size_t(j + 1)][size_t(i + 1)]; };
  return gradientAt(seen, x, y, 1, in_x, [&](int i, int j) { return in_x(j, i); }).answer();
}

Kernel scaled(Kernel kernel, double factor) {
  for (auto& row : kernel)
    for (double& value : row) value *= factor;
  return kernel;
}
const Kernel kSobel = scaled({{{-1, 0, 1}, {-2, 0, 2}, {-1, 0, 1}}}, 1. / 4);
const Kernel kPrewitt = scaled({{{-1, 0, 1}, {-1, 0, 1}, {-1, 0, 1}}}, 1. / 3);
const Kernel kScharr = scaled({{{-3, 0, 3}, {-10, 0, 10}, {-3, 0, 3}}}, 1. / 16);

double byRoberts(const Seen& seen, int x, int y) {
  auto down = [](int i, int j) { return i == j && i >= 0 ? (i == 1 ? 1 : -1) * std::sqrt(.5) : 0; };
  auto up = [](int i, int j) { return i + j == 1 && i >= 0 && j >= 0 ? (i == 1 ? 1 : -1) * std::sqrt(.5) : 0; };
  return gradientAt(seen, x, y, 1, down, up).answer();
}

// Second differences of the inverse depth; `radius` in px.
double byLaplacian(const Seen& seen, int x, int y, int radius, const Weight& weight) {
  double own = seen.depth(x, y), depth = 0, unit = 0;
  dvec3 normal(0);
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) {
      if (i > 0) unit += weight(i, j);
      if (!seen.isInside(x + i, y + j) || !seen.isInside(x - i, y - j)) continue;
      depth += weight(i, j) * (std::min(own / seen.depth(x + i, y + j), 16.) - 1);
      normal += weight(i, j) * (seen.normal(x + i, y + j) - seen.normal(x, y));
    }
  return Steps{std::abs(depth / unit), length(normal / unit)}.answer();
}

double offPlane(const Seen& seen, int x, int y, int i, int j) {
  if (!seen.isInside(x + i, y + j) || !seen.isInside(x - i, y - j)) return 0;
  double own = seen.depth(x, y);
  double ahead = std::min(own / seen.depth(x + i, y + j), 16.), behind = std::min(own / seen.depth(x - i, y - j), 16.);
  return std::abs(ahead + behind - 2) / kPlaneThreshold;
}

double byPlane(const Seen& seen, int x, int y) {
  double answer = std::max(offPlane(seen, x, y, 1, 0), offPlane(seen, x, y, 0, 1));
  for (auto [i, j] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
    answer = std::max(answer, length(seen.normal(x + i, y + j) - seen.normal(x, y)) / kNormalThreshold);
  return answer;
}

// With `stands_off` the neighbour must also be off the tangent plane.
double bySilhouette(const Seen& seen, int x, int y, bool stands_off) {
  double answer = 0;
  for (auto [i, j] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    bool beyond = seen.id(x + i, y + j) != seen.id(x, y) && seen.depth(x + i, y + j) > seen.depth(x, y);
    if (beyond) answer = std::max(answer, stands_off ? offPlane(seen, x, y, i, j) : kInfinity);
  }
  return answer;
}

double answerOf(const std::string& detector, const Seen& seen, int x, int y) {
  auto all_but_centre = [](int i, int j) { return i == 0 && j == 0 ? 0. : 1.; };
  auto four = [](int i, int j) { return std::abs(i) + std::abs(j) == 1 ? 1. : 0.; };
  auto log = [](int i, int j) { return (i * i + j * j - 2) * std::exp(-.5 * (i * i + j * j)); };
  if (!seen.isSurface(x, y)) return 0;
  if (detector == "sobel") return byKernel(seen, x, y, kSobel);
  if (detector == "prewitt") return byKernel(seen, x, y, kPrewitt);
  if (detector == "scharr") return byKernel(seen, x, y, kScharr);
  if (detector == "roberts") return byRoberts(seen, x, y);
  if (detector == "laplacian four") return byLaplacian(seen, x, y, 1, four);
  if (detector == "laplacian eight") return byLaplacian(seen, x, y, 1, all_but_centre);
  if (detector == "laplacian log") return byLaplacian(seen, x, y, 3, log);
  if (detector == "plane") return byPlane(seen, x, y);
  if (detector == "silhouette") return bySilhouette(seen, x, y, true);
  return bySilhouette(seen, x, y, false);
}

// --- Canny's steps: smooth, differentiate, keep ridges, flood

// The direction is the principal axis of the summed outer products of all components, divided by their thresholds.
struct Slope {
  double answer = 0, angle = 0;
};

Slope slopeAt(const Seen& seen, int x, int y) {
  if (!seen.isInside(x, y) || !seen.isSurface(x, y)) return {};
  double sum = 0;
  for (int i = -2; i <= 2; ++i) sum += std::exp(-.5 * i * i);
  auto gauss = [&](int i) { return std::abs(i) > 2 ? 0 : std::exp(-.5 * i * i) / sum; };
  double unit = gauss(0) + gauss(1);  // response to a unit step after smoothing
  auto smoothed = [&](const Kernel& sobel, int i, int j) {
    double weight = 0;
    for (int b = -1; b <= 1; ++b)
      for (int a = -1; a <= 1; ++a) weight += sobel[size_t(b + 1)][size_t(a + 1)] * gauss(i - a) * gauss(j - b);
    return weight / unit;
  };
  double own = seen.depth(x, y), xx = 0, xy = 0, yy = 0;
  std::array<std::array<double, 2>, 4> slope{};
  for (int j = -3; j <= 3; ++j)
    for (int i = -3; i <= 3; ++i) {
      dvec3 n = seen.normal(x + i, y + j);
      const double feature[4] = {n.x / kNormalThreshold, n.y / kNormalThreshold, n.z / kNormalThreshold,
                                 std::min(seen.depth(x + i, y + j) / own, 16.) / kDepthThreshold};
      for (size_t c = 0; c < 4; ++c) {
        slope[c][0] += smoothed(kSobel, i, j) * feature[c];
        slope[c][1] += smoothed(kSobel, j, i) * feature[c];
      }
    }
  double normal = 0;
  for (size_t c = 0; c < 4; ++c) {
    xx += slope[c][0] * slope[c][0];
    xy += slope[c][0] * slope[c][1];
    yy += slope[c][1] * slope[c][1];
    if (c < 3) normal = std::hypot(normal, slope[c][0], slope[c][1]);
  }
  return {std::max(std::hypot(slope[3][0], slope[3][1]), normal), .5 * std::atan2(2 * xy, xx - yy)};
}

// 2 strong, 1 weak, 0 no edge.
int ridgeAt(const Seen& seen, int x, int y) {
  Slope slope = slopeAt(seen, x, y);
  const int dx[] = {0, 1, 1, 1, 0}, dy[] = {-1, -1, 0, 1, 1};
  int sector = int(std::lround(slope.angle / (kPi / 4))) + 2;
  if (slope.answer <= .5) return 0;
  bool is_ridge = slope.answer > slopeAt(seen, x - dx[sector], y - dy[sector]).answer &&
                  slope.answer >= slopeAt(seen, x + dx[sector], y + dy[sector]).answer;
  return is_ridge ? (slope.answer > 1 ? 2 : 1) : 0;
}

// Edges, flooded from strong ridges along weak ones. The flood is longer than every edge in these pictures.
std::vector<bool> cannyOf(const Seen& seen) {
  std::vector<int> ridge;
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) ridge.push_back(ridgeAt(seen, x, y));
  std::vector<bool> edge(ridge.size());
  std::vector<int> open;
  for (size_t i = 0; i < ridge.size(); ++i)
    if (ridge[i] == 2) open.push_back(int(i));
  while (!open.empty()) {
    int at = open.back(), x = at % seen.width, y = at / seen.width;
    open.pop_back();
    if (edge[size_t(at)]) continue;
    edge[size_t(at)] = true;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if (int beside = at + j * seen.width + i; seen.isInside(x + i, y + j) && ridge[size_t(beside)])
          open.push_back(beside);
  }
  return edge;
}

constexpr double kNear = 105;  // the reliefs step from depth 100 to 110

// --- Pixel by pixel

class RenderEdges : public RenderTest {
 protected:
  static image::Image edgesOf(const lab::Shot& shot) { return imageOf(render(shot), "edge"); }
  // Number of edge pixels.
  static int count(const image::Image& edges) {
    int sum = 0;
    for (float value : edges.values) sum += value > .5f;
    return sum;
  }
  // Expects `expected` as the largest response to depth on near pixels, 5 px or more from the border: edges exist with
  // a threshold just below it, but not with a threshold just above it.
  static void expectAnswer(const lab::Shot& shot, const std::string& detector, double expected, double tolerance,
                           std::vector<std::string> settings = {}) {
    std::string node = detector == "canny" ? "edge_gradient" : "edge";
    if (detector == "canny") settings.push_back("edge_thin.ratio=1");
    if (detector != "silhouette") settings.push_back(node + ".normal_threshold=16");
    for (double factor : {1 - tolerance, 1 + tolerance}) {
      std::vector<std::string> at = settings;
      at.push_back(fmt::format("{}.depth_threshold={:.9g}", node, expected * factor));
      lab::Picture picture = render(detected(shot, detector, at));
      int edges = 0;
      for (int y = 5; y < shot.height - 5; ++y)
        for (int x = 5; x < shot.width - 5; ++x)
          edges += imageOf(picture, "edge").at(x, y, 0) > .5f && imageOf(picture, "depth").at(x, y, 0) < kNear;
      EXPECT_EQ(edges > 0, factor < 1) << detector << " " << fmt::format("{}", fmt::join(at, " "));
    }
  }
};

// Single precision may decide differently only if the response is within 1e-4 of 1: depths have 7 digits, and their
// differences are at least a hundredth of the depth.
TEST_F(RenderEdges, DetectorsMatchTheirFormulas) {
  for (const std::string scene : {"crowd", "solids"}) {
    for (std::string name : {"sobel", "prewitt", "scharr", "roberts", "laplacian four", "laplacian eight",
                             "laplacian log", "plane", "silhouette", "id"}) {
      size_t space = name.find(' ');
      std::vector<std::string> settings;
      if (space != std::string::npos) settings = {"edge.kernel=" + name.substr(space + 1)};
      lab::Picture picture = render(detected(shotOf(scene, 64, 40), name.substr(0, space), settings));
      Seen seen(picture);
      int wrong = 0, edges = 0;
      for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
          double answer = answerOf(name, seen, x, y);
          bool edge = imageOf(picture, "edge").at(x, y, 0) > .5f;
          edges += edge;
          wrong += edge != (answer > 1) && !(std::abs(answer - 1) <= 1e-4);
        }
      EXPECT_EQ(wrong, 0) << scene << " " << name;
      EXPECT_GE(edges, 100) << scene << " " << name;
    }
  }
}

TEST_F(RenderEdges, DepthAndNormalCombineBySumOrAnd) {
  auto in_x = [](int i, int j) { return kSobel[size_t(j + 1)][size_t(i + 1)]; };
  auto in_y = [&](int i, int j) { return in_x(j, i); };
  for (const std::string scene : {"crowd", "solids"}) {
    for (const std::string combine : {"sum", "and"}) {
      lab::Picture picture = render(detected(shotOf(scene, 64, 40), "sobel", {"edge.combine=" + combine}));
      Seen seen(picture);
      int wrong = 0, edges = 0;
      for (int y = 0; y < seen.height; ++y)
        for (int x = 0; x < seen.width; ++x) {
          Steps steps = seen.isSurface(x, y) ? gradientAt(seen, x, y, 1, in_x, in_y) : Steps();
          double depth = steps.depth / kDepthThreshold, normal = steps.normal / kNormalThreshold;
          double answer = combine == "sum" ? depth + normal : std::min(depth, normal);
          bool edge = imageOf(picture, "edge").at(x, y, 0) > .5f;
          edges += edge;
          wrong += edge != (answer > 1) && !(std::abs(answer - 1) <= 1e-4);
        }
      EXPECT_EQ(wrong, 0) << scene << " " << combine;
      EXPECT_GE(edges, combine == "sum" ? 100 : 10) << scene << " " << combine;
    }
  }
}

// No response in these pictures is close enough to a threshold, a neighbour's response or a sector's border for
// rounding to decide.
TEST_F(RenderEdges, CannyMatchesItsFourSteps) {
  for (const std::string scene : {"crowd", "solids"}) {
    lab::Picture picture = render(detected(shotOf(scene, 64, 40), "canny"));
    Seen seen(picture);
    std::vector<bool> expected = cannyOf(seen);
    int wrong = 0;
    for (int i = 0; i < seen.width * seen.height; ++i)
      wrong += expected[size_t(i)] != (imageOf(picture, "edge").values[size_t(i)] > .5f);
    EXPECT_EQ(wrong, 0) << scene;
    EXPECT_GE(std::count(expected.begin(), expected.end(), true), 100) << scene;
  }
}

// --- Steps of known height

// A step from 100 to 110: 1/10 of the near side's depth, or 1 - 10/11 in inverse depth. A tolerance of .001 separates
// neighbouring weights of every kernel; single precision is accurate to 1e-5.
TEST_F(RenderEdges, ResponseToAStepIsItsRelativeHeight) {
  lab::Shot step = shotOf("relief", 32, 32, {{"field", 1}, {"step", .1}});
  for (const char* detector : {"sobel", "prewitt", "scharr", "roberts", "canny"})
    expectAnswer(step, detector, .1, .001);
  for (const char* kernel : {"four", "eight"})
    expectAnswer(step, "laplacian", 1 - 1 / 1.1, .001, {fmt::format("edge.kernel={}", kernel)});
  expectAnswer(step, "laplacian", (1 - 1 / 1.1) * 1.00504, .001, {"edge.kernel=log"});  // larger at the second pixel
  expectAnswer(step, "plane", 1 - 1 / 1.1, .001);
  expectAnswer(step, "roberts", .1, .001, {"edge.norm=l1"});
}

// Response of [side middle side] x [-1 0 1] to a wave of k rad/px along an axis and along a diagonal: equal within 1 %
// for Scharr, 3 % for Sobel and 6 % for Prewitt. Tolerance .002: a pixel's phase is at most .042 from the steepest one
// (.0009), and its depth differs by 2 % (.0002).
TEST_F(RenderEdges, ScharrDependsLeastOnDirection) {
  const double k = .85, height = .02;
  const std::pair<const char*, double> sides[] = {{"scharr", 3. / 16}, {"sobel", 1. / 4}, {"prewitt", 1. / 3}};
  double worst = 0;
  for (auto [detector, side] : sides) {
    double axis = 2 * std::sin(k), along = k / std::sqrt(2.);
    double diagonal = 2 * std::sqrt(2.) * std::sin(along) * (1 - 2 * side + 2 * side * std::cos(along));
    for (bool turned : {false, true}) {
      lab::Shot wave = shotOf("relief", 64, 64, {{"angle", turned ? 45 : 0}, {"k", k}, {"step", height}});
      expectAnswer(wave, detector, height * (turned ? diagonal : axis), .002);
    }
    EXPECT_GE(std::abs(1 - diagonal / axis), 2 * worst) << detector;
    worst = std::abs(1 - diagonal / axis);
  }
}

// --- Edges of a bar [96, 160)

std::vector<int> columnsOf(const image::Image& edges) {
  std::vector<int> columns;
  for (int x = 0; x < edges.width; ++x)
    if (edges.at(x, edges.height / 2, 0) > .5f) columns.push_back(x);
  return columns;
}

TEST_F(RenderEdges, DetectorsMarkTheExpectedPixelsOfAStep) {
  const std::vector<int> near = {96, 159}, both = {95, 96, 159, 160}, wide = {94, 95, 96, 97, 158, 159, 160, 161};
  lab::Shot bar = shotOf("bar", 256, 16);
  for (const char* detector : {"id", "silhouette", "canny"})
    EXPECT_EQ(columnsOf(edgesOf(detected(bar, detector, {}))), near) << detector;
  for (const char* detector : {"sobel", "prewitt", "scharr", "laplacian", "plane"})
    EXPECT_EQ(columnsOf(edgesOf(detected(bar, detector))), both) << detector;
  EXPECT_EQ(columnsOf(edgesOf(detected(bar, "laplacian", {"edge.kernel=log"}))), wide);
  // Edges by Roberts lie half a pixel to the right and below: the left edge falls on the background.
  EXPECT_EQ(columnsOf(edgesOf(detected(bar, "roberts"))), (std::vector<int>{95, 159}));
}

// --- Planes

// The floor of `solids` without the rows beside the horizon and without pixels within 4 px of another instance. Only
// Sobel finds edges there.
TEST_F(RenderEdges, PlaneDetectorsFindNoEdgeOnAFloor) {
  for (std::string name : {"plane", "plane distance", "laplacian", "laplacian log", "silhouette", "sobel"}) {
    size_t space = name.find(' ');
    std::vector<std::string> settings;
    if (name == "plane distance") settings = {"edge.measure=distance"};
    if (name == "laplacian log") settings = {"edge.kernel=log"};
    lab::Picture picture = render(detected(shotOf("solids", 96, 64), name.substr(0, space), settings));
    Seen seen(picture);
    int floor = 0, marked = 0;
    for (int y = 33; y < seen.height; ++y)
      for (int x = 0; x < seen.width; ++x) {
        bool alone = true;
        for (int j = -4; j <= 4; ++j)
          for (int i = -4; i <= 4; ++i) alone = alone && seen.id(x + i, y + j) == 1;
        floor += alone;
        marked += alone && imageOf(picture, "edge").at(x, y, 0) > .5f;
      }
    EXPECT_GE(floor, 1000);
    if (name == "sobel") {
      EXPECT_GE(marked, floor / 2) << "rows change by 2 / y of their depth, above .05 within 40 px of the horizon";
    } else {
      EXPECT_EQ(marked, 0) << name;
    }
  }
}

// The tangent plane at the ball's outline contains the view ray, so the background lies near that plane.
TEST_F(RenderEdges, PlaneDistanceMissesOutlinesOfABall) {
  lab::Shot solids = shotOf("solids", 96, 64);
  const std::string threshold = "edge.depth_threshold=0.2";  // the wall is .44 of its depth behind the ball
  lab::Picture picture = render(detected(solids, "id"));
  Seen seen(picture);
  image::Image by_distance = edgesOf(detected(solids, "silhouette", {"edge.measure=distance", threshold}));
  image::Image by_depth = edgesOf(detected(solids, "silhouette", {threshold}));
  int missed_by_distance = 0, missed_by_depth = 0;
  for (int y = 0; y < seen.height; ++y)
    for (int x = 0; x < seen.width; ++x) {
      if (seen.id(x, y) != 4 || imageOf(picture, "edge").at(x, y, 0) < .5f) continue;
      missed_by_distance += by_distance.at(x, y, 0) < .5f;
      missed_by_depth += by_depth.at(x, y, 0) < .5f;
    }
  EXPECT_EQ(missed_by_depth, 0);
  EXPECT_GE(missed_by_distance, 1);
}

// --- Canny

// Column 19 is strong down to about row 25, where the step is .1, and weak below. Column 43 is weak throughout.
TEST_F(RenderEdges, CannyKeepsWeakEdgesThatMeetStrongOnes) {
  lab::Shot relief = shotOf("relief", 64, 64, {{"field", 2}, {"step", .3}, {"weak", .07}});
  relief = with(relief, "", {"edge_gradient.depth_threshold=0.1", "edge_gradient.normal_threshold=16"});
  auto lastRow = [&](const std::string& setting) {
    image::Image edges = edgesOf(detected(relief, "canny", {setting}));
    int last = -1;
    for (int y = 0; y < 64; ++y) {
      EXPECT_LT(edges.at(43, y, 0), .5f) << y;
      if (edges.at(19, y, 0) > .5f) {
        EXPECT_EQ(last, y - 1);
        last = y;
      }
    }
    return last;
  };
  int strong = lastRow("edge.reach=0");
  EXPECT_NEAR(strong, 4 + 24 * .2 / .23, 2);
  EXPECT_EQ(lastRow("edge.reach=5"), strong + 5);
  EXPECT_EQ(lastRow("edge.reach=15"), strong + 15);
  // A lower threshold makes both columns strong.
  image::Image all = edgesOf(detected(relief, "canny", {"edge_gradient.depth_threshold=0.05"}));
  EXPECT_GT(all.at(19, 60, 0), .5f);
  EXPECT_GT(all.at(43, 60, 0), .5f);
}

// --- Scale

TEST_F(RenderEdges, ScalingByPowersOfTwoChangesNoEdge) {
  std::map<std::string, image::Image> at_one;
  for (double scale : {1., 1. / 4096, 1024.})
    for (const std::string& detector : kDetectors) {
      image::Image edges = edgesOf(detected(shotOf("crowd", 64, 40, {{"scale", scale}}), detector));
      EXPECT_TRUE(identical(at_one.emplace(detector, edges).first->second, edges)) << detector << " " << scale;
    }
}

}  // namespace render_edges_test
}  // namespace strobe::oracle
