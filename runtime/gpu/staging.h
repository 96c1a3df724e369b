// SPDX-License-Identifier: MIT
// How the host writes what work on the device reads, without waiting for the work before.
#pragma once

#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

// Host memory for what is written to buffers of the device until commands copy it there, in their turn: work that was
// submitted before still reads what it is meant to read. The device must outlive it.
class Staging {
 public:
  Staging() = default;
  explicit Staging(const Device& device) : device_(&device) {}

  // Writes `count` values, which the next `recordCopies` copies to a buffer of such values, from the one numbered
  // `first` on. Of two writes to one place, both before that call, neither is sure to last. Throws `Error` where memory
  // runs out.
  template <class T>
  void write(const Buffer& to, size_t first, const T* values, size_t count) {
    if (count > 0) std::memcpy(placeFor(to, first * sizeof(T), count * sizeof(T)), values, count * sizeof(T));
  }
  bool isEmpty() const { return copies_.empty(); }

  // Records copies of all that was written since the last time, behind all work before, and before all that follows.
  void recordCopies(VkCommandBuffer commands);
  // All copies that were recorded are executed, or never will be: their memory is used again. What was written and not
  // recorded is forgotten.
  void reset();

 private:
  struct Copy {
    VkBuffer from, to;
    VkBufferCopy region;
  };
  // In host memory, for bytes that go to a buffer from its byte `at` on.
  void* placeFor(const Buffer& to, size_t at, size_t bytes);

  const Device* device_ = nullptr;
  std::vector<Buffer> parts_;
  size_t part_ = 0, used_ = 0;  // of the part that is filled
  std::vector<Copy> copies_;
};

}  // namespace strobe::gpu
