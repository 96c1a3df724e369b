// SPDX-License-Identifier: MIT
#include "base/lease.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ctime>
#include <utility>

#include "base/process_name.h"

namespace strobe {

namespace fs = std::filesystem;

// ---- heartbeat

constexpr std::chrono::seconds kBeat(5);

Heartbeat::Heartbeat(Path file)
    : file_(std::move(file)), thread_([this] {
        std::unique_lock<std::mutex> lock(mutex_);
        // The file may be gone, or on a full disk; then the claim ends after a while.
        while (!changed_.wait_for(lock, kBeat, [this] { return ends_; }))
          ::utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);
      }) {}

Heartbeat::~Heartbeat() {
  {
    std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

// ---- files

namespace {

// State of a file; no inode if it is missing. Opening a file makes a network file system fetch its present state.
struct stat stateOf(const Path& file) {
  struct stat state {};
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return state;
  ::fstat(descriptor, &state);
  ::close(descriptor);
  return state;
}

double secondsOf(const struct stat& state) {
  return double(state.st_mtim.tv_sec) + 1e-9 * double(state.st_mtim.tv_nsec);
}

Path besideOf(const Path& file) { return Path(file) += "." + processName() + ".part"; }

}  // namespace

double changedAt(const Path& file) { return secondsOf(stateOf(file)); }

double timeIn(const Path& folder) {
  const Path file = besideOf(folder / "now");
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  struct stat state {};
  if (descriptor < 0) {
    ::clock_gettime(CLOCK_REALTIME, &state.st_mtim);
    return secondsOf(state);
  }
  ::futimens(descriptor, nullptr);
  ::fstat(descriptor, &state);
  ::close(descriptor);
  std::error_code ignored;
  fs::remove(file, ignored);
  return secondsOf(state);
}

// ---- claims

namespace {

// Process that holds a claim; "" if the file is missing or not written yet.
std::string holderOf(const Path& file) {
  try {
    return readText(file);
  } catch (const Error&) {
    return "";
  }
}

// Creates the file with the name of this process, unless it exists.
bool create(const Path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0 && errno == EEXIST) return false;
  const std::string name = processName();
  const bool is_written = descriptor >= 0 && ::write(descriptor, name.data(), name.size()) == ssize_t(name.size());
  const int reason = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (is_written) return true;
  std::error_code ignored;
  if (descriptor >= 0) fs::remove(file, ignored);
  throw WriteError(fmt::format("cannot be written: {}", std::strerror(reason)), {file.string()});
}

bool isAbandoned(const Path& file, double changed_s) {
  return hasEnded(holderOf(file)) || timeIn(file.parent_path()) > changed_s + kLease_s;
}

// Removes an abandoned claim. If another process has replaced the file meanwhile, its claim is put back.
void removeAbandoned(const Path& file) {
  const struct stat state = stateOf(file);
  if (state.st_ino == 0 || !isAbandoned(file, secondsOf(state))) return;
  const Path moved = besideOf(file);
  std::error_code failed;
  fs::rename(file, moved, failed);
  if (failed) return;
  const struct stat found = stateOf(moved);
  const bool is_same = found.st_ino == state.st_ino && secondsOf(found) == secondsOf(state);
  if (is_same) fs::remove(moved, failed);
  else fs::rename(moved, file, failed);
}

}  // namespace

std::unique_ptr<Lease> Lease::claim(const Path& file) {
  if (!create(file)) {
    removeAbandoned(file);
    if (!create(file)) return nullptr;
  }
  return std::unique_ptr<Lease>(new Lease(file));
}

std::unique_ptr<Lease> Lease::ofFolder(const Path& folder) {
  constexpr int kTries = 100;  // 20 ms apart: a process that was just killed runs until the system has ended it
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  const Path file = folder / ".lock";
  for (int tries = 0; tries < kTries; ++tries) {
    if (std::unique_ptr<Lease> lease = claim(file)) return lease;
    ::usleep(20000);
  }
  throw Error(fmt::format("another program works in this folder: process {}", holderOf(file)), {folder.string()}, 2);
}

// Leaves the file alone if another process has taken the claim over.
Lease::~Lease() {
  std::error_code ignored;
  if (holderOf(file_) == processName()) fs::remove(file_, ignored);
}

}  // namespace strobe
