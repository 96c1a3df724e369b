// SPDX-License-Identifier: MIT
// Packets for the viewer tev, decoded by an independent parser of the protocol.
#include "lab/tev.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <functional>
#include <future>
#include <memory>

#include "base/error.h"

using namespace strobe;
using namespace strobe::lab;

namespace tev_test {

// A viewer on a free port of this machine that reads until the sender closes the connection.
class Viewer {
 public:
  explicit Viewer(int waiting = 4) : listener_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(listener_, waiting), 0);
    EXPECT_EQ(getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
  }
  ~Viewer() { close(listener_); }

  TevAddress address() const { return {"127.0.0.1", port_}; }

  std::future<std::string> receive() {
    return std::async(std::launch::async, [this] {
      int from = accept(listener_, nullptr, nullptr);
      std::string all;
      char chunk[65536];
      for (ssize_t got; (got = recv(from, chunk, sizeof chunk, 0)) > 0;) all.append(chunk, size_t(got));
      close(from);
      return all;
    });
  }

  // A connection accepted by the system but never read.
  int accepted() const { return accept(listener_, nullptr, nullptr); }

 private:
  int listener_ = -1;
  int port_ = 0;
};

// Reads numbers and texts from the start of bytes.
struct Reader {
  std::string bytes;
  size_t at = 0;

  template <class Number>
  Number number() {
    Number value{};
    EXPECT_LE(at + sizeof value, bytes.size());
    if (at + sizeof value <= bytes.size()) std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
  }
  std::string text() {
    std::string value = bytes.c_str() + at;
    at += value.size() + 1;
    return value;
  }
  std::vector<std::string> texts(int count) {
    std::vector<std::string> all;
    for (int i = 0; i < count; ++i) all.push_back(text());
    return all;
  }
  bool done() const { return at >= bytes.size(); }
};

struct Shown {
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<std::vector<float>> planes;  // by channel
  int creations = 0, updates = 0;
};

void takeCreate(Reader& packet, std::map<std::string, Shown>& all) {
  packet.number<uint8_t>();
  Shown& shown = all[packet.text()];
  shown.width = packet.number<int32_t>();
  shown.height = packet.number<int32_t>();
  int count = packet.number<int32_t>();
  shown.channels = packet.texts(count);
  shown.planes.assign(size_t(count), std::vector<float>(size_t(shown.width * shown.height)));
  ++shown.creations;
}

void takeUpdate(Reader& packet, std::map<std::string, Shown>& all) {
  packet.number<uint8_t>();
  Shown& shown = all.at(packet.text());
  int count = packet.number<int32_t>();
  EXPECT_EQ(packet.texts(count), shown.channels);
  for (int expected : {0, 0, shown.width, shown.height}) EXPECT_EQ(packet.number<int32_t>(), expected);
  std::vector<int64_t> offsets, strides;
  for (int c = 0; c < count; ++c) offsets.push_back(packet.number<int64_t>());
  for (int c = 0; c < count; ++c) strides.push_back(packet.number<int64_t>());
  std::vector<float> data((packet.bytes.size() - packet.at) / sizeof(float));
  for (float& value : data) value = packet.number<float>();
  for (int c = 0; c < count; ++c)
    for (size_t i = 0; i < shown.planes[size_t(c)].size(); ++i)
      shown.planes[size_t(c)][i] = data.at(size_t(offsets[size_t(c)]) + i * size_t(strides[size_t(c)]));
  ++shown.updates;
}

std::map<std::string, Shown> parsed(const std::string& bytes) {
  std::map<std::string, Shown> all;
  for (size_t at = 0; at < bytes.size();) {
    uint32_t length = 0;
    std::memcpy(&length, bytes.data() + at, 4);
    EXPECT_LE(at + length, bytes.size());
    if (length < 5 || at + length > bytes.size()) return all;
    Reader packet{bytes.substr(at + 4, length - 4)};
    at += length;
    int type = packet.number<uint8_t>();
    EXPECT_TRUE(type == 4 || type == 6) << type;
    type == 4 ? takeCreate(packet, all) : takeUpdate(packet, all);
    EXPECT_TRUE(packet.done());
  }
  return all;
}

graph::ReadImage numbered(int width, int height, int channels, float first = 0) {
  image::Image image(width, height, channels);
  for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = first + 0.25f * float(i);
  return {"", image, {}};
}

