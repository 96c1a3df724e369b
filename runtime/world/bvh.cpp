// SPDX-License-Identifier: MIT
#include "world/bvh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <future>
#include <span>

#include "base/cores.h"
#include "base/error.h"

namespace strobe::world {

namespace {

double halfArea(const Box& box) {
  double x = double(box.high.x) - box.low.x, y = double(box.high.y) - box.low.y, z = double(box.high.z) - box.low.z;
  return x < 0 ? 0 : x * y + y * z + z * x;
}

struct Split {
  double cost = HUGE_VAL;  // of both sides: area times number of boxes
  int axis = -1;
  uint32_t bin = 0;  // first bin on the right
};

float twiceMiddle(const BvhItem& item, int axis) { return item.box.low[axis] + item.box.high[axis]; }

// A box in vector registers; the fourth components are unused.
struct WideBox {
  using Four = float __attribute__((vector_size(16)));
  Four low = {HUGE_VALF, HUGE_VALF, HUGE_VALF}, high = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF};
  void add(const Four& other_low, const Four& other_high) {
    low = other_low < low ? other_low : low;
    high = other_high > high ? other_high : high;
  }
  void add(const WideBox& other) { add(other.low, other.high); }
  Box box() const { return {vec3(low[0], low[1], low[2]), vec3(high[0], high[1], high[2])}; }

  static WideBox of(const BvhItem& item) {
    WideBox box;
    static_assert(sizeof item == 28 && sizeof box.low == 16);
    std::memcpy(&box.low, &item.box.low, sizeof box.low);
    std::memcpy(&box.high, &item.box.high, sizeof box.high);
    return box;
  }
};

struct Binning {
  static constexpr uint32_t kBins = 32;
  float low, scale;
  Binning(const Box& middles, int axis) : low(middles.low[axis]) {
    float extent = middles.high[axis] - low;
    scale = extent > 0 ? float(kBins) * (1 - 1e-6f) / extent : 0;
    if (!std::isfinite(scale)) scale = 0;
  }
  uint32_t of(float twice_middle) const { return std::min(uint32_t((twice_middle - low) * scale), kBins - 1); }
};

// Bounds and counts of items per axis and bin; the bin of an item depends on its centroid.
struct Bins {
  static constexpr uint32_t kBins = Binning::kBins;
  std::array<std::array<WideBox, kBins>, 3> boxes;
  std::array<std::array<uint32_t, kBins>, 3> counts{};
  void add(const Bins& other) {
    for (size_t axis = 0; axis < 3; ++axis)
      for (uint32_t bin = 0; bin < kBins; ++bin) {
        boxes[axis][bin].add(other.boxes[axis][bin]);
        counts[axis][bin] += other.counts[axis][bin];
      }
  }
};

// Quantises the plane at `place` to one byte relative to `origin`; rounds up if `up`, otherwise down.
uint32_t plane(double place, double origin, double step, bool up) {
  double distance = place - origin;
  // Exact rounding error of `distance` (Knuth, TAOCP 2, 4.2.2): operands of very different size may round to either
  // side.
  const double taken = place - distance, rest = (place - (distance + taken)) + (taken - origin);
  if (up ? rest > 0 : rest < 0) distance = std::nextafter(distance, up ? HUGE_VAL : -HUGE_VAL);
  double steps = up ? std::ceil(distance / step) : std::floor(distance / step);
  return uint32_t(std::clamp(steps, 0.0, 255.0));
}

// Sets the quantised bounds of a node's children and returns their union.
Box setBounds(shared::BvhNode& node, std::span<const Box> children) {
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
      node.low[axis] |= plane(children[c].low[axis], node.origin[axis], step, false) << (8 * c);
      node.high[axis] |= plane(children[c].high[axis], node.origin[axis], step, true) << (8 * c);
    }
  }
  return box;
}

// Largest absolute coordinate of a node's planes.
float reachOf(const shared::BvhNode& node) {
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double step = std::ldexp(1.0, int(node.steps >> (8 * axis) & 255) - 127);
    reach = std::max({reach, std::abs(double(node.origin[axis])), std::abs(node.origin[axis] + 255 * step)});
  }
  return float(std::min(reach, double(FLT_MAX)));
}

