// SPDX-License-Identifier: MIT
#include "lab/tev.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "base/log.h"
#include "lab/capture.h"

namespace strobe::lab {

static_assert(std::endian::native == std::endian::little, "packets are written as memory holds them");

namespace {

constexpr char kCreate = 4, kUpdate = 6, kKeepFocus = 0;

template <class Number>
void put(std::string& packet, Number value) {
  packet.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void put(std::string& packet, const std::string& text) { packet.append(text.c_str(), text.size() + 1); }

void put(std::string& packet, const std::vector<std::string>& texts) {
  for (const std::string& text : texts) put(packet, text);
}

std::string begun(char type, const std::string& name) {
  std::string packet(4, '\0');
  packet += type;
  packet += kKeepFocus;
  put(packet, name);
  return packet;
}

std::string finished(std::string packet) {
  uint32_t length = uint32_t(packet.size());
  std::memcpy(packet.data(), &length, sizeof length);
  return packet;
}

image::Image asFloats(const graph::ReadImage& read) {
  if (!read.isUint()) return read.floats;
  image::Image image(read.uints.width, read.uints.height, read.uints.channels);
  std::transform(read.uints.values.begin(), read.uints.values.end(), image.values.begin(),
                 [](uint32_t v) { return float(v); });
  return image;
}

// Waits until the socket accepts bytes or a connection attempt ends. True if the socket is writable without an error.
bool writable(int socket, double until_s) {
  double left_s = until_s - clockSeconds();
  pollfd wait = {socket, POLLOUT, 0};
  return left_s > 0 && poll(&wait, 1, int(left_s * 1000) + 1) == 1 && !(wait.revents & (POLLERR | POLLHUP | POLLNVAL));
}

// A connected, non-blocking socket, or -1.
int connected(const addrinfo& to, double until_s) {
  int made = socket(to.ai_family, to.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, to.ai_protocol);
  if (made < 0) return -1;
  int error = 0;
  socklen_t size = sizeof error;
  bool good = ::connect(made, to.ai_addr, to.ai_addrlen) == 0;
  if (!good && errno == EINPROGRESS)
    good = writable(made, until_s) && getsockopt(made, SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
  if (good) return made;
  ::close(made);
  return -1;
}

}  // namespace

TevAddress parseTevAddress(const std::string& text) {
  size_t colon = text.rfind(':');
  std::string host = text.substr(0, colon == std::string::npos ? 0 : colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']') host = host.substr(1, host.size() - 2);
  else if (host.find_first_of(":[]") != std::string::npos) host.clear();
  bool spaces = host.find_first_of(" \t\n/") != std::string::npos;
  int port = 0;
  const char* end = text.data() + text.size();
  const char* from = colon == std::string::npos ? end : text.data() + colon + 1;
  auto [after, error] = std::from_chars(from, end, port);
  if (host.empty() || spaces || error != std::errc() || after != end || port < 1 || port > 65535)
    throw Error(fmt::format("--tev '{}' is not HOST:PORT with a port of 1 to 65535, like localhost:14158", text), {},
                2);
  return {host, port};
}

std::string tevCreatePacket(const std::string& name, int width, int height, const std::vector<std::string>& channels) {
  std::string packet = begun(kCreate, name);
  for (int number : {width, height, int(channels.size())}) put(packet, int32_t(number));
  put(packet, channels);
  return finished(std::move(packet));
}

std::string tevUpdatePacket(const std::string& name, const std::vector<std::string>& channels,
                            const image::Image& image) {
  STROBE_ASSERT(int(channels.size()) == image.channels, "{} names for {} channels", channels.size(), image.channels);
  std::string packet = begun(kUpdate, name);
  put(packet, int32_t(image.channels));
  put(packet, channels);
  for (int number : {0, 0, image.width, image.height}) put(packet, int32_t(number));
  for (int c = 0; c < image.channels; ++c) put(packet, int64_t(c));
  for (int c = 0; c < image.channels; ++c) put(packet, int64_t(image.channels));
  packet.append(reinterpret_cast<const char*>(image.values.data()), image.values.size() * sizeof(float));
  return finished(std::move(packet));
}

Tev::Tev(TevAddress address, double patience_s) : address_(std::move(address)), patience_s_(patience_s) {}

Tev::~Tev() { close(); }

void Tev::close() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
  created_.clear();
}

bool Tev::connect() {
  if (socket_ >= 0) return true;
  double until_s = clockSeconds() + patience_s_;
  addrinfo wanted = {}, *found = nullptr;
  wanted.ai_socktype = SOCK_STREAM;
  if (getaddrinfo(address_.host.c_str(), std::to_string(address_.port).c_str(), &wanted, &found) != 0) return false;
  for (const addrinfo* to = found; to && socket_ < 0; to = to->ai_next) socket_ = connected(*to, until_s);
  freeaddrinfo(found);
  return socket_ >= 0;
}

// Sends all bytes. False if the connection fails or the viewer accepts nothing for `patience_s`.
bool Tev::write(const std::string& bytes) {
  for (size_t sent = 0; sent < bytes.size();) {
    ssize_t took = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (took > 0) sent += size_t(took);
    else if (errno != EINTR && !(errno == EAGAIN && writable(socket_, clockSeconds() + patience_s_))) return false;
  }
  return true;
}

bool Tev::send(const std::string& output, const graph::ReadImage& read) {
  image::Image image = asFloats(read);
  if (image.empty() || !connect()) return false;
  std::string name = "strobe: " + output;
  std::vector<std::string> channels = componentNames(output, image.channels);
  std::string create = tevCreatePacket(name, image.width, image.height, channels);
  std::string& created = created_[name];
  bool good = (created == create || write(create)) && write(tevUpdatePacket(name, channels, image));
  if (good) created = create;
  else close();
  return good;
}

}  // namespace strobe::lab
