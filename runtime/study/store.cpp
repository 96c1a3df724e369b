// SPDX-License-Identifier: MIT
#include "study/store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

#include "base/hash.h"
#include "base/leftovers.h"
#include "image/exr.h"
#include "lab/capture.h"

namespace strobe::study {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;

// Processes of a sweep that was just interrupted hold its lock until the system has ended them.
constexpr int kTries = 100;  // 20 ms apart

// A lock held until the file is closed; -1: another process holds it.
int locked(const Path& file, bool waits) {
  fs::create_directories(file.parent_path());
  int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw Error(fmt::format("cannot be opened: {}", std::strerror(errno)), {file.string()});
  for (int tries = 0; ::flock(descriptor, LOCK_EX | (waits ? 0 : LOCK_NB)) != 0; ++tries) {
    if (errno == EINTR) continue;
    if (errno == EWOULDBLOCK && tries < kTries) {
      ::usleep(20000);
      continue;
    }
    ::close(descriptor);
    return -1;
  }
  return descriptor;
}

// Locks of truths that a killed process was drawing.
void removeLocks(const Path& folder) {
  for (const std::string& key : namesIn(folder, ".lock")) fs::remove(folder / (key + ".lock"));
}

// ---- truth as a file: outputs as large as the color, each a layer with channels "NAME.0", "NAME.1", ...

std::vector<std::string> numbered(int channels) {
  std::vector<std::string> names;
  for (int c = 0; c < channels; ++c) names.push_back(std::to_string(c));
  return names;
}

std::string encoded(const lab::Picture& picture) {
  image::ExrFile file;
  const image::Image& color = picture.frame.outputs.at("color").floats;
  Json formats = Json::object();
  for (const auto& [name, read] : picture.frame.outputs) {
    bool whole = read.uints.width == color.width && read.uints.height == color.height;
    if (whole) file.add(name, numbered(read.uints.channels), read.uints);
    bool real = read.floats.width == color.width && read.floats.height == color.height;
    if (real) file.add(name, numbered(read.floats.channels), read.floats);
    if (whole || real) formats[name] = {read.format, whole ? read.uints.channels : read.floats.channels, whole};
  }
  file.texts["outputs"] = formats.dump();
  file.texts["record"] = picture.record.dump();
  file.texts["warnings"] = Json(picture.warnings).dump();
  return image::encodeExr(file);
}

std::shared_ptr<const lab::Picture> decoded(const Path& name) {
  image::ExrFile file = image::readExr(name);
  auto picture = std::make_shared<lab::Picture>();
  picture->record = Json::parse(file.texts.at("record"));
  picture->warnings = Json::parse(file.texts.at("warnings")).get<std::vector<std::string>>();
  Json outputs = Json::parse(file.texts.at("outputs"));
  for (const auto& [output, form] : outputs.items()) {
    std::vector<std::string> channels = numbered(form.at(1));
    for (std::string& channel : channels) channel = output + "." + channel;
    graph::ReadImage& read = picture->frame.outputs[output];
    read.format = form.at(0);
    if (form.at(2).get<bool>()) read.uints = image::idsOf(file, channels, name);
    else read.floats = image::channelsOf(file, channels, name);
  }
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
  removeLeftovers(folder_);
  removeLocks(folder_ / "truth");
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
