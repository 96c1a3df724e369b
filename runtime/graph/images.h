// SPDX-License-Identifier: MIT
// The images and buffers of one plan: slots of memory that they share, histories kept from frame to frame, buffers to
// read back.
#pragma once

#include "gpu/resources.h"
#include "graph/frame.h"

namespace strobe::graph {

// Bytes of a plan's images, before the first allocation: slots and zeros on the device, read-back buffers, and the
// pictures that the program makes of these.
struct ImageBytes {
  uint64_t on_device = 0, read_back = 0, pictures = 0;
};
ImageBytes imageBytes(const plan::Plan& plan, size_t frames);

// The plan and the device must outlive it.
class PlanImages {
 public:
  // Images and histories that are described alike are moved out of `previous` (may be null), and buffers are shared
  // with it: drivers take long over each allocation. What is read back has a buffer for each of `frames`, those under
  // way at once. Throws `Error` where memory or sides do not suffice; `previous` is then as it was.
  PlanImages(const gpu::Device& device, const plan::Plan& plan, size_t frames, PlanImages* previous);

  // Goes on with a plan of the same shape.
  void setPlan(const plan::Plan& plan) { plan_ = &plan; }
  // Undoes the taking over.
  void giveBack(PlanImages& previous);

  // One of them, as the format of the plan's image says.
  const gpu::Image& of(int image) const;
  const gpu::Buffer& buffer(int image) const;
  // What stands behind optional reads that nothing is wired to.
  const gpu::Image& unwired(bool uint) const { return uint ? unwired_->uint_image : unwired_->image; }
  const gpu::Buffer& unwiredBuffer() const { return unwired_->buffer; }
  const gpu::Buffer& readBack(int image, size_t frame) const { return *read_back_.at(image)[frame]; }
  ReadImage fetch(int image, size_t frame) const;

  // Of what is zero outside of the reach of a frame: the pixels that may not be zero, null: any; and those that may not
  // be from now on.
  const scene::PixelArea* touched(int image) const;
  void touch(int image, const scene::PixelArea& area) { touched_[slotOf(image)] = area; }
  void forgetTouched() { touched_.clear(); }
  // As many bytes of zeros as a quarter of the largest of these has.
  const gpu::Buffer& zeros() const { return zeros_; }

  bool holdsEarlierFrame(int image) const;
  void frameIsRecorded();
  void forgetHistories();
  // "node.port" of the histories that were taken over, and of those that begin anew.
  std::vector<std::string> histories(bool taken_over) const;

 private:
  using SharedBuffer = std::shared_ptr<const gpu::Buffer>;
  struct Unwired {
    gpu::Image image, uint_image;
    gpu::Buffer buffer;
  };

  int slotOf(int image) const { return plan_->images[size_t(image)].slot; }
  void make(PlanImages* previous);
  void makeZeros();
  void makeUnwired();
  void keepReadBack(size_t frames, const PlanImages* previous);
  std::vector<SharedBuffer> readBackOf(const std::string& name, size_t bytes) const;
  gpu::Image takeOver(const plan::VirtualImage& image, const gpu::ImageDesc& desc, PlanImages& previous);

  const gpu::Device& device_;
  const plan::Plan* plan_;
  std::vector<gpu::Image> slots_;
  std::map<int, SharedBuffer> buffers_;  // by slot; its image is then empty
  std::shared_ptr<const Unwired> unwired_;
  std::map<int, scene::PixelArea> touched_;  // by slot
  gpu::Buffer zeros_;
  std::map<int, std::vector<SharedBuffer>> read_back_;  // by virtual image, then frame
  std::map<int, bool> history_;                         // by virtual image: holds an earlier frame
  std::set<std::string> taken_over_;                    // histories of a previous graph
  std::vector<std::pair<size_t, size_t>> taken_slots_;  // this one's, and that of a previous graph it came from
};

}  // namespace strobe::graph
