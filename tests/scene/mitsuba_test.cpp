// SPDX-License-Identifier: MIT
// The exported Mitsuba 3 scene, read by an independent script (mitsuba_reference.py): vertices, camera rays and lights
// at times of the exposure match the runtime.
#include "scene/mitsuba.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/process.h"
#include "common/source.h"
#include "common/temporary_folder.h"
#include "image/exr.h"
#include "scene/bend.h"
#include "scene/json_scene.h"
#include "scene/motion.h"

namespace strobe::scene {
namespace mitsuba_test {

// The exposure lasts from 1 s to 1.5 s; the raster time is its end.
const FrameView kFrame{1.5, 1, 1.5, 1, {}, 200, 100};
// Shares of the exposure: start, end, and times mostly between keys.
const std::vector<double> kTimes = {0, 0.1, 0.3701, 0.5, 0.93, 1};
// Shares of width and height, as in mitsuba_reference.py.
const dvec2 kFilm[] = {{0.5, 0.5}, {0, 0}, {1, 0}, {0, 1}, {0.25, 0.75}};

dvec3 vector(const Json& json) { return {json[0], json[1], json[2]}; }

std::string node(const std::string& name, const std::string& fields) {
  return R"({"kind":"node","name":")" + name + "\"," + fields + "}";
}

std::string box(const std::string& material, const std::string& more = "") {
  return R"("shape":{"kind":"shape","type":"box","size":[1,0.5,2]},"material":{"kind":"material",)" + material + "}" +
         more;
}

const std::string kCamera = R"("position":[0,0,6],"camera":{"kind":"camera","type":"perspective"})";

Scene sceneOf(const std::vector<std::string>& nodes, const std::string& more = "") {
  return sceneFromJson(
      Json::parse(fmt::format(R"({{"kind":"scene","name":"s","nodes":[{}]{}}})", fmt::join(nodes, ","), more)),
      "test.lua");
}

class Mitsuba : public ::testing::Test {
 protected:
  void SetUp() override {
    if (run({.arguments = {"sh", "-c", "command -v python3"}}).code() != 0) GTEST_SKIP() << "no python3";
  }

  Json written(const Scene& scene) {
    Poser poser(scene, cameraNode(scene, ""));
    export_ = exportMitsuba(
        scene, [&](double time_s) { return poser.at(time_s); }, kFrame, folder_.path());
    ProgramEnd end = run({.arguments = {"python3", sourceFolder() / "tests/scene/mitsuba_reference.py", folder_.path(),
                                        fmt::format("{}", fmt::join(kTimes, ","))}});
    EXPECT_TRUE(end.succeeded()) << end.errors;
    return end.succeeded() ? Json::parse(end.output) : Json();
  }

  bool leavesOut(const std::string& what, const std::string& name) const {
    return std::any_of(export_.left_out.begin(), export_.left_out.end(), [&](const std::string& text) {
      return text.starts_with(what) && text.find(name) != std::string::npos;
    });
  }

  static double timeOf(double share) { return glm::mix(kFrame.open_s, kFrame.close_s, share); }

  // Largest distance of a triangle corner from its position in the runtime, over all times, metres.
  static double worstCorner(const Scene& scene, const Json& shapes) {
    Poser poser(scene, cameraNode(scene, ""));
    double worst = 0;
    for (size_t t = 0; t < kTimes.size(); ++t) {
      const Pose pose = poser.at(timeOf(kTimes[t]));
      size_t shape = 0;
      const std::vector<Instance> instances = instancesOf(scene);
      for (size_t i = 0; i < instances.size(); ++i)
        for (const Geometry& geometry : scene.meshes[size_t(instances[i].mesh)].geometries) {
          const Json& points = shapes[shape++]["points"][t];
          EXPECT_EQ(points.size(), geometry.indices.size());
          for (size_t k = 0; k < geometry.indices.size() && k < points.size(); ++k) {
            const dvec4 own(geometry.vertices[geometry.indices[k]].position, 1);
            worst = std::max(worst, glm::length(vector(points[k]) - dvec3(pose.world_from_instance[i] * own)));
          }
        }
      EXPECT_EQ(shape, shapes.size());
    }
    return worst;
  }

