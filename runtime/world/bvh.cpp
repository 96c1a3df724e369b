// SPDX-License-Identifier: MIT
#include "world/bvh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <future>
#include <thread>

#include "base/error.h"
#include "world/refit.h"

namespace strobe::world {

namespace {

constexpr double kNodeCost = 1, kBoxCost = 1;

double halfArea(const Box& box) {
  double x = double(box.high.x) - box.low.x, y = double(box.high.y) - box.low.y, z = double(box.high.z) - box.low.z;
  return x < 0 ? 0 : x * y + y * z + z * x;
}

struct Item {
  Box box;
  uint32_t index;
  float twiceMiddle(int axis) const { return box.low[axis] + box.high[axis]; }
};

// A node of two children: the left one is the next in the list.
struct Binary {
  Box box;
  uint32_t begin = 0, end = 0;  // items
  uint32_t right = 0;           // 0: a leaf
};

struct Split {
  double cost = HUGE_VAL;  // of both sides, as areas times boxes
  int axis = -1;
  uint32_t bin = 0;  // the first on the right
};

class Builder {
 public:
  Builder(std::vector<Item>& items, const BvhOptions& options) : items_(items), options_(options) {
    binaries_.resize(items.empty() ? 0 : 2 * items.size() - 1);
  }

  // The subtree over [begin, end) has the places from `at` on, two for each item less one: so children of any list are
  // where they are, whichever thread builds them.
  void build(uint32_t begin, uint32_t end, uint32_t at, int depth, unsigned threads) {
    Binary& node = binaries_[at];
    node.begin = begin, node.end = end;
    Box middles;
    for (uint32_t i = begin; i < end; ++i) {
      const Item& item = items_[i];
      node.box.add(item.box);
      middles.add(vec3(item.twiceMiddle(0), item.twiceMiddle(1), item.twiceMiddle(2)));
    }
    uint32_t count = end - begin;
    if (count == 1) return;
    Split split = bestSplit(begin, end, middles);
    double area = halfArea(node.box);
    if (count <= options_.leaf_boxes && !(kNodeCost * area + kBoxCost * split.cost < kBoxCost * area * count)) return;
    // Where halves alone keep the tree as low as it has to be, or nothing tells boxes apart, halves it is.
    bool deep = depth + int(std::bit_width(count - 1)) >= options_.depth;
    uint32_t middle = deep || split.axis < 0 ? halve(begin, end, middles) : partition(begin, end, middles, split);
    node.right = at + 2 * (middle - begin);
    uint32_t right = node.right;
    std::future<void> left;
    if (threads > 1 && count > kWorthAThread)
      left = std::async(std::launch::async, [=, this] { build(begin, middle, at + 1, depth + 1, threads / 2); });
    else build(begin, middle, at + 1, depth + 1, 1);
    build(middle, end, right, depth + 1, threads - threads / 2);
    if (left.valid()) left.get();
  }

  const std::vector<Binary>& binaries() const { return binaries_; }

 private:
  static constexpr uint32_t kBins = 32, kWorthAThread = 10000;

  struct Binning {
    float low, scale;
    Binning(const Box& middles, int axis) : low(middles.low[axis]) {
      float extent = middles.high[axis] - low;
      scale = extent > 0 ? float(kBins) * (1 - 1e-6f) / extent : 0;
      if (!std::isfinite(scale)) scale = 0;
    }
    uint32_t of(float twice_middle) const { return std::min(uint32_t((twice_middle - low) * scale), kBins - 1); }
  };

