// SPDX-License-Identifier: MIT
#include "archive/differences.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "archive/capture_run.h"
#include "image/false_colour.h"
#include "image/flip.h"
#include "image/metrics.h"
#include "image/png.h"

namespace strobe::archive {

namespace fs = std::filesystem;

namespace {

// ---- images

// Index of a number in the order of representable numbers: neighbours differ by 1, and 0 and -0 are equal.
int64_t ordinal(float value) {
  int32_t bits = std::bit_cast<int32_t>(value);
  return bits < 0 ? -int64_t(bits & 0x7fffffff) : bits;
}

// JSON has no infinity and no NaN.
Json numberOr(double value) { return std::isfinite(value) ? Json(value) : Json(fmt::format("{}", value)); }

// Calls `visit(x, y, channel, was, is)` for each pair of numbers with different bits.
template <class Pixels, class Visit>
void forDifferences(const Pixels& was, const Pixels& is, const Visit& visit) {
  for (int y = 0; y < was.height; ++y)
    for (int x = 0; x < was.width; ++x)
      for (int c = 0; c < was.channels; ++c)
        if (std::bit_cast<uint32_t>(was.at(x, y, c)) != std::bit_cast<uint32_t>(is.at(x, y, c)))
          visit(x, y, c, was.at(x, y, c), is.at(x, y, c));
}

template <class Pixels, class Ulp>
Json comparedNumbers(const std::string& name, const Pixels& was, const Pixels& is, const Ulp& ulp_of) {
  double largest = 0, sum = 0, largest_ulp = 0, sum_ulp = 0;
  uint64_t pixels = 0;
  int last_x = -1, last_y = -1;
  Json first = {{"first", {0, 0, 0}}, {"was", 0.0}, {"is", 0.0}};
  forDifferences(was, is, [&](int x, int y, int c, auto a, auto b) {
    double difference = std::abs(double(a) - double(b)), ulp = ulp_of(a, b);
    if (std::isnan(difference)) difference = HUGE_VAL;
    if (pixels == 0) first = {{"first", {x, y, c}}, {"was", numberOr(double(a))}, {"is", numberOr(double(b))}};
    if (x != last_x || y != last_y) ++pixels;
    last_x = x, last_y = y;
    largest = std::max(largest, difference), largest_ulp = std::max(largest_ulp, ulp);
    sum += difference, sum_ulp += ulp;
  });
  const double numbers = std::max(1.0, double(was.width) * double(was.height) * double(was.channels));
  Json json = {{"image", name},
               {"kept", true},
               {"largest", numberOr(largest)},
               {"average", numberOr(sum / numbers)},
               {"largest_ulp", largest_ulp},
               {"average_ulp", sum_ulp / numbers},
               {"pixels", pixels}};
  json.update(first);
  return json;
}

// Compares two images of one format and size.
Json compared(const std::string& name, const graph::ReadImage& was, const graph::ReadImage& is) {
  if (was.isUint())
    return comparedNumbers(name, was.uints, is.uints,
                           [](uint32_t a, uint32_t b) { return std::abs(double(a) - double(b)); });
  Json json = comparedNumbers(name, was.floats, is.floats, [](float a, float b) {
    return std::isnan(a) || std::isnan(b) ? 4294967296.0 : std::abs(double(ordinal(a)) - double(ordinal(b)));
  });
  if (name == "color" && was.floats.channels >= 3 && json["largest"].is_number())
    json["flip"] = image::meanOf(image::hdrFlip(is.floats, was.floats).map);
  return json;
}

bool sameSize(const graph::ReadImage& a, const graph::ReadImage& b) {
  return a.isUint() == b.isUint() && a.width() == b.width() && a.height() == b.height() && a.channels() == b.channels();
}

// |a - b| of each pixel, scaled so that the largest difference is white. `largest`: from `compared`.
image::Image mapOf(const graph::ReadImage& was, const graph::ReadImage& is, const Json& largest) {
  const double white = largest.is_number() ? largest.get<double>() : HUGE_VAL;
  image::Image map(was.width(), was.height(), 1);
  auto add = [&](int x, int y, int, auto a, auto b) {
    double share = std::abs(double(a) - double(b)) / white;
    map.at(x, y, 0) = std::max(map.at(x, y, 0), std::isfinite(share) ? float(share) : 1.0f);
  };
  if (was.isUint()) forDifferences(was.uints, is.uints, add);
  else forDifferences(was.floats, is.floats, add);
  return map;
}

// ---- manifests

using Texts = std::map<std::string, std::string>;

// A line for each name with different texts: "NAME: TEXT, now TEXT".
std::vector<std::string> linesOf(const Texts& was, const Texts& is) {
  Texts names = was;
  names.insert(is.begin(), is.end());
  auto textIn = [](const Texts& texts, const std::string& name) {
    auto found = texts.find(name);
    return found == texts.end() ? std::string("missing") : found->second;
  };
  std::vector<std::string> lines;
  for (const auto& [name, any] : names)
    if (std::string a = textIn(was, name), b = textIn(is, name); a != b)
      lines.push_back(fmt::format("{}: {}, now {}", name, a, b));
  return lines;
}

Texts fieldTexts(const Json& object) {
  Texts texts;
  for (const auto& [name, value] : object.items()) texts[name] = value.dump();
  return texts;
}

Texts parameterTexts(const Json& list) {
  Texts texts;
  for (const Json& one : list)
    texts[one.at("name").get<std::string>() + " of " + one.at("of").get<std::string>()] =
        fmt::format("{} ({})", one.at("value").dump(), one.at("set_by").get<std::string>());
  return texts;
}

std::vector<std::string> textLines(const Path& file) {
  std::vector<std::string> lines(1);
  for (char c : readText(file)) {
    if (c == '\n') lines.emplace_back();
    else lines.back() += c;
  }
  return lines;
}

// First line of an input that differs, or an empty object if the texts of the input are not kept.
Json firstLine(const std::string& name, const Path& was_folder, const Path& is_folder) {
  Path was = was_folder / inputCopy(name), is = is_folder / inputCopy(name);
  bool is_text = name.ends_with(".lua") || name.ends_with(".glsl") || name.ends_with(".h");
  if (!is_text || !fs::is_regular_file(was) || !fs::is_regular_file(is)) return Json::object();
  std::vector<std::string> a = textLines(was), b = textLines(is);
  size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  if (at == a.size() && at == b.size()) return Json::object();
  return {{"line", at + 1}, {"was", at < a.size() ? a[at] : ""}, {"is", at < b.size() ? b[at] : ""}};
}

Json inputDifferences(const Manifest& stated, const Manifest& now) {
  Json list = Json::array();
  Inputs was = inputsFrom(stated.json.at("inputs")), is = inputsFrom(now.json.at("inputs"));
  for (const auto& [name, input] : was) {
    if (!is.count(name)) list.push_back({{"name", name}, {"kind", "missing"}});
    else if (!(is.at(name) == input)) {
      list.push_back({{"name", name}, {"kind", "altered"}});
      list.back().update(firstLine(name, stated.folder, now.folder));
    }
  }
  for (const auto& [name, input] : is)
    if (!was.count(name)) list.push_back({{"name", name}, {"kind", "added"}});
  return list;
}

// True if an output of a pass or a layer of the picture differs.
bool isImage(const Json& picture) { return picture.at("passes").get<int>() > 0 || !picture.at("layers").empty(); }

class PictureComparer {
 public:
  PictureComparer(const Manifest& stated, const Manifest& now, const Path& folder)
      : stated_(stated), now_(now), folder_(folder) {}

