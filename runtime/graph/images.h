// SPDX-License-Identifier: MIT
// Images and buffers of one plan: shared memory slots, histories kept between frames, read-back buffers.
#pragma once

#include "gpu/resources.h"
#include "graph/frame.h"

namespace strobe::graph {

// Vulkan format and GLSL layout qualifier of a format of a plan (plan/formats.h); of a buffer: format and qualifier of
// its entries.
struct DeviceFormat {
  VkFormat vk;
  const char* glsl;
};
const DeviceFormat& deviceFormat(const std::string& format);

// Bytes of a plan's images, computed before any allocation: slots on the device, read-back buffers, and host
// images of the results.
struct ImageBytes {
  uint64_t on_device = 0, read_back = 0, pictures = 0;
};
ImageBytes imageBytes(const plan::Plan& plan, size_t frames);

// Owns the images and buffers of a plan. The plan and the device must outlive it.
class PlanImages {
 public:
  // Moves images and histories with equal descriptions out of `previous` (may be null), and shares buffers with it, so
  // that both plans together need little more memory than one. Each image that is read back has one buffer per frame in
  // flight (`frames`). Throws `Error` if memory runs out or an image is too large; `previous` is then unchanged.
  PlanImages(const gpu::Device& device, const plan::Plan& plan, size_t frames, PlanImages* previous);

  // Continues with a plan of the same shape.
  void setPlan(const plan::Plan& plan) { plan_ = &plan; }
  // Moves the images taken from `previous` back into it.
  void giveBack(PlanImages& previous);

  // Image or buffer of a virtual image; the format of the virtual image decides which one exists.
  const gpu::DeviceImage& of(int image) const;
  const gpu::Buffer& buffer(int image) const;
  // Placeholders bound to optional reads that are not wired.
  const gpu::DeviceImage& unwired(bool uint) const { return uint ? unwired_.uint_image : unwired_.image; }
  const gpu::Buffer& unwiredBuffer() const { return unwired_.buffer; }
  const gpu::Buffer& readBack(int image, size_t frame) const { return *read_back_.at(image)[frame]; }
  ReadImage fetch(int image, size_t frame) const;

  bool holdsEarlierFrame(int image) const;
  void frameIsRecorded();
  void forgetHistories();
  // History images ("node.port"): taken over from the previous graph, or newly created.
  std::vector<std::string> histories(bool taken_over) const;

 private:
  using SharedBuffer = std::shared_ptr<const gpu::Buffer>;
  struct Unwired {
    gpu::DeviceImage image, uint_image;
    gpu::Buffer buffer;
  };

  std::vector<size_t> makeSlots(PlanImages* previous);
  void makeUnwired();
  void initialize(const std::vector<size_t>& fresh);
  void keepReadBack(size_t frames, const PlanImages* previous);
  std::vector<SharedBuffer> readBackOf(const std::string& name, size_t bytes) const;
  gpu::DeviceImage takeOver(const plan::VirtualImage& image, const gpu::ImageDesc& desc, PlanImages& previous);

  const gpu::Device& device_;
  const plan::Plan* plan_;
  std::vector<gpu::DeviceImage> slots_;
  std::map<int, SharedBuffer> buffers_;  // by slot; the slot's image is then empty
  Unwired unwired_;
  std::map<int, std::vector<SharedBuffer>> read_back_;  // by virtual image, then frame
  std::map<int, bool> history_;                         // by virtual image: holds the previous frame
  std::set<std::string> taken_over_;                    // histories taken from the previous graph
  std::vector<std::pair<size_t, size_t>> taken_slots_;  // slot here, slot in the previous graph
};

}  // namespace strobe::graph
