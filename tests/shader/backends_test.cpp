// SPDX-License-Identifier: MIT
#include "shader/backends.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace strobe::shader {
namespace backends_test {

gpu::DeviceInfo deviceWith(const std::vector<std::string>& features, bool software = false) {
  gpu::DeviceInfo info;
  info.name = "device", info.software = software;
  for (const std::string& name : features) info.features.push_back({name, "", false, true});
  return info;
}

TEST(Backends, AutoUsesRayQueriesExceptOnSoftwareDevices) {
  EXPECT_EQ(chooseBackend(deviceWith({"rayQuery", "rayTracingPipeline"}), "auto"), Backend::Query);
  EXPECT_EQ(chooseBackend(deviceWith({"rayQuery", "rayTracingPipeline"}, true), "auto"), Backend::Bvh);
  EXPECT_EQ(chooseBackend(deviceWith({"rayTracingPipeline"}), "auto"), Backend::Bvh);
  EXPECT_EQ(chooseBackend(deviceWith({}), "auto"), Backend::Bvh);
}

TEST(Backends, NamedBackendIsUsedOrRefused) {
  EXPECT_EQ(chooseBackend(deviceWith({"rayTracingPipeline"}), "pipeline"), Backend::Pipeline);
  EXPECT_THROW(chooseBackend(deviceWith({"rayTracingPipeline"}), "query"), Error);
}

}  // namespace backends_test
}  // namespace strobe::shader