  Split bestSplit(uint32_t begin, uint32_t end, const Box& middles) const {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      Binning binning(middles, axis);
      if (binning.scale == 0) continue;
      std::array<Box, kBins> boxes;
      std::array<uint32_t, kBins> counts{};
      for (uint32_t i = begin; i < end; ++i) {
        uint32_t bin = binning.of(items_[i].twiceMiddle(axis));
        boxes[bin].add(items_[i].box);
        ++counts[bin];
      }
      std::array<double, kBins> left{};
      Box box;
      uint32_t count = 0;
      for (uint32_t bin = 0; bin + 1 < kBins; ++bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        left[bin + 1] = halfArea(box) * count;
      }
      box = Box(), count = 0;
      for (uint32_t bin = kBins - 1; bin > 0; --bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        double cost = left[bin] + halfArea(box) * count;
        if (count > 0 && count < end - begin && cost < best.cost) best = {cost, axis, bin};
      }
    }
    return best;
  }

  uint32_t partition(uint32_t begin, uint32_t end, const Box& middles, const Split& split) {
    Binning binning(middles, split.axis);
    auto is_left = [&](const Item& item) { return binning.of(item.twiceMiddle(split.axis)) < split.bin; };
    return uint32_t(std::stable_partition(at(begin), at(end), is_left) - items_.begin());
  }

  uint32_t halve(uint32_t begin, uint32_t end, const Box& middles) {
    vec3 extent = middles.high - middles.low;
    int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [axis](const Item& a, const Item& b) {
      float left = a.twiceMiddle(axis), right = b.twiceMiddle(axis);
      return left < right || (left == right && a.index < b.index);
    });
    return middle;
  }

  std::vector<Item>::iterator at(uint32_t i) { return items_.begin() + std::ptrdiff_t(i); }

  std::vector<Item>& items_;
  BvhOptions options_;
  std::vector<Binary> binaries_;
};

// One byte of a plane, rounded away from what is inside.
uint32_t plane(double distance, double step, bool up) {
  double steps = up ? std::ceil(distance / step) : std::floor(distance / step);
  return uint32_t(std::clamp(steps, 0.0, 255.0));
}

// Gives a node these children's bounds, and returns what is around them all.
Box setBounds(shared::BvhNode& node, const std::vector<Box>& children) {
  Box box;
  for (const Box& child : children) box.add(child);
  node.origin = box.low;
  node.steps = uint32_t(children.size()) << 24;
  node.low = node.high = uvec3(0);
  for (int axis = 0; axis < 3; ++axis) {
    double extent = double(box.high[axis]) - box.low[axis];
    int exponent = -126;
    if (extent > 0) std::frexp(extent / 255, &exponent);  // extent / 255 < 2^exponent
    exponent = std::clamp(exponent, -126, 127);
    double step = std::ldexp(1.0, exponent);
    node.steps |= uint32_t(exponent + 127) << (8 * axis);
    for (size_t c = 0; c < children.size(); ++c) {
      node.low[axis] |= plane(double(children[c].low[axis]) - node.origin[axis], step, false) << (8 * c);
      node.high[axis] |= plane(double(children[c].high[axis]) - node.origin[axis], step, true) << (8 * c);
    }
  }
  return box;
}

// Joins nodes of two children to nodes of four.
class Joiner {
 public:
  Joiner(const std::vector<Binary>& binaries, const std::vector<Item>& items, const BvhOptions& options)
      : binaries_(binaries), items_(items), options_(options) {}

  // Appends the node and what is below it.
  uint32_t join(uint32_t root) {
    // The largest is opened first: a line meets it most likely.
    std::vector<uint32_t> children = {root};
    while (children.size() < 4) {
      auto larger = [this](uint32_t a, uint32_t b) { return worth(a) < worth(b); };
      auto largest = std::max_element(children.begin(), children.end(), larger);
      if (binaries_[*largest].right == 0) break;
      uint32_t opened = *largest;
      *largest = opened + 1;
      children.insert(largest + 1, binaries_[opened].right);
    }
    uint32_t index = uint32_t(nodes.size());
    nodes.push_back(nodeOf(children));
    for (size_t c = 0; c < children.size(); ++c) {
      const Binary& child = binaries_[children[c]];
      uint32_t reference = child.right == 0 ? leafOf(child) : join(children[c]);
      nodes[index].children[c] = reference;
    }
    return index;
  }