  // Camera rays as in shaders/mixin/camera.glsl: largest difference of origins and unit directions.
  static double worstRay(const Scene& scene, const Json& sensor) {
    Poser poser(scene, cameraNode(scene, ""));
    double worst = 0;
    for (size_t t = 0; t < kTimes.size(); ++t)
      for (size_t k = 0; k < std::size(kFilm); ++k) {
        const Pose pose = poser.at(timeOf(kTimes[t]));
        const Camera& camera = pose.camera;
        const double half = camera.orthographic ? camera.half_height : std::tan(camera.vertical_fov / 2);
        const dvec4 aside((2 * kFilm[k].x - 1) * half * kFrame.width / kFrame.height, (1 - 2 * kFilm[k].y) * half, 0,
                          0);
        const dvec4 forward(0, 0, -1, 0), at = camera.orthographic ? aside : dvec4(0);
        const dvec3 origin(pose.world_from_camera * (at + dvec4(0, 0, 0, 1)));
        const dvec3 direction(pose.world_from_camera * (camera.orthographic ? forward : forward + aside));
        const Json& ray = sensor["rays"][t][k];
        worst = std::max(worst, glm::length(vector(ray[0]) - origin));
        worst = std::max(worst, glm::length(vector(ray[1]) - glm::normalize(direction)));
      }
    return worst;
  }

