// SPDX-License-Identifier: MIT
// A scene on the CPU: meshes, materials, textures, lights, cameras and their motion. Positions are metres (or the
// file's unit), y up, right-handed. Times are seconds. Transforms are double, target-from-source, column vectors.
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

// Vertex of a triangle mesh at rest: position, unit normal, two sets of texture coordinates and linear colour.
struct Vertex {
  vec3 position;
  vec3 normal;  // unit
  vec2 uv0 = vec2(0);
  vec2 uv1 = vec2(0);
  vec4 color = vec4(1);  // linear factor of the base colour
};

// Joints of a skin that each vertex follows, `count` per vertex, with their shares. The shares of a vertex add up to 1.
struct Influences {
  int count = 0;  // 0: no joints
  std::vector<uint32_t> joints = {};
  std::vector<double> shares = {};
};

// Offsets of each vertex at weight 1 of the target. Empty: no offsets.
struct MorphTarget {
  std::vector<vec3> positions = {}, normals = {}, tangents = {};
};

// Bounds of vertices, and of the offsets of each morph target.
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
  Influences influences = {};
  // Per vertex: direction of the normal map's x axis, unit, and sign of its y axis. 0, 0, 0, 0, or an empty list: both
  // are derived from the texture coordinates.
  std::vector<vec4> tangents = {};
  std::vector<MorphTarget> targets = {};    // as many as in other geometries of the mesh
  bool faceted = false;                     // normals are the triangle normals, also after deformation
  std::optional<VertexBounds> bounds = {};  // bounds of these vertices, set by `findBounds`
};

// Mesh of one geometry per material. Positions are relative to `origin`, which poses add in double precision (a mesh
// may be far from its node's origin).
struct Mesh {
  std::string name;
  std::vector<Geometry> geometries;
  dvec3 origin = dvec3(0);
};

// Image with its mip levels, wrap modes and filters, for the materials of a scene.
struct Texture {
  enum class Format { Rgba8Srgb, Rgba8Unorm, Rgba32f };
  enum class Wrap { Repeat, Mirror, Clamp };
  std::string name;
  Format format = Format::Rgba8Srgb;
  int width = 0, height = 0;
  std::vector<std::vector<uint8_t>> levels;  // level 0 first, each of size max(1, size >> level), top row first
  Wrap wrap_u = Wrap::Repeat, wrap_v = Wrap::Repeat;
  // Filters for texels larger and smaller than a pixel, and the use of levels for smaller texels.
  enum class Filter { Nearest, Linear };
  enum class Levels { None, Nearest, Linear };
  Filter magnify = Filter::Linear, minify = Filter::Linear;
  Levels between = Levels::Linear;
};

// Use of a texture in a material: uv' = matrix * (u, v, 1).
struct TextureUse {
  int texture = -1;  // index into Scene::textures; -1: no texture
  int uv_set = 0;
  glm::dmat3x2 uv_transform = glm::dmat3x2(1);  // three columns of two: u, v, offset
};

// Metallic-roughness material of glTF 2.0.
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
  // Mask: the surface is absent where alpha is below `alpha_cutoff`. Blend: alpha is the share of surface points that
  // are present.
  enum class Alpha { Opaque, Mask, Blend };
  Alpha alpha = Alpha::Opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = true;  // false: not visible from behind
};

// Directional, point or spot light: linear colour, intensity in candela or lux, range in metres and cone angles in
// radians.
struct Light {
  enum class Type { Directional, Point, Spot };
  std::string name;
  Type type = Type::Point;
  vec3 color = vec3(1);                          // linear
  double intensity = 1;                          // candela (point, spot) or lux (directional)
  float moderation = 1;                          // factor set by `moderateLights`
  double range = 0;                              // metres; 0: unlimited
  double inner_cone = 0, outer_cone = 0.785398;  // spot: half angles, radians
  bool shadow = true;
  vec3 emitted() const { return color * float(intensity) * moderation; }
  bool operator==(const Light&) const = default;
};