  std::vector<shared::BvhNode> nodes;

 private:
  double worth(uint32_t binary) const { return binaries_[binary].right == 0 ? -1 : halfArea(binaries_[binary].box); }

  uint32_t leafOf(const Binary& leaf) const {
    if (options_.leaf_boxes == 1) return BVH_LEAF | items_[leaf.begin].index;
    return BVH_LEAF | (leaf.end - leaf.begin - 1) << BVH_LEAF_COUNT | leaf.begin;
  }

  shared::BvhNode nodeOf(const std::vector<uint32_t>& children) const {
    std::vector<Box> boxes;
    for (uint32_t child : children) boxes.push_back(binaries_[child].box);
    shared::BvhNode node{};
    setBounds(node, boxes);
    return node;
  }

  const std::vector<Binary>& binaries_;
  const std::vector<Item>& items_;
  BvhOptions options_;
};

double costOf(const std::vector<Binary>& binaries, uint32_t root) {
  double sum = 0;
  std::vector<uint32_t> open = {root};
  while (!open.empty()) {
    uint32_t at = open.back();
    open.pop_back();
    const Binary& node = binaries[at];
    double area = halfArea(node.box);
    sum += area * (node.right == 0 ? kBoxCost * (node.end - node.begin) : kNodeCost);
    if (node.right != 0) open.insert(open.end(), {at + 1, node.right});
  }
  double whole = halfArea(binaries[root].box);
  return whole > 0 ? sum / whole : 1;
}

// The largest coordinate of any plane of a node.
float reachOf(const shared::BvhNode& node) {
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double step = std::ldexp(1.0, int(node.steps >> (8 * axis) & 255) - 127);
    reach = std::max({reach, std::abs(double(node.origin[axis])), std::abs(node.origin[axis] + 255 * step)});
  }
  return float(std::min(reach, double(FLT_MAX)));
}

}  // namespace

Bvh buildBvh(const std::vector<Box>& boxes, const BvhOptions& options) {
  Bvh bvh;
  std::vector<Item> items;
  for (size_t i = 0; i < boxes.size(); ++i)
    if (boxes[i].low.x <= boxes[i].high.x) items.push_back({boxes[i], uint32_t(i)});
  if (items.empty()) {
    bvh.nodes.push_back({});
    return bvh;
  }
  Builder builder(items, options);
  builder.build(0, uint32_t(items.size()), 0, 0, std::max(1u, std::thread::hardware_concurrency()));
  Joiner joiner(builder.binaries(), items, options);
  joiner.join(0);
  bvh.nodes = std::move(joiner.nodes);
  bvh.nodes.front().reach = reachOf(bvh.nodes.front());
  for (const Item& item : items) bvh.order.push_back(item.index);
  bvh.cost = costOf(builder.binaries(), 0);
  return bvh;
}

void refitBvh(Bvh& bvh, const std::vector<Box>& boxes) {
  std::vector<Box> around(bvh.nodes.size());
  // Children have higher numbers than their node.
  for (size_t index = bvh.nodes.size(); index-- > 0 && !bvh.order.empty();) {
    shared::BvhNode& node = bvh.nodes[index];
    std::vector<Box> children(node.steps >> 24);
    for (size_t c = 0; c < children.size(); ++c) {
      const uint32_t reference = node.children[c];
      if (!(reference & BVH_LEAF)) children[c] = around[reference];
      else
        for (uint32_t i = 0; i <= (reference >> BVH_LEAF_COUNT & 3); ++i)
          children[c].add(boxes.at(bvh.order.at((reference & ((1u << BVH_LEAF_COUNT) - 1)) + i)));
    }
    around[index] = setBounds(node, children);
  }
  bvh.nodes.front().reach = reachOf(bvh.nodes.front());
}

}  // namespace strobe::world
