// SPDX-License-Identifier: MIT
// Exclusive claims of names in a folder that several programs use, also from several machines. Needs no locks of the
// file system, which network file systems refuse or ignore: a claim is a file that only one process can create.
#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

#include "base/files.h"

namespace strobe {

// Time without a sign after which a process of another machine counts as ended, seconds. A running process gives a sign
// every 5 s.
inline constexpr double kLease_s = 60;

// Present time by the clock of the folder's file system, seconds: the time of a file made there. The times of signs are
// compared with it, so that the clocks of the machines do not matter. Without permission to write, the time of this
// machine.
double timeIn(const Path& folder);
// Time of the last change of a file, seconds; 0 if it is missing.
double changedAt(const Path& file);

// Sets the time of a file's last change to the present every 5 s, from a thread.
class Heartbeat {
 public:
  explicit Heartbeat(Path file);
  Heartbeat(const Heartbeat&) = delete;
  ~Heartbeat();

 private:
  const Path file_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ends_ = false;
  std::thread thread_;
};

// Claim of a file name until the object is destroyed. The file contains the name of the process. A claim of a process
// that has ended can be taken over: at once on the same machine, on other machines after `kLease_s` without a sign.
class Lease {
 public:
  // Claims `file`, in an existing folder. Null if another process, or another object, holds the claim. Throws
  // `WriteError`.
  static std::unique_ptr<Lease> claim(const Path& file);

  // Claims a folder (FOLDER/.lock), and creates it. Throws `Error` (exit code 2) naming the process that works there.
  static std::unique_ptr<Lease> ofFolder(const Path& folder);

  Lease(const Lease&) = delete;
  ~Lease();

 private:
  explicit Lease(const Path& file) : file_(file), heartbeat_(file) {}

  const Path file_;
  Heartbeat heartbeat_;
};

}  // namespace strobe
