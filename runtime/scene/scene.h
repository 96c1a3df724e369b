// SPDX-License-Identifier: MIT
// A scene on the CPU: meshes, materials, textures, lights, cameras and how they move. Positions are metres (or the
// file's unit), y up, right-handed; times are seconds; transforms are double (target-from-source, column vectors).
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/json.h"
#include "math/bounds.h"
#include "math/geometry.h"

namespace strobe::scene {

struct Vertex {
  vec3 position;
  vec3 normal;  // unit
  vec2 uv0 = vec2(0);
  vec2 uv1 = vec2(0);
  vec4 color = vec4(1);  // linear factor of the base colour
};

// Which joints of a skin each vertex follows, `count` of them, and to what share; shares of a vertex add up to 1.
struct Influences {
  int count = 0;  // 0: there are none
  std::vector<uint32_t> joints = {};
  std::vector<double> shares = {};
};

// What is added to each vertex, times the weight of the target; empty: nothing.
struct MorphTarget {
  std::vector<vec3> positions = {}, normals = {}, tangents = {};
};

// Boxes around vertices, and around what each morph target adds to them.
struct VertexBounds {
  Bounds rest;
  std::vector<Bounds> targets = {};

  void add(const VertexBounds& other) {
    rest.add(other.rest);
    targets.resize(std::max(targets.size(), other.targets.size()), Bounds{dvec3(0), dvec3(0)});
    for (size_t t = 0; t < other.targets.size(); ++t) targets[t].add(other.targets[t]);
  }
};

// Triangles of one material.
struct Geometry {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // three per triangle
  int material = 0;
  std::vector<uint32_t> source = {};  // which triangle of the file each was (scene/tree_order.h); empty: the same
  Influences influences = {};
  // Direction of the normal map's x, unit, and the sign of its y, of each vertex; 0, 0, 0, 0: by the texture
  // coordinates, as if it is empty.
  std::vector<vec4> tangents = {};
  std::vector<MorphTarget> targets = {};    // as many as other geometries of the mesh have
  bool faceted = false;                     // normals are those of the triangles, however they bend
  std::optional<VertexBounds> bounds = {};  // of these vertices, once `findBounds` has found them
};

// Positions are relative to `origin`, which poses add back in double (a mesh may lie far from its node's origin).
struct Mesh {
  std::string name;
  std::vector<Geometry> geometries;
  dvec3 origin = dvec3(0);
};

struct Texture {
  enum class Format { Rgba8Srgb, Rgba8Unorm, Rgba32f };
  enum class Wrap { Repeat, Mirror, Clamp };
  std::string name;
  Format format = Format::Rgba8Srgb;
  int width = 0, height = 0;
  std::vector<std::vector<uint8_t>> levels;  // level 0 first, each of size max(1, size >> level), top row first
  Wrap wrap_u = Wrap::Repeat, wrap_v = Wrap::Repeat;
  // How texels are looked up where one is larger than a pixel and where it is smaller, and which levels serve then.
  enum class Filter { Nearest, Linear };
  enum class Levels { None, Nearest, Linear };
  Filter magnify = Filter::Linear, minify = Filter::Linear;
  Levels between = Levels::Linear;
};

// A texture as a material uses it: uv' = matrix * (u, v, 1).
struct TextureUse {
  int texture = -1;  // index into Scene::textures, -1 for none
  int uv_set = 0;
  glm::dmat3x2 uv_transform = glm::dmat3x2(1);  // three columns of two: u, v, offset
};

// Metallic-roughness as glTF 2.0 defines it.
struct Material {
  std::string name;
  vec4 base_color = vec4(1);
  TextureUse base_color_texture;
  float metallic = 0, roughness = 1;
  TextureUse metallic_roughness_texture;
  TextureUse normal_texture;
  float normal_scale = 1;
  vec3 emissive = vec3(0);  // strength included
  TextureUse emissive_texture;
  bool unlit = false;
  // Mask: nothing is there where alpha is below `alpha_cutoff`. Blend: alpha is the share of points that are there.
  enum class Alpha { Opaque, Mask, Blend };
  Alpha alpha = Alpha::Opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = true;  // false: nothing is seen from behind
};

struct Light {
  enum class Type { Directional, Point, Spot };
  std::string name;
  Type type = Type::Point;
  vec3 color = vec3(1);                          // linear
  double intensity = 1;                          // candela (point, spot) or lux (directional)
  float moderation = 1;                          // factor of `moderateLights`
  double range = 0;                              // metres, 0 for unlimited
  double inner_cone = 0, outer_cone = 0.785398;  // spot: half angles, radians
  bool shadow = true;
  vec3 emitted() const { return color * float(intensity) * moderation; }
  bool operator==(const Light&) const = default;
};

struct Camera {
  std::string name;
  bool orthographic = false;
  double vertical_fov = 0.8;     // perspective: full angle, radians
  double half_height = 1;        // orthographic: half the height of the view, metres
  std::optional<double> aspect;  // stated by the file; the picture's own aspect is used, this is only reported
  double near = 0.01;            // metres along the view direction; nothing nearer is seen
  bool operator==(const Camera&) const = default;
};

// A keyed channel of a node's transform.
struct Track {
  enum class Target { Translation, Rotation, Scale };
  enum class Interpolation { Step, Linear, CubicSpline };
  int node = -1;
  Target target = Target::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<double> times;  // seconds, increasing
  std::vector<dvec4> values;  // xyz or quaternion xyzw; CubicSpline: in-tangent, value, out-tangent per key
};

// A keyed number (or colour) of a camera or a light.
struct PropertyTrack {
  enum class Property { FieldOfView, HalfHeight, Near, Color, Intensity, Range, InnerCone, OuterCone };
  Property property = Property::FieldOfView;
  int index = -1;  // into Scene::cameras for the first three, else Scene::lights
  Track keys;      // of no node: xyz is the colour, x any number; in the units of the scene's structures
  bool isOfCamera() const { return property <= Property::Near; }
};

// The keyed weight of a morph target.
struct WeightTrack {
  int node = -1;  // whose Node::weights has it
  size_t target = 0;
  Track keys;  // of no node: x is the weight
};

struct Animation {
  std::string name;
  std::vector<Track> tracks;
  double duration = 0;  // seconds; time past the end repeats from the start
  std::vector<PropertyTrack> properties = {};
  std::vector<WeightTrack> weights = {};
  // Seconds of the clip, from 0 to its duration, at which what it drives jumps, each time that it comes there. At 0 and
  // at its end: where it begins again.
  std::vector<double> cuts = {};
  // Index of an earlier clip that plays and drives a target of this clip; else -1. A clip that yields does not play
  // with "all". `yieldClips` sets both; `shared_target` is the name of the target.
  int yields_to = -1;
  std::string shared_target = {};
};

// Rigid motion at a constant rate, in world axes: of `--move`, `--spin` and of scenes described in Lua.
// Per second; the node is at rest at `rest_time`.
struct ConstantMotion {
  int node = -1;
  dvec3 velocity = dvec3(0);    // metres per second
  dvec3 axis = dvec3(0, 1, 0);  // unit
  double angular_velocity = 0;  // radians per second about `axis` through the node's origin (pivot)
  double rest_time = 0;         // seconds
};

// Nodes that vertices follow. A vertex of a mesh comes to the world by joint * inverse_bind.
struct Skin {
  std::vector<int> joints;           // nodes
  std::vector<dmat4> inverse_binds;  // of each
};

struct Node {
  std::string name;
  int parent = -1;
  dvec3 translation = dvec3(0);
  dquat rotation = dquat(1, 0, 0, 0);
  dvec3 scale = dvec3(1);
  std::optional<dmat4> matrix;  // instead of the three above
  // Applied before scale, rotation and translation: the shear of a matrix that was taken apart (`splitMatrix`).
  std::optional<dmat3> shear = {};
  int mesh = -1, camera = -1, light = -1;
  std::vector<dmat4> instances;  // of EXT_mesh_gpu_instancing: node-from-instance; empty means one, identity
  // Of its mesh. With a skin the joints say where that is, and the transform of the node counts for nothing but its
  // handedness. `sole_joint` (within the skin) has all vertices, which it then moves without bending them, and the
  // handedness of the node at all times; else -1.
  int skin = -1, sole_joint = -1;
  std::vector<double> weights;  // of the morph targets, at rest; empty where none ever counts
  std::vector<double> cuts;     // seconds at which it and all below it jump: no frame blurs over one
};

// Radiance of rays that leave the scene, and the light that reaches surfaces from everywhere:
// blends from `ground` (down) to `sky` (up) with the height of the direction. Linear radiance.
struct Environment {
  vec3 sky = vec3(0);
  vec3 ground = vec3(0);
  std::optional<vec3> background;  // what a ray that misses sees, if not the above
};

// A file that was read for a scene, and the hash of its content.
struct SourceFile {
  Path path;  // absolute
  std::string hash;
};

struct Scene {
  std::string name;
  std::vector<Node> nodes;  // a parent may stand after its child
  std::vector<Mesh> meshes;
  std::vector<Skin> skins;
  std::vector<Material> materials;  // at least one
  std::vector<Texture> textures;
  std::vector<std::string> variants;  // sets of materials that the file offers, by name
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<Animation> animations;
  std::vector<ConstantMotion> motions;
  Environment environment;
  std::vector<double> cuts;              // seconds at which everything jumps, the camera included
  double loop_s = 0;                     // seconds after which the window plays it anew; 0: no suggestion
  std::vector<std::string> warnings;     // what was not understood, naming the node
  std::vector<std::string> assumptions;  // defaults supplied for what the file lacks, for the run record
  Json attribution;                      // licence and author where the file or its folder states them
  std::vector<SourceFile> files;         // of a glTF scene itself first; then all files that the scene names
};

// One drawable: a mesh at a node. Its index is its instance id.
struct Instance {
  int node = -1;
  int mesh = -1;
  dmat4 node_from_instance = dmat4(1);
  bool flattens = false;  // its transform may be flat at some time (scene/flat.h)
};

// The drawables in a fixed order (node order, then instance order).
std::vector<Instance> instancesOf(const Scene& scene);

// How an instance is bent: what its vertices are made from (scene/bend.h).
struct Bend {
  // World-from-mesh of each joint of its skin, or of all vertices of an instance that flattens; empty: it has no skin,
  // or a sole joint.
  std::vector<dmat4> joints;
  std::vector<double> weights;  // of the morph targets
  // True where the transform of the node mirrors: joints then give vertices with x turned round, so that
  // `Pose::world_from_instance` mirrors them back and has the sign that says which side is the front.
  bool mirrored = false;
  bool operator==(const Bend&) const = default;
};

// Where everything is at one time, in world space.
struct Pose {
  // One per instance, the mesh's `origin` already included. Where joints bend it, the axes of the world, x turned round
  // if `Bend::mirrored`.
  std::vector<dmat4> world_from_instance;
  std::vector<Bend> bends;              // one per instance; of what does not bend empty
  std::vector<dmat4> world_from_light;  // one per light node, see `lightsOf`
  std::vector<Light> lights;            // as they shine then, one per light node
  dmat4 world_from_camera = dmat4(1);   // camera looks along -z, y up; unit scale
  Camera camera;                        // its lens then
};

// Light nodes: indices into Scene::nodes, in order.
std::vector<int> lightsOf(const Scene& scene);

// The node of the camera called `name` ("" for the first). Throws `Error` listing the cameras when there is none.
int cameraNode(const Scene& scene, const std::string& name);

// True poses at `time_s`: animations of `animation` ("all", "none" or a clip's name), then constant motions.
// A clip is at its first keys before them, and repeats from time 0 when the time is past its duration; of several clips
// that drive one target, "all" plays the first. Throws `Error` for an unknown clip, naming the nearest, and for nodes
// that are their own ancestors. `scene` must outlive the poser.
class Poser {
 public:
  Poser(const Scene& scene, int camera_node, const std::string& animation = "all");
  Pose at(double time_s) const;
  // The same with STEP channels as they are at `held_time_s`: poses of one frame in which a jump leaves no streak.
  Pose at(double time_s, double held_time_s) const;
  // World from node, of every node.
  std::vector<dmat4> nodesAt(double time_s, double held_time_s) const;

 private:
  // A node that keys or a motion at a constant rate move, or one below it.
  struct Driven {
    int node = -1;
    bool keyed = false;
    std::vector<const ConstantMotion*> motions;
  };

  std::vector<Driven> drivenNodes() const;
  std::vector<size_t> drivenInstances() const;
  void keyProperties(Pose& pose, double time_s, double held_time_s) const;
  std::vector<std::vector<double>> weightsAt(double time_s, double held_time_s) const;
  const Scene& scene_;
  std::vector<Instance> instances_;
  std::vector<int> lights_;
  int camera_node_;
  std::vector<const Animation*> clips_;
  std::vector<dmat4> rest_worlds_;        // of every node
  Pose rest_;                             // of every instance
  std::vector<Driven> driven_;            // parents before children
  std::vector<size_t> driven_instances_;  // all that may not be as at rest
};

}  // namespace strobe::scene
