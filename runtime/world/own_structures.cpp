// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "world/limits.h"
#include "world/structures.h"

namespace strobe::world {

using shared::BvhInstance;
using shared::BvhNode;
using shared::BvhTriangle;

namespace {

// Layout of SceneBvh in shaders/shared/bindings.glsl.
struct Addresses {
  VkDeviceAddress nodes, triangles, instances;
  uint32_t first_root, nodes_per_tree;
};

// An affine transform by rows. `ofSizes` transforms absolute values, to bound the rounding of a ray in object space.
struct Rows {
  std::array<dvec4, 3> rows;
  dvec3 of(const dvec3& p) const { return {dot(0, p), dot(1, p), dot(2, p)}; }
  dvec3 ofSizes(const dvec3& size) const {
    dvec3 result;
    for (size_t r = 0; r < 3; ++r)
      result[int(r)] = std::abs(rows[r].x) * size.x + std::abs(rows[r].y) * size.y + std::abs(rows[r].z) * size.z +
                       std::abs(rows[r].w);
    return result;
  }

 private:
  double dot(size_t r, const dvec3& p) const { return rows[r].x * p.x + rows[r].y * p.y + rows[r].z * p.z + rows[r].w; }
};

Rows inverseOf(const Rows& m) {
  dvec3 x(m.rows[0]), y(m.rows[1]), z(m.rows[2]), moved(m.rows[0].w, m.rows[1].w, m.rows[2].w);
  double determinant = glm::dot(x, glm::cross(y, z));
  dvec3 c0 = glm::cross(y, z) / determinant, c1 = glm::cross(z, x) / determinant, c2 = glm::cross(x, y) / determinant;
  Rows inverse;
  for (int r = 0; r < 3; ++r) {
    dvec3 row(c0[r], c1[r], c2[r]);
    inverse.rows[size_t(r)] = dvec4(row, -glm::dot(row, moved));
  }
  return inverse;
}

// World-space box of a posed mesh, padded for the rounding of a ray's transform to object space. Inverted if rays
// cannot be transformed to object space.
Box posedBox(const Box& mesh, const Rows& world_from_object, const Rows& object_from_world) {
  Bounds box;
  for (int i = 0; i < 8; ++i) box.add(world_from_object.of(dvec3(mesh.corner(i))));
  dvec3 low = box.low, high = box.high;
  dvec3 size = glm::max(glm::abs(low), glm::abs(high));
  dvec3 room = world_from_object.ofSizes(object_from_world.ofSizes(size)) * std::ldexp(1.0, -21);
  low -= room, high += room;
  // A transform that flattens the object has no inverse, so rays cannot be transformed to object space.
  for (int axis = 0; axis < 3; ++axis)
    if (!(low[axis] > -FLT_MAX && high[axis] < FLT_MAX)) return {};
  return {vec3(low), vec3(high)};
}

class OwnStructures : public Structures {
 public:
  OwnStructures(const gpu::Device& device, const scene::Scene& scene, const MeshTrees& trees,
                const gpu::Buffer& triangles, BentInstances& bent, uint32_t slices, gpu::Uploads& uploads)
      : device_(device),
        instances_(scene::instancesOf(scene)),
        bent_(bent),
        roots_(trees.roots),
        bounds_(trees.bounds) {
    for (uint32_t root : roots_) reaches_.push_back(trees.nodes[root].reach);
    const shared::SceneTransform nowhere{vec4(NAN), vec4(NAN), vec4(NAN)};
    placed_.resize(instances_.size(), {nowhere, {}, {}});
    size_t levels = levelOf(slices - 1) + 1;
    nodes_per_tree_ = std::max<size_t>(1, instances_.size());
    first_root_ = trees.nodes.size();
    numberBending(scene, triangles, levels);
    refuseNodes(scene.name, levels);
    size_t mesh_bytes = first_root_ * sizeof(BvhNode), top_bytes = 2 * levels * nodes_per_tree_ * sizeof(BvhNode);
    size_t instance_bytes = levels * instances_.size() * sizeof(BvhInstance);
    using gpu::Buffer;
    nodes_ = Buffer(device, "scene.bvh.nodes", mesh_bytes + top_bytes + levels * bending_nodes_ * sizeof(BvhNode),
                    gpu::kReadByAddress, Buffer::Memory::Device);
    uploads.fill<BvhNode>(nodes_, 0, first_root_, [&](size_t i) { return trees.nodes[i]; });
    posed_ = Buffer(device, "scene.bvh.instances", instance_bytes, gpu::kReadByAddress, Buffer::Memory::Device);
    if (!bending_.empty()) makeTriangles(triangles, levels);
    Addresses addresses{nodes_.address(), bending_.empty() ? triangles.address() : triangles_.address(),
                        posed_.address(), uint32_t(first_root_), uint32_t(nodes_per_tree_)};
    addresses_ = uploads.array("scene.bvh", std::vector{addresses}, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
  }

  VkDescriptorSetLayoutBinding binding(uint32_t number) const override {
    return {number, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, VK_SHADER_STAGE_ALL, nullptr};
  }

  void write(const gpu::DescriptorSet& set, uint32_t number) const override { set.write(number, addresses_); }

  void pose(gpu::Staging& staging, uint32_t level, const std::vector<shared::SceneTransform>& transforms,
            const std::vector<bool>& moves) override {
    for (size_t b = 0; b < bending_.size(); ++b) fit(staging, level, b);
    std::vector<BvhInstance> posed(instances_.size());
    std::vector<Box> boxes(instances_.size());
    for (size_t i = 0; i < instances_.size(); ++i) {
      placeAt(transforms[i], i);
      posed[i] = placed_[i].posed, boxes[i] = placed_[i].box;
    }
    for (size_t b = 0; b < bending_.size(); ++b) {
      const Bending& bending = bending_[b];
      const size_t i = bent_.items()[b].instance;
      const Fit& fit = bending.fits[level];
      Rows forward{{dvec4(transforms[i].row_x), dvec4(transforms[i].row_y), dvec4(transforms[i].row_z)}};
      posed[i].root = firstNode(level, bending), posed[i].reach = fit.reach;
      boxes[i] = bending.tree.triangles() > 0 ? posedBox(fit.bounds, forward, inverseOf(forward)) : Box();
    }
    staging.write(posed_, level * posed.size(), posed.data(), posed.size());
    putTrees(staging, level, boxes, moves);
  }

  // The copies of the host writes suffice.
  void recordBuild(VkCommandBuffer, uint32_t, uint32_t) override {}

 private:
  // Tree of a deformed instance at one level.
  struct Fit {
    uint64_t version = 0;
    Box bounds;
    float reach = 0;
  };
  struct Bending {
    BendingTree tree;
    size_t first_node = 0, first_triangle = 0;  // within each level
    std::vector<Fit> fits;                      // by level
  };

  // Last pose of an instance that is not deformed.
  struct Placed {
    shared::SceneTransform transform;
    BvhInstance posed;
    Box box;
  };

  void placeAt(const shared::SceneTransform& transform, size_t i) {
    Placed& placed = placed_[i];
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): equal bits
    if (std::memcmp(&placed.transform, &transform, sizeof transform) == 0) return;
    const size_t mesh = size_t(instances_[i].mesh);
    const Rows forward{{dvec4(transform.row_x), dvec4(transform.row_y), dvec4(transform.row_z)}};
    const Rows back = inverseOf(forward);
    placed = {
        transform, {vec4(back.rows[0]), vec4(back.rows[1]), vec4(back.rows[2]), roots_[mesh], reaches_[mesh]}, {}};
    if (!bounds_[mesh].empty()) placed.box = posedBox(bounds_[mesh], forward, back);
  }

