// SPDX-License-Identifier: MIT
// Last message of a program that the user ends with Ctrl-C.
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace strobe {

// While the object exists, SIGINT and SIGTERM print the line returned by `last_words`, on a separate thread, and then
// end the process by their default action. An ignored signal stays ignored. One object at a time.
class Interruption {
 public:
  explicit Interruption(std::function<std::string()> last_words);
  Interruption(const Interruption&) = delete;
  ~Interruption();

 private:
  void wait();
  std::function<std::string()> last_words_;
  int reading_ = -1;
  std::thread thread_;
};

}  // namespace strobe