// Lens of a perspective or orthographic camera: field of view in radians or height in metres, and near plane. A node
// places the camera.
struct Camera {
  std::string name;
  bool orthographic = false;
  double vertical_fov = 0.8;  // perspective: full angle, radians
  double half_height = 1;     // orthographic: half the height of the view, metres
  double near = 0.01;         // near plane, metres along the view direction
  bool operator==(const Camera&) const = default;
};

// Keyed value: transform of a node, weight of a morph target, or property of a camera or a light.
struct Track {
  // Targets up to Weight belong to a node, targets up to Near to a camera, all others to a light.
  enum class Target {
    Translation,
    Rotation,
    Scale,
    Weight,
    FieldOfView,
    HalfHeight,
    Near,
    Color,
    Intensity,
    Range,
    InnerCone,
    OuterCone
  };
  enum class Interpolation { Step, Linear, CubicSpline };
  int object = -1;  // index of the node, camera or light
  Target target = Target::Translation;
  Interpolation interpolation = Interpolation::Linear;
  std::vector<double> times;  // seconds, increasing
  // xyz, quaternion xyzw, or number x, in the units of Camera and Light; CubicSpline: in-tangent, value, out-tangent
  // per key
  std::vector<dvec4> values;
  size_t weight = 0;  // Weight: index into Node::weights

  bool isOfTransform() const { return target <= Target::Scale; }
  bool isOfNode() const { return target <= Target::Weight; }
  bool isOfCamera() const { return target >= Target::FieldOfView && target <= Target::Near; }
  bool isOfLight() const { return target >= Target::Color; }
};

// Animation clip: keyed transforms of nodes, keyed properties of cameras and lights, and keyed morph weights. The clip
// repeats after its duration in seconds.
struct Animation {
  std::string name;
  std::vector<Track> tracks;
  double duration = 0;  // seconds; later times repeat from the start
  // Cuts of the clip: times, s, from 0 to its duration. In every repetition, the driven properties jump at these times.
  // A cut at 0 or at the duration is a jump between repetitions.
  std::vector<double> cuts = {};
  // Index of an earlier clip that plays and drives a target of this clip; else -1. A clip that yields does not play
  // with "all". `shared_target` is the name of the target. `yieldClips` sets both.
  int yields_to = -1;
  std::string shared_target = {};
};

// Rigid motion at a constant rate, in world axes, of `--move`, `--spin` and scenes described in Lua. The node is at
// rest at `rest_time`.
struct ConstantMotion {
  int node = -1;
  dvec3 velocity = dvec3(0);    // metres per second
  dvec3 axis = dvec3(0, 1, 0);  // unit
  double angular_velocity = 0;  // radians per second about `axis` through the node's origin (pivot)
  double rest_time = 0;         // seconds
};

// Nodes that vertices follow. World-from-mesh of joint i is world-from-node of joints[i] * inverse_binds[i].
struct Skin {
  std::vector<int> joints;           // nodes
  std::vector<dmat4> inverse_binds;  // by joint
};

// Translation, rotation and scale, applied in the reverse order.
struct Transform {
  dvec3 translation = dvec3(0);
  dquat rotation = dquat(1, 0, 0, 0);
  dvec3 scale = dvec3(1);
  dmat4 matrix() const;
};

// Node of the scene hierarchy: transform relative to its parent, and the mesh, camera or light that it places.
struct Node {
  std::string name;
  int parent = -1;
  Transform transform;
  std::optional<dmat4> matrix;  // replaces `transform`
  // Shear of a split matrix (`splitMatrix`), applied before scale, rotation and translation.
  std::optional<dmat3> shear = {};
  int mesh = -1, camera = -1, light = -1;
  std::vector<dmat4> instances;  // node-from-instance of EXT_mesh_gpu_instancing; empty: one instance, identity
  // Skin of the node's mesh. With a skin, the joints place the mesh, and only the handedness of the node's own
  // transform counts. `sole_joint` (index into the skin) is a joint that all vertices follow rigidly and that always
  // has the handedness of the node; else -1.
  int skin = -1, sole_joint = -1;
  std::vector<double> weights;  // of the morph targets, at rest; empty if they have no effect
  std::vector<double> cuts;     // times, s, of jumps of the node and its descendants; no blur over these
};