  Json compare(const Json& was, const Json& is) {
    Json difference = {
        {"name", was.at("name")},
        {"parameters", linesOf(parameterTexts(was.at("parameters")), parameterTexts(is.at("parameters")))},
        {"same_plan", was.at("plan") == is.at("plan")},
        {"passes", 0},
        {"layers", Json::array()}};
    was_images_.reset(), is_images_.reset();
    findPass(difference, was, is);
    for (const auto& [name, layer] : was.at("layers").items())
      if (!is.at("layers").contains(name) || is.at("layers").at(name).at("hash") != layer.at("hash"))
        difference["layers"].push_back(imageDifference(name, was, is));
    return difference;
  }

 private:
  // Finds the first pass, in the order of execution, that is missing or has a different output. Counts all such passes.
  void findPass(Json& difference, const Json& was, const Json& is) {
    std::map<std::string, const Json*> now;
    for (const Json& pass : is.at("passes")) now[pass.at("node").get<std::string>()] = &pass;
    int passes = 0;
    for (const Json& pass : was.at("passes")) {
      const std::string node = pass.at("node").get<std::string>();
      std::string port = now.count(node) ? firstPort(pass, *now[node]) : "";
      if (now.count(node) && port.empty()) continue;
      if (passes++ > 0) continue;
      difference["first"] = {{"node", node}, {"pass", pass.at("pass")}, {"shader", pass.at("shader")}};
      if (port.empty()) continue;
      difference["first"].update(imageDifference(node + "." + port, was, is));
      drawMap(difference);
    }
    difference["passes"] = passes;
  }

