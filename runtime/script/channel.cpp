// SPDX-License-Identifier: MIT
#include "script/channel.h"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace strobe::script {

namespace {

// Header of a message, with room for one file.
struct Envelope {
  alignas(cmsghdr) char room[CMSG_SPACE(sizeof(int))] = {};
  iovec text;
  msghdr header{};

  explicit Envelope(std::string& content) : text{content.data(), content.size()} {
    header.msg_iov = &text;
    header.msg_iovlen = 1;
    header.msg_control = room;
    header.msg_controllen = sizeof room;
  }
};

}  // namespace

bool sendMessage(int socket, const Message& message) {
  std::string text = message.text;
  Envelope envelope(text);
  if (message.file < 0) {
    envelope.header.msg_controllen = 0;
  } else {
    cmsghdr* file = CMSG_FIRSTHDR(&envelope.header);
    file->cmsg_level = SOL_SOCKET;
    file->cmsg_type = SCM_RIGHTS;
    file->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(file), &message.file, sizeof(int));
  }
  ssize_t sent = -1;
  do sent = ::sendmsg(socket, &envelope.header, MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

std::optional<Message> receiveMessage(int socket) {
  Message message{std::string(size_t{1} << 18, '\0')};
  Envelope envelope(message.text);
  ssize_t got = -1;
  do got = ::recvmsg(socket, &envelope.header, MSG_CMSG_CLOEXEC);
  while (got < 0 && errno == EINTR);
  if (got <= 0) return std::nullopt;
  message.text.resize(size_t(got));
  const cmsghdr* file = CMSG_FIRSTHDR(&envelope.header);
  if (file && file->cmsg_type == SCM_RIGHTS) std::memcpy(&message.file, CMSG_DATA(file), sizeof(int));
  return message;
}

}  // namespace strobe::script
