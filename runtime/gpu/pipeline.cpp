// SPDX-License-Identifier: MIT
#include "gpu/pipeline.h"

#include <algorithm>

namespace strobe::gpu {

Owned<VkDescriptorSetLayout> makeSetLayout(const Device& device, const std::string& name,
                                           const std::vector<VkDescriptorSetLayoutBinding>& bindings) {
  VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = uint32_t(bindings.size());
  info.pBindings = bindings.data();
  const Dispatch& vk = device.vk();
  return create(device, VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, vk.CreateDescriptorSetLayout,
                vk.DestroyDescriptorSetLayout, info, "set layout", name);
}

DescriptorSet::DescriptorSet(const Device& device, const std::string& name, VkDescriptorSetLayout layout,
                             const std::vector<VkDescriptorSetLayoutBinding>& bindings)
    : device_(&device), bindings_(bindings) {
  std::vector<VkDescriptorPoolSize> sizes;
  for (const auto& binding : bindings) sizes.push_back({binding.descriptorType, binding.descriptorCount});
  if (sizes.empty()) sizes.push_back({VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1});
  VkDescriptorPoolCreateInfo pool{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = 1;
  pool.poolSizeCount = uint32_t(sizes.size());
  pool.pPoolSizes = sizes.data();
  const Dispatch& vk = device.vk();
  pool_ = create(device, VK_OBJECT_TYPE_DESCRIPTOR_POOL, vk.CreateDescriptorPool, vk.DestroyDescriptorPool, pool,
                 "descriptor pool", name);
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pool_.get();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout;
  check(vk.AllocateDescriptorSets(device.handle(), &info, &set_), "allocating the descriptor set " + name);
}

void DescriptorSet::update(uint32_t number, VkWriteDescriptorSet write) const {
  auto of_number = [&](const VkDescriptorSetLayoutBinding& binding) { return binding.binding == number; };
  const auto binding = std::find_if(bindings_.begin(), bindings_.end(), of_number);
  STROBE_ASSERT(binding != bindings_.end(), "binding {}", number);
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set_;
  write.dstBinding = number;
  write.descriptorCount = binding->descriptorCount;
  write.descriptorType = binding->descriptorType;
  device_->vk().UpdateDescriptorSets(device_->handle(), 1, &write, 0, nullptr);
}

void DescriptorSet::write(uint32_t number, const VkDescriptorBufferInfo& buffer) const {
  VkWriteDescriptorSet write{};
  write.pBufferInfo = &buffer;
  update(number, write);
}

void DescriptorSet::write(uint32_t number, const std::vector<VkDescriptorImageInfo>& images) const {
  VkWriteDescriptorSet write{};
  write.pImageInfo = images.data();
  update(number, write);
}

void DescriptorSet::write(uint32_t number, const std::vector<VkAccelerationStructureKHR>& structures) const {
  VkWriteDescriptorSetAccelerationStructureKHR info{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR};
  info.accelerationStructureCount = uint32_t(structures.size());
  info.pAccelerationStructures = structures.data();
  VkWriteDescriptorSet write{};
  write.pNext = &info;
  update(number, write);
}

static Owned<VkShaderModule> makeModule(const Device& device, const std::string& name, const Spirv& code) {
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size() * sizeof(uint32_t);
  info.pCode = code.data();
  const Dispatch& vk = device.vk();
  return create(device, VK_OBJECT_TYPE_SHADER_MODULE, vk.CreateShaderModule, vk.DestroyShaderModule, info,
                "shader module", name);
}

static VkPipelineShaderStageCreateInfo stageInfo(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

Pipeline Pipeline::withLayout(const Device& device, const std::string& name,
                              const std::vector<VkDescriptorSetLayout>& sets, VkPipelineBindPoint bind_point,
                              uint32_t constant_bytes) {
  VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT, 0, constant_bytes};
  VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = uint32_t(sets.size());
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = constant_bytes > 0;
  info.pPushConstantRanges = &constants;
  const Dispatch& vk = device.vk();
  Pipeline result;
  result.device_ = &device;
  result.bind_point_ = bind_point;
  result.layout_ = create(device, VK_OBJECT_TYPE_PIPELINE_LAYOUT, vk.CreatePipelineLayout, vk.DestroyPipelineLayout,
                          info, "pipeline layout", name);
  return result;
}

void Pipeline::own(VkResult result, VkPipeline pipeline, const std::string& name) {
  check(result, fmt::format("creating the pipeline of pass '{}'", name));
  pipeline_ = {device_->handle(), pipeline, device_->vk().DestroyPipeline};
  device_->setName(VK_OBJECT_TYPE_PIPELINE, uint64_t(pipeline), name);
}

Pipeline Pipeline::compute(const Device& device, const std::string& name, const Spirv& code,
                           const std::vector<VkDescriptorSetLayout>& sets) {
  Pipeline result = withLayout(device, name, sets, VK_PIPELINE_BIND_POINT_COMPUTE);
  Owned<VkShaderModule> module = makeModule(device, name, code);
  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = stageInfo(VK_SHADER_STAGE_COMPUTE_BIT, module.get());
  info.layout = result.layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkResult made = device.vk().CreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  result.own(made, pipeline, name);
  return result;
}

Pipeline Pipeline::raster(const Device& device, const std::string& name, const RasterShaders& shaders,
                          const std::vector<VkDescriptorSetLayout>& sets) {
  Pipeline result = withLayout(device, name, sets, VK_PIPELINE_BIND_POINT_GRAPHICS, shaders.constant_bytes);
  Owned<VkShaderModule> vertex = makeModule(device, name + ".vert", shaders.vertex);
  Owned<VkShaderModule> fragment = makeModule(device, name + ".frag", shaders.fragment);
  VkPipelineShaderStageCreateInfo stages[] = {stageInfo(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                                              stageInfo(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get())};
  VkVertexInputBindingDescription vertices{0, shaders.vertex_stride, VK_VERTEX_INPUT_RATE_VERTEX};
  VkPipelineVertexInputStateCreateInfo vertex_input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  vertex_input.vertexBindingDescriptionCount = shaders.vertex_stride > 0;
  vertex_input.pVertexBindingDescriptions = &vertices;
  vertex_input.vertexAttributeDescriptionCount = uint32_t(shaders.attributes.size());
  vertex_input.pVertexAttributeDescriptions = shaders.attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  viewport.viewportCount = viewport.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo rasterization{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  rasterization.cullMode = VK_CULL_MODE_NONE;
  rasterization.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo multisample{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
  VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  depth.depthTestEnable = depth.depthWriteEnable = !shaders.overlay;
  depth.depthCompareOp = VK_COMPARE_OP_GREATER;  // reversed depth; the first of equal depths stays
  VkPipelineColorBlendAttachmentState by_alpha{};
  by_alpha.blendEnable = shaders.overlay;
  by_alpha.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
  by_alpha.dstColorBlendFactor = by_alpha.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
  by_alpha.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  by_alpha.colorWriteMask = 0xf;
  std::vector<VkPipelineColorBlendAttachmentState> attachments(shaders.color_formats.size(), by_alpha);
  VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  blend.attachmentCount = uint32_t(attachments.size());
  blend.pAttachments = attachments.data();
  VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
  VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  dynamic.dynamicStateCount = 2;
  dynamic.pDynamicStates = dynamic_states;
  VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = uint32_t(shaders.color_formats.size());
  rendering.pColorAttachmentFormats = shaders.color_formats.data();
  rendering.depthAttachmentFormat = shaders.overlay ? VK_FORMAT_UNDEFINED : VK_FORMAT_D32_SFLOAT;

  VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
  info.stageCount = 2;
  info.pStages = stages;
  info.pVertexInputState = &vertex_input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &viewport;
  info.pRasterizationState = &rasterization;
  info.pMultisampleState = &multisample;
  info.pDepthStencilState = &depth;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = result.layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkResult made = device.vk().CreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline);
  result.own(made, pipeline, name);
  return result;
}

static VkRayTracingShaderGroupCreateInfoKHR generalGroup(uint32_t stage) {
  VkRayTracingShaderGroupCreateInfoKHR group{VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR};
  group.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_GENERAL_KHR;
  group.generalShader = stage;
  group.closestHitShader = group.anyHitShader = group.intersectionShader = VK_SHADER_UNUSED_KHR;
  return group;
}

Pipeline Pipeline::trace(const Device& device, const std::string& name, const TraceShaders& shaders,
                         const std::vector<VkDescriptorSetLayout>& sets) {
  Pipeline result = withLayout(device, name, sets, VK_PIPELINE_BIND_POINT_RAY_TRACING_KHR);
  Owned<VkShaderModule> modules[] = {
      makeModule(device, name + ".rgen", shaders.raygen), makeModule(device, name + ".rmiss", shaders.miss),
      makeModule(device, name + ".rchit", shaders.closest_hit), makeModule(device, name + ".rahit", shaders.any_hit)};
  VkPipelineShaderStageCreateInfo stages[] = {stageInfo(VK_SHADER_STAGE_RAYGEN_BIT_KHR, modules[0].get()),
                                              stageInfo(VK_SHADER_STAGE_MISS_BIT_KHR, modules[1].get()),
                                              stageInfo(VK_SHADER_STAGE_CLOSEST_HIT_BIT_KHR, modules[2].get()),
                                              stageInfo(VK_SHADER_STAGE_ANY_HIT_BIT_KHR, modules[3].get())};
  VkRayTracingShaderGroupCreateInfoKHR hit{VK_STRUCTURE_TYPE_RAY_TRACING_SHADER_GROUP_CREATE_INFO_KHR};
  hit.type = VK_RAY_TRACING_SHADER_GROUP_TYPE_TRIANGLES_HIT_GROUP_KHR;
  hit.generalShader = hit.intersectionShader = VK_SHADER_UNUSED_KHR;
  hit.closestHitShader = 2;
  hit.anyHitShader = 3;
  VkRayTracingShaderGroupCreateInfoKHR groups[] = {generalGroup(0), generalGroup(1), hit};

  VkRayTracingPipelineCreateInfoKHR info{VK_STRUCTURE_TYPE_RAY_TRACING_PIPELINE_CREATE_INFO_KHR};
  info.stageCount = 4;
  info.pStages = stages;
  info.groupCount = 3;
  info.pGroups = groups;
  info.maxPipelineRayRecursionDepth = 1;
  info.layout = result.layout();
  VkPipeline pipeline = VK_NULL_HANDLE;
  VkResult made = device.vk().CreateRayTracingPipelinesKHR(device.handle(), VK_NULL_HANDLE, VK_NULL_HANDLE, 1, &info,
                                                           nullptr, &pipeline);
  result.own(made, pipeline, name);
  result.makeBindingTable(device, name);
  return result;
}

void Pipeline::makeBindingTable(const Device& device, const std::string& name) {
  const auto& properties = device.rayProperties();
  uint32_t handle_size = properties.shaderGroupHandleSize;
  uint32_t region = std::max(properties.shaderGroupBaseAlignment, handle_size);
  std::vector<uint8_t> handles(3 * handle_size);
  check(device.vk().GetRayTracingShaderGroupHandlesKHR(device.handle(), handle(), 0, 3, handles.size(), handles.data()),
        "reading the shader groups of " + name);
  binding_table_ = Buffer(device, name + ".binding_table", 4 * region,
                          VK_BUFFER_USAGE_SHADER_BINDING_TABLE_BIT_KHR | VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT,
                          Buffer::Memory::Host);
  VkDeviceAddress base = (binding_table_.address() + region - 1) / region * region;
  size_t shift = base - binding_table_.address();
  for (uint32_t i = 0; i < 3; ++i)
    std::memcpy(static_cast<uint8_t*>(binding_table_.mapped()) + shift + i * region, &handles[i * handle_size],
                handle_size);
  raygen_ = {base, region, region};
  miss_ = {base + region, region, region};
  hit_ = {base + 2 * region, region, region};
}

void Pipeline::recordTrace(VkCommandBuffer commands, uint32_t width, uint32_t height) const {
  device_->vk().CmdTraceRaysKHR(commands, &raygen_, &miss_, &hit_, &callable_, width, height, 1);
}

std::vector<uint64_t> ticksSinceFirst(const std::vector<uint64_t>& stamps, uint32_t bits) {
  const uint64_t mask = bits < 64 ? (uint64_t{1} << bits) - 1 : UINT64_MAX;
  std::vector<uint64_t> ticks(stamps.size());
  for (size_t i = 1; i < stamps.size(); ++i) ticks[i] = ticks[i - 1] + ((stamps[i] - stamps[i - 1]) & mask);
  return ticks;
}

Timer::Timer(const Device& device, uint32_t capacity)
    : device_(&device), capacity_(device.stampFormat().bits > 0 ? capacity : 0) {
  if (capacity_ == 0) return;
  VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = capacity_;
  const Dispatch& vk = device.vk();
  pool_ = create(device, VK_OBJECT_TYPE_QUERY_POOL, vk.CreateQueryPool, vk.DestroyQueryPool, info, "the", "timer");
}

void Timer::recordReset(VkCommandBuffer commands) {
  used_ = 0;
  if (capacity_ > 0) device_->vk().CmdResetQueryPool(commands, pool_.get(), 0, capacity_);
}

int Timer::recordStamp(VkCommandBuffer commands) {
  if (used_ == capacity_) return -1;
  device_->vk().CmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_.get(), used_);
  return int(used_++);
}

std::vector<double> Timer::readMs() const {
  if (used_ == 0) return {};
  std::vector<uint64_t> stamps(used_);
  check(device_->vk().GetQueryPoolResults(device_->handle(), pool_.get(), 0, used_, stamps.size() * 8, stamps.data(), 8,
                                          VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading the timer");
  std::vector<double> ms;
  for (uint64_t ticks : ticksSinceFirst(stamps, device_->stampFormat().bits))
    ms.push_back(double(ticks) * device_->stampFormat().tick_ns * 1e-6);
  return ms;
}

}  // namespace strobe::gpu
