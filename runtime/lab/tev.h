// SPDX-License-Identifier: MIT
// Sends images to the viewer tev (https://github.com/Tom94/tev), or to anything that speaks its protocol: TCP, little
// endian, packets of uint32 length (its own four bytes included), uint8 type, payload; strings end in a zero byte.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/graph.h"

namespace strobe::lab {

struct TevAddress {
  std::string host = "localhost";
  int port = 14158;
};

// "HOST:PORT", "[ADDRESS]:PORT" for one with colons. Throws `Error` with exit code 2 for anything else.
TevAddress parseTevAddress(const std::string& text);

// The packets themselves. Type 4: bool grab focus, name, int32 width, height, channels, their names.
std::string tevCreatePacket(const std::string& name, int width, int height, const std::vector<std::string>& channels);

// Type 6: bool grab focus, name, int32 channels, their names, int32 x, y, width, height, int64 offset of each channel,
// int64 stride of each channel (both in floats), floats as they lie in the image.
std::string tevUpdatePacket(const std::string& name, const std::vector<std::string>& channels,
                            const image::Image& image);

// No viewer is required: one that is not there, closes or is too slow is no error, and costs at most `patience_s`.
class Tev {
 public:
  explicit Tev(TevAddress address = {}, double patience_s = 0.25);
  ~Tev();
  Tev(const Tev&) = delete;
  Tev& operator=(const Tev&) = delete;

  // Shows or updates "strobe: <output>". Integers are sent as numbers (exact up to 2^24). False without a viewer.
  bool send(const std::string& output, const graph::ReadImage& image);

 private:
  bool connect();
  bool write(const std::string& bytes);
  void close();

  TevAddress address_;
  double patience_s_;
  int socket_ = -1;
  std::map<std::string, std::string> created_;  // the packet that made each image the viewer has
};

}  // namespace strobe::lab
