// SPDX-License-Identifier: MIT
// Mattes by name: hashes published with the specification; ranks compared with hand counts.
#include "image/cryptomatte.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "base/json.h"

using namespace strobe;
using namespace strobe::image;

namespace cryptomatte_test {

UintImage ids(std::vector<uint32_t> values) { return {2, 1, 2, std::move(values)}; }

// Instances 1 and 3 are called "ball".
CryptomatteLayer layer() {
  auto name = [](IdShare share) {
    return share.instance == 2  ? std::string("floor")
           : share.instance > 3 ? fmt::format("other {}", share.instance)
                                : std::string("ball");
  };
  return {"CryptoObject", {"floor", "ball", "ball"}, name};
}

float idOf(const char* name) { return std::bit_cast<float>(cryptomatteId(name)); }

float at(const ExrPart& part, const std::string& channel, size_t pixel) { return part.find(channel)->values[pixel]; }

// Hashes of the reference implementation of MurmurHash3_x86_32 with seed 0: tails of 0 to 3 bytes.
TEST(Cryptomatte, HashesMatchMurmurHash3) {
  EXPECT_EQ(murmurHash3(""), 0u);
  EXPECT_EQ(murmurHash3("a"), 0x3c2569b2u);
  EXPECT_EQ(murmurHash3("ab"), 0x9bbfd75fu);
  EXPECT_EQ(murmurHash3("abc"), 0xb3dd93fau);
  EXPECT_EQ(murmurHash3("test"), 0xba6bd213u);
  EXPECT_EQ(murmurHash3("Hello, world!"), 0xc0363e43u);
  EXPECT_EQ(murmurHash3("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

// Values from the tests of Psyop's decoder.
TEST(Cryptomatte, IdsMatchPublishedValues) {
  EXPECT_EQ(idOf("hello"), 6.0705627102400005616e-17f);
  EXPECT_EQ(idOf("cube"), -4.08461912519e+15f);
  EXPECT_EQ(idOf("sphere"), 2.79018604383e+15f);
  EXPECT_EQ(idOf("plane"), 3.66557617593e-11f);
  EXPECT_EQ(idOf("равнина"), -1.3192631212399999468e-25f);
  EXPECT_EQ(idOf("mädchen"), 6.2361298211599995797e+25f);
}

// One name in 128 has a hash with an exponent reserved for non-normal floats: the exponent's lowest bit is flipped.
TEST(Cryptomatte, IdsAreNormalFloats) {
  int turned = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string name = fmt::format("node {}", i);
    uint32_t hash = murmurHash3(name), id = cryptomatteId(name);
    EXPECT_TRUE(std::isnormal(std::bit_cast<float>(id))) << name;
    if (std::isnormal(std::bit_cast<float>(hash))) EXPECT_EQ(id, hash);
    else EXPECT_EQ(id ^ hash, 1u << 23);
    turned += id != hash;
  }
  EXPECT_GT(turned, 5);
  EXPECT_LT(turned, 40);
}

// Four samples of two pixels. Left: ball (as two instances) three times, floor once. Right: floor and background.
TEST(Cryptomatte, RanksAreSortedByCoverage) {
  IdCoverage seen;
  seen.add(ids({2, 1, 2, 1}));
  seen.add(ids({1, 1, 0, 0}));
  seen.add(ids({3, 1, 2, 2}));
  seen.add(ids({1, 2, 0, 0}));
  EXPECT_EQ(seen.samples(), 4);
  EXPECT_EQ(coverageOf(seen).values, (std::vector<float>{1, 0.5f}));
  ExrPart part;
  EXPECT_EQ(addCryptomatte(part, layer(), seen), 0u);
  ASSERT_EQ(part.channels.size(), 12u);
  for (const ExrChannel& channel : part.channels) EXPECT_EQ(channel.kind, ExrKind::real);
  EXPECT_EQ(at(part, "CryptoObject00.R", 0), idOf("ball"));
  EXPECT_EQ(at(part, "CryptoObject00.G", 0), 0.75f);
  EXPECT_EQ(at(part, "CryptoObject00.B", 0), idOf("floor"));
  EXPECT_EQ(at(part, "CryptoObject00.A", 0), 0.25f);
  EXPECT_EQ(at(part, "CryptoObject00.R", 1), idOf("floor"));
  EXPECT_EQ(at(part, "CryptoObject00.G", 1), 0.5f);
  for (const char* none : {"CryptoObject00.B", "CryptoObject00.A", "CryptoObject01.R", "CryptoObject02.A"})
    EXPECT_EQ(at(part, none, 1), 0) << none;
}

// Equal shares are sorted by id in any order of samples; the seventh is left out and counted.
TEST(Cryptomatte, SixMattesOfAPixelAreKept) {
  auto ranksOf = [](const std::vector<uint32_t>& order, size_t& crowded) {
    IdCoverage seen;
    for (uint32_t id : order) seen.add(ids({id, 1, 2, 1}));
    ExrPart part;
    crowded = addCryptomatte(part, layer(), seen);
    std::vector<uint32_t> ranks;
    for (const ExrChannel& channel : part.channels)
      if (channel.name.ends_with("R") || channel.name.ends_with("B"))
        ranks.push_back(std::bit_cast<uint32_t>(channel.values[0]));
    return ranks;
  };
  size_t crowded = 0;
  std::vector<uint32_t> ranks = ranksOf({4, 5, 6, 7, 8, 9, 10}, crowded);
  EXPECT_EQ(crowded, 1u);
  EXPECT_EQ(ranks.size(), 6u);
  EXPECT_TRUE(std::is_sorted(ranks.begin(), ranks.end()));
  EXPECT_EQ(ranksOf({10, 8, 6, 4, 9, 7, 5}, crowded), ranks);
}

TEST(Cryptomatte, ManifestNamesEveryMatte) {
  std::map<std::string, std::string> texts;
  addCryptomatteTexts(texts, layer());
  ASSERT_EQ(texts.size(), 4u);
  std::string key = fmt::format("cryptomatte/{}/", fmt::format("{:08x}", murmurHash3("CryptoObject")).substr(0, 7));
  EXPECT_EQ(texts.at(key + "name"), "CryptoObject");
  EXPECT_EQ(texts.at(key + "hash"), "MurmurHash3_32");
  EXPECT_EQ(texts.at(key + "conversion"), "uint32_to_float32");
  EXPECT_EQ(texts.at(key + "manifest"),
            fmt::format(R"({{"ball":"{:08x}","floor":"{:08x}"}})", cryptomatteId("ball"), cryptomatteId("floor")));
  EXPECT_LT((key + "conversion").size(), 32u);  // the limit of OpenEXR 1 readers
}

}  // namespace cryptomatte_test
