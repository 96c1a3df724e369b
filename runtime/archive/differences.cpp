// SPDX-License-Identifier: MIT
#include "archive/differences.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>

#include "archive/capture_run.h"
#include "image/comparison.h"
#include "image/false_colour.h"
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

struct Sums {
  double mean = 0, mean_ulp = 0;
  uint64_t numbers = 0;
};

void addNumber(ImageDifference& result, Sums& sums, double difference, double ulp) {
  result.largest = std::max(result.largest, difference);
  result.largest_ulp = std::max(result.largest_ulp, ulp);
  sums.mean += difference, sums.mean_ulp += ulp;
}

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
void compareNumbers(ImageDifference& result, const Pixels& was, const Pixels& is, const Ulp& ulp_of) {
  Sums sums;
  sums.numbers = uint64_t(was.width) * uint64_t(was.height) * uint64_t(was.channels);
  int last_x = -1, last_y = -1;
  forDifferences(was, is, [&](int x, int y, int c, auto a, auto b) {
    double difference = std::abs(double(a) - double(b));
    if (std::isnan(difference)) difference = HUGE_VAL;
    if (result.pixels == 0)
      result.x = x, result.y = y, result.channel = c, result.was = double(a), result.is = double(b);
    if (x != last_x || y != last_y) ++result.pixels;
    last_x = x, last_y = y;
    addNumber(result, sums, difference, ulp_of(a, b));
  });
  if (sums.numbers > 0)
    result.mean = sums.mean / double(sums.numbers), result.mean_ulp = sums.mean_ulp / double(sums.numbers);
}

bool sameSize(const graph::ReadImage& a, const graph::ReadImage& b) {
  auto same = [](const auto& m, const auto& n) {
    return m.width == n.width && m.height == n.height && m.channels == n.channels;
  };
  return same(a.floats, b.floats) && same(a.uints, b.uints);
}

// |a - b| of each pixel, scaled so that the largest difference is white.
image::Image mapOf(const graph::ReadImage& was, const graph::ReadImage& is, double largest) {
  bool uints = !was.uints.values.empty();
  image::Image map(uints ? was.uints.width : was.floats.width, uints ? was.uints.height : was.floats.height, 1);
  auto add = [&](int x, int y, int, auto a, auto b) {
    double share = std::abs(double(a) - double(b)) / largest;
    map.at(x, y, 0) = std::max(map.at(x, y, 0), std::isfinite(share) ? float(share) : 1.0f);
  };
  if (uints) forDifferences(was.uints, is.uints, add);
  else forDifferences(was.floats, is.floats, add);
  return map;
}

// ---- manifests

std::vector<std::string> linesOf(const Json& was, const Json& is, const std::vector<std::string>& ignored = {}) {
  std::vector<std::string> lines;
  std::set<std::string> names;
  for (const Json* json : {&was, &is})
    for (const auto& [name, value] : json->items()) names.insert(name);
  for (const std::string& name : names) {
    Json a = was.contains(name) ? was[name] : Json(), b = is.contains(name) ? is[name] : Json();
    if (a == b || std::find(ignored.begin(), ignored.end(), name) != ignored.end()) continue;
    lines.push_back(fmt::format("{}: {}, now {}", name, a.dump(), b.dump()));
  }
  return lines;
}

std::vector<std::string> textLines(const Path& file) {
  std::vector<std::string> lines(1);
  for (char c : readText(file)) {
    if (c == '\n') lines.emplace_back();
    else lines.back() += c;
  }
  return lines;
}

// Sets the first different line of an input, if its texts are kept.
void findLine(InputDifference& difference, const Path& was_folder, const Path& is_folder) {
  Path was = was_folder / inputCopy(difference.name), is = is_folder / inputCopy(difference.name);
  if (!fs::is_regular_file(was) || !fs::is_regular_file(is)) return;
  if (!difference.name.ends_with(".lua") && !difference.name.ends_with(".glsl") && !difference.name.ends_with(".h"))
    return;
  std::vector<std::string> a = textLines(was), b = textLines(is);
  size_t at = 0;
  while (at < a.size() && at < b.size() && a[at] == b[at]) ++at;
  if (at == a.size() && at == b.size()) return;
  difference.line = int(at) + 1;
  difference.was = at < a.size() ? a[at] : "", difference.is = at < b.size() ? b[at] : "";
}

std::vector<InputDifference> inputDifferences(const Manifest& stated, const Manifest& now) {
  std::vector<InputDifference> differences;
  Inputs was = inputsFrom(stated.json.at("inputs")), is = inputsFrom(now.json.at("inputs"));
  for (const auto& [name, input] : was) {
    if (!is.count(name)) differences.push_back({InputDifference::Kind::missing, name, 0, "", ""});
    else if (!(is.at(name) == input)) {
      InputDifference& one = differences.emplace_back(InputDifference{InputDifference::Kind::altered, name, 0, "", ""});
      findLine(one, stated.folder, now.folder);
    }
  }
  for (const auto& [name, input] : is)
    if (!was.count(name)) differences.push_back({InputDifference::Kind::added, name, 0, "", ""});
  return differences;
}

