// SPDX-License-Identifier: MIT
#include "gpu/staging.h"

#include <exception>

namespace strobe::gpu {

// Moves to a part with `bytes` unused bytes.
const Buffer& Staging::partWith(size_t bytes) {
  used_ = (used_ + 15) & ~size_t{15};  // alignment of a texel
  while (part_ < parts_.size() && parts_[part_].size() < used_ + bytes) ++part_, used_ = 0;
  if (part_ == parts_.size()) parts_.emplace_back(*device_, "staging", std::max(bytes, kPart), 0, Buffer::Memory::Host);
  return parts_[part_];
}

void* Staging::placeFor(const Buffer& to, size_t at, size_t bytes) {
  STROBE_ASSERT(bytes > 0 && at + bytes <= to.size(), "{} bytes from {} on into {}", bytes, at, to.size());
  Copy* last = copies_.empty() ? nullptr : &copies_.back();
  const bool continues = last && last->to == to.handle() && last->region.dstOffset + last->region.size == at &&
                         last->from == parts_[part_].handle() && last->region.srcOffset + last->region.size == used_ &&
                         used_ + bytes <= parts_[part_].size();
  if (continues) {
    last->region.size += bytes;
  } else {
    const VkBuffer from = partWith(bytes).handle();
    copies_.push_back({from, to.handle(), {used_, at, bytes}});
  }
  void* place = static_cast<char*>(parts_[part_].mapped()) + used_;
  used_ += bytes;
  return place;
}

void Staging::write(const DeviceImage& to, const std::vector<std::vector<uint8_t>>& levels) {
  STROBE_ASSERT(levels.size() == to.desc().levels, "{} levels of {}", levels.size(), to.desc().levels);
  for (uint32_t l = 0; l < levels.size(); ++l) {
    const Buffer& part = partWith(levels[l].size());
    std::memcpy(static_cast<char*>(part.mapped()) + used_, levels[l].data(), levels[l].size());
    VkBufferImageCopy region{};
    region.bufferOffset = used_;
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, l, 0, 1};
    region.imageExtent = {std::max(1u, to.desc().width >> l), std::max(1u, to.desc().height >> l), 1};
    image_copies_.push_back({part.handle(), to.handle(), region});
    used_ += levels[l].size();
  }
}

void Staging::recordCopies(VkCommandBuffer commands) {
  if (isEmpty()) return;
  constexpr VkAccessFlags2 kAny = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  recordBarrier(*device_, commands, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT},
                {VK_PIPELINE_STAGE_2_COPY_BIT, kAny});
  for (const Copy& copy : copies_) device_->vk().CmdCopyBuffer(commands, copy.from, copy.to, 1, &copy.region);
  recordImageCopies(commands);
  recordBarrier(*device_, commands, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, kAny});
  copies_.clear();
  image_copies_.clear();
}

void Staging::recordImageCopies(VkCommandBuffer commands) {
  VkImage image = VK_NULL_HANDLE;
  for (const ImageCopy& copy : image_copies_) {
    if (std::exchange(image, copy.to) != copy.to)
      recordBarrier(*device_, commands, {VK_PIPELINE_STAGE_2_COPY_BIT, 0},
                    {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                    {image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL});
    device_->vk().CmdCopyBufferToImage(commands, copy.from, image, VK_IMAGE_LAYOUT_GENERAL, 1, &copy.region);
  }
}

void Staging::reset() {
  part_ = used_ = 0;
  copies_.clear();
  image_copies_.clear();
}

Uploads::~Uploads() { STROBE_ASSERT(staging_.isEmpty() || std::uncaught_exceptions() > 0, "uploads are not finished"); }

// Submits the held copies before they exceed the most bytes with `bytes` more.
void Uploads::reserve(size_t bytes) {
  constexpr size_t kMost = size_t{16} << 20;
  if (staged_ + bytes > kMost) finish();
  staged_ += bytes;
}

void* Uploads::placeFor(const Buffer& to, size_t at, size_t bytes) {
  reserve(bytes);
  return staging_.placeFor(to, at, bytes);
}

DeviceImage Uploads::image(const std::string& name, ImageDesc desc, const std::vector<std::vector<uint8_t>>& levels) {
  desc.usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  DeviceImage image(device_, name, desc);
  size_t bytes = 0;
  for (const auto& level : levels) bytes += level.size();
  reserve(bytes);
  staging_.write(image, levels);
  return image;
}

void Uploads::finish() {
  staged_ = 0;
  if (staging_.isEmpty()) return;
  device_.submit([this](VkCommandBuffer commands) { staging_.recordCopies(commands); });
  staging_.reset();
}

}  // namespace strobe::gpu
