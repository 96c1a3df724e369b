// SPDX-License-Identifier: MIT
// Shapes compared with topology (every edge of a closed surface is used once in each direction, Euler's V - E + F) and
// with areas and volumes in closed form.
#include "scene/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "math/constants.h"

namespace strobe::scene {
namespace shapes_test {

double volume(const Shape& shape) {
  double six = 0;
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    dvec3 a = shape.points[shape.indices[i]].position, b = shape.points[shape.indices[i + 1]].position,
          c = shape.points[shape.indices[i + 2]].position;
    six += glm::dot(a, glm::cross(b, c));
  }
  return six / 6;
}

double area(const Shape& shape) {
  double twice = 0;
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    dvec3 a = shape.points[shape.indices[i]].position, b = shape.points[shape.indices[i + 1]].position,
          c = shape.points[shape.indices[i + 2]].position;
    twice += glm::length(glm::cross(b - a, c - a));
  }
  return twice / 2;
}

using Key = std::tuple<long, long, long>;

// Positions are welded on a grid of one nanometre: far above rounding, far below any edge.
Key key(const dvec3& p) { return {std::lround(p.x * 1e9), std::lround(p.y * 1e9), std::lround(p.z * 1e9)}; }

// V - E + F if every edge has exactly one partner in the other direction, else an impossible number.
int euler(const Shape& shape) {
  std::set<Key> corners;
  std::map<std::pair<Key, Key>, int> edges;
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    for (int k = 0; k < 3; ++k) {
      Key a = key(shape.points[shape.indices[i + k]].position);
      Key b = key(shape.points[shape.indices[i + (k + 1) % 3]].position);
      corners.insert(a);
      edges[{a, b}] += 1;
    }
  }
  for (const auto& [edge, count] : edges) {
    auto partner = edges.find({edge.second, edge.first});
    if (count != 1 || partner == edges.end() || partner->second != 1) return -1000;
  }
  return int(corners.size()) - int(edges.size() / 2) + int(shape.indices.size() / 3);
}

// Normals have unit length and point to the side with anticlockwise winding. `exempt` triangles may differ: at a sharp
// rim, facets in different directions share one smooth normal.
void expectNormalsAgree(const Shape& shape, size_t exempt = 0) {
  size_t turned = 0;
  for (const Shape::Point& point : shape.points) ASSERT_NEAR(glm::length(point.normal), 1, 1e-9);
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    const Shape::Point *a = &shape.points[shape.indices[i]], *b = &shape.points[shape.indices[i + 1]],
                       *c = &shape.points[shape.indices[i + 2]];
    dvec3 facet = glm::cross(b->position - a->position, c->position - a->position);
    turned += !(glm::dot(facet, a->normal + b->normal + c->normal) > 0);
  }
  EXPECT_LE(turned, exempt);
}

TEST(Shapes, BoxIsExact) {
  Shape shape = box({2, 3, 5});
  EXPECT_EQ(euler(shape), 2);
  EXPECT_NEAR(volume(shape), 30, 1e-12);
  EXPECT_NEAR(area(shape), 62, 1e-12);
  expectNormalsAgree(shape);
}

// Steiner: a box rounded by r is its inner box extended by a ball of radius r.
TEST(Shapes, RoundedBoxFollowsSteiner) {
  dvec3 size(2, 3, 5);
  double r = 0.4;
  Shape shape = box(size, r, 24);
  dvec3 i = size - 2 * r;
  double exact = i.x * i.y * i.z + 2 * r * (i.x * i.y + i.y * i.z + i.z * i.x) + kPi * r * r * (i.x + i.y + i.z) +
                 4.0 / 3 * kPi * r * r * r;
  EXPECT_EQ(euler(shape), 2);
  EXPECT_NEAR(volume(shape) / exact, 1, 2e-4);  // error of chords with 24 steps per quarter
  expectNormalsAgree(shape);
  EXPECT_EQ(euler(box({1, 1, 1}, 9, 8)), 2);  // radius limited to half the side: a ball
}

TEST(Shapes, SphereConverges) {
  double before = 1;
  for (int segments : {16, 32, 64, 128}) {
    Shape shape = sphere(1.5, segments);
    EXPECT_EQ(euler(shape), 2);
    double error = 1 - volume(shape) / (4.0 / 3 * kPi * 1.5 * 1.5 * 1.5);
    EXPECT_GT(error, 0);
    EXPECT_LT(error, before / 3.5);  // second order: a quarter of the error per halving
    before = error;
  }
  expectNormalsAgree(sphere(1, 24));
}

TEST(Shapes, TorusFollowsPappus) {
  Shape shape = torus(2, 0.5, 128, 64);
  EXPECT_EQ(euler(shape), 0);
  EXPECT_NEAR(volume(shape) / (2 * kPi * kPi * 2 * 0.25), 1, 3e-3);
  EXPECT_NEAR(area(shape) / (4 * kPi * kPi * 2 * 0.5), 1, 3e-3);
  expectNormalsAgree(shape);
}