  void numberBending(const scene::Scene& scene, const gpu::Buffer& triangles, size_t levels) {
    for (const SceneMeshes::Bending& item : bent_.items()) {
      const size_t mesh = size_t(instances_[item.instance].mesh);
      Bending bending{BendingTree(scene, scene.meshes[mesh]), bending_nodes_, bending_triangles_, {}};
      bending.fits.resize(levels);
      bending_nodes_ += bending.tree.nodes();
      bending_triangles_ += bending.tree.triangles();
      bending_.push_back(std::move(bending));
    }
    first_bending_node_ = first_root_ + 2 * levels * nodes_per_tree_;
    first_bending_triangle_ = triangles.size() / sizeof(BvhTriangle);
  }

  // Creates a buffer with the triangles of all meshes, and space for the deformed triangles of each level.
  void makeTriangles(const gpu::Buffer& meshes, size_t levels) {
    const size_t bytes = (first_bending_triangle_ + levels * bending_triangles_) * sizeof(BvhTriangle);
    triangles_ =
        gpu::Buffer(device_, "scene.bvh.all_triangles", bytes, gpu::kReadByAddress, gpu::Buffer::Memory::Device);
    device_.submit([&](VkCommandBuffer commands) {
      VkBufferCopy copy{0, 0, first_bending_triangle_ * sizeof(BvhTriangle)};
      if (copy.size > 0) device_.vk().CmdCopyBuffer(commands, meshes.handle(), triangles_.handle(), 1, &copy);
    });
  }

  uint32_t firstNode(uint32_t level, const Bending& bending) const {
    return uint32_t(first_bending_node_ + level * bending_nodes_ + bending.first_node);
  }

