// SPDX-License-Identifier: MIT
#include "base/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/log.h"

extern char** environ;

namespace strobe {

namespace {

class Descriptor {
 public:
  Descriptor() = default;
  ~Descriptor() { reset(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return value_; }
  void reset(int value = -1) {
    if (value_ >= 0) ::close(value_);
    value_ = value;
  }

 private:
  int value_ = -1;
};

[[noreturn]] void failed(const Program& program, const char* what, int reason = errno) {
  throw Error(fmt::format("'{}' cannot be started: {}: {}", program.arguments[0], what, std::strerror(reason)));
}

// Input stream of a child. A socket: sending to a closed socket raises no signal.
class Feeding {
 public:
  Feeding(const Program& program, Descriptor& child_end) : program_(program) {
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) failed(program, "socketpair");
    descriptor_.reset(ends[0]);
    child_end.reset(ends[1]);
  }

  int descriptor() const { return descriptor_.get(); }

  // Sends as much as the child takes at once. Closes the stream after the last input, or if the child does not read any
  // more.
  void write() {
    if (rest_.size() == done_) rest_ = program_.input ? program_.input() : "", done_ = 0;
    if (rest_.empty()) return end();
    ssize_t sent = ::send(descriptor_.get(), rest_.data() + done_, rest_.size() - done_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0) done_ += static_cast<size_t>(sent);
    if (sent < 0 && errno != EINTR && errno != EAGAIN) end();
  }

  void end() { descriptor_.reset(); }

 private:
  const Program& program_;
  Descriptor descriptor_;
  std::string rest_;
  size_t done_ = 0;
};

// A stream of the child, and the text read from it.
struct Stream {
  Descriptor reading, writing;
  std::string text;

  void open(const Program& program) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) failed(program, "pipe");
    reading.reset(ends[0]);
    writing.reset(ends[1]);
  }
};

std::vector<std::string> variablesOf(const Program& program) {
  std::vector<std::string> variables = program.environment;
  for (char** entry = environ; *entry; ++entry) {
    std::string_view one = *entry, name = one.substr(0, one.find('=') + 1);
    bool given = std::any_of(program.environment.begin(), program.environment.end(),
                             [&](const std::string& own) { return own.starts_with(name); });
    if (!given) variables.emplace_back(one);
  }
  return variables;
}

std::vector<char*> pointersTo(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Everything that the child needs until it has become the program. The child shares memory with this process until
// then, so it must not allocate or throw.
struct Birth {
  char* const* arguments;
  char* const* environment;
  int input, output, errors;
  sigset_t signals;
  pid_t parent;
};

// Returns errno if the program cannot be started.
int become(const Birth& birth) {
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != birth.parent) ::_exit(127);
  ::dup2(birth.input, STDIN_FILENO);
  ::dup2(birth.output, STDOUT_FILENO);
  if (birth.errors >= 0) ::dup2(birth.errors, STDERR_FILENO);
  ::closefrom(STDERR_FILENO + 1);
  ::sigprocmask(SIG_SETMASK, &birth.signals, nullptr);
  ::execvpe(birth.arguments[0], birth.arguments, birth.environment);
  return errno;
}

// Blocks signals: handlers of this process must not run in the child, which shares its memory until it has become the
// program.
pid_t start(const Program& program, const Descriptor& input, const Stream& output, const Stream& errors) {
  std::vector<std::string> arguments = program.arguments, variables = variablesOf(program);
  std::vector<char*> argument_list = pointersTo(arguments), variable_list = pointersTo(variables);
  int error_stream = program.errors == Program::Errors::apart         ? errors.writing.get()
                     : program.errors == Program::Errors::with_output ? output.writing.get()
                                                                      : -1;
  Birth birth{
      argument_list.data(), variable_list.data(), input.get(), output.writing.get(), error_stream, {}, ::getpid()};
  sigset_t all;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_BLOCK, &all, &birth.signals);
  volatile int failure = 0;
  pid_t child = ::vfork();
  if (child == 0) {
    failure = become(birth);
    ::_exit(127);
  }
  int reason = child < 0 ? errno : failure;
  ::pthread_sigmask(SIG_SETMASK, &birth.signals, nullptr);
  if (child > 0 && reason) ::waitpid(child, nullptr, 0);
  if (reason) throw Error(fmt::format("'{}' cannot be started: {}", program.arguments[0], std::strerror(reason)));
  return child;
}

