// SPDX-License-Identifier: MIT
#include "graph/images.h"

#include <glm/gtc/packing.hpp>
#include <map>
#include <set>

#include "gpu/limits.h"
#include "plan/formats.h"

namespace strobe::graph {

using plan::Plan;

static VkImageUsageFlags vulkanUsage(uint32_t usage) {
  VkImageUsageFlags flags = 0;
  if (usage & plan::kUsageSampled) flags |= VK_IMAGE_USAGE_SAMPLED_BIT;
  if (usage & plan::kUsageStorage) flags |= VK_IMAGE_USAGE_STORAGE_BIT;
  if (usage & plan::kUsageColorAttachment) flags |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  if (usage & plan::kUsageDepthAttachment) flags |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  if (usage & plan::kUsageTransferSource) flags |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  if (usage & plan::kUsageTransferTarget) flags |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  return flags;
}

const DeviceFormat& deviceFormat(const std::string& format) {
  static const std::map<std::string, DeviceFormat> table = {
      {"r8_unorm", {VK_FORMAT_R8_UNORM, "r8"}},
      {"rgba8_unorm", {VK_FORMAT_R8G8B8A8_UNORM, "rgba8"}},
      {"rg16f", {VK_FORMAT_R16G16_SFLOAT, "rg16f"}},
      {"rgba16f", {VK_FORMAT_R16G16B16A16_SFLOAT, "rgba16f"}},
      {"r32f", {VK_FORMAT_R32_SFLOAT, "r32f"}},
      {"rg32f", {VK_FORMAT_R32G32_SFLOAT, "rg32f"}},
      {"rgba32f", {VK_FORMAT_R32G32B32A32_SFLOAT, "rgba32f"}},
      {"r32ui", {VK_FORMAT_R32_UINT, "r32ui"}},
      {"rg32ui", {VK_FORMAT_R32G32_UINT, "rg32ui"}},
      {"rgba32ui", {VK_FORMAT_R32G32B32A32_UINT, "rgba32ui"}},
      {plan::kBufferFormat, {VK_FORMAT_R32_UINT, "r32ui"}},
      {"d32f", {VK_FORMAT_D32_SFLOAT, ""}},
  };
  return table.at(format);
}

// Moves the image with an equal description out of `previous`; empty if no image matches.
gpu::DeviceImage PlanImages::takeOver(const plan::VirtualImage& image, const gpu::ImageDesc& desc,
                                      PlanImages& previous) {
  for (size_t i = 0; i < previous.plan_->images.size(); ++i) {
    const plan::VirtualImage& other = previous.plan_->images[i];
    gpu::DeviceImage& held = previous.slots_[size_t(other.slot)];
    bool alike = other.name == image.name && other.history == image.history && held.desc() == desc;
    if (!alike || !held.handle()) continue;
    auto history = previous.history_.find(int(i));
    if (image.history && history != previous.history_.end() && history->second) taken_over_.insert(image.name);
    taken_slots_.push_back({slots_.size(), size_t(other.slot)});
    return std::move(held);
  }
  return {};
}

void PlanImages::giveBack(PlanImages& previous) {
  for (auto [slot, from] : taken_slots_)
    if (slot < slots_.size()) previous.slots_[from] = std::move(slots_[slot]);
}

// Checks all sizes before any allocation.
static void requireImages(const gpu::Device& device, const Plan& plan) {
  const gpu::DeviceLimits limits = gpu::limitsOf(device);
  const uint64_t most = limits.image_side;
  for (const plan::VirtualImage& image : plan.images) {
    if (plan::isBuffer(image.format)) {
      const uint64_t bytes = plan::bytesOf(image.format, image.width, image.height);
      if (bytes <= limits.buffer_bytes) continue;
      throw Error(gpu::kBufferLimit.text(fmt::format("'{}' takes {} bytes, of at most {} on device '{}'", image.name,
                                                     bytes, limits.buffer_bytes, device.info().name)));
    }
    if (uint64_t(std::max(image.width, image.height)) <= most) continue;
    throw Error(gpu::kImageLimit.text(fmt::format("'{}' is {}x{} pixels, of at most {} a side on device '{}'",
                                                  image.name, image.width, image.height, most, device.info().name)));
  }
}

static gpu::Buffer madeBuffer(const gpu::Device& device, const std::string& name, uint64_t bytes) {
  const VkBufferUsageFlags usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                                   VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  return gpu::Buffer(device, name, bytes, usage, gpu::Buffer::Memory::Device);
}

static std::shared_ptr<const gpu::Buffer> share(gpu::Buffer&& buffer) {
  return std::make_shared<const gpu::Buffer>(std::move(buffer));
}

PlanImages::PlanImages(const gpu::Device& device, const Plan& plan, size_t frames, PlanImages* previous)
    : device_(device), plan_(&plan) {
  try {
    requireImages(device_, *plan_);
    const std::vector<size_t> fresh = makeSlots(previous);
    makeUnwired();
    keepReadBack(frames, previous);
    initialize(fresh);
  } catch (...) {
    if (previous) giveBack(*previous);
    throw;
  }
}

// Takes or creates the image or buffer of each slot, and returns the slots with new images.
std::vector<size_t> PlanImages::makeSlots(PlanImages* previous) {
  std::vector<size_t> fresh;
  for (size_t i = 0; i < plan_->slots.size(); ++i) {
    const plan::Slot& slot = plan_->slots[i];
    if (plan::isBuffer(slot.format)) {
      auto held = previous ? previous->buffers_.find(int(i)) : buffers_.end();
      bool alike = previous && held != previous->buffers_.end() && held->second->size() == slot.bytes;
      if (alike) buffers_[int(i)] = held->second;
      else buffers_[int(i)] = share(madeBuffer(device_, fmt::format("slot {}", i), slot.bytes));
      slots_.emplace_back();
      continue;
    }
    gpu::ImageDesc desc;
    desc.format = deviceFormat(slot.format).vk;
    desc.width = uint32_t(slot.width);
    desc.height = uint32_t(slot.height);
    desc.usage = vulkanUsage(slot.usage);
    const plan::VirtualImage* held = nullptr;
    for (const auto& image : plan_->images)
      if (image.slot == int(i)) held = &image;
    gpu::DeviceImage taken = held && previous ? takeOver(*held, desc, *previous) : gpu::DeviceImage();
    if (!taken.handle()) fresh.push_back(i);
    if (!taken.handle()) taken = gpu::DeviceImage(device_, held ? held->name : fmt::format("slot {}", i), desc);
    slots_.push_back(std::move(taken));
  }
  for (size_t i = 0; i < plan_->images.size(); ++i)
    if (plan_->images[i].history) history_[int(i)] = taken_over_.count(plan_->images[i].name) > 0;
  return fresh;
}

// Gives the new images their layout and the zeros their value.
void PlanImages::initialize(const std::vector<size_t>& fresh) {
  device_.submit([&](VkCommandBuffer commands) {
    for (size_t i : fresh) {
      bool depth = slots_[i].desc().format == VK_FORMAT_D32_SFLOAT;
      VkImageAspectFlags aspect = depth ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
      gpu::recordFirstLayout(device_, commands, slots_[i].handle(), aspect);
    }
    for (const gpu::DeviceImage* image : {&unwired_.image, &unwired_.uint_image})
      gpu::recordFirstLayout(device_, commands, image->handle(), VK_IMAGE_ASPECT_COLOR_BIT);
  });
}

// Images that are read back: outputs, taps, stop conditions of loops.
static std::set<int> imagesKept(const Plan& plan) {
  std::set<int> kept;
  for (const auto* named : {&plan.outputs, &plan.taps})
    for (const auto& [name, image] : *named) kept.insert(image);
  for (const auto& loop : plan.loops)
    if (loop.until >= 0) kept.insert(loop.until);
  return kept;
}

static size_t readBackBytes(const plan::VirtualImage& image) {
  return size_t(image.width) * image.height * size_t(plan::findFormat(image.format)->bytes);
}

ImageBytes imageBytes(const Plan& plan, size_t frames) {
  ImageBytes bytes{plan::bytesAliased(plan), 0, 0};
  for (int index : imagesKept(plan)) bytes.read_back += frames * readBackBytes(plan.images[size_t(index)]);
  for (const auto* named : {&plan.outputs, &plan.taps})
    for (const auto& [name, index] : *named) {
      const plan::VirtualImage& image = plan.images[size_t(index)];
      bytes.pictures +=
          uint64_t(image.width) * image.height * uint64_t(plan::findFormat(image.format)->channels) * sizeof(float);
    }
  return bytes;
}

void PlanImages::makeUnwired() {
  gpu::ImageDesc one;
  one.usage = VK_IMAGE_USAGE_SAMPLED_BIT;
  one.format = VK_FORMAT_R32_SFLOAT;
  unwired_.image = gpu::DeviceImage(device_, "unwired", one);
  one.format = VK_FORMAT_R32_UINT;
  unwired_.uint_image = gpu::DeviceImage(device_, "unwired uint", one);
  unwired_.buffer = madeBuffer(device_, "unwired buffer", plan::kBufferHead);
}

// Read-back buffers of an image of this name and size; empty if no image matches.
std::vector<PlanImages::SharedBuffer> PlanImages::readBackOf(const std::string& name, size_t bytes) const {
  for (const auto& [image, buffers] : read_back_)
    if (plan_->images[size_t(image)].name == name && buffers.front()->size() == bytes) return buffers;
  return {};
}

void PlanImages::keepReadBack(size_t frames, const PlanImages* previous) {
  for (int image : imagesKept(*plan_)) {
    const plan::VirtualImage& kept = plan_->images[size_t(image)];
    const size_t bytes = readBackBytes(kept);
    std::vector<SharedBuffer>& buffers = read_back_[image];
    if (buffers.empty() && previous) buffers = previous->readBackOf(kept.name, bytes);
    while (buffers.size() < frames)
      buffers.push_back(share(gpu::Buffer(device_, kept.name + ".read_back", bytes, 0, gpu::Buffer::Memory::Host)));
  }
}

const gpu::DeviceImage& PlanImages::of(int image) const { return slots_[size_t(plan_->images[size_t(image)].slot)]; }

const gpu::Buffer& PlanImages::buffer(int image) const { return *buffers_.at(plan_->images[size_t(image)].slot); }

static float unpackHalf(uint16_t bits) { return glm::unpackHalf1x16(bits); }

ReadImage PlanImages::fetch(int image, size_t frame) const {
  const plan::VirtualImage& source = plan_->images[size_t(image)];
  const plan::Format& format = *plan::findFormat(source.format);
  const void* data = readBack(image, frame).mapped();
  size_t count = size_t(source.width) * source.height * format.channels;
  ReadImage read;
  read.format = source.format;
  if (format.uint) {
    read.uints = {source.width, source.height, format.channels, std::vector<uint32_t>(count)};
    std::memcpy(read.uints.values.data(), data, count * 4);
    return read;
  }
  read.floats = image::Image(source.width, source.height, format.channels);
  int bytes_per_channel = format.bytes / format.channels;
  for (size_t i = 0; i < count; ++i) {
    float& value = read.floats.values[i];
    if (bytes_per_channel == 4) value = static_cast<const float*>(data)[i];
    if (bytes_per_channel == 2) value = unpackHalf(static_cast<const uint16_t*>(data)[i]);
    if (bytes_per_channel == 1) value = static_cast<const uint8_t*>(data)[i] / 255.0f;
  }
  return read;
}

// ---- histories

bool PlanImages::holdsEarlierFrame(int image) const {
  auto history = history_.find(image);
  return history != history_.end() && history->second;
}

void PlanImages::frameIsRecorded() {
  for (auto& [image, earlier] : history_) earlier = true;
}

std::vector<std::string> PlanImages::histories(bool taken_over) const {
  std::vector<std::string> names;
  for (const auto& [image, earlier] : history_) {
    const std::string& name = plan_->images[size_t(image)].name;
    if (bool(taken_over_.count(name)) == taken_over) names.push_back(name);
  }
  return names;
}

void PlanImages::forgetHistories() {
  for (auto& [image, earlier] : history_) earlier = false;
}

}  // namespace strobe::graph