// Radiance of rays that leave the scene, and ambient light of surfaces. Linear radiance, blended from `ground` (down)
// to `sky` (up) with the height of the direction.
struct Environment {
  vec3 sky = vec3(0);
  vec3 ground = vec3(0);
  std::optional<vec3> background;  // radiance of rays without a hit, in place of the blend
};

// File that was read for a scene, with the hash of its content.
struct SourceFile {
  Path path;  // absolute
  std::string hash;
};

// Complete scene: node hierarchy, meshes, materials, textures, cameras, lights, animations and environment. Objects
// refer to each other by index.
struct Scene {
  std::string name;
  std::vector<Node> nodes;  // in any order of parents and children
  std::vector<Mesh> meshes;
  std::vector<Skin> skins;
  std::vector<Material> materials;  // at least one
  std::vector<Texture> textures;
  std::vector<Camera> cameras;
  std::vector<Light> lights;
  std::vector<Animation> animations;
  std::vector<ConstantMotion> motions;
  Environment environment;
  std::vector<double> cuts;              // times, s, of jumps of all objects and the camera
  double loop_s = 0;                     // duration of a loop in the window, s; 0: no suggestion
  std::vector<std::string> warnings;     // unsupported contents, with the node's name
  std::vector<std::string> assumptions;  // supplied defaults, for the run record
  Json attribution;                      // licence and author, if stated by the file or its folder
  std::vector<SourceFile> files;         // a glTF scene's own file first, then all files that the scene names
};

// Drawable: a mesh at a node. Its instance id is its index + 1.
struct Instance {
  int node = -1;
  int mesh = -1;
  dmat4 node_from_instance = dmat4(1);
  bool flattens = false;  // true if its transform may be flat at some time (scene/flat.h)
};

// Drawables of a scene in a fixed order: by node, then by instance.
std::vector<Instance> instancesOf(const Scene& scene);

// Inputs of the deformation of an instance's vertices (`scene/bend.h`).
struct Bend {
  // World-from-mesh of each joint of the skin, or of all vertices of an instance that flattens. Empty without a skin,
  // or with a sole joint.
  std::vector<dmat4> joints;
  std::vector<double> weights;  // of the morph targets
  // True if the transform of the node mirrors. Joints then give vertices with negated x, and
  // `Pose::world_from_instance` mirrors them back, so that its sign selects the front.
  bool mirrored = false;
  bool operator==(const Bend&) const = default;
};

// State of a scene at one time, in world space.
struct Pose {
  // One per instance, including the mesh's `origin`. For an instance with joints: identity, with x negated if
  // `Bend::mirrored`.
  std::vector<dmat4> world_from_instance;
  std::vector<Bend> bends;              // one per instance; empty for a rigid instance
  std::vector<dmat4> world_from_light;  // one per light node (`lightsOf`)
  std::vector<Light> lights;            // state at this time, one per light node
  dmat4 world_from_camera = dmat4(1);   // camera looks along -z, y up; unit scale
  Camera camera;                        // lens at this time
};

// Light nodes: indices into Scene::nodes, in order.
std::vector<int> lightsOf(const Scene& scene);

// Node of the camera `name` ("" for the first). Throws `Error` with the list of cameras if the camera is missing.
int cameraNode(const Scene& scene, const std::string& name);

// Computes true poses: first the animations of `animation` ("all", "none" or a clip's name), then constant motions. A
// clip has the values of its first keys before them, and repeats from time 0 after its duration. If several clips drive
// one target, "all" plays the first. Throws `Error` for an unknown clip, with the nearest name, and for nodes that are
// their own ancestors. `scene` must outlive the poser.
class Poser {
 public:
  Poser(const Scene& scene, int camera_node, const std::string& animation = "all");
  Pose at(double time_s) const;
  // STEP channels are held at `held_time_s`, so that a jump leaves no streak in a frame.
  Pose at(double time_s, double held_time_s) const;
  // World-from-node of every node.
  std::vector<dmat4> nodesAt(double time_s, double held_time_s) const;

 private:
  // Node that keys or constant motions move, or a descendant of such a node.
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
  std::vector<size_t> driven_instances_;  // all instances that may differ from rest
};

}  // namespace strobe::scene
