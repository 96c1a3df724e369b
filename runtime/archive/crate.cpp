// SPDX-License-Identifier: MIT
#include "archive/crate.h"

#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <utility>

#include "archive/capture_run.h"
#include "base/extension.h"

namespace strobe::archive {

namespace {

constexpr const char* kSpecification = "https://w3id.org/ro/crate/1.1";
constexpr const char* kProfile = "https://w3id.org/ro/wfrun/process/0.5";
// The context of RO-Crate 1.1 has no term for SHA-256.
constexpr const char* kSha256Term = "https://w3id.org/ro/terms/workflow-run#sha256";
constexpr const char* kMit = "https://spdx.org/licenses/MIT";

constexpr std::array<std::pair<const char*, const char*>, 16> kFormats = {{{".png", "image/png"},
                                                                           {".jpg", "image/jpeg"},
                                                                           {".jpeg", "image/jpeg"},
                                                                           {".exr", "image/x-exr"},
                                                                           {".hdr", "image/vnd.radiance"},
                                                                           {".pdf", "application/pdf"},
                                                                           {".mp4", "video/mp4"},
                                                                           {".mkv", "video/x-matroska"},
                                                                           {".json", "application/json"},
                                                                           {".gltf", "model/gltf+json"},
                                                                           {".glb", "model/gltf-binary"},
                                                                           {".lua", "text/x-lua"},
                                                                           {".glsl", "text/plain"},
                                                                           {".h", "text/plain"},
                                                                           {".txt", "text/plain"},
                                                                           {".ttf", "font/ttf"}}};

std::string formatOf(const std::string& name) {
  for (const auto& [ending, format] : kFormats)
    if (hasExtension(name, ending)) return format;
  return "application/octet-stream";
}

// Path as a relative URI. Letters beyond ASCII stay (RO-Crate 1.1, "Encoding file paths").
std::string uriOf(const std::string& path) {
  std::string uri;
  for (char c : path) {
    bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    bool stays = letter || (c & 0x80) || std::string_view("-._~/!$&'()*+,;=@").find(c) != std::string_view::npos;
    uri += stays ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

Json link(const std::string& id) { return {{"@id", id}}; }

Json linkTo(const Json& entity) { return link(entity.at("@id").get<std::string>()); }

// `entry`: { sha256, bytes }.
Json fileOf(const std::string& name, const Json& entry) {
  return {{"@id", uriOf(name)},
          {"@type", "File"},
          {"name", name},
          {"encodingFormat", formatOf(name)},
          {"contentSize", std::to_string(entry.at("bytes").get<uint64_t>())},
          {"sha256", entry.at("sha256")}};
}

std::string versionOf(const Json& program) {
  std::string version = program.at("version").get<std::string>();
  if (program.contains("revision")) version += fmt::format("+{}", program.at("revision").get<std::string>());
  return version + (program.value("modified", false) ? ".modified" : "");
}

std::string commandOf(const Json& capture) {
  const auto size = capture.at("size").get<std::array<int, 2>>();
  std::string command =
      fmt::format("strobe capture {} --size {}x{}", capture.at("file").get<std::string>(), size[0], size[1]);
  if (capture.contains("only")) command += " --only " + capture.at("only").get<std::string>();
  return command + (capture.value("bundle", false) ? " --bundle" : "");
}

// Author and licence of a scene, from its file or from the text beside it.
Json sceneOf(const std::string& id, const std::string& shot, const Json& attribution) {
  auto text = [](const Json& json, const char* name) {
    return json.is_object() && json.contains(name) && json[name].is_string() ? json[name].get<std::string>() : "";
  };
  const Json extras = attribution.value("extras", Json::object());
  std::string title = text(extras, "title"), copyright = text(attribution, "copyright"),
              beside = text(attribution, "text");
  Json scene = {{"@id", id},
                {"@type", "CreativeWork"},
                {"name", title.empty() ? fmt::format("Scene of the shot '{}'", shot) : title}};
  std::string description = copyright + (copyright.empty() || beside.empty() ? "" : "\n") + beside;
  if (!description.empty()) scene["description"] = description;
  for (const char* field : {"author", "license"})
    if (std::string said = text(extras, field); !said.empty()) scene[field] = said;
  if (std::string source = text(extras, "source"); !source.empty()) scene["url"] = source;
  return scene;
}

class Crate {
 public:
  Crate(const Manifest& manifest, const std::set<std::string>& names) : manifest_(manifest.json) {
    Json itself = fileOf(kManifestFile, fileEntry(manifest.folder / kManifestFile));
    itself["description"] = "All inputs of the pictures, and the hash of the output of every pass";
    addPart(itself, results_);
    addPictures();
    addInputs(names);
    Json sums = {{"@id", kSumsFile},
                 {"@type", "File"},
                 {"name", kSumsFile},
                 {"description", "SHA-256 of the files of this folder, for sha256sum -c"},
                 {"encodingFormat", "text/plain"}};
    parts_.push_back(linkTo(sums));
    entities_.push_back(std::move(sums));
  }

  Json json(const std::string& date) const {
    Json graph = {descriptor(), root(date), profile(), action(), program(), mit(), licences()};
    for (const auto* list : {&entities_, &scenes_})
      for (const Json& entity : *list) graph.push_back(entity);
    return {{"@context", {std::string(kSpecification) + "/context", {{"sha256", kSha256Term}}}},
            {"@graph", std::move(graph)}};
  }

 private:
  void addPart(Json entity, Json& role) {
    parts_.push_back(linkTo(entity));
    role.push_back(linkTo(entity));
    entities_.push_back(std::move(entity));
  }

  // Adds pictures, figures and films. A picture links to its scene if the scene has an attribution.
  void addPictures() {
    std::map<std::string, std::string> based_on;  // by file name: @id of the scene
    std::map<std::string, std::string> known;     // by attribution: @id of the scene
    for (const Json& picture : manifest_.at("pictures")) {
      const Json scene = picture.at("record").value("scene", Json::object());
      const Json attribution = scene.value("attribution", Json::object());
      if (attribution.empty()) continue;
      auto [place, is_new] = known.emplace(attribution.dump(), fmt::format("#scene-{}", known.size() + 1));
      if (is_new) scenes_.push_back(sceneOf(place->second, picture.at("shot").get<std::string>(), attribution));
      for (const auto& [kind, file] : picture.at("images").items()) based_on[file.get<std::string>()] = place->second;
    }
    for (const auto& [name, entry] : manifest_.at("files").items()) {
      Json file = fileOf(name, entry);
      if (based_on.count(name)) file["isBasedOn"] = link(based_on[name]);
      addPart(std::move(file), results_);
    }
  }

  // A file that is not in the crate must not have the type File.
  void addInputs(const std::set<std::string>& names) {
    for (const Json& input : manifest_.at("inputs")) {
      const std::string name = input.at("name").get<std::string>(), copy = inputCopy(name).generic_string();
      Json entity = fileOf(copy, input);
      entity["name"] = name;
      if (name == manifest_.at("capture").at("file")) entity["description"] = "The script of the capture";
      if (names.count(copy)) {
        addPart(std::move(entity), objects_);
        continue;
      }
      entity["@id"] = fmt::format("#{}", uriOf(copy));
      entity["@type"] = "CreativeWork";
      entity["description"] = "Input that is not in this folder; a capture with --bundle includes it";
      objects_.push_back(linkTo(entity));
      entities_.push_back(std::move(entity));
    }
  }

  Json descriptor() const {
    return {
        {"@id", kCrateFile}, {"@type", "CreativeWork"}, {"conformsTo", link(kSpecification)}, {"about", link("./")}};
  }

  Json root(const std::string& date) const {
    const Json& capture = manifest_.at("capture");
    std::string note = capture.value("note", "");
    return {{"@id", "./"},
            {"@type", "Dataset"},
            {"name", capture.at("title")},
            {"description", note + (note.empty() ? "" : " ") +
                                "A capture of Strobe: pictures, and figures made from the pictures. With "
                                "manifest.json, the capture can be taken again and compared bit for bit."},
            {"datePublished", date},
            {"license", link("#licences")},
            {"conformsTo", link(kProfile)},
            {"hasPart", parts_},
            {"mentions", link("#capture")}};
  }

  Json profile() const {
    return {{"@id", kProfile}, {"@type", "CreativeWork"}, {"name", "Process Run Crate"}, {"version", "0.5"}};
  }

  Json action() const {
    const Json& device = manifest_.at("device");
    return {{"@id", "#capture"},
            {"@type", "CreateAction"},
            {"name", "Taking the capture: " + manifest_.at("capture").at("title").get<std::string>()},
            {"description", fmt::format("{}\nDrawn by {}, {}", commandOf(manifest_.at("capture")),
                                        device.at("name").get<std::string>(), device.at("driver").get<std::string>())},
            {"instrument", link("#strobe")},
            {"object", objects_},
            {"result", results_}};
  }

  Json program() const {
    return {{"@id", "#strobe"},
            {"@type", "SoftwareApplication"},
            {"name", "Strobe"},
            {"description", "Research sandbox for motion blur"},
            {"softwareVersion", versionOf(manifest_.at("program"))},
            {"license", link(kMit)}};
  }

  static Json mit() {
    return {{"@id", kMit},
            {"@type", "CreativeWork"},
            {"name", "MIT License"},
            {"description", "A permissive licence: copies keep the copyright and the licence's text"}};
  }

  static Json licences() {
    return {{"@id", "#licences"},
            {"@type", "CreativeWork"},
            {"name", "Licences of the parts"},
            {"description",
             "Files of Strobe are under the MIT licence. Scripts, scenes and textures of other authors keep their own "
             "licences. Pictures link to the author and licence of their scene (isBasedOn). A capture grants no "
             "licence for its pictures."}};
  }

  const Json& manifest_;
  Json parts_ = Json::array(), objects_ = Json::array(), results_ = Json::array();
  std::vector<Json> entities_, scenes_;
};

}  // namespace

std::string crateDate(const Home& home) {
  constexpr int64_t kYear10000 = 253402300800;
  int64_t seconds = 0;
  if (const char* given = std::getenv("SOURCE_DATE_EPOCH")) {
    const std::string_view text = given;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (error != std::errc() || end != text.data() + text.size() || seconds < 0 || seconds >= kYear10000)
      throw Error(fmt::format("SOURCE_DATE_EPOCH is not a number of seconds since 1970: '{}'", text));
  } else {
    seconds = revisionTime(home).value_or(0);
  }
  const std::chrono::sys_seconds time{std::chrono::seconds(seconds)};
  const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(time)};
  return fmt::format("{:04}-{:02}-{:02}", int(day.year()), unsigned(day.month()), unsigned(day.day()));
}

Json crateOf(const Manifest& manifest, const std::set<std::string>& names, const std::string& date) {
  return Crate(manifest, names).json(date);
}

}  // namespace strobe::archive