void expectPixels(const Shown& shown, const image::Image& image) {
  ASSERT_EQ(shown.width, image.width);
  ASSERT_EQ(shown.height, image.height);
  ASSERT_EQ(int(shown.planes.size()), image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        EXPECT_EQ(shown.planes[size_t(c)][size_t(y * image.width + x)], image.at(x, y, c));
}

double secondsOf(const std::function<void()>& action) {
  auto start = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Tev, ShowsImagesUnchanged) {
  Viewer viewer;
  std::future<std::string> bytes = viewer.receive();
  graph::ReadImage color = numbered(5, 3, 4), later = numbered(5, 3, 4, 100), depth = numbered(7, 2, 1);
  graph::ReadImage velocity = numbered(300, 200, 2), ids = {"rg32ui", {}, {2, 1, 2, {1, 2, 3, 16777216}}};
  {
    Tev tev(viewer.address());
    EXPECT_TRUE(tev.send("color", color));
    EXPECT_TRUE(tev.send("depth", depth));
    EXPECT_TRUE(tev.send("color", later));
    EXPECT_TRUE(tev.send("gbuffer.velocity", velocity));
    EXPECT_TRUE(tev.send("id", ids));
  }
  std::map<std::string, Shown> shown = parsed(bytes.get());
  ASSERT_EQ(shown.size(), 4u);
  EXPECT_EQ(shown["strobe: color"].channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  EXPECT_EQ(shown["strobe: color"].creations, 1);
  EXPECT_EQ(shown["strobe: color"].updates, 2);
  expectPixels(shown["strobe: color"], later.floats);
  EXPECT_EQ(shown["strobe: depth"].channels, (std::vector<std::string>{"Z"}));
  expectPixels(shown["strobe: depth"], depth.floats);
  EXPECT_EQ(shown["strobe: gbuffer.velocity"].channels, (std::vector<std::string>{"X", "Y"}));
  expectPixels(shown["strobe: gbuffer.velocity"], velocity.floats);
  EXPECT_EQ(shown["strobe: id"].planes, (std::vector<std::vector<float>>{{1, 3}, {2, 16777216}}));
}

TEST(Tev, ImageOfAnotherSizeIsCreatedAgain) {
  Viewer viewer;
  std::future<std::string> bytes = viewer.receive();
  graph::ReadImage small = numbered(4, 4, 3), large = numbered(8, 4, 3);
  {
    Tev tev(viewer.address());
    EXPECT_TRUE(tev.send("color", small));
    EXPECT_TRUE(tev.send("color", large));
  }
  std::map<std::string, Shown> shown = parsed(bytes.get());
  EXPECT_EQ(shown["strobe: color"].creations, 2);
  expectPixels(shown["strobe: color"], large.floats);
}

// Packets match the protocol's description byte for byte.
TEST(Tev, PacketsMatchTheProtocol) {
  std::string create = tevCreatePacket("a", 2, 1, {"R", "G"});
  EXPECT_EQ(create, std::string("\x18\0\0\0\x04\0a\0\x02\0\0\0\x01\0\0\0\x02\0\0\0R\0G\0", 24));
  image::Image one(1, 1, 1, 1.0f);
  std::string update = tevUpdatePacket("a", {"Y"}, one);
  EXPECT_EQ(update, std::string("\x32\0\0\0\x06\0a\0\x01\0\0\0Y\0\0\0\0\0\0\0\0\0\x01\0\0\0\x01\0\0\0"
                                "\0\0\0\0\0\0\0\0\x01\0\0\0\0\0\0\0\0\0\x80\x3f",
                                50));
}

TEST(Tev, MissingViewerIsIgnoredQuickly) {
  TevAddress gone;
  { gone = Viewer().address(); }
  ::testing::internal::CaptureStderr();
  Tev tev(gone, 0.1);
  EXPECT_LT(secondsOf([&] { EXPECT_FALSE(tev.send("color", numbered(4, 4, 3))); }), 2);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

// A viewer that accepts no more connections: by default, the system would retry for minutes.
TEST(Tev, ConnectionAttemptsTimeOut) {
  Viewer viewer(0);
  std::vector<std::unique_ptr<Tev>> waiting;
  bool refused = false;
  for (int i = 0; i < 4 && !refused; ++i) {
    waiting.push_back(std::make_unique<Tev>(viewer.address(), 0.1));
    EXPECT_LT(secondsOf([&] { refused = !waiting.back()->send("color", numbered(4, 4, 3)); }), 2);
  }
  EXPECT_TRUE(refused);
}

TEST(Tev, ViewerThatDoesNotReadIsDropped) {
  Viewer viewer;
  Tev tev(viewer.address(), 0.1);
  graph::ReadImage large = numbered(2048, 2048, 4);
  double took_s = secondsOf([&] { EXPECT_FALSE(tev.send("color", large)); });
  EXPECT_LT(took_s, 10);
}

// After a viewer has gone, the next image is created in the next viewer.
TEST(Tev, RestartedViewerIsServed) {
  Viewer viewer;
  auto tev = std::make_unique<Tev>(viewer.address());
  EXPECT_TRUE(tev->send("color", numbered(4, 4, 3)));
  close(viewer.accepted());
  graph::ReadImage image = numbered(512, 512, 4);
  while (tev->send("color", image)) {
  }
  std::future<std::string> bytes = viewer.receive();
  EXPECT_TRUE(tev->send("color", image));
  tev.reset();
  std::map<std::string, Shown> shown = parsed(bytes.get());
  EXPECT_EQ(shown["strobe: color"].creations, 1);
  expectPixels(shown["strobe: color"], image.floats);
}

TEST(Tev, AddressesAreParsed) {
  EXPECT_EQ(parseTevAddress("localhost:14158").host, "localhost");
  EXPECT_EQ(parseTevAddress("10.0.0.7:80").port, 80);
  EXPECT_EQ(parseTevAddress("[::1]:14158").host, "::1");
  for (const char* text : {"", ":", "localhost", "localhost:", ":14158", "localhost:0", "localhost:65536",
                           "localhost:80x", "::1:14158", "a b:80", "http://localhost:80", "localhost:-1"}) {
    try {
      parseTevAddress(text);
      ADD_FAILURE() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.exitCode(), 2) << text;
      EXPECT_NE(std::string(error.what()).find("HOST:PORT"), std::string::npos);
    }
  }
}

}  // namespace tev_test