TEST(Shapes, OctahedronIsASuperellipsoid) {
  Shape shape = superellipsoid({2, 2, 2}, 2, 2, 32);
  EXPECT_EQ(euler(shape), 2);
  EXPECT_NEAR(volume(shape), 4.0 / 3, 1e-9);
  expectNormalsAgree(superellipsoid({1, 2, 3}, 0.5, 0.3, 32));
}

TEST(Shapes, CylinderAndConeAreExactPrisms) {
  int n = 40;
  double polygon = n / 2.0 * std::sin(2 * kPi / n);  // area of the n-gon in the unit circle
  EXPECT_NEAR(volume(cylinder(2, 2, 3, n)), polygon * 4 * 3, 1e-9);
  EXPECT_NEAR(volume(cylinder(2, 0, 3, n)), polygon * 4 * 3 / 3, 1e-9);
  EXPECT_NEAR(volume(cylinder(0, 2, 3, n)), polygon * 4 * 3 / 3, 1e-9);
  EXPECT_NEAR(volume(cylinder(1, 2, 3, n)), polygon * 7, 1e-9);
  for (const Shape& shape : {cylinder(2, 2, 3, n), cylinder(2, 0, 3, n), cylinder(1, 2, 3, n, 0.1)}) {
    EXPECT_EQ(euler(shape), 2);
    expectNormalsAgree(shape);
  }
}

TEST(Shapes, LatheOfAVesselIsClosed) {
  std::vector<dvec2> profile = {{0, 0},      {0.5, 0},   {0.8, 0.6}, {0.3, 1.2},
                                {0.25, 1.2}, {0.7, 0.6}, {0.4, 0.1}, {0, 0.1}};
  Shape shape = lathe(profile, 48, 4);
  EXPECT_EQ(euler(shape), 2);
  EXPECT_GT(volume(shape), 0);
  Shape plain = lathe({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 64, 1);
  EXPECT_NEAR(volume(plain), 32 * std::sin(2 * kPi / 64), 1e-12);
  expectNormalsAgree(plain);
}

TEST(Shapes, TubeCushionAndClothAreClosed) {
  Shape bent = tube({{0, 0, 0}, {0, 1, 0}, {1, 2, 0}, {2, 2, 1}}, {0.1, 0.2, 0.2, 0.05}, 12, 6);
  EXPECT_EQ(euler(bent), 2);
  EXPECT_GT(volume(bent), 0);
  Shape straight = tube({{0, 0, 0}, {0, 2, 0}}, {0.5, 0.5}, 32);
  EXPECT_NEAR(volume(straight), 2 * 0.25 * 16 * std::sin(2 * kPi / 32), 1e-9);
  expectNormalsAgree(straight);
  for (const Shape& shape : {cushion({0.5, 0.5, 0.16}, 0.05, 4), cloth({2, 2.4, 0.1}, 9)}) {
    EXPECT_EQ(euler(shape), 2);
    EXPECT_GT(volume(shape), 0);
    expectNormalsAgree(shape, shape.indices.size() / 300);
  }
}

TEST(Shapes, QuadHasItsTextureUpright) {
  Shape shape = quad({4, 2}, {2, 3});
  EXPECT_NEAR(area(shape), 8, 1e-12);
  expectNormalsAgree(shape);
  for (const Shape::Point& point : shape.points) {
    EXPECT_NEAR(point.uv.x, point.position.x / 4 + 0.5, 1e-12);
    EXPECT_NEAR(point.uv.y, 0.5 - point.position.y / 2, 1e-12);
  }
  EXPECT_NEAR(quad({4, 2}, {1, 1}, 0.5).points.back().uv.x, 8, 1e-12);
}

TEST(Shapes, MirroringKeepsTheOutsideOutside) {
  Shape shape = transformed(box({1, 2, 3}), glm::scale(dmat4(1), dvec3(-2, 1, 1)));
  EXPECT_NEAR(volume(shape), 12, 1e-12);
  expectNormalsAgree(shape);
}

TEST(Shapes, MeshIsRelativeToItsOrigin) {
  Shape far = transformed(box({1, 1, 1}), glm::translate(dmat4(1), dvec3(1e6, 0.1, -3e5)));
  Mesh mesh = meshOf("far", {{far, 3}});
  EXPECT_EQ(mesh.geometries[0].material, 3);
  for (size_t i = 0; i < far.points.size(); ++i) {
    dvec3 back = mesh.origin + dvec3(mesh.geometries[0].vertices[i].position);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(back[k], far.points[i].position[k], 1e-7);
  }
}

}  // namespace shapes_test
}  // namespace strobe::scene
