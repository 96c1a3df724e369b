// SPDX-License-Identifier: MIT
#include "script/server.h"

#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/error.h"
#include "script/channel.h"

extern char** environ;

namespace strobe::script {

namespace {

constexpr const char* kInsideChild = "STROBE_SCRIPT_CHILD";
constexpr size_t kMaxOutput = size_t{64} << 20;

std::array<int, 2> socketPair(int type) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw Error(fmt::format("cannot create a socket: {}", std::strerror(errno)));
  return ends;
}

// Output up to the status of the process, which the server appends as a last line; nothing without that line.
std::optional<ProgramEnd> endOf(std::string output) {
  const size_t line = output.rfind('\n');
  if (line == std::string::npos) return std::nullopt;
  const int status = std::atoi(output.c_str() + line + 1);
  output.resize(line);
  ProgramEnd end{.output = std::move(output)};
  if (WIFEXITED(status)) end.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.timed_out = end.signal == SIGALRM;
  return end;
}

// A server process. It ends with this object or with this program.
class ScriptServer {
 public:
  explicit ScriptServer(const Home& home) : program_(home.program()), roots_(home.roots()) {
    // A program without the option --script-child would evaluate again, and so recurse without end.
    if (std::getenv(kInsideChild))
      throw Error("a script child cannot start another one; check that STROBE_PROGRAM is strobe");
    const std::array<int, 2> ends = socketPair(SOCK_SEQPACKET);
    const int failed = spawn(ends[1]);
    ::close(ends[1]);
    control_ = ends[0];
    if (!failed) return;
    ::close(control_);
    throw Error(fmt::format("'{}' cannot be started: {}", program_.string(), std::strerror(failed)));
  }
  ~ScriptServer() {
    ::kill(process_, SIGKILL);
    ::close(control_);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  ScriptServer(const ScriptServer&) = delete;
  ScriptServer& operator=(const ScriptServer&) = delete;

  bool serves(const Home& home) const { return program_ == home.program() && roots_ == home.roots(); }

  // Nothing if the server ends before the answer.
  std::optional<ProgramEnd> answerTo(const std::string& file, const std::string& request, double wall_s) const {
    const std::array<int, 2> ends = socketPair(SOCK_STREAM);
    // A request waits at most for one file to load, and each process ends itself in time: only a lost server is later.
    const timeval longest{time_t(2 * wall_s) + 10, 0};
    for (int which : {SO_RCVTIMEO, SO_SNDTIMEO}) ::setsockopt(ends[0], SOL_SOCKET, which, &longest, sizeof longest);
    sendMessage(control_, {file, ends[1]});
    ::close(ends[1]);
    send(ends[0], request);
    std::string output;
    const bool timed_out = !receive(ends[0], output);
    ::close(ends[0]);
    if (timed_out) ::kill(process_, SIGKILL);
    if (timed_out) return ProgramEnd{.timed_out = true};
    if (output.size() > kMaxOutput) return ProgramEnd{.too_long = true};
    return endOf(std::move(output));
  }

 private:
  // Errno, or 0.
  int spawn(int control) {
    std::vector<std::string> texts = {program_.string(), "--script-child"};
    for (const Path& root : roots_) texts.push_back(root.string());
    std::vector<char*> arguments, variables;
    for (std::string& text : texts) arguments.push_back(text.data());
    arguments.push_back(nullptr);
    std::string inside = std::string(kInsideChild) + "=1";
    for (char** entry = environ; *entry; ++entry) variables.push_back(*entry);
    variables.insert(variables.end(), {inside.data(), nullptr});
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_adddup2(&files, control, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
    ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int failed = ::posix_spawnp(&process_, arguments[0], &files, &attributes, arguments.data(), variables.data());
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&files);
    return failed;
  }

  // Sends the whole text and its end. Stops if the process at the other end has ended.
  static void send(int socket, const std::string& text) {
    for (size_t done = 0; done < text.size();) {
      const ssize_t sent = ::send(socket, text.data() + done, text.size() - done, MSG_NOSIGNAL);
      if (sent < 0 && errno != EINTR) break;
      if (sent > 0) done += size_t(sent);
    }
    ::shutdown(socket, SHUT_WR);
  }

  // Reads until the other end is closed or the text is too long. False if nothing arrives in time.
  static bool receive(int socket, std::string& text) {
    std::vector<char> buffer(size_t{1} << 18);
    while (text.size() <= kMaxOutput) {
      const ssize_t got = ::recv(socket, buffer.data(), buffer.size(), 0);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0 && errno == EAGAIN) return false;
      if (got <= 0) break;
      text.append(buffer.data(), size_t(got));
    }
    return true;
  }

  Path program_;
  std::vector<Path> roots_;
  int control_ = -1;
  pid_t process_ = -1;
};

// The servers of this program, most recent first.
class Servers {
 public:
  std::shared_ptr<const ScriptServer> of(const Home& home) {
    constexpr size_t kMost = 4;
    std::lock_guard lock(mutex_);
    auto found = std::find_if(servers_.begin(), servers_.end(), [&](const auto& one) { return one->serves(home); });
    if (found != servers_.end()) servers_.splice(servers_.begin(), servers_, found);
    else servers_.push_front(std::make_shared<const ScriptServer>(home));
    if (servers_.size() > kMost) servers_.pop_back();
    return servers_.front();
  }
  void forget(const std::shared_ptr<const ScriptServer>& server) {
    std::lock_guard lock(mutex_);
    servers_.remove(server);
  }

 private:
  std::mutex mutex_;
  std::list<std::shared_ptr<const ScriptServer>> servers_;
};

Servers& servers() {
  static Servers all;
  return all;
}

}  // namespace

void startServer(const Home& home) { servers().of(home); }

ProgramEnd answerTo(const Home& home, const std::string& file, const std::string& request, double wall_s) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    std::shared_ptr<const ScriptServer> server = servers().of(home);
    if (std::optional<ProgramEnd> end = server->answerTo(file, request, wall_s)) return std::move(*end);
    servers().forget(server);
  }
  throw Error("the process that evaluates scripts ended without an answer");
}

}  // namespace strobe::script
