// SPDX-License-Identifier: MIT
// Cryptomatte, specification 1.2.0 (Psyop, github.com/Psyop/Cryptomatte): mattes by name in OpenEXR files. Friedman and
// Jones, "Fully automatic ID mattes with support for motion blur and transparency", SIGGRAPH 2015 posters.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "image/exr.h"

namespace strobe::image {

// Number of samples of a pixel that hit one geometry of one instance.
struct IdShare {
  uint32_t instance = 0;  // as in images; 0: no hit
  uint32_t geometry = 0;
  uint32_t samples = 0;
};

// Hits of each pixel's samples, counted by instance and geometry.
class IdCoverage {
 public:
  // Adds one sample per pixel. Channel 0 is the instance; channel 1, if present, is the geometry. All images have one
  // size.
  void add(const UintImage& ids);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }  // per pixel
  // Counts of a pixel in the order of the first hits. Pixels are in reading order, top row first.
  std::vector<IdShare> at(size_t pixel) const;

 private:
  int width_ = 0, height_ = 0, samples_ = 0;
  std::vector<IdShare> first_;                                // first hit of each pixel; most pixels have only this one
  std::unordered_map<size_t, std::vector<IdShare>> further_;  // other hits by pixel; only looked up, never iterated
};

// Share of the samples with a hit, one channel.
Image coverageOf(const IdCoverage& seen);

// MurmurHash3_x86_32 with seed 0.
uint32_t murmurHash3(std::string_view text);

// Id of a name: the bits of a float that is not 0, denormal, infinite or NaN.
uint32_t cryptomatteId(std::string_view name);

// Mattes of one kind.
struct CryptomatteLayer {
  std::string name;                             // "CryptoObject"
  std::vector<std::string> names;               // in the manifest; equal names share one matte
  std::function<std::string(IdShare)> name_of;  // name of a hit; not called for instance 0
};

// Adds the layers NAME00, NAME01, NAME02 of 32-bit floats. Each layer has two ids of a pixel (R, B) and their coverage
// (G, A). Ids are sorted by descending coverage; equal coverages by ascending id. Returns the number of pixels with
// more than six ids; the ids with the least coverage are left out there.
size_t addCryptomatte(ExrPart& part, const CryptomatteLayer& layer, const IdCoverage& seen);

// Adds the attributes "cryptomatte/<key>/...": name, hash, conversion, manifest.
void addCryptomatteTexts(std::map<std::string, std::string>& texts, const CryptomatteLayer& layer);

}  // namespace strobe::image
