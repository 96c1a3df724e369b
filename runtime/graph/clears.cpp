// SPDX-License-Identifier: MIT
#include "graph/clears.h"

#include "plan/formats.h"

namespace strobe::graph {

static const plan::PassDesc& clearPass() {
  static const plan::PassDesc pass = [] {
    plan::PassDesc clear;
    clear.name = "clear", clear.shader = "graph/clear";
    return clear;
  }();
  return pass;
}

static shader::Interface interfaceFor(const std::string& format) {
  const gpu::FormatInfo& info = gpu::formatInfo(format);
  shader::Interface in;
  in.pass = clearPass().name;
  in.writes.push_back({"cleared", info.glsl, info.uint, false, format});
  in.variants.push_back({"is_uint", {}, info.uint});
  return in;
}

void Clears::make(PipelineCache& cache, const plan::Plan& plan, const PlanImages& images,
                  const world::GpuScene& scene) {
  for (size_t i = 0; i < plan.images.size(); ++i) {
    const plan::VirtualImage& image = plan.images[i];
    if (!image.cleared || plan::isBuffer(image.format)) continue;
    Cleared& cleared = cleared_[int(i)];
    cleared.width = uint32_t(image.width), cleared.height = uint32_t(image.height);
    cleared.pipeline = cache.get(interfaceFor(image.format), clearPass(), scene);
    cleared.pool = gpu::makeDescriptorPool(device_, image.name + ".clear", cleared.pipeline->bindings, 1);
    cleared.set = gpu::allocateSet(device_, cleared.pool.get(), cleared.pipeline->driver->set_layout.get());
    const VkDescriptorImageInfo view{VK_NULL_HANDLE, images.of(int(i)).view(), VK_IMAGE_LAYOUT_GENERAL};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = cleared.set;
    write.dstBinding = cleared.pipeline->interface.writeBinding(0);
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    write.pImageInfo = &view;
    device_.vk().UpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
  }
}

void Clears::record(VkCommandBuffer commands, int image, const world::GpuScene& scene) const {
  const Cleared& cleared = cleared_.at(image);
  const gpu::Pipeline& pipeline = cleared.pipeline->driver->pipeline;
  const VkDescriptorSet sets[] = {scene.set(), cleared.set};
  const auto& vk = device_.vk();
  vk.CmdBindPipeline(commands, pipeline.bindPoint(), pipeline.handle());
  vk.CmdBindDescriptorSets(commands, pipeline.bindPoint(), pipeline.layout(), 0, 2, sets, 0, nullptr);
  const uint32_t group = shader::kGroupSize;
  vk.CmdDispatch(commands, (cleared.width + group - 1) / group, (cleared.height + group - 1) / group, 1);
}

}  // namespace strobe::graph
