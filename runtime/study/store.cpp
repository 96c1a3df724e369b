// SPDX-License-Identifier: MIT
#include "study/store.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "base/hash.h"
#include "base/interruption.h"
#include "base/leftovers.h"
#include "base/log.h"
#include "base/sealed_json.h"
#include "image/exr.h"
#include "lab/capture.h"
#include "lab/record.h"
#include "study/worker.h"

namespace strobe::study {

namespace fs = std::filesystem;

namespace {

constexpr int kVersion = 1;
constexpr double kPoll_s = 0.2;  // between looks at the claim of another program

// ---- truth as a file: a part for each output, the color first (docs/exr.md)

// Hash of the text fields of a truth's file. The record has the hashes of the images.
std::string sumOf(const image::ExrFile& file) {
  std::string texts;
  for (const char* name : {"key", "strobe"}) texts += file.texts.at(name) + "|";
  return hashText(texts);
}

std::string encoded(const std::string& key, const lab::Picture& picture) {
  image::ExrFile file = lab::exrOf(picture, {.multipart = true});
  file.texts["key"] = key;
  file.texts["sum"] = sumOf(file);
  return image::encodeExr(file);
}

// Null if the file is damaged or has another truth.
std::shared_ptr<const lab::Picture> decoded(const std::string& key, const Path& name) {
  try {
    image::ExrFile file = image::readExr(name);
    if (file.texts.at("key") != key || file.texts.at("sum") != sumOf(file)) return nullptr;
    auto picture = std::make_shared<lab::Picture>();
    picture->record = Json::parse(file.texts.at("strobe"));
    picture->warnings = picture->record.at("warnings").get<std::vector<std::string>>();
    picture->frame.outputs = lab::imagesOf(file, name);
    for (const auto& [output, read] : picture->frame.outputs)
      if (picture->record.at("outputs").at(output) != Json(lab::hashOf(read))) return nullptr;
    return picture;
  } catch (const std::exception&) {  // not OpenEXR, or without the fields of a truth
    return nullptr;
  }
}

}  // namespace

// Name of the file with the numbers of a point.
static std::string numbersFile(const std::string& key) { return pointFile("", key, ".json"); }

// Point with this key; empty if its file is damaged or has another point.
static std::optional<Point> pointIn(const PointFiles& files, const std::string& key) {
  const std::string file = numbersFile(key);
  try {
    std::optional<Json> json = unsealed(files.read(file).value_or(""));
    if (!json || json->value("key", "") != key) return std::nullopt;
    Point point = pointFrom(*json, file);
    point.tries = json->value("tries", point.tries);
    point.crops = cropsFrom(json->value("crops", Json::array())), point.attribution = json->value("attribution", "");
    return point;
  } catch (const std::exception&) {  // not JSON of a point, or not readable
  }
  return std::nullopt;
}

// Fills in crops and attribution of a shot from its first truth that is drawn.
static void describeShot(Results& results, const PointGroup& group, const Point& truth,
                         std::set<std::string>& described) {
  if (!truth.isDrawn() || !described.insert(group.shot).second) return;
  for (ShotSummary& shot : results.shots) {
    if (shot.name != group.shot) continue;
    shot.crops = truth.crops;
    if (shot.attribution.empty()) shot.attribution = truth.attribution;
  }
}

std::string keyWithoutDevice(const std::string& key) { return key.substr(0, key.find('_')); }

// Keys of the points in a folder by their content; of several devices, the first by name.
static std::map<std::string, std::string> keysByContent(const PointFiles& files) {
  std::map<std::string, std::string> found;
  for (const std::string& key : files.keys()) found.emplace(keyWithoutDevice(key), key);
  return found;
}

std::vector<Path> takePoints(Results& results, const Path& folder, bool of_any_device) {
  const PointFiles files(folder);
  const auto others = of_any_device ? keysByContent(files) : std::map<std::string, std::string>();
  std::vector<Path> damaged;
  std::set<std::string> described;
  for (PointGroup& group : results.groups)
    for (Point& point : group.points) {
      std::string key = point.key;
      auto other = others.find(keyWithoutDevice(key));
      if (other != others.end() && !files.has(numbersFile(key))) key = other->second;
      if (key.empty() || !files.has(numbersFile(key))) continue;
      std::optional<Point> known = pointIn(files, key);
      if (!known) {
        damaged.push_back(folder / numbersFile(key));
        point.values.clear(), point.failed.clear();  // the point counts as missing
        continue;
      }
      if (known->command.empty()) known->command = point.command;
      if (known->device == results.device && known->driver == results.driver) known->device = known->driver = "";
      known->arm = point.arm, known->role = point.role;
      if (known->role == ArmRole::truth) describeShot(results, group, *known, described);
      point = std::move(*known);
    }
  for (const Path& pack : files.takeDamaged()) damaged.push_back(pack);
  return damaged;
}

Results resultsSoFar(const Path& outline) {
  Results results = resultsIn(outline);
  takePoints(results, outline.parent_path(), true);
  return results;
}

std::optional<std::string> checkedFile(const Point& point, const PointFiles& files, const std::string& name) {
  std::optional<std::string> content = files.read(name);
  auto hash = point.files.find(name);
  if (content && hash != point.files.end() && hashText(*content) != hash->second) return std::nullopt;
  return content;
}

std::vector<Path> alteredFiles(const Results& results, const Path& folder) {
  const PointFiles files(folder);
  std::vector<Path> altered;
  for (const PointGroup& group : results.groups)
    for (const Point& point : group.points)
      for (const auto& [name, hash] : point.files)
        if (files.has(name) && !checkedFile(point, files, name)) altered.push_back(folder / name);
  return altered;
}

Store::Store(const Path& folder) : folder_(folder), files_(folder) {
  std::error_code failed;
  fs::create_directories(workers(), failed);
  if (failed) throw WriteError(fmt::format("cannot be written: {}", failed.message()), {workers().string()});
  removeEndedWorkers(folder_);
  if (isUsed(folder_)) return;
  for (const Path& place : {folder_, workers()}) removeLeftovers(place);
  // A claim of an ended process is taken over, and given back.
  for (const std::string& key : namesIn(workers(), ".lock")) claim(key);
}

// Renames the file, so that it can still be inspected. If several processes find the file, one process renames it.
void Store::discard(const Path& file) const {
  Path kept = file;
  kept += ".damaged";
  std::error_code gone;
  fs::rename(file, kept, gone);
  if (gone) return;
  warn(fmt::format("{}: is damaged and counts as missing; it is made again, and the damaged file is now {}",
                   file.string(), kept.filename().string()));
}

std::unique_ptr<Lease> Store::waitedClaim(const std::string& key) const {
  std::unique_ptr<Lease> lease;
  while (!(lease = claim(key))) waitFor(kPoll_s);
  return lease;
}

// Title and version of experiment.json; empty if the file is damaged. Files of earlier versions have no checksum.
static std::optional<std::pair<std::string, int>> titleAndVersion(const std::string& text) {
  Json whole = Json::parse(text, nullptr, false);
  bool has_sum = !whole.is_object() || whole.contains("sum");
  std::optional<Json> known = has_sum ? unsealed(text) : whole;
  if (!known || !known->contains("title") || !known->contains("version")) return std::nullopt;
  if (!known->at("title").is_string() || !known->at("version").is_number_integer()) return std::nullopt;
  return std::pair(known->at("title").get<std::string>(), known->at("version").get<int>());
}

void Store::belongTo(const std::string& title) const {
  const auto lease = waitedClaim("experiment");
  Path file = folder_ / "experiment.json";
  auto keep = [&] { writeFileAtomically(file, sealed({{"title", title}, {"version", kVersion}})); };
  if (!fs::exists(file)) return keep();
  auto known = titleAndVersion(readText(file));
  if (!known) {
    discard(file);
    return keep();
  }
  const auto& [other, version] = *known;
  if (version != kVersion)
    throw Error("was written by another version of Strobe; use another folder", {file.string()}, 2);
  if (other != title)
    throw Error(fmt::format("has points of another experiment, '{}', not of '{}'; use another folder", other, title),
                {folder_.string()}, 2);
}

// Names of inputs in both lists with different contents.
static std::vector<std::string> unlike(const Inputs& inputs, const Inputs& others) {
  std::vector<std::string> names;
  for (const auto& [name, hash] : inputs)
    if (auto other = others.find(name); other != others.end() && other->second != hash) names.push_back(name);
  return names;
}

void Store::agreeOn(const Inputs& inputs, const std::string& version) const {
  const Path file = folder_ / "experiment.json";
  if (!fs::exists(file)) return;                 // no other program uses the folder
  const auto lease = waitedClaim("experiment");  // programs that start together agree one after another
  Json known = unsealed(readText(file)).value_or(Json::object());
  Inputs before = known.value("inputs", Inputs());
  std::vector<std::string> names = unlike(inputs, before);
  if (known.value("program", lab::programHash()) != lab::programHash()) names.insert(names.begin(), "the program");
  if (!names.empty()) {
    const size_t shown = std::min<size_t>(names.size(), 3);
    std::string changed = fmt::format("{}", fmt::join(names.begin(), names.begin() + long(shown), ", "));
    if (names.size() > shown) changed += fmt::format(" and {} more", names.size() - shown);
    for (const WorkerState& worker : workersIn(folder_))
      if (worker.version != version && worker.isRunning())
        throw Error(fmt::format("process {} works in this folder with another version of {}; use another folder, or "
                                "stop that process",
                                worker.name, changed),
                    {folder_.string()}, 2);
    warn(fmt::format("{}: changed since the last run: {}; points that depend on this are drawn again", folder_.string(),
                     changed));
  }
  Inputs all = inputs;
  all.merge(before);
  if (names.empty() && all == before && known.contains("program")) return;
  known["program"] = lab::programHash(), known["inputs"] = all;
  writeFileAtomically(file, sealed(std::move(known)));
}

// Hash of an outline without the device: equal for programs on different devices.
static std::string hashOfOutline(Results outline) {
  outline.device = outline.driver = "", outline.software = false;
  for (PointGroup& group : outline.groups)
    for (Point& point : group.points) point.key = keyWithoutDevice(point.key);
  return hashText(textOf(outline));
}

void Store::keepOutline(Results results) const {
  if (outline.empty()) return;
  results.command = command;
  const std::string hash = hashOfOutline(results);
  const auto lease = waitedClaim("experiment");
  const Path file = folder_ / "experiment.json";
  Json known = fs::exists(file) ? unsealed(readText(file)).value_or(Json::object()) : Json::object();
  if (fs::exists(outline) && known.value("outline", "") == hash) return;
  writeFileAtomically(outline, textOf(results));
  if (known.empty()) return;
  known["outline"] = hash;
  writeFileAtomically(file, sealed(std::move(known)));
}

std::optional<Point> Store::point(const std::string& key) const {
  const bool has_file = files_.has(numbersFile(key));
  for (const Path& pack : files_.takeDamaged()) discard(pack);
  if (!has_file) return std::nullopt;
  std::optional<Point> point = pointIn(files_, key);
  if (!point) discard(folder_ / numbersFile(key));
  return point;
}

// True if another point has overwritten the pictures of the layout, which are named by arm and values, not by key.
static bool isOfAnother(const Path& folder, const Point& point) {
  if (point.record.empty() || !fs::exists(folder / point.record)) return false;
  Json record = Json::parse(readText(folder / point.record), nullptr, false);
  bool has_color = record.is_object() && record.contains("outputs") && record["outputs"].is_object() &&
                   record["outputs"].contains("color");
  return has_color && record["outputs"]["color"] != point.image;
}

// True for files of a point that are kept on request: KEY.exr, KEY.record.json, KEY.timings.json.
static bool isOnRequest(const std::string& name) { return name.starts_with("points/") && !name.ends_with(".png"); }

bool Store::hasFiles(const Point& point) const {
  if (isOfAnother(folder_, point)) return false;
  bool all = true;
  for (const auto& [name, hash] : point.files) {
    if (isOnRequest(name) && !requires_exr) continue;
    if (checkedFile(point, files_, name)) continue;
    discard(folder_ / name);
    all = false;
  }
  return all;
}

bool Store::has(const std::string& key) const {
  if (had_.count(key)) return true;
  std::optional<Point> kept = point(key);
  bool is_had =
      kept && kept->isDrawn() && hasFiles(*kept) && (!requires_exr || fs::exists(pointFile(folder_, key, ".exr")));
  if (is_had) had_.insert(key);
  return is_had;
}

void Store::keep(const std::string& key, const Point& point) const {
  if (!point.isDrawn()) had_.erase(key);
  Json json = toJson(point);
  json["key"] = key;
  if (!point.tries.empty()) json["tries"] = point.tries;
  if (!point.crops.empty()) json["crops"] = toJson(point.crops);
  if (!point.attribution.empty()) json["attribution"] = point.attribution;
  writeFileAtomically(pointFile(folder_, key, ".json"), sealed(std::move(json)));
}

void Store::finish(const std::string& key) const {
  if (!packs_) return;
  finished_.insert(key);
  if (finished_.size() < PointFiles::kPerPack) return;
  files_.pack(finished_);
  finished_.clear();
}

void Store::packAll(const std::vector<std::string>& keys) const {
  if (!packs_) return;
  const std::unique_ptr<Lease> lease = claim("packs" + files_.share);
  if (!lease) return;
  for (const std::string& key : keys)
    if (fs::exists(pointFile(folder_, key, ".json"))) finish(key);
  files_.pack(finished_);
  finished_.clear();
}

size_t Store::triesOf(const std::string& key) const { return point(key).value_or(Point()).tries.size(); }

std::shared_ptr<const lab::Picture> Store::truth(
    const std::string& key, const std::function<std::shared_ptr<const lab::Picture>()>& draw) const {
  const Path file = folder_ / "truth" / (key + ".exr");
  auto kept = [&] { return fs::exists(file) ? decoded(key, file) : nullptr; };
  std::shared_ptr<const lab::Picture> picture = kept();
  std::unique_ptr<Lease> lease;
  while (!picture && !(lease = claim(key))) waitFor(kPoll_s), picture = kept();
  if (!picture) picture = kept();  // written between the look and the claim
  if (picture) return picture;
  discard(file);
  writeFileAtomically(file, encoded(key, *draw()));
  picture = decoded(key, file);
  if (!picture) throw Error("cannot be read back as it was written", {file.string()});
  return picture;
}

}  // namespace strobe::study
