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

// The samples of a pixel that met one geometry of one drawable.
struct IdShare {
  uint32_t instance = 0;  // as it stands in images: 0 is nothing
  uint32_t geometry = 0;
  uint32_t samples = 0;
};

// How many of a pixel's samples met what.
class IdCoverage {
 public:
  // A sample of each pixel: its instance and, where there is a second channel, its geometry. All of one size.
  void add(const UintImage& ids);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }  // of each pixel
  // In the order in which they were met; top row first.
  std::vector<IdShare> at(size_t pixel) const;

 private:
  int width_ = 0, height_ = 0, samples_ = 0;
  std::vector<IdShare> first_;                                // of each pixel: most have no other
  std::unordered_map<size_t, std::vector<IdShare>> further_;  // only looked up, never walked through
};

// The share of samples that met anything, one channel.
Image coverageOf(const IdCoverage& seen);

// MurmurHash3_x86_32 with seed 0.
uint32_t murmurHash3(std::string_view text);

// The id of a name as the bits of a float that is neither 0, denormal, infinite nor NaN.
uint32_t cryptomatteId(std::string_view name);

// Mattes of one kind.
struct CryptomatteLayer {
  std::string name;                            // "CryptoObject"
  std::vector<std::string> names;              // of the manifest; equal names are one matte
  std::function<std::string(IdShare)> nameOf;  // of what a sample met; never asked for nothing
};

// Adds the ranks: layers NAME00, NAME01, NAME02 of 32-bit floats, each with two ids of a pixel (R, B) and how much of
// it they cover (G, A), the largest first, of equal ones the lower id. Returns how many pixels have more than six ids,
// of which the smallest are left out.
size_t addCryptomatte(ExrPart& part, const CryptomatteLayer& layer, const IdCoverage& seen);

// Adds the attributes "cryptomatte/<key>/...": name, hash, conversion, manifest.
void addCryptomatteTexts(std::map<std::string, std::string>& texts, const CryptomatteLayer& layer);

}  // namespace strobe::image
