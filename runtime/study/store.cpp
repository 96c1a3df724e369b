// SPDX-License-Identifier: MIT
#include "study/store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "base/hash.h"
#include "image/exr.h"
#include "lab/capture.h"

namespace strobe::study {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;

// A lock held until the file is closed; -1: another process holds it.
int locked(const Path& file, bool waits) {
  fs::create_directories(file.parent_path());
  int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw Error(fmt::format("cannot be opened: {}", std::strerror(errno)), {file.string()});
  while (::flock(descriptor, LOCK_EX | (waits ? 0 : LOCK_NB)) != 0) {
    if (errno == EINTR) continue;
    ::close(descriptor);
    return -1;
  }
  return descriptor;
}

// What a process left that was killed.
void removeUnfinished(const Path& folder) {
  if (!fs::exists(folder)) return;
  std::vector<Path> unfinished;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".part" || entry.path().extension() == ".lock") unfinished.push_back(entry.path());
  for (const Path& file : unfinished) fs::remove(file);
}

// ---- truth as a file: a part for each output, the color first (docs/exr.md)

std::string encoded(const lab::Picture& picture) {
  image::ExrFile file = lab::exrOf(picture, {.multipart = true});
  file.texts["warnings"] = Json(picture.warnings).dump();
  return image::encodeExr(file);
}

std::shared_ptr<const lab::Picture> decoded(const Path& name) {
  image::ExrFile file = image::readExr(name);
  auto picture = std::make_shared<lab::Picture>();
  picture->record = Json::parse(file.texts.at("strobe"));
  picture->warnings = Json::parse(file.texts.at("warnings")).get<std::vector<std::string>>();
  picture->frame.outputs = lab::imagesOf(file, name);
  return picture;
}

}  // namespace

Path pointFile(const Path& folder, const std::string& key, const std::string& ending) {
  return folder / "points" / (key + ending);
}

static std::optional<Point> pointIn(const Path& folder, const std::string& key) {
  Path file = pointFile(folder, key, ".json");
  if (!fs::exists(file)) return std::nullopt;
  return pointFrom(Json::parse(readText(file), nullptr, false), file.string());
}

void takePoints(Results& results, const Path& folder) {
  for (PointGroup& group : results.groups)
    for (Point& point : group.points) {
      std::optional<Point> known = point.key.empty() ? std::nullopt : pointIn(folder, point.key);
      if (!known) continue;
      if (known->command.empty()) known->command = point.command;
      known->key = point.key, known->arm = point.arm, known->role = point.role;
      point = std::move(*known);
    }
}

Store::Store(const Path& folder) : folder_(folder), lock_(locked(folder / ".lock", false)) {
  if (lock_ < 0) throw Error("another sweep is at work in this folder", {folder_.string()}, 2);
  for (const char* part : {"points", "truth"}) removeUnfinished(folder_ / part);
}

Store::~Store() { ::close(lock_); }

void Store::belongTo(const std::string& title) const {
  Path file = folder_ / "experiment.json";
  if (!fs::exists(file))
    return writeFileAtomically(file, Json({{"title", title}, {"version", kVersion}}).dump(1) + "\n");
  Json known = Json::parse(readText(file), nullptr, false);
  if (!known.is_object() || known.value("version", 0) != kVersion)
    throw Error("is not of this version of Strobe; take another folder", {file.string()}, 2);
  if (known.value("title", "") != title)
    throw Error(fmt::format("has points of another experiment, '{}', not of '{}'; take another folder",
                            known.value("title", ""), title),
                {folder_.string()}, 2);
}

std::optional<Point> Store::point(const std::string& key) const { return pointIn(folder_, key); }

// Pictures have the names of their arms, so that those of other values may lie there by now.
static bool hasPictures(const Path& folder, const Point& point) {
  if (point.picture.empty()) return true;
  for (const std::string& name : {point.measured, point.shown, point.picture, point.record})
    if (!fs::exists(folder / name)) return false;
  Json record = Json::parse(readText(folder / point.record), nullptr, false);
  return record.is_object() && record["outputs"]["color"] == point.image &&
         hashText(readText(folder / point.picture)) == point.picture_hash;
}

bool Store::has(const std::string& key) const {
  std::optional<Point> kept = point(key);
  return kept && kept->failed.empty() && hasPictures(folder_, *kept) &&
         (!requires_exr || fs::exists(pointFile(folder_, key, ".exr")));
}

void Store::keep(const std::string& key, const Point& point) const {
  writeFileAtomically(pointFile(folder_, key, ".json"), toJson(point).dump(1) + "\n");
}

std::shared_ptr<const lab::Picture> Store::truth(
    const std::string& key, const std::function<std::shared_ptr<const lab::Picture>()>& draw) const {
  Path file = folder_ / "truth" / (key + ".exr");
  if (fs::exists(file)) return decoded(file);
  Path lock = folder_ / "truth" / (key + ".lock");
  int held = locked(lock, true);
  std::shared_ptr<const lab::Picture> picture;
  try {
    if (!fs::exists(file)) writeFileAtomically(file, encoded(*draw()));
    picture = decoded(file);
  } catch (...) {
    ::close(held);
    throw;
  }
  fs::remove(lock);
  ::close(held);
  return picture;
}

}  // namespace strobe::study
