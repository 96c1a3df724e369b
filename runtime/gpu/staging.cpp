// SPDX-License-Identifier: MIT
#include "gpu/staging.h"

namespace strobe::gpu {

// Bytes of a part: small enough to allocate for each frame, large enough for most frames.
static constexpr size_t kPart = size_t{1} << 20;

void* Staging::placeFor(const Buffer& to, size_t at, size_t bytes) {
  STROBE_ASSERT(bytes > 0 && at + bytes <= to.size(), "{} bytes from {} on into {}", bytes, at, to.size());
  const size_t room = (bytes + 15) & ~size_t{15};
  while (part_ < parts_.size() && parts_[part_].size() - used_ < room) ++part_, used_ = 0;
  if (part_ == parts_.size()) parts_.emplace_back(*device_, "staging", std::max(room, kPart), 0, Buffer::Memory::Host);
  const Buffer& part = parts_[part_];
  copies_.push_back({part.handle(), to.handle(), {used_, at, bytes}});
  void* place = static_cast<char*>(part.mapped()) + used_;
  used_ += room;
  return place;
}

void Staging::recordCopies(VkCommandBuffer commands) {
  if (copies_.empty()) return;
  constexpr VkAccessFlags2 kAny = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
  recordBarrier(*device_, commands, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT},
                {VK_PIPELINE_STAGE_2_COPY_BIT, kAny});
  for (const Copy& copy : copies_) device_->vk().CmdCopyBuffer(commands, copy.from, copy.to, 1, &copy.region);
  recordBarrier(*device_, commands, {VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT},
                {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, kAny});
  copies_.clear();
}

void Staging::reset() {
  part_ = used_ = 0;
  copies_.clear();
}

}  // namespace strobe::gpu
