// SPDX-License-Identifier: MIT
#include "gpu/renderdoc.h"

#include <dlfcn.h>

#include <filesystem>

#include "base/temporary_file.h"

namespace strobe::gpu {

// Table of functions of the API, version 1.1.2. Unused functions are placeholders, so that the others have their place
// in the table (https://renderdoc.org/docs/in_application_api.html).
struct RenderDocApi {
  void* unused_0_to_10[11];
  void (*set_file_template)(const char* beginning);
  void* unused_12;
  uint32_t (*capture_count)();
  uint32_t (*capture_at)(uint32_t index, char* file, uint32_t* length, uint64_t* time);
  void* unused_15_to_18[4];
  void (*start_capture)(void* device, void* window);
  void* unused_20;
  uint32_t (*end_capture)(void* device, void* window);
};

namespace {

constexpr int kApiVersion = 10102;  // 1.1.2
const char* const kLibrary = "librenderdoc.so";

// File of the newest capture; "": no capture.
std::string newestFile(const RenderDocApi& api) {
  uint32_t length = 0;
  const uint32_t count = api.capture_count();
  if (count == 0 || !api.capture_at(count - 1, nullptr, &length, nullptr)) return "";
  std::string file(length, '\0');  // `length` includes the null at the end
  api.capture_at(count - 1, file.data(), &length, nullptr);
  return file.c_str();
}

}  // namespace

bool RenderDoc::isLoaded() {
  void* library = ::dlopen(kLibrary, RTLD_NOW | RTLD_NOLOAD);
  if (library) ::dlclose(library);
  return library != nullptr;
}

// The library activates its Vulkan layer when it is loaded.
RenderDoc::RenderDoc() {
  void* library = ::dlopen(kLibrary, RTLD_NOW);
  using GetApi = int (*)(int version, void** api);
  auto get = library ? reinterpret_cast<GetApi>(::dlsym(library, "RENDERDOC_GetAPI")) : nullptr;
  void* api = nullptr;
  if (!get || !get(kApiVersion, &api))
    throw Error(
        "--renderdoc: RenderDoc is not loaded: install it (Debian: librenderdoc), start this command by 'renderdoccmd "
        "capture', or name its librenderdoc.so in LD_PRELOAD and set ENABLE_VULKAN_RENDERDOC_CAPTURE=1",
        {}, 2);
  api_ = static_cast<const RenderDocApi*>(api);
}

void RenderDoc::capture(const Path& file, const std::function<void()>& work) const {
  TemporaryFile written(file);
  api_->set_file_template(written.path().c_str());
  api_->start_capture(nullptr, nullptr);
  work();
  const bool is_captured = api_->end_capture(nullptr, nullptr) != 0;
  const std::string captured = is_captured ? newestFile(*api_) : "";
  if (captured.empty())
    throw Error(
        "--renderdoc: RenderDoc captured nothing, because it is not a layer of the Vulkan device: register its layer "
        "(renderdoccmd vulkanlayer --explain)");
  std::filesystem::rename(captured, written.path());
  written.keep();
}

}  // namespace strobe::gpu