// Items of one binary node or of one leaf.
struct TreePart {
  uint32_t begin = 0, end = 0;
  int depth = 0;
  Box box, middles;  // bounds of the items; bounds of twice their centroids
  Split split;
  bool leaf = false;
  uint32_t count() const { return end - begin; }
};

// Splits parts in two by the heuristic, and joins the splits to nodes of four children.
class BvhBuilder {
 public:
  using Nodes = std::vector<shared::BvhNode>;  // child indices relative to the first node

  BvhBuilder(std::vector<BvhItem>& items, const BvhOptions& options)
      : items_(items), options_(options), spare_threads_(int(allowedCores()) - 1) {}

  TreePart examined(uint32_t begin, uint32_t end, int depth) {
    TreePart part{begin, end, depth, {}, {}, {}, false};
    measure(part);
    const uint32_t count = part.count();
    part.leaf = count == 1;
    if (part.leaf) return part;
    part.split = count <= kFew ? bestSplitOfFew(part) : bestSplit(part);
    const double area = halfArea(part.box);
    // Expected cost of a random line: 1 per node, 1 per box in a leaf.
    part.leaf = count <= options_.leaf_boxes && !(area + part.split.cost < area * count);
    return part;
  }

  // Appends the node of a part and its subtree to `nodes`; returns the index of the node.
  uint32_t append(const TreePart& root, Nodes& nodes) {
    std::array<TreePart, 4> children = {root};
    size_t count = 1;
    // Open the largest child first: a random line most likely hits it.
    while (count < 4) {
      auto larger = [](const TreePart& a, const TreePart& b) { return worth(a) < worth(b); };
      auto largest = std::max_element(children.begin(), children.begin() + count, larger);
      if (largest->leaf) break;
      auto [left, right] = opened(*largest);
      std::move_backward(largest + 1, children.begin() + count, children.begin() + count + 1);
      *largest = left, *(largest + 1) = right;
      ++count;
    }
    const uint32_t index = uint32_t(nodes.size());
    nodes.push_back(nodeOf(children, count));
    if (root.count() > kWorthAThread) appendApart(children, count, index, nodes);
    else
      for (size_t c = 0; c < count; ++c) {
        const uint32_t reference = children[c].leaf ? leafOf(children[c]) : append(children[c], nodes);
        nodes[index].children[c] = reference;
      }
    return index;
  }

 private:
  static constexpr uint32_t kFew = 12, kWorthAThread = 50000;

  // Starts a task on another thread if one is free; otherwise the future is invalid. Threads do not change the tree.
  template <class Task>
  auto started(const Task& task) {
    std::future<decltype(task())> future;
    if (spare_threads_.fetch_sub(1) > 0)
      future = std::async(std::launch::async, [this, task] {
        auto result = task();
        spare_threads_.fetch_add(1);
        return result;
      });
    else spare_threads_.fetch_add(1);
    return future;
  }

  // Builds the children as separate subtrees, then appends them in order.
  void appendApart(const std::array<TreePart, 4>& children, size_t count, uint32_t index, Nodes& nodes) {
    std::array<std::future<Nodes>, 4> futures;
    std::array<Nodes, 4> apart;
    auto below = [this](const TreePart& part) {
      Nodes subtree;
      append(part, subtree);
      return subtree;
    };
    for (size_t c = 0; c < count; ++c)
      if (!children[c].leaf) {
        futures[c] = started([below, part = children[c]] { return below(part); });
        if (!futures[c].valid()) apart[c] = below(children[c]);
      }
    size_t total = nodes.size();
    for (size_t c = 0; c < count; ++c) {
      if (futures[c].valid()) apart[c] = futures[c].get();
      total += apart[c].size();
    }
    nodes.reserve(total);
    for (size_t c = 0; c < count; ++c) {
      const uint32_t first = uint32_t(nodes.size());
      nodes[index].children[c] = children[c].leaf ? leafOf(children[c]) : first;
      for (shared::BvhNode& node : apart[c]) {
        for (uint32_t& child : node.children) child += child & BVH_LEAF ? 0 : first;
        nodes.push_back(node);
      }
      apart[c] = {};
    }
  }

  // Returns over(begin, end). For a long range, two halves run in parallel if a thread is free, and the results are
  // added.
  template <class Over>
  auto summed(uint32_t begin, uint32_t end, const Over& over) {
    if (end - begin <= kWorthAThread) return over(begin, end);
    const uint32_t middle = begin + (end - begin) / 2;
    auto left = started([&over, begin, middle] { return over(begin, middle); });
    if (!left.valid()) return over(begin, end);
    auto sum = over(middle, end);
    sum.add(left.get());
    return sum;
  }

