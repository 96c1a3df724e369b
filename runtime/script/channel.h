// SPDX-License-Identifier: MIT
// Messages between the processes of a script server, with an open file.
#pragma once

#include <optional>
#include <string>

namespace strobe::script {

// Message on a socket of type SOCK_SEQPACKET: a text that is not empty, and an open file or -1. The receiver owns the
// file.
struct Message {
  std::string text;
  int file = -1;
};

// False if the other end is closed.
bool sendMessage(int socket, const Message& message);
// Waits for a message; nothing if the other end is closed.
std::optional<Message> receiveMessage(int socket);

}  // namespace strobe::script
