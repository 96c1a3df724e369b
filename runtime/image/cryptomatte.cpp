// SPDX-License-Identifier: MIT
#include "image/cryptomatte.h"

#include <algorithm>
#include <bit>

#include "base/error.h"
#include "base/json.h"

namespace strobe::image {

constexpr int kLayers = 3, kRanks = 2 * kLayers;

// ---- coverage

static void count(IdShare& share, uint32_t instance, uint32_t geometry) {
  share.instance = instance, share.geometry = geometry;
  ++share.samples;
}

void IdCoverage::add(const UintImage& ids) {
  if (samples_ == 0) width_ = ids.width, height_ = ids.height, first_.resize(size_t(width_) * height_);
  STROBE_ASSERT(ids.width == width_ && ids.height == height_, "{}x{} is not {}x{}", ids.width, ids.height, width_,
                height_);
  ++samples_;
  for (size_t pixel = 0; pixel < first_.size(); ++pixel) {
    const uint32_t* id = &ids.values[pixel * size_t(ids.channels)];
    uint32_t instance = id[0], geometry = ids.channels > 1 ? id[1] : 0;
    auto same = [&](const IdShare& share) { return share.instance == instance && share.geometry == geometry; };
    if (first_[pixel].samples == 0 || same(first_[pixel])) {
      count(first_[pixel], instance, geometry);
      continue;
    }
    std::vector<IdShare>& further = further_[pixel];
    auto found = std::find_if(further.begin(), further.end(), same);
    count(found == further.end() ? further.emplace_back() : *found, instance, geometry);
  }
}

std::vector<IdShare> IdCoverage::at(size_t pixel) const {
  std::vector<IdShare> shares = {first_[pixel]};
  auto further = further_.find(pixel);
  if (further != further_.end()) shares.insert(shares.end(), further->second.begin(), further->second.end());
  return shares;
}

Image coverageOf(const IdCoverage& seen) {
  Image image(seen.width(), seen.height(), 1);
  for (size_t pixel = 0; pixel < image.values.size(); ++pixel) {
    uint32_t met = 0;
    for (const IdShare& share : seen.at(pixel)) met += share.instance != 0 ? share.samples : 0;
    image.values[pixel] = float(met) / float(seen.samples());
  }
  return image;
}

// ---- ids of names

uint32_t murmurHash3(std::string_view text) {
  uint32_t hash = 0;
  auto mixed = [](uint32_t k) { return std::rotl(k * 0xcc9e2d51u, 15) * 0x1b873593u; };
  size_t whole = text.size() / 4 * 4;
  for (size_t i = 0; i < whole; i += 4) {
    uint32_t k = 0;
    for (size_t b = 0; b < 4; ++b) k |= uint32_t(uint8_t(text[i + b])) << (8 * b);
    hash = std::rotl(hash ^ mixed(k), 13) * 5 + 0xe6546b64u;
  }
  uint32_t tail = 0;
  for (size_t b = 0; whole + b < text.size(); ++b) tail |= uint32_t(uint8_t(text[whole + b])) << (8 * b);
  hash ^= mixed(tail);
  hash ^= uint32_t(text.size());
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
  return hash ^ (hash >> 16);
}

uint32_t cryptomatteId(std::string_view name) {
  uint32_t hash = murmurHash3(name), exponent = (hash >> 23) & 255;
  return exponent == 0 || exponent == 255 ? hash ^ (1u << 23) : hash;
}

// ---- layers

namespace {

struct Rank {
  uint32_t id = 0, samples = 0;
};

// Cached ids by instance and geometry. Many pixels share few names, so each name is requested once.
class Ids {
 public:
  explicit Ids(const CryptomatteLayer& layer) : layer_(layer) {}
  uint32_t of(const IdShare& share) {
    auto [known, is_new] = ids_.emplace(uint64_t{share.instance} << 32 | share.geometry, 0);
    if (is_new) known->second = cryptomatteId(layer_.name_of(share));
    return known->second;
  }

 private:
  const CryptomatteLayer& layer_;
  std::unordered_map<uint64_t, uint32_t> ids_;
};

std::vector<Rank> ranksOf(const std::vector<IdShare>& shares, Ids& ids) {
  std::vector<Rank> ranks;
  for (const IdShare& share : shares) {
    if (share.instance == 0) continue;
    uint32_t id = ids.of(share);
    auto same = std::find_if(ranks.begin(), ranks.end(), [id](const Rank& rank) { return rank.id == id; });
    Rank& rank = same == ranks.end() ? ranks.emplace_back(Rank{id, 0}) : *same;
    rank.samples += share.samples;
  }
  std::sort(ranks.begin(), ranks.end(),
            [](const Rank& a, const Rank& b) { return a.samples != b.samples ? a.samples > b.samples : a.id < b.id; });
  return ranks;
}

}  // namespace

size_t addCryptomatte(ExrPart& part, const CryptomatteLayer& layer, const IdCoverage& seen) {
  std::vector<Image> images(kLayers, Image(seen.width(), seen.height(), 4));
  Ids ids(layer);
  size_t crowded = 0;
  for (size_t pixel = 0; pixel < size_t(seen.width()) * seen.height(); ++pixel) {
    std::vector<Rank> ranks = ranksOf(seen.at(pixel), ids);
    crowded += ranks.size() > kRanks;
    ranks.resize(std::min<size_t>(ranks.size(), kRanks));
    for (size_t i = 0; i < ranks.size(); ++i) {
      float* value = &images[i / 2].values[4 * pixel + 2 * (i % 2)];
      value[0] = std::bit_cast<float>(ranks[i].id);
      value[1] = float(ranks[i].samples) / float(seen.samples());
    }
  }
  for (int i = 0; i < kLayers; ++i)
    part.add(fmt::format("{}{:02}", layer.name, i), {"R", "G", "B", "A"}, images[size_t(i)]);
  return crowded;
}

void addCryptomatteTexts(std::map<std::string, std::string>& texts, const CryptomatteLayer& layer) {
  std::map<std::string, std::string> manifest;  // sorted by name
  for (const std::string& name : layer.names) manifest[name] = fmt::format("{:08x}", cryptomatteId(name));
  std::string key = fmt::format("cryptomatte/{}/", fmt::format("{:08x}", murmurHash3(layer.name)).substr(0, 7));
  texts[key + "name"] = layer.name;
  texts[key + "hash"] = "MurmurHash3_32";
  texts[key + "conversion"] = "uint32_to_float32";
  texts[key + "manifest"] = Json(manifest).dump();
}

}  // namespace strobe::image
