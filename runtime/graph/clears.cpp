// SPDX-License-Identifier: MIT
#include "graph/clears.h"

#include "plan/formats.h"

namespace strobe::graph {

void Clears::make(PipelineCache& cache, const plan::Plan& plan, const PlanImages& images) {
  for (size_t i = 0; i < plan.images.size(); ++i) {
    const plan::VirtualImage& image = plan.images[i];
    if (!image.cleared || plan::isBuffer(image.format)) continue;
    const DriverPipeline& clear = cache.clearOf(image.format);
    Cleared& cleared = cleared_[int(i)];
    cleared.pipeline = &clear.pipeline;
    cleared.width = uint32_t(image.width), cleared.height = uint32_t(image.height);
    VkDescriptorSetLayoutBinding binding{};
    binding.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    binding.descriptorCount = 1;
    cleared.set = gpu::DescriptorSet(device_, image.name + ".clear", clear.set_layout.get(), {binding});
    cleared.set.write(0, std::vector{gpu::inGeneral(images.of(int(i)).view())});
  }
}

void Clears::record(VkCommandBuffer commands, int image) const {
  const Cleared& cleared = cleared_.at(image);
  const auto& vk = device_.vk();
  vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, cleared.pipeline->handle());
  const VkDescriptorSet set = cleared.set.handle();
  vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, cleared.pipeline->layout(), 0, 1, &set, 0,
                           nullptr);
  const uint32_t group = shader::kGroupSize;
  vk.CmdDispatch(commands, (cleared.width + group - 1) / group, (cleared.height + group - 1) / group, 1);
}

}  // namespace strobe::graph