std::string parameterText(const Json& one) {
  return fmt::format("{} ({})", one.at("value").dump(), one.at("set_by").get<std::string>());
}

std::vector<std::string> parameterDifferences(const Json& was, const Json& is) {
  auto byName = [](const Json& list) {
    std::map<std::string, Json> map;
    for (const Json& one : list)
      map[one.at("name").get<std::string>() + " of " + one.at("of").get<std::string>()] = one;
    return map;
  };
  std::map<std::string, Json> a = byName(was), b = byName(is);
  std::vector<std::string> lines;
  for (const auto& [name, one] : a) {
    if (!b.count(name)) lines.push_back(fmt::format("{}: {}, now missing", name, parameterText(one)));
    else if (one.at("value") != b[name].at("value") || one.at("set_by") != b[name].at("set_by"))
      lines.push_back(fmt::format("{}: {}, now {}", name, parameterText(one), parameterText(b[name])));
  }
  for (const auto& [name, one] : b)
    if (!a.count(name)) lines.push_back(fmt::format("{}: missing, now {}", name, parameterText(one)));
  return lines;
}

class PictureComparer {
 public:
  PictureComparer(const Manifest& stated, const Manifest& now, const Path& folder)
      : stated_(stated), now_(now), folder_(folder) {}

  PictureDifference compare(const Json& was, const Json& is) {
    PictureDifference difference;
    difference.name = was.at("name").get<std::string>();
    difference.parameters = parameterDifferences(was.at("parameters"), is.at("parameters"));
    difference.same_plan = was.at("plan") == is.at("plan");
    was_images_.reset(), is_images_.reset();
    findPass(difference, was, is);
    for (const auto& [name, layer] : was.at("layers").items())
      if (!is.at("layers").contains(name) || is.at("layers").at(name).at("hash") != layer.at("hash"))
        difference.layers.push_back(imageDifference(name, was, is));
    return difference;
  }

