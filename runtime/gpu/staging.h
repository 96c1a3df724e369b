// SPDX-License-Identifier: MIT
// Writes data from the host to device buffers and images: data of a frame without waiting for earlier work, and data of
// new buffers and images in few submissions.
#pragma once

#include <algorithm>
#include <vector>

#include "gpu/resources.h"

namespace strobe::gpu {

// Host memory for data that commands copy to device buffers and images in submission order, so that earlier work still
// reads the old data. The device must outlive it.
class Staging {
 public:
  // Bytes of a part: small enough to allocate for each frame, large enough for most frames.
  static constexpr size_t kPart = size_t{1} << 20;

  Staging() = default;
  explicit Staging(const Device& device) : device_(&device) {}

  // Writes `count` values; the next `recordCopies` copies them to `to`, an array of T, from index `first`. Two writes
  // to one place before one `recordCopies` have an undefined order. Throws `Error` if memory runs out.
  template <class T>
  void write(const Buffer& to, size_t first, const T* values, size_t count) {
    if (count > 0) std::memcpy(placeFor(to, first * sizeof(T), count * sizeof(T)), values, count * sizeof(T));
  }
  // Host memory for `bytes` bytes (at least one), to be copied to `to` from byte `at` on.
  void* placeFor(const Buffer& to, size_t at, size_t bytes);
  // Writes all levels of a new image (size of level l: max(1, size >> l)). The image must live until the copies.
  void write(const DeviceImage& to, const std::vector<std::vector<uint8_t>>& levels);
  bool isEmpty() const { return copies_.empty() && image_copies_.empty(); }

  // Records copies of all writes since the last call, with barriers to earlier and later commands.
  void recordCopies(VkCommandBuffer commands);
  // Reuses the memory of all recorded copies; they must have executed, or never will. Discards unrecorded writes.
  void reset();

 private:
  struct Copy {
    VkBuffer from, to;
    VkBufferCopy region;
  };
  struct ImageCopy {
    VkBuffer from;
    VkImage to;
    VkBufferImageCopy region;
  };
  const Buffer& partWith(size_t bytes);
  void recordImageCopies(VkCommandBuffer commands);

  const Device* device_ = nullptr;
  std::vector<Buffer> parts_;
  size_t part_ = 0, used_ = 0;  // current part; bytes used in it
  std::vector<Copy> copies_;
  std::vector<ImageCopy> image_copies_;
};

// Fills new buffers and images, and submits the copies of each 16 MiB together. The device must outlive it.
class Uploads {
 public:
  explicit Uploads(const Device& device) : device_(device), staging_(device) {}
  // `finish` must have been called, except during the handling of an exception.
  ~Uploads();

  // A buffer of the device with `values`.
  template <class T>
  Buffer array(const std::string& name, const std::vector<T>& values, VkBufferUsageFlags usage) {
    Buffer buffer(device_, name, values.size() * sizeof(T), usage, Buffer::Memory::Device);
    fill<T>(buffer, 0, values.size(), [&](size_t i) { return values[i]; });
    return buffer;
  }
  // Writes `count` items to an array of T, from index `first`; `item(i)` returns item i.
  template <class T, class Item>
  void fill(const Buffer& to, size_t first, size_t count, const Item& item) {
    for (size_t i = 0; i < count;) {
      const size_t end = std::min(count, i + Staging::kPart / sizeof(T));
      T* place = static_cast<T*>(placeFor(to, (first + i) * sizeof(T), (end - i) * sizeof(T)));
      for (; i < end; ++i) *place++ = item(i);
    }
  }
  DeviceImage image(const std::string& name, ImageDesc desc, const std::vector<std::vector<uint8_t>>& levels);
  // Waits for all copies.
  void finish();

 private:
  void* placeFor(const Buffer& to, size_t at, size_t bytes);
  void reserve(size_t bytes);

  const Device& device_;
  Staging staging_;
  size_t staged_ = 0;  // bytes since the last submission
};

}  // namespace strobe::gpu