  void measure(TreePart& part) {
    struct Sizes {
      WideBox box, middles;
      void add(const Sizes& other) { box.add(other.box), middles.add(other.middles); }
    };
    Sizes sizes = summed(part.begin, part.end, [this](uint32_t begin, uint32_t end) {
      Sizes sum;
      for (uint32_t i = begin; i < end; ++i) {
        const WideBox box = WideBox::of(items_[i]);
        sum.box.add(box);
        sum.middles.add(box.low + box.high, box.low + box.high);
      }
      return sum;
    });
    part.box = sizes.box.box(), part.middles = sizes.middles.box();
  }

  Bins binned(const TreePart& part) {
    const std::array<Binning, 3> binnings = {Binning(part.middles, 0), Binning(part.middles, 1),
                                             Binning(part.middles, 2)};
    return summed(part.begin, part.end, [&](uint32_t begin, uint32_t end) {
      Bins bins;
      for (uint32_t i = begin; i < end; ++i) {
        const WideBox box = WideBox::of(items_[i]);
        for (int axis = 0; axis < 3; ++axis) {
          const uint32_t bin = binnings[size_t(axis)].of(twiceMiddle(items_[i], axis));
          bins.boxes[size_t(axis)][bin].add(box);
          ++bins.counts[size_t(axis)][bin];
        }
      }
      return bins;
    });
  }

  Split bestSplit(const TreePart& part) {
    constexpr uint32_t kBins = Binning::kBins;
    const Bins bins = binned(part);
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (Binning(part.middles, axis).scale == 0) continue;
      const auto& boxes = bins.boxes[size_t(axis)];
      const auto& counts = bins.counts[size_t(axis)];
      std::array<double, kBins> left{};
      WideBox box;
      uint32_t count = 0;
      for (uint32_t bin = 0; bin + 1 < kBins; ++bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        left[bin + 1] = halfArea(box.box()) * count;
      }
      box = WideBox(), count = 0;
      for (uint32_t bin = kBins - 1; bin > 0; --bin) {
        box.add(boxes[bin]);
        count += counts[bin];
        double cost = left[bin] + halfArea(box.box()) * count;
        if (count > 0 && count < part.count() && cost < best.cost) best = {cost, axis, bin};
      }
    }
    return best;
  }

  // Best split of at most kFew items: sorts the items instead of filling bins.
  Split bestSplitOfFew(const TreePart& part) {
    const uint32_t count = part.count();
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      Binning binning(part.middles, axis);
      if (binning.scale == 0) continue;
      struct Place {
        uint32_t bin, item;
      };
      std::array<Place, kFew> places;
      for (uint32_t i = 0; i < count; ++i) {
        uint32_t at = i, bin = binning.of(twiceMiddle(items_[part.begin + i], axis));
        for (; at > 0 && places[at - 1].bin > bin; --at) places[at] = places[at - 1];
        places[at] = {bin, part.begin + i};
      }
      std::array<double, kFew> left{};
      WideBox box;
      for (uint32_t i = 0; i + 1 < count; ++i) {
        box.add(WideBox::of(items_[places[i].item]));
        left[i + 1] = halfArea(box.box()) * (i + 1);
      }
      box = WideBox();
      for (uint32_t i = count - 1; i > 0; --i) {
        box.add(WideBox::of(items_[places[i].item]));
        if (places[i - 1].bin == places[i].bin) continue;
        double cost = left[i] + halfArea(box.box()) * (count - i);
        if (cost < best.cost) best = {cost, axis, places[i].bin};
      }
    }
    return best;
  }

  std::pair<TreePart, TreePart> opened(const TreePart& part) {
    // Median split if the depth limit requires it or all centroids coincide.
    bool deep = part.depth + int(std::bit_width(part.count() - 1)) >= options_.depth;
    uint32_t middle = deep || part.split.axis < 0 ? halve(part) : partition(part);
    return {examined(part.begin, middle, part.depth + 1), examined(middle, part.end, part.depth + 1)};
  }

  uint32_t partition(const TreePart& part) {
    const int axis = part.split.axis;
    const Binning binning(part.middles, axis);
    auto is_left = [&](const BvhItem& item) { return binning.of(twiceMiddle(item, axis)) < part.split.bin; };
    return uint32_t(std::stable_partition(at(part.begin), at(part.end), is_left) - items_.begin());
  }

  uint32_t halve(const TreePart& part) {
    vec3 extent = part.middles.high - part.middles.low;
    int axis = extent.x >= extent.y ? (extent.x >= extent.z ? 0 : 2) : (extent.y >= extent.z ? 1 : 2);
    uint32_t middle = part.begin + part.count() / 2;
    std::nth_element(at(part.begin), at(middle), at(part.end), [axis](const BvhItem& a, const BvhItem& b) {
      float left = twiceMiddle(a, axis), right = twiceMiddle(b, axis);
      return left < right || (left == right && a.index < b.index);
    });
    return middle;
  }

  static double worth(const TreePart& part) { return part.leaf ? -1 : halfArea(part.box); }

  uint32_t leafOf(const TreePart& leaf) const {
    if (options_.leaf_boxes == 1) return BVH_LEAF | items_[leaf.begin].index;
    return BVH_LEAF | (leaf.count() - 1) << BVH_LEAF_COUNT | leaf.begin;
  }

  static shared::BvhNode nodeOf(const std::array<TreePart, 4>& children, size_t count) {
    std::array<Box, 4> boxes;
    for (size_t c = 0; c < count; ++c) boxes[c] = children[c].box;
    shared::BvhNode node{};
    setBounds(node, std::span(boxes).first(count));
    return node;
  }

  std::vector<BvhItem>::iterator at(uint32_t i) { return items_.begin() + std::ptrdiff_t(i); }

  std::vector<BvhItem>& items_;
  BvhOptions options_;
  std::atomic<int> spare_threads_;
};

}  // namespace

