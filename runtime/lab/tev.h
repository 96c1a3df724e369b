// SPDX-License-Identifier: MIT
// Sends images to the viewer tev (https://github.com/Tom94/tev) or another program with its protocol. Protocol: TCP,
// little endian; a packet has uint32 length (including its own four bytes), uint8 type, payload; strings end in a zero
// byte.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "graph/graph.h"

namespace strobe::lab {

// Network address of the image viewer tev: host name and TCP port, localhost:14158 by default.
struct TevAddress {
  std::string host = "localhost";
  int port = 14158;
};

// Parses "HOST:PORT", or "[ADDRESS]:PORT" for an address with colons. Throws `Error` (exit code 2) for other text.
TevAddress parseTevAddress(const std::string& text);

// Packet of type 4: bool grab focus, name, int32 width, height, channels, channel names.
std::string tevCreatePacket(const std::string& name, int width, int height, const std::vector<std::string>& channels);

// Packet of type 6: bool grab focus, name, int32 channels, channel names, int32 x, y, width, height, int64 offset of
// each channel, int64 stride of each channel (both in floats), floats in image order.
std::string tevUpdatePacket(const std::string& name, const std::vector<std::string>& channels,
                            const image::Image& image);

// Connection to a viewer. A missing, closed or slow viewer is not an error. Each wait for the viewer ends after
// `patience_s` seconds.
class Tev {
 public:
  explicit Tev(TevAddress address = {}, double patience_s = 0.25);
  ~Tev();
  Tev(const Tev&) = delete;
  Tev& operator=(const Tev&) = delete;

  // Shows or updates "strobe: <output>". Integers are sent as floats (exact up to 2^24). Returns false without a
  // viewer.
  bool send(const std::string& output, const graph::ReadImage& image);

 private:
  bool connect();
  bool write(const std::string& bytes);
  void close();

  TevAddress address_;
  double patience_s_;
  int socket_ = -1;
  std::map<std::string, std::string> created_;  // create packet of each image in the viewer, by name
};

}  // namespace strobe::lab