  void fit(gpu::Staging& staging, uint32_t level, size_t b) {
    Bending& bending = bending_[b];
    Fit& fit = bending.fits[level];
    const uint32_t slice = sliceOf(level);
    if (fit.version == bent_.version(slice, b)) return;
    fit.version = bent_.version(slice, b);
    const size_t node = firstNode(level, bending);
    const size_t triangle = first_bending_triangle_ + level * bending_triangles_ + bending.first_triangle;
    std::vector<BvhNode> nodes(bending.tree.nodes());
    std::vector<BvhTriangle> triangles(bending.tree.triangles());
    bending.tree.fit(bent_.vertices(slice, b), uint32_t(node), uint32_t(triangle), nodes.data(), triangles.data());
    staging.write(nodes_, node, nodes.data(), nodes.size());
    staging.write(triangles_, triangle, triangles.data(), triangles.size());
    fit.bounds = bending.tree.bounds(), fit.reach = bending.tree.reach();
  }

  void refuseNodes(const std::string& scene, size_t levels) const {
    const size_t nodes = first_bending_node_ + levels * bending_nodes_;
    const size_t triangles = first_bending_triangle_ + levels * bending_triangles_;
    if (nodes <= BVH_MOST_NODES && triangles <= size_t{1} << BVH_LEAF_COUNT) return;
    throw Error(
        kTreeLimit.text(fmt::format("{}: its tree, posed {} times at once, has {} nodes of at most {} and {} "
                                    "triangles of at most {}",
                                    scene, levels, nodes, BVH_MOST_NODES, triangles, size_t{1} << BVH_LEAF_COUNT)));
  }

  // Each level has two trees: over all instances, and over the moving instances. With many static instances, the tree
  // over the static instances is rebuilt only when their boxes change, and is joined with the tree over the moving
  // instances: a full build would take the host longer than rays lose with the joined tree.
  void putTrees(gpu::Staging& staging, uint32_t level, const std::vector<Box>& boxes, const std::vector<bool>& moves) {
    constexpr ptrdiff_t kMany = 256;
    std::vector<Box> moving = boxes, resting = boxes;
    for (size_t i = 0; i < boxes.size(); ++i) (moves[i] ? resting : moving)[i] = {};
    const Bvh moving_tree = buildBvh(moving, {1, BVH_TOP_DEPTH - 1});
    putTree(staging, 2 * level + 1, moving_tree);
    if (std::count(moves.begin(), moves.end(), false) < kMany) {
      putTree(staging, 2 * level, buildBvh(boxes, {1, BVH_TOP_DEPTH}));
      return;
    }
    if (resting != resting_) resting_tree_ = buildBvh(resting, {1, BVH_TOP_DEPTH - 1});
    resting_ = std::move(resting);
    putTree(staging, 2 * level, joined(resting_tree_, moving_tree));
  }

  void putTree(gpu::Staging& staging, size_t tree, Bvh bvh) {
    STROBE_ASSERT(bvh.nodes.size() <= nodes_per_tree_, "{} nodes", bvh.nodes.size());
    const uint32_t first = uint32_t(first_root_ + tree * nodes_per_tree_);
    for (BvhNode& node : bvh.nodes)
      for (uint32_t& child : node.children)
        if (!(child & BVH_LEAF)) child += first;
    staging.write(nodes_, first, bvh.nodes.data(), bvh.nodes.size());
  }

  const gpu::Device& device_;
  std::vector<scene::Instance> instances_;
  BentInstances& bent_;
  std::vector<Bending> bending_;
  std::vector<uint32_t> roots_;
  std::vector<float> reaches_;
  std::vector<Box> bounds_;
  size_t first_root_ = 0, nodes_per_tree_ = 0;
  size_t first_bending_node_ = 0, bending_nodes_ = 0;          // of level 0; per level
  size_t first_bending_triangle_ = 0, bending_triangles_ = 0;  // of level 0; per level
  gpu::Buffer nodes_, posed_, addresses_;
  gpu::Buffer triangles_;  // only with deformed instances
  std::vector<Placed> placed_;
  std::vector<Box> resting_;  // boxes of static instances in resting_tree_
  Bvh resting_tree_;
};

}  // namespace

std::unique_ptr<Structures> makeOwnStructures(const gpu::Device& device, const scene::Scene& scene,
                                              const MeshTrees& trees, const gpu::Buffer& triangles, BentInstances& bent,
                                              uint32_t slices, gpu::Uploads& uploads) {
  return std::make_unique<OwnStructures>(device, scene, trees, triangles, bent, slices, uploads);
}

}  // namespace strobe::world