// False if the child has closed its end.
bool readInto(Stream& stream, const Program& program, ProgramEnd& end) {
  char buffer[65536];
  ssize_t got = ::read(stream.reading.get(), buffer, sizeof buffer);
  if (got < 0 && errno == EINTR) return true;
  if (got <= 0) return false;
  size_t room = program.output_bytes - stream.text.size();
  end.too_long = end.too_long || size_t(got) > room;
  stream.text.append(buffer, std::min(size_t(got), room));
  return true;
}

double leftOf(const Program& program, double started_s) {
  return program.wall_s > 0 ? started_s + program.wall_s - clockSeconds() : 1e9;
}

// Reads until the child closes its streams or exceeds its time or room.
void collect(const Program& program, std::array<Stream, 2>& streams, Feeding& feeding, double started_s,
             ProgramEnd& end) {
  for (;;) {
    std::array<pollfd, 3> waiting{pollfd{streams[0].reading.get(), POLLIN, 0},
                                  pollfd{streams[1].reading.get(), POLLIN, 0},
                                  pollfd{feeding.descriptor(), POLLOUT, 0}};
    if (waiting[0].fd < 0 && waiting[1].fd < 0) return;
    double left_s = leftOf(program, started_s);
    end.timed_out = left_s <= 0;
    if (end.timed_out || (end.too_long && !program.drops_rest)) return;
    double longest_s = program.meanwhile ? 0.02 : 3600;
    int ready = ::poll(waiting.data(), waiting.size(), int(std::min(left_s, longest_s) * 1000) + 1);
    if (program.meanwhile) program.meanwhile();
    for (size_t i = 0; ready > 0 && i < streams.size(); ++i)
      if (waiting[i].revents && !readInto(streams[i], program, end)) streams[i].reading.reset();
    if (ready > 0 && waiting[2].revents) feeding.write();
  }
}

[[noreturn]] void endAndRethrow(pid_t child) {
  ::kill(-child, SIGKILL);
  while (::waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  throw;
}

void reap(pid_t child, const Program& program, double started_s, ProgramEnd& end) {
  int status = 0;
  bool kill_now = end.timed_out || (end.too_long && !program.drops_rest);
  while (!kill_now && ::waitpid(child, &status, WNOHANG) == 0) {
    kill_now = end.timed_out = leftOf(program, started_s) <= 0;
    if (program.meanwhile) program.meanwhile();
    ::usleep(200);
  }
  if (kill_now) {
    ::kill(-child, SIGKILL);
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  }
  if (WIFEXITED(status)) end.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
}

}  // namespace

ProgramEnd run(const Program& program) {
  STROBE_ASSERT(!program.arguments.empty());
  Descriptor input;
  Feeding feeding(program, input);
  std::array<Stream, 2> streams;
  streams[0].open(program);
  if (program.errors == Program::Errors::apart) streams[1].open(program);
  const double started_s = clockSeconds();
  const pid_t child = start(program, input, streams[0], streams[1]);
  input.reset();
  for (Stream& stream : streams) stream.writing.reset();
  ProgramEnd end;
  try {
    collect(program, streams, feeding, started_s, end);
  } catch (...) {
    endAndRethrow(child);
  }
  feeding.end();
  reap(child, program, started_s, end);
  end.output = std::move(streams[0].text);
  end.errors = std::move(streams[1].text);
  end.seconds = clockSeconds() - started_s;
  return end;
}

}  // namespace strobe
