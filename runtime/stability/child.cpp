// SPDX-License-Identifier: MIT
#include "stability/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/inotify.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "base/error.h"
#include "base/log.h"

extern char** environ;

namespace strobe::stability {

namespace fs = std::filesystem;

namespace {

constexpr size_t kMostOutput = size_t{4} << 20;

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Between fork and exec only what is safe beside other threads.
[[noreturn]] void become(char* const* arguments, char* const* environment, int output, pid_t parent) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);
  int nothing = ::open("/dev/null", O_RDONLY);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(output, STDOUT_FILENO);
  ::dup2(output, STDERR_FILENO);
  ::execve(arguments[0], arguments, environment);
  ::_exit(127);
}

pid_t start(std::vector<std::string> arguments, const std::vector<std::string>& environment, int output) {
  std::vector<std::string> variables = environment;
  for (char** entry = environ; *entry; ++entry) {
    std::string_view name(*entry, size_t(std::strchr(*entry, '=') - *entry) + 1);
    bool given =
        std::any_of(environment.begin(), environment.end(), [&](const auto& own) { return own.starts_with(name); });
    if (!given) variables.emplace_back(*entry);
  }
  std::vector<char*> argument_list = pointersTo(arguments), variable_list = pointersTo(variables);
  pid_t parent = ::getpid(), child = ::fork();
  if (child < 0) throw Error(fmt::format("'{}' cannot be started: {}", arguments[0], std::strerror(errno)));
  if (child == 0) become(argument_list.data(), variable_list.data(), output, parent);
  ::setpgid(child, child);
  return child;
}

// Until the child closes its end, or the time is over.
void collect(int descriptor, double deadline_s, const std::function<void()>& meanwhile, ChildEnd& end) {
  char buffer[65536];
  for (;;) {
    double left_s = deadline_s - clockSeconds();
    end.timed_out = left_s <= 0;
    if (end.timed_out) return;
    pollfd waiting{descriptor, POLLIN, 0};
    int ready = ::poll(&waiting, 1, std::min(20, int(left_s * 1000) + 1));
    if (meanwhile) meanwhile();
    if (ready <= 0) continue;
    ssize_t got = ::read(descriptor, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return;
    if (end.output.size() < kMostOutput) end.output.append(buffer, size_t(got));
  }
}

void reap(pid_t child, double deadline_s, ChildEnd& end) {
  int status = 0;
  while (!end.timed_out && ::waitpid(child, &status, WNOHANG) == 0) {
    end.timed_out = clockSeconds() > deadline_s;
    ::usleep(1000);
  }
  if (end.timed_out) {
    ::kill(-child, SIGKILL);
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  }
  end.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

ChildEnd runProgram(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
                    double limit_s, const std::function<void()>& meanwhile) {
  double started_s = clockSeconds();
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw Error(fmt::format("no pipe: {}", std::strerror(errno)));
  ChildEnd end;
  pid_t child = start(arguments, environment, ends[1]);
  ::close(ends[1]);
  collect(ends[0], started_s + limit_s, meanwhile, end);
  reap(child, started_s + limit_s, end);
  ::close(ends[0]);
  end.seconds = clockSeconds() - started_s;
  return end;
}

HomeCopy::HomeCopy(const Path& home) {
  static std::atomic<int> count = 0;
  folder_ = fs::temp_directory_path() / fmt::format("strobe_mutant_{}_{}", ::getpid(), count++);
  for (const char* part : {"passes", "shaders", "scripts"}) {
    fs::create_directories(folder_ / part);
    fs::copy(home / part, folder_ / part, fs::copy_options::recursive);
  }
}

HomeCopy::~HomeCopy() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

OpenedFiles::OpenedFiles(const Path& folder) : descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  auto add = [&](const Path& one, const std::string& name) {
    int watch = ::inotify_add_watch(descriptor_, one.c_str(), IN_OPEN | IN_ONLYDIR);
    if (watch < 0) throw Error(fmt::format("cannot be watched: {}", std::strerror(errno)), {one.string()});
    folders_.push_back({watch, name});
  };
  add(folder, "");
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_directory()) add(entry.path(), entry.path().lexically_relative(folder).string() + "/");
}

OpenedFiles::~OpenedFiles() { ::close(descriptor_); }

bool OpenedFiles::collect(std::vector<std::string>& files) {
  bool complete = true;
  alignas(inotify_event) char buffer[65536];
  for (ssize_t got; (got = ::read(descriptor_, buffer, sizeof buffer)) > 0;) {
    for (ssize_t at = 0; at < got;) {
      const auto& event = *reinterpret_cast<const inotify_event*>(buffer + at);
      at += ssize_t(sizeof event + event.len);
      complete = complete && !(event.mask & IN_Q_OVERFLOW);
      for (const auto& [watch, name] : folders_)
        if (watch == event.wd && event.len > 0 && !(event.mask & IN_ISDIR)) files.push_back(name + event.name);
    }
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return complete;
}

}  // namespace strobe::stability
