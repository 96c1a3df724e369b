// SPDX-License-Identifier: MIT
#include "gpu/features.h"

#include <algorithm>

namespace strobe::gpu {

static bool has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

VkPhysicalDeviceFeatures2* FeatureChain::chain(const std::vector<std::string>& extensions) {
  void* head = nullptr;
  auto link = [&head](auto& structure) {
    structure.pNext = head;
    head = &structure;
  };
  if (has(extensions, VK_KHR_RAY_QUERY_EXTENSION_NAME)) link(ray_query);
  if (has(extensions, VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME)) link(ray_pipeline);
  if (has(extensions, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME)) link(acceleration);
  link(v13);
  link(v12);
  core.pNext = head;
  return &core;
}

#define CORE(field) [](FeatureChain& f) -> VkBool32& { return f.core.features.field; }
#define IN(part, field) [](FeatureChain& f) -> VkBool32& { return f.part.field; }

const std::vector<WantedFeature>& wantedFeatures() {
  static const std::vector<WantedFeature> table = {
      {"geometryShader", "vertices that triangles share, fetched once", "", false, CORE(geometryShader)},
      {"shaderFloat64", "tracing backend 'bvh' as exact at edges as the others", "", false, CORE(shaderFloat64)},
      {"fragmentStoresAndAtomics", "event counts in raster passes", "", true, CORE(fragmentStoresAndAtomics)},
      {"vertexPipelineStoresAndAtomics", "event counts in raster passes", "", false,
       CORE(vertexPipelineStoresAndAtomics)},
      {"shaderStorageImageExtendedFormats", "two-channel and 16-bit images", "", true,
       CORE(shaderStorageImageExtendedFormats)},
      {"scalarBlockLayout", "structures shared by C++ and GLSL", "", true, IN(v12, scalarBlockLayout)},
      {"bufferDeviceAddress", "structures that rays traverse", "", true, IN(v12, bufferDeviceAddress)},
      {"descriptorIndexing", "textures chosen per pixel", "", true, IN(v12, descriptorIndexing)},
      {"runtimeDescriptorArray", "textures chosen per pixel", "", true, IN(v12, runtimeDescriptorArray)},
      {"shaderSampledImageArrayNonUniformIndexing", "textures chosen per pixel", "", true,
       IN(v12, shaderSampledImageArrayNonUniformIndexing)},
      {"synchronization2", "barriers between passes", "", true, IN(v13, synchronization2)},
      {"dynamicRendering", "raster passes", "", true, IN(v13, dynamicRendering)},
      {"maintenance4", "compute passes in SPIR-V 1.6", "", true, IN(v13, maintenance4)},
      {"accelerationStructure", "tracing backends 'query' and 'pipeline'", VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
       false, IN(acceleration, accelerationStructure)},
      {"rayTracingPipeline", "tracing backend 'pipeline'", VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME, false,
       IN(ray_pipeline, rayTracingPipeline)},
      {"rayQuery", "tracing backend 'query'", VK_KHR_RAY_QUERY_EXTENSION_NAME, false, IN(ray_query, rayQuery)},
  };
  return table;
}

std::vector<const char*> wantedExtensions(const std::vector<std::string>& available) {
  std::vector<const char*> wanted;
  if (!has(available, VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME)) return wanted;
  for (const char* name : {VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME, VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME,
                           VK_KHR_RAY_TRACING_PIPELINE_EXTENSION_NAME, VK_KHR_RAY_QUERY_EXTENSION_NAME})
    if (has(available, name)) wanted.push_back(name);
  return wanted;
}

}  // namespace strobe::gpu