  testing::TemporaryFolder folder_;
  MitsubaExport export_;
};

// The export's limit, 1/1000 px, is 2 * tan(0.4) / 100 * 4 m / 1000 at the nearest corner, 4 m away; vertex coordinates
// are rounded with a relative error of 2^-24.
constexpr double kNear_m = 3.4e-5 + 1e-6;

TEST_F(Mitsuba, HasTheVerticesAndRaysOfTheRuntime) {
  const std::string grey = R"("color":[0.5,0.5,0.5])";
  const Scene scene = sceneOf(
      {node("car", box(grey) + R"(,"motion":{"velocity":[3,0,0],"rest_time":1.2},"scale":[1,2,1],"children":[)" +
                       node("wheel", R"("position":[0.4,0.1,0],)" + box(R"("color":[0.2,0,0])") +
                                         R"(,"motion":{"axis":[0,0,1],"degrees_per_second":900})") +
                       "]"),
       node("still", box(grey) + R"(,"position":[0,-1,0],"rotation":[0,30,20])"),
       node("eye", kCamera + R"(,"motion":{"velocity":[0,0.5,0],"axis":[0,1,0],"degrees_per_second":40})"),
       node(
           "lamp",
           R"("position":[1,3,0],"light":{"kind":"light","type":"point","intensity":50},"motion":{"velocity":[0,0,2]})")});
  const Json read = written(scene);
  ASSERT_FALSE(read.empty());
  EXPECT_LT(worstCorner(scene, read["shapes"]), kNear_m);
  EXPECT_LT(worstRay(scene, read["sensor"]), 1e-5);
  EXPECT_EQ(read["integrator"], "path");
  EXPECT_EQ(read["sensor"]["shutter_open"], 0);
  EXPECT_EQ(read["sensor"]["shutter_close"], 1);
  EXPECT_EQ(read["sensor"]["width"], kFrame.width);
  EXPECT_NEAR(double(read["sensor"]["fov"]), scene.cameras[0].vertical_fov * 180 / 3.14159265358979, 1e-6);
  // Straight motion at a constant rate is exact with two keys; a static node has one key.
  EXPECT_EQ(read["shapes"][0]["keys"], 2);
  EXPECT_GT(read["shapes"][1]["keys"], 16);
  EXPECT_EQ(read["shapes"][2]["keys"], 1);
}

TEST_F(Mitsuba, HasTheLightsOfTheRuntime) {
  const Scene scene = sceneOf(
      {node("body", box(R"("color":[0.5,0.5,0.5])")), node("eye", kCamera),
       node(
           "sun",
           R"("rotation":[-50,20,0],"light":{"kind":"light","type":"directional","intensity":3,"color":[1,0.5,0.25]})"),
       node(
           "lamp",
           R"("position":[1,3,0],"light":{"kind":"light","type":"spot","intensity":50},"motion":{"velocity":[0,0,2],"axis":[1,0,0],"degrees_per_second":90})")},
      R"(,"environment":{"background":[0.25,0.5,1]})");
  const Json emitters = written(scene)["emitters"];
  ASSERT_EQ(emitters.size(), 3);
  EXPECT_EQ(emitters[0]["type"], "constant");
  EXPECT_EQ(vector(emitters[0]["radiance"]), dvec3(0.25, 0.5, 1));
  EXPECT_EQ(emitters[1]["type"], "directional");
  EXPECT_EQ(vector(emitters[1]["irradiance"]), dvec3(3, 1.5, 0.75));
  EXPECT_EQ(emitters[2]["type"], "spot");
  Poser poser(scene, cameraNode(scene, ""));
  for (size_t t = 0; t < kTimes.size(); ++t) {
    const Pose pose = poser.at(timeOf(kTimes[t]));
    for (size_t i = 0; i < 2; ++i) {
      const dmat4& world = pose.world_from_light[i];
      // Lights shine along their -z axis.
      EXPECT_LT(glm::length(vector(emitters[i + 1]["directions"][t]) + dvec3(world[2])), 1e-5);
      EXPECT_LT(glm::length(vector(emitters[i + 1]["positions"][t]) - dvec3(world[3])), 1e-5);
    }
  }
  EXPECT_TRUE(leavesOut("the falloff between the cones of spot lights", "lamp"));
}

TEST_F(Mitsuba, WritesUnlitScenesAsColours) {
  const std::string camera = R"("position":[0,0,5],"camera":{"kind":"camera","type":"orthographic","half_height":2})";
  const std::string texture =
      R"("unlit":true,"color":[0.5,1,2],"color_texture":{"kind":"use","scale":[3,2],"offset":[0.25,0.5],"texture":
      {"kind":"texture","type":"texels","width":2,"height":1,"texels":[[1,0,0.5],[0.25,1,1]]}})";
  const Scene scene = sceneOf(
      {node("panel", box(texture)),
       node("lamp", box(R"("unlit":true,"color":[3,1,0])") + R"(,"motion":{"velocity":[0,1,0]})"), node("eye", camera)},
      R"(,"environment":{"background":[0.25,0.5,1]})");
  const Json read = written(scene);
  ASSERT_FALSE(read.empty());
  EXPECT_EQ(read["integrator"], "aov");
  EXPECT_TRUE(export_.left_out.empty()) << export_.left_out[0];
  EXPECT_LT(worstRay(scene, read["sensor"]), 1e-12);
  const Json &panel = read["shapes"][1], &lamp = read["shapes"][2];
  EXPECT_EQ(read["shapes"][0]["id"], "background");
  EXPECT_EQ(vector(read["shapes"][0]["bsdf"]), dvec3(0.25, 0.5, 1));
  EXPECT_EQ(panel["bsdf"]["filter_type"], "nearest");
  const image::ExrFile texels = image::readExr(folder_ / std::string(panel["bsdf"]["filename"]));
  const image::Image color = image::colourOf(texels, "", "texels");
  EXPECT_EQ(color.values, (std::vector<float>{0.5f, 0, 1, 0.125f, 1, 2}));
  // A colour above 1 is stored in a texture, because Mitsuba refuses it elsewhere.
  const image::Image bright =
      image::colourOf(image::readExr(folder_ / std::string(lamp["bsdf"]["filename"])), "", "lamp");
  EXPECT_EQ(bright.at(1, 1, 0), 3);
  const Geometry& geometry = scene.meshes[0].geometries[0];
  for (size_t k = 0; k < geometry.indices.size(); ++k) {
    const vec2 uv = geometry.vertices[geometry.indices[k]].uv0;
    EXPECT_NEAR(panel["uvs"][k][0], 3 * uv.x + 0.25, 1e-6);
    EXPECT_NEAR(panel["uvs"][k][1], 2 * uv.y + 0.5, 1e-6);
  }
}

TEST_F(Mitsuba, HasDeformedVerticesAtTheRasterTime) {
  Scene scene = sceneOf({node("cloth", box(R"("color":[0.5,0.5,0.5])")), node("eye", kCamera)});
  Geometry& geometry = scene.meshes[0].geometries[0];
  geometry.targets.push_back({std::vector<vec3>(geometry.vertices.size(), vec3(0, 1, 0)), {}, {}});
  scene.nodes[0].weights = {0.25};
  const Json read = written(scene);
  ASSERT_FALSE(read.empty());
  for (size_t k = 0; k < geometry.indices.size(); ++k) {
    const dvec3 expected = dvec3(geometry.vertices[geometry.indices[k]].position) + dvec3(0, 0.25, 0);
    EXPECT_LT(glm::length(vector(read["shapes"][0]["points"][0][k]) - expected), 1e-6);
  }
  EXPECT_TRUE(leavesOut("deformation", "cloth"));
}

