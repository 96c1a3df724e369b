// SPDX-License-Identifier: MIT
#include "plan/slots.h"

#include <algorithm>
#include <numeric>

#include "plan/formats.h"

namespace strobe::plan {
namespace {

void touch(Plan& plan, const Step& step, int position, std::vector<bool>& seen) {
  for (const Use& use : step.uses) {
    if (use.image < 0) continue;
    VirtualImage& image = plan.images[use.image];
    if (!seen[use.image]) image.first = position;
    seen[use.image] = true;
    image.last = position;
  }
  for (const Step& inner : step.body) touch(plan, inner, position, seen);
}

void findLifetimes(Plan& plan) {
  std::vector<bool> seen(plan.images.size(), false);
  for (size_t i = 0; i < plan.steps.size(); ++i) touch(plan, plan.steps[i], static_cast<int>(i), seen);
  for (VirtualImage& image : plan.images) {
    if (image.kept) image.last = static_cast<int>(plan.steps.size()) - 1;
  }
}

bool alone(const VirtualImage& image) { return image.kept || image.update; }

bool sameKind(const Slot& slot, const VirtualImage& image) {
  return slot.format == image.format && slot.width == image.width && slot.height == image.height;
}

Slot slotFor(const VirtualImage& image) {
  const uint64_t bytes = bytesOf(image.format, image.width, image.height);
  return {image.format, image.width, image.height, 0, bytes};
}

}  // namespace

void assignSlots(Plan& plan) {
  findLifetimes(plan);
  std::vector<int> order(plan.images.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return plan.images[a].first < plan.images[b].first; });

  constexpr int kNeverFree = 1 << 30;
  std::vector<int> busy_until;  // per slot
  plan.slots.clear();
  for (int index : order) {
    VirtualImage& image = plan.images[index];
    size_t slot = plan.slots.size();
    for (size_t i = 0; i < plan.slots.size() && !alone(image) && slot == plan.slots.size(); ++i) {
      if (sameKind(plan.slots[i], image) && busy_until[i] < image.first) slot = i;
    }
    if (slot == plan.slots.size()) {
      plan.slots.push_back(slotFor(image));
      busy_until.push_back(0);
    }
    image.slot = static_cast<int>(slot);
    plan.slots[slot].usage |= image.usage;
    busy_until[slot] = alone(image) ? kNeverFree : image.last;
  }
}

}  // namespace strobe::plan
