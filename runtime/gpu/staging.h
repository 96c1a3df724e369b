// SPDX-License-Identifier: MIT
// Writes data from the host to device buffers without waiting for earlier work.
#pragma once

#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

// Host memory for data that commands copy to device buffers in submission order, so that earlier work still reads the
// old data. The device must outlive it.
class Staging {
 public:
  Staging() = default;
  explicit Staging(const Device& device) : device_(&device) {}

  // Writes `count` values; the next `recordCopies` copies them to `to`, an array of T, from index `first`. Two writes
  // to one place before one `recordCopies` have an undefined order. Throws `Error` if memory runs out.
  template <class T>
  void write(const Buffer& to, size_t first, const T* values, size_t count) {
    if (count > 0) std::memcpy(placeFor(to, first * sizeof(T), count * sizeof(T)), values, count * sizeof(T));
  }
  bool isEmpty() const { return copies_.empty(); }

  // Records copies of all writes since the last call, with barriers to earlier and later commands.
  void recordCopies(VkCommandBuffer commands);
  // Reuses the memory of all recorded copies; they must have executed, or never will. Discards unrecorded writes.
  void reset();

 private:
  struct Copy {
    VkBuffer from, to;
    VkBufferCopy region;
  };
  // Host memory for `bytes` bytes, to be copied to `to` from byte `at` on.
  void* placeFor(const Buffer& to, size_t at, size_t bytes);

  const Device* device_ = nullptr;
  std::vector<Buffer> parts_;
  size_t part_ = 0, used_ = 0;  // current part; bytes used in it
  std::vector<Copy> copies_;
};

}  // namespace strobe::gpu