  static std::string firstPort(const Json& was, const Json& is) {
    for (const auto& [port, output] : was.at("outputs").items())
      if (!is.at("outputs").contains(port) || is.at("outputs").at(port).at("hash") != output.at("hash")) return port;
    return "";
  }

  const Images& imagesOf(std::optional<Images>& images, const Manifest& manifest, const Json& picture) {
    if (!images) {
      Path file = manifest.folder / picture.at("images").at("exr").get<std::string>();
      images = fs::exists(file) ? readLayers(file, picture.at("layers")) : Images();
    }
    return *images;
  }

  Json imageDifference(const std::string& name, const Json& was, const Json& is) {
    const Images &a = imagesOf(was_images_, stated_, was), &b = imagesOf(is_images_, now_, is);
    bool kept = a.count(name) && b.count(name) && sameSize(a.at(name), b.at(name));
    if (!kept) return {{"image", name}, {"kept", false}};
    return compared(name, a.at(name), b.at(name));
  }

  void drawMap(const Json& difference) {
    const Json& first = difference.at("first");
    if (folder_.empty() || !first.at("kept").get<bool>()) return;
    const std::string name = first.at("image").get<std::string>();
    image::Image map = mapOf(was_images_->at(name), is_images_->at(name), first.at("largest"));
    image::writePng(folder_ / (difference.at("name").get<std::string>() + "." + name + ".png"),
                    image::heatMap(map, 0, 1));
  }

