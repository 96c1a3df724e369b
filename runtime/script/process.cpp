// SPDX-License-Identifier: MIT
#include "script/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/log.h"

extern char** environ;

namespace strobe::script {

namespace {

constexpr size_t kMaxOutput = size_t{64} << 20;
constexpr const char* kInsideChild = "STROBE_SCRIPT_CHILD";

class Descriptor {
 public:
  explicit Descriptor(int value = -1) : value_(value) {}
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return value_; }
  void reset(int value = -1) {
    if (value_ >= 0) ::close(value_);
    value_ = value;
  }

 private:
  int value_;
};

[[noreturn]] void failed(const char* what) {
  throw Error(fmt::format("a script cannot be evaluated: {}: {}", what, std::strerror(errno)));
}

std::string program() {
  const char* named = std::getenv("STROBE_PROGRAM");
  return named && *named ? named : "/proc/self/exe";
}

// In memory, so that a child that never reads cannot block its parent.
void fillInput(Descriptor& file, const std::string& input) {
  file.reset(::memfd_create("strobe-script", MFD_CLOEXEC));
  if (file.get() < 0) failed("memfd_create");
  for (size_t done = 0; done < input.size();) {
    ssize_t written = ::write(file.get(), input.data() + done, input.size() - done);
    if (written < 0 && errno != EINTR) failed("write");
    if (written > 0) done += static_cast<size_t>(written);
  }
  ::lseek(file.get(), 0, SEEK_SET);
}

std::vector<std::string> childEnvironment() {
  std::vector<std::string> variables = {std::string(kInsideChild) + "=1"};
  for (char** entry = environ; *entry; ++entry) variables.emplace_back(*entry);
  return variables;
}

pid_t start(int input, int output) {
  std::string path = program();
  std::vector<std::string> variables = childEnvironment();
  std::vector<char*> environment;
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  std::string name = "strobe", option = "--script-child";
  char* arguments[] = {name.data(), option.data(), nullptr};

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  pid_t child = -1;
  int failure = ::posix_spawn(&child, path.c_str(), &actions, nullptr, arguments, environment.data());
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw Error(fmt::format("'{}' cannot be started: {}", path, std::strerror(failure)));
  return child;
}

// Reads until the child closes its end; false when the time or the size is used up.
bool collect(int descriptor, double deadline_s, ChildResult& result) {
  char buffer[65536];
  for (;;) {
    double left_s = deadline_s - clockSeconds();
    if (left_s <= 0) return result.timed_out = true, false;
    pollfd waiting{descriptor, POLLIN, 0};
    if (::poll(&waiting, 1, static_cast<int>(left_s * 1000) + 1) <= 0) continue;
    ssize_t got = ::read(descriptor, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    result.output.append(buffer, static_cast<size_t>(got));
    if (result.output.size() > kMaxOutput) return result.too_long = true, false;
  }
}

void reap(pid_t child, bool kill_now, double deadline_s, ChildResult& result) {
  int status = 0;
  while (!kill_now) {
    pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) break;
    if (clockSeconds() > deadline_s) kill_now = result.timed_out = true;
    if (!kill_now) ::usleep(200);
  }
  if (kill_now) {
    ::kill(child, SIGKILL);
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  }
  if (WIFEXITED(status)) result.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
}

}  // namespace

ChildResult runChild(const std::string& input, double wall_s) {
  // A program that does not know the option would evaluate again, and so on without end.
  if (std::getenv(kInsideChild)) throw Error("a script child was asked to start another; is STROBE_PROGRAM strobe?");
  double deadline_s = clockSeconds() + wall_s;
  Descriptor request, reading, writing;
  fillInput(request, input);
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) failed("pipe");
  reading.reset(ends[0]);
  writing.reset(ends[1]);

  ChildResult result;
  pid_t child = start(request.get(), writing.get());
  writing.reset();
  bool ended = collect(reading.get(), deadline_s, result);
  reap(child, !ended, deadline_s, result);
  return result;
}

}  // namespace strobe::script
