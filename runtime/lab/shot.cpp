// SPDX-License-Identifier: MIT
#include "lab/shot.h"

#include <algorithm>
#include <charconv>

#include "shared/frame.h"

namespace strobe::lab {

static const std::vector<std::string> kAnchors = {"close", "centre", "open"};
static const std::vector<std::string> kBackends = {"auto", "pipeline", "query"};

std::array<double, 2> Shot::window() const {
  double length_s = exposure / fps;
  double before = anchor == "close" ? 1 : anchor == "centre" ? 0.5 : 0;
  return {captureTime() - before * length_s, captureTime() + (1 - before) * length_s};
}

static void requireOneOf(const char* option, const std::string& value, const std::vector<std::string>& allowed) {
  if (std::find(allowed.begin(), allowed.end(), value) != allowed.end()) return;
  throw Error(fmt::format("{} '{}' is none of {}{}", option, value, fmt::join(allowed, ", "), didYouMean(value, allowed)), {}, 2);
}

void checkShot(const Shot& shot) {
  auto refuse = [](const std::string& text) { throw Error(text, {}, 2); };
  requireOneOf("--anchor", shot.anchor, kAnchors);
  requireOneOf("--backend", shot.backend, kBackends);
  if (!(shot.fps > 0 && shot.fps <= 1e6)) refuse(fmt::format("--fps {} is not above 0 and at most 1000000", shot.fps));
  if (!(shot.exposure >= 0 && shot.exposure <= 1000)) refuse(fmt::format("--exposure {} is not in 0 to 1000 frames", shot.exposure));
  if (shot.aa < 1 || shot.aa > 256) refuse(fmt::format("--aa {} is not in 1 to 256", shot.aa));
}

Json toJson(const Shot& shot) {
  Json json;
  json["scene"] = shot.scene;
  json["pipeline"] = shot.pipeline;
  json["size"] = {shot.width, shot.height};
  json["fps"] = shot.fps;
  json["frame"] = shot.frame;
  json["exposure"] = shot.exposure;
  json["anchor"] = shot.anchor;
  json["camera"] = shot.camera;
  json["animation"] = shot.animation;
  json["move"] = shot.moves;
  json["spin"] = shot.spins;
  json["aa"] = shot.aa;
  json["seed"] = shot.seed;
  json["backend"] = shot.backend;
  for (const auto& [name, value] : shot.sets) json["set"][name] = value;
  return json;
}

uint32_t anchorCode(const std::string& anchor) {
  if (anchor == "close") return ANCHOR_CLOSE;
  return anchor == "centre" ? ANCHOR_CENTRE : ANCHOR_OPEN;
}

std::array<int, 2> parseSize(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  auto [after_width, first_error] = std::from_chars(text.data(), end, width);
  bool ok = first_error == std::errc() && after_width != end && *after_width == 'x';
  if (ok) {
    auto [after_height, second_error] = std::from_chars(after_width + 1, end, height);
    ok = second_error == std::errc() && after_height == end;
  }
  ok = ok && width >= 1 && height >= 1 && width <= 16384 && height <= 16384;
  if (!ok) throw Error(fmt::format("--size '{}' is not WIDTHxHEIGHT with 1 to 16384 pixels each", text), {}, 2);
  return {width, height};
}

}  // namespace strobe::lab