Bvh buildBvh(std::vector<BvhItem>& items, const BvhOptions& options) {
  Bvh bvh;
  std::erase_if(items, [](const BvhItem& item) { return item.box.empty(); });
  if (items.empty()) {
    bvh.nodes.push_back({});
    return bvh;
  }
  BvhBuilder builder(items, options);
  const TreePart root = builder.examined(0, uint32_t(items.size()), 0);
  builder.append(root, bvh.nodes);
  bvh.nodes.front().reach = reachOf(bvh.nodes.front());
  bvh.bounds = root.box;
  return bvh;
}

Bvh buildBvh(const std::vector<Box>& boxes, const BvhOptions& options) {
  std::vector<BvhItem> items;
  items.reserve(boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i) items.push_back({boxes[i], uint32_t(i)});
  return buildBvh(items, options);
}

Bvh joined(const Bvh& a, const Bvh& b) {
  Bvh both;
  both.nodes.push_back({});
  std::vector<Box> boxes;
  for (const Bvh* part : {&a, &b}) {
    if (part->bounds.empty()) continue;
    const uint32_t first = uint32_t(both.nodes.size());
    both.nodes.front().children[boxes.size()] = first;
    boxes.push_back(part->bounds);
    for (shared::BvhNode node : part->nodes) {
      for (uint32_t& child : node.children) child += child & BVH_LEAF ? 0 : first;
      both.nodes.push_back(node);
    }
  }
  if (boxes.empty()) return both;
  both.bounds = setBounds(both.nodes.front(), boxes);
  both.nodes.front().reach = reachOf(both.nodes.front());
  return both;
}

void refitBvh(Bvh& bvh, const std::vector<Box>& boxes) {
  if (boxes.empty()) return;
  std::vector<Box> around(bvh.nodes.size());
  // Children have higher numbers than their node.
  for (size_t index = bvh.nodes.size(); index-- > 0;) {
    shared::BvhNode& node = bvh.nodes[index];
    std::vector<Box> children(node.steps >> 24);
    for (size_t c = 0; c < children.size(); ++c) {
      const uint32_t reference = node.children[c];
      if (!(reference & BVH_LEAF)) children[c] = around[reference];
      else
        for (uint32_t i = 0; i <= (reference >> BVH_LEAF_COUNT & 3); ++i)
          children[c].add(boxes.at((reference & ((1u << BVH_LEAF_COUNT) - 1)) + i));
    }
    around[index] = setBounds(node, children);
  }
  bvh.bounds = around.front();
  bvh.nodes.front().reach = reachOf(bvh.nodes.front());
}

}  // namespace strobe::world