 private:
  // Finds the first pass, in the order of execution, that is missing or has a different output. Counts all such passes.
  void findPass(PictureDifference& difference, const Json& was, const Json& is) {
    std::map<std::string, const Json*> now;
    for (const Json& pass : is.at("passes")) now[pass.at("node").get<std::string>()] = &pass;
    for (const Json& pass : was.at("passes")) {
      const std::string node = pass.at("node").get<std::string>();
      std::string port = now.count(node) ? firstPort(pass, *now[node]) : "";
      if (now.count(node) && port.empty()) continue;
      if (difference.passes++ > 0) continue;
      difference.node = node;
      difference.pass = pass.at("pass").get<std::string>(), difference.shader = pass.at("shader").get<std::string>();
      if (!port.empty()) {
        difference.first = imageDifference(node + "." + port, was, is);
        drawMap(difference);
      }
    }
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

  ImageDifference imageDifference(const std::string& name, const Json& was, const Json& is) {
    const Images &a = imagesOf(was_images_, stated_, was), &b = imagesOf(is_images_, now_, is);
    if (!a.count(name) || !b.count(name) || !sameSize(a.at(name), b.at(name))) {
      ImageDifference unknown;
      unknown.image = name, unknown.is_kept = false;
      return unknown;
    }
    return compared(name, a.at(name), b.at(name));
  }

  void drawMap(const PictureDifference& difference) {
    if (folder_.empty() || !difference.first->is_kept) return;
    const std::string& name = difference.first->image;
    image::Image map = mapOf(was_images_->at(name), is_images_->at(name), difference.first->largest);
    image::writePng(folder_ / (difference.name + "." + name + ".png"), image::heatMap(map, 0, 1));
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

std::string textOf(const ImageDifference& one) {
  if (!one.is_kept) return fmt::format("{}: differs (its texels are not in both folders)", one.image);
  std::string text = fmt::format(
      "{}: {} pixels, largest {:.6g} ({:.0f} units in the last place), mean {:.3g} ({:.3g}); first at {},{} "
      "channel {}: {:.9g}, now {:.9g}",
      one.image, one.pixels, one.largest, one.largest_ulp, one.mean, one.mean_ulp, one.x, one.y, one.channel, one.was,
      one.is);
  if (one.flip) text += fmt::format("; FLIP {:.6f}", *one.flip);
  return text;
}

Json numberOr(double value) { return std::isfinite(value) ? Json(value) : Json(fmt::format("{}", value)); }

Json toJson(const ImageDifference& one) {
  Json json = {{"image", one.image}, {"kept", one.is_kept}};
  if (!one.is_kept) return json;
  json.update({{"largest", numberOr(one.largest)},
               {"average", numberOr(one.mean)},
               {"largest_ulp", one.largest_ulp},
               {"average_ulp", one.mean_ulp},
               {"pixels", one.pixels},
               {"first", {one.x, one.y, one.channel}},
               {"was", numberOr(one.was)},
               {"is", numberOr(one.is)}});
  if (one.flip) json["flip"] = *one.flip;
  return json;
}

const char* kindName(InputDifference::Kind kind) {
  return kind == InputDifference::Kind::altered   ? "altered"
         : kind == InputDifference::Kind::missing ? "missing"
                                                  : "added";
}

}  // namespace

ImageDifference compared(const std::string& name, const graph::ReadImage& was, const graph::ReadImage& is) {
  ImageDifference result;
  result.image = name;
  if (!was.uints.values.empty())
    compareNumbers(result, was.uints, is.uints, [](uint32_t a, uint32_t b) { return std::abs(double(a) - double(b)); });
  else
    compareNumbers(result, was.floats, is.floats, [](float a, float b) {
      return std::isnan(a) || std::isnan(b) ? 4294967296.0 : std::abs(double(ordinal(a)) - double(ordinal(b)));
    });
  bool is_color = name == "color" && was.floats.channels >= 3 && std::isfinite(result.largest);
  if (is_color)
    result.flip = image::compareImages(image::threeChannels(is.floats), image::threeChannels(was.floats)).hdr_flip;
  return result;
}

bool Differences::identical() const {
  bool same = std::none_of(pictures.begin(), pictures.end(), [](const auto& picture) { return picture.isImage(); });
  return same && missing.empty() && files.empty();
}

bool Differences::within(double most_flip) const {
  auto is_within = [&](const PictureDifference& picture) {
    return std::all_of(picture.layers.begin(), picture.layers.end(), [&](const ImageDifference& layer) {
      return layer.image != "color" || (layer.flip && *layer.flip <= most_flip);
    });
  };
  return missing.empty() && std::all_of(pictures.begin(), pictures.end(), is_within);
}

Differences differencesOf(const Manifest& stated, const Manifest& now, const Path& folder) {
  Differences differences;
  differences.program = linesOf(stated.json.at("program"), now.json.at("program"));
  differences.device = linesOf(stated.json.at("device"), now.json.at("device"));
  differences.inputs = inputDifferences(stated, now);
  std::map<std::string, const Json*> is;
  for (const Json& picture : now.json.at("pictures")) is[picture.at("name").get<std::string>()] = &picture;
  PictureComparer comparer(stated, now, folder);
  for (const Json& picture : stated.json.at("pictures")) {
    const std::string name = picture.at("name").get<std::string>();
    if (!is.count(name)) {
      differences.missing.push_back(name);
      continue;
    }
    PictureDifference one = comparer.compare(picture, *is[name]);
    if (one.isImage() || !one.parameters.empty() || !one.same_plan) differences.pictures.push_back(std::move(one));
    is.erase(name);
  }
  for (const auto& [name, picture] : is) differences.added.push_back(name);
  differences.files = fileDifferences(stated, now);
  return differences;
}

std::string textOf(const Differences& all) {
  std::string text;
  for (const std::string& line : all.program) text += "program: " + line + "\n";
  for (const std::string& line : all.device) text += "device: " + line + "\n";
  for (const InputDifference& one : all.inputs) {
    text += fmt::format("input {}: {}\n", kindName(one.kind), one.name);
    if (one.line) text += fmt::format("  line {}: {}\n  now     {}\n", one.line, one.was, one.is);
  }
  for (const std::string& name : all.missing) text += fmt::format("picture {}: missing\n", name);
  for (const std::string& name : all.added) text += fmt::format("picture {}: new\n", name);
  for (const PictureDifference& one : all.pictures) {
    text += fmt::format("picture {}:{}\n", one.name,
                        one.isImage() ? "" : " the same, from other parameters or another plan");
    for (const std::string& line : one.parameters) text += "  parameter " + line + "\n";
    if (one.passes)
      text += fmt::format("  the first pass whose output differs: {} (pass {}, shaders/{}.glsl); {} passes differ\n",
                          one.node, one.pass, one.shader, one.passes);
    if (one.first) text += "    " + textOf(*one.first) + "\n";
    for (const ImageDifference& layer : one.layers)
      if (!one.first || layer.image != one.first->image) text += "  layer " + textOf(layer) + "\n";
  }
  for (const std::string& name : all.files) text += "file " + name + ": differs\n";
  return text;
}

Json toJson(const Differences& all) {
  Json json = {{"identical", all.identical()}, {"program", all.program},   {"device", all.device},
               {"missing", all.missing},       {"added", all.added},       {"files", all.files},
               {"inputs", Json::array()},      {"pictures", Json::array()}};
  for (const InputDifference& one : all.inputs) {
    Json input = {{"name", one.name}, {"kind", kindName(one.kind)}};
    if (one.line) input.update({{"line", one.line}, {"was", one.was}, {"is", one.is}});
    json["inputs"].push_back(std::move(input));
  }
  for (const PictureDifference& one : all.pictures) {
    Json picture = {{"name", one.name},
                    {"parameters", one.parameters},
                    {"same_plan", one.same_plan},
                    {"passes", one.passes},
                    {"layers", Json::array()}};
    if (one.passes) picture["first"] = {{"node", one.node}, {"pass", one.pass}, {"shader", one.shader}};
    if (one.first) picture["first"].update(toJson(*one.first));
    for (const ImageDifference& layer : one.layers) picture["layers"].push_back(toJson(layer));
    json["pictures"].push_back(std::move(picture));
  }
  return json;
}

}  // namespace strobe::archive
