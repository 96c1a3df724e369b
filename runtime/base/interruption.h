// SPDX-License-Identifier: MIT
// Last words of a program that the user ends with Ctrl-C.
#pragma once

#include <functional>
#include <string>
#include <thread>

namespace strobe {

// While it lives, SIGINT and SIGTERM print the line that `last_words` returns, on a thread of its own, and then end the
// process as they would without it. A signal that is ignored stays ignored. One at a time.
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