  const Manifest &stated_, &now_;
  const Path folder_;
  std::optional<Images> was_images_, is_images_;
};

// Figures and films that differ: all files except pictures.
std::vector<std::string> fileDifferences(const Manifest& stated, const Manifest& now) {
  std::vector<std::string> lines;
  const Json &was = stated.json.at("files"), &is = now.json.at("files");
  for (const auto& [name, file] : was.items()) {
    if (name.starts_with("pictures/")) continue;
    if (!is.contains(name)) lines.push_back(name + ": missing");
    else if (is.at(name).at("sha256") != file.at("sha256")) lines.push_back(name);
  }
  return lines;
}

std::string textIn(const Json& object, const char* key) { return object.at(key).get<std::string>(); }

// Number with `digits` significant digits, or the text in place of a number.
std::string numberText(const Json& number, int digits) {
  return number.is_string() ? number.get<std::string>() : fmt::format("{:.{}g}", number.get<double>(), digits);
}

std::string imageText(const Json& one) {
  const std::string name = textIn(one, "image");
  if (!one.at("kept").get<bool>()) return fmt::format("{}: differs (its texels are not in both folders)", name);
  const Json& first = one.at("first");
  std::string text = fmt::format(
      "{}: {} pixels, largest {} ({:.0f} units in the last place), mean {} ({}); first at {},{} channel {}: {}, now {}",
      name, one.at("pixels").get<uint64_t>(), numberText(one.at("largest"), 6), one.at("largest_ulp").get<double>(),
      numberText(one.at("average"), 3), numberText(one.at("average_ulp"), 3), first.at(0).get<int>(),
      first.at(1).get<int>(), first.at(2).get<int>(), numberText(one.at("was"), 9), numberText(one.at("is"), 9));
  if (one.contains("flip")) text += fmt::format("; FLIP {:.6f}", one.at("flip").get<double>());
  return text;
}

std::string pictureText(const Json& one) {
  std::string text = fmt::format("picture {}:{}\n", textIn(one, "name"),
                                 isImage(one) ? "" : " the same, from other parameters or another plan");
  for (const Json& line : one.at("parameters")) text += "  parameter " + line.get<std::string>() + "\n";
  const Json first = one.value("first", Json::object());
  if (!first.empty())
    text +=
        fmt::format("  the first pass whose output differs: {} (pass {}, shaders/{}.glsl); {} passes differ\n",
                    textIn(first, "node"), textIn(first, "pass"), textIn(first, "shader"), one.at("passes").get<int>());
  if (first.contains("image")) text += "    " + imageText(first) + "\n";
  for (const Json& layer : one.at("layers"))
    if (first.value("image", "") != textIn(layer, "image")) text += "  layer " + imageText(layer) + "\n";
  return text;
}

}  // namespace

Json differencesOf(const Manifest& stated, const Manifest& now, const Path& folder) {
  auto lines = [&](const char* part) {
    return linesOf(fieldTexts(stated.json.at(part)), fieldTexts(now.json.at(part)));
  };
  Json all = {{"identical", true},
              {"program", lines("program")},
              {"device", lines("device")},
              {"missing", Json::array()},
              {"added", Json::array()},
              {"files", fileDifferences(stated, now)},
              {"inputs", inputDifferences(stated, now)},
              {"pictures", Json::array()}};
  std::map<std::string, const Json*> is;
  for (const Json& picture : now.json.at("pictures")) is[textIn(picture, "name")] = &picture;
  PictureComparer comparer(stated, now, folder);
  bool same_images = true;
  for (const Json& picture : stated.json.at("pictures")) {
    const std::string name = textIn(picture, "name");
    if (!is.count(name)) {
      all["missing"].push_back(name);
      continue;
    }
    Json one = comparer.compare(picture, *is[name]);
    same_images = same_images && !isImage(one);
    if (isImage(one) || !one["parameters"].empty() || !one["same_plan"]) all["pictures"].push_back(std::move(one));
    is.erase(name);
  }
  for (const auto& [name, picture] : is) all["added"].push_back(name);
  all["identical"] = same_images && all["missing"].empty() && all["files"].empty();
  return all;
}

bool identical(const Json& differences) { return differences.at("identical").get<bool>(); }

bool within(const Json& differences, double most_flip) {
  auto is_within = [&](const Json& layer) {
    return layer.at("image") != "color" || (layer.contains("flip") && layer.at("flip").get<double>() <= most_flip);
  };
  const Json& pictures = differences.at("pictures");
  return differences.at("missing").empty() && std::all_of(pictures.begin(), pictures.end(), [&](const Json& picture) {
           const Json& layers = picture.at("layers");
           return std::all_of(layers.begin(), layers.end(), is_within);
         });
}

std::string textOf(const Json& differences) {
  std::string text;
  auto add = [&](const char* key, const char* begin, const char* end) {
    for (const Json& one : differences.at(key)) text += begin + one.get<std::string>() + end + "\n";
  };
  add("program", "program: ", "");
  add("device", "device: ", "");
  for (const Json& one : differences.at("inputs")) {
    text += fmt::format("input {}: {}\n", textIn(one, "kind"), textIn(one, "name"));
    if (one.contains("line"))
      text += fmt::format("  line {}: {}\n  now     {}\n", one.at("line").get<int>(), textIn(one, "was"),
                          textIn(one, "is"));
  }
  add("missing", "picture ", ": missing");
  add("added", "picture ", ": new");
  for (const Json& one : differences.at("pictures")) text += pictureText(one);
  add("files", "file ", ": differs");
  return text;
}

}  // namespace strobe::archive
