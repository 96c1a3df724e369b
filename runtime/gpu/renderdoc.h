// SPDX-License-Identifier: MIT
// Captures of Vulkan commands with RenderDoc, by its in-application API. The build needs no file of RenderDoc.
#pragma once

#include <functional>

#include "base/files.h"

namespace strobe::gpu {

struct RenderDocApi;

// RenderDoc in this process. The constructor loads its library; without RenderDoc a process pays nothing.
class RenderDoc {
 public:
  // Must run before a device is created, because RenderDoc becomes a layer of the Vulkan instance. Throws `Error` if
  // the library is missing.
  RenderDoc();

  // Runs `work` and writes its Vulkan commands to `file` (.rdc). Throws `Error` if RenderDoc is not a layer of the
  // device.
  void capture(const Path& file, const std::function<void()>& work) const;

  // True if the library is loaded, by this class or by the start of the process (`renderdoccmd capture`).
  static bool isLoaded();

 private:
  const RenderDocApi* api_ = nullptr;
};

}  // namespace strobe::gpu
