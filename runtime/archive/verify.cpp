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

Json verify(const Home& home, const Manifest& manifest, const std::string& device, bool validation,
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
  Json verification = differencesOf(manifest, again.manifest, pictures);
  const bool same_device = verification["device"].empty();
  const double most_flip = capture.value("most_flip", 0.0);
  verification["holds"] = identical(verification) || (!same_device && within(verification, most_flip));
  verification["same_device"] = same_device;
  verification["most_flip"] = most_flip;
  return verification;
}

std::string verdictOf(const Json& verification) {
  if (identical(verification)) return "identical: every output of every pass, every layer, every figure\n";
  if (verification.at("same_device").get<bool>()) return "not identical\n";
  return fmt::format("another device: {} the mean FLIP of {:g} that the capture allows\n",
                     verification.at("holds").get<bool>() ? "within" : "beyond",
                     verification.at("most_flip").get<double>());
}

}  // namespace strobe::archive
