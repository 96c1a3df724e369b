// SPDX-License-Identifier: MIT
#include "archive/verify.h"

#include <unistd.h>

#include <filesystem>

#include "archive/capture_run.h"
#include "base/hash.h"

namespace strobe::archive {

namespace fs = std::filesystem;

namespace {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(fs::temp_directory_path() / fmt::format("strobe_verify_{}", ::getpid())) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const Path& path() const { return path_; }

 private:
  Path path_;
};

// Throws `Error` if an input in a bundle is missing or was altered.
void checkBundle(const Manifest& manifest) {
  std::vector<std::string> problems;
  for (const auto& [name, input] : inputsFrom(manifest.json.at("inputs"))) {
    Path copy = manifest.folder / inputCopy(name);
    if (!fs::is_regular_file(copy)) problems.push_back(Error("is missing in the bundle", {copy.string()}).what());
    else if (sha256(readText(copy)) != input.sha256)
      problems.push_back(Error("was altered: its SHA-256 differs from the manifest", {copy.string()}).what());
  }
  throwIfAny(problems);
}

Home homeOf(const Home& home, const Manifest& manifest) {
  const Path inputs = fs::absolute(manifest.folder) / kInputsFolder;
  std::vector<Path> roots;
  if (fs::is_directory(inputs / "project")) roots.push_back(inputs / "project");
  roots.push_back(inputs / "strobe");
  return Home(home, roots, inputs / "shared");
}

Path scriptOf(const Home& home, const Manifest& manifest, bool bundle) {
  const Json& capture = manifest.json.at("capture");
  const std::string name = capture.at("file").get<std::string>();
  if (bundle) return manifest.folder / inputCopy(name);
  Path file = name.starts_with("capture:") ? manifest.folder / capture.at("from_here").get<std::string>()
                                           : InputNames(home, home, manifest.folder / kManifestFile).pathOf(name);
  if (fs::is_regular_file(file)) return file;
  throw Error(fmt::format("the capture's script '{}' is missing", name), {(manifest.folder / kManifestFile).string()});
}

}  // namespace

Verification verify(const Home& home, const Manifest& manifest, const std::string& device, bool validation,
                    const Path& pictures, const std::function<void(const std::string&)>& report) {
  const Json& capture = manifest.json.at("capture");
  bool bundle = capture.value("bundle", false);
  if (bundle) checkBundle(manifest);
  const Home from = bundle ? homeOf(home, manifest) : home;
  TemporaryFolder folder;
  Order order;
  order.file = scriptOf(from, manifest, bundle).string();
  order.folder = folder.path();
  order.only = capture.value("only", "");
  order.size = capture.at("size").get<std::array<int, 2>>();
  order.bundle = bundle, order.device = device, order.validation = validation;
  Captured again = runCapture(from, order, report);
  Verification verdict;
  verdict.differences = differencesOf(manifest, again.manifest, pictures);
  verdict.same_device = verdict.differences.sameDevice();
  verdict.most_flip = capture.value("most_flip", 0.0);
  verdict.holds =
      verdict.differences.identical() || (!verdict.same_device && verdict.differences.within(verdict.most_flip));
  return verdict;
}

std::string textOf(const Verification& verdict) {
  std::string text = textOf(verdict.differences);
  if (verdict.differences.identical())
    return text + "identical: every output of every pass, every layer, every figure\n";
  if (verdict.same_device) return text + "not identical\n";
  return text + fmt::format("another device: {} the mean FLIP of {:g} that the capture allows\n",
                            verdict.holds ? "within" : "beyond", verdict.most_flip);
}

}  // namespace strobe::archive