TEST_F(Mitsuba, NamesOmittedFeatures) {
  Scene scene = sceneOf(
      {node("body",
            box(R"("name":"paint","color":[0.5,0.5,0.5],"emissive":[1,1,1])") + R"(,"motion":{"velocity":[1,0,0]})"),
       node("sign", box(R"("name":"neon","color":[0.5,0.5,0.5],"unlit":true)")),
       node("lamp", R"("light":{"kind":"light","type":"point","range":9,"shadow":false})"), node("eye", kCamera)},
      R"(,"environment":{"sky":[1,1,1],"ground":[0,0,0]})");
  for (Material& material : scene.materials) {
    if (material.name != "paint") continue;
    material.alpha = Material::Alpha::Blend;
    material.double_sided = false;
  }
  scene.meshes[0].geometries[0].vertices[0].color = vec4(0.5f);
  const Json read = written(scene);
  EXPECT_TRUE(leavesOut("alpha of materials", "paint"));
  EXPECT_TRUE(leavesOut("back-face culling", "paint"));
  EXPECT_TRUE(leavesOut("specular reflection", "paint"));
  EXPECT_FALSE(leavesOut("specular reflection", "neon"));
  EXPECT_TRUE(leavesOut("emission of moving objects", "paint"));
  EXPECT_TRUE(leavesOut("emission of both sides", "neon"));
  EXPECT_TRUE(leavesOut("vertex colours", "paint"));
  EXPECT_TRUE(leavesOut("ranges of lights", "lamp"));
  EXPECT_TRUE(leavesOut("lights without shadows", "lamp"));
  EXPECT_TRUE(leavesOut("shading at the raster time", ""));
  EXPECT_TRUE(leavesOut("ambient light", ""));
  // The file lists them too, after a line about the scene.
  EXPECT_EQ(read["comments"].size(), export_.left_out.size() + 1);
  // The background's gradient: white above, black below.
  const image::Image sky = image::colourOf(image::readExr(folder_ / "background.exr"), "", "background");
  EXPECT_GT(sky.at(0, 0, 0), 0.999);
  EXPECT_LT(sky.at(0, sky.height - 1, 0), 0.001);
}

TEST_F(Mitsuba, EscapesNames) {
  const std::string name = "a & 'b' <c>.d--e\t\x01";
  Scene scene = sceneOf(
      {node("body", box(R"("color":[0.5,0.5,0.5])") + R"(,"motion":{"velocity":[1,0,0]})"), node("eye", kCamera)});
  scene.name = scene.nodes[0].name = scene.materials.back().name = scene.meshes[0].name = name;
  scene.materials.back().alpha = Material::Alpha::Mask;
  const Json read = written(scene);
  ASSERT_FALSE(read.empty());
  EXPECT_EQ(read["shapes"][0]["id"], "instance_0_a & 'b' <c>_d--e\t?");
  EXPECT_TRUE(leavesOut("alpha of materials", name));
}

TEST_F(Mitsuba, HandlesMirroredAndShearedTransforms) {
  Scene scene = sceneOf(
      {node("frame", R"("scale":[1,2,1],"children":[)" +
                         node("turning", box(R"("color":[0.5,0.5,0.5])") +
                                             R"(,"motion":{"axis":[0,0,1],"degrees_per_second":90,"rest_time":1.5})") +
                         "]"),
       node("mirror", R"("scale":[-1,1,1],)" + box(R"("color":[0.5,0.5,0.5])") +
                          R"(,"motion":{"axis":[0,1,0],"degrees_per_second":90})"),
       node("eye", kCamera)});
  scene.nodes[1].transform.rotation = glm::angleAxis(0.5, dvec3(0, 0, 1));
  const Json read = written(scene);
  ASSERT_FALSE(read.empty());
  EXPECT_TRUE(leavesOut("motion of sheared objects", "turning"));
  EXPECT_EQ(read["shapes"][0]["keys"], 1);
  EXPECT_LT(worstCorner(sceneOf({node("mirror", R"("scale":[-1,1,1],)" + box(R"("color":[0.5,0.5,0.5])") +
                                                    R"(,"motion":{"axis":[0,1,0],"degrees_per_second":90})"),
                                 node("eye", kCamera)}),
                        Json::array({read["shapes"][1]})),
            kNear_m);
}

}  // namespace mitsuba_test
}  // namespace strobe::scene
