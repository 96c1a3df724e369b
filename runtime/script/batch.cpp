// SPDX-License-Identifier: MIT
#include "script/batch.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <future>
#include <thread>

#include "base/error.h"
#include "base/log.h"
#include "script/evaluate.h"

namespace strobe::script {

namespace {

constexpr size_t kMaxOutput = size_t{64} << 20;

// ---- the child's side

void writeAll(int descriptor, const std::string& text) {
  for (size_t done = 0; done < text.size();) {
    ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) ::_exit(1);
    if (written > 0) done += static_cast<size_t>(written);
  }
}

// Reads until the other end is closed; false when the time or the size is used up.
bool collect(int descriptor, double deadline_s, ProgramEnd& result) {
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

// One request in a process of its own, which is a copy of this one.
ProgramEnd forked(const Json& request, double wall_s, const std::function<void(const Json&)>& evaluate) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) ::_exit(1);
  pid_t child = ::fork();
  if (child < 0) ::_exit(1);
  if (child == 0) {
    ::dup2(ends[1], STDOUT_FILENO);
    evaluate(request);
    ::_exit(1);
  }
  ::close(ends[1]);
  ProgramEnd result;
  if (!collect(ends[0], clockSeconds() + wall_s, result)) ::kill(child, SIGKILL);
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (WIFEXITED(status)) result.exit_status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
  return result;
}

// A line of JSON that says how a request ended, then what it wrote.
void send(const ProgramEnd& result) {
  Json head = {{"exit_status", result.exit_status},
               {"signal", result.signal},
               {"timed_out", result.timed_out},
               {"too_long", result.too_long},
               {"bytes", result.output.size()}};
  writeAll(STDOUT_FILENO, head.dump() + "\n" + result.output);
}

std::string withoutArgument(Json request) {
  request.erase("argument");
  return request.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Answers requests, each in a copy of a process that has loaded what they share. False: it could not load that.
bool answerLoaded(const std::vector<Json>& requests, double wall_s, const Answering& answering) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) ::_exit(1);
  pid_t loader = ::fork();
  if (loader < 0) ::_exit(1);
  if (loader == 0) {
    std::optional<std::string> shared = answering.load(requests.front());
    if (!shared) ::_exit(1);
    writeAll(ends[1], "+");
    Json head = {{"shared", shared->size()}, {"requests", requests.size()}};
    writeAll(STDOUT_FILENO, head.dump() + "\n" + *shared);
    for (const Json& request : requests) send(forked(request, wall_s, answering.evaluate));
    ::_exit(0);
  }
  ::close(ends[1]);
  char loaded = 0;
  while (::read(ends[0], &loaded, 1) < 0 && errno == EINTR) continue;
  ::close(ends[0]);
  int status = 0;
  while (::waitpid(loader, &status, 0) < 0 && errno == EINTR) continue;
  if (loaded && status != 0) ::_exit(1);
  return loaded;
}

// ---- the parent's side

// What `answerLoaded` and `send` wrote; none for what is cut off.
std::vector<Answer> received(const std::string& text) {
  std::vector<Answer> results;
  std::shared_ptr<const std::string> shared;
  size_t sharing = 0;  // of the requests to come
  for (size_t at = 0; at < text.size();) {
    size_t end = text.find('\n', at);
    Json head = Json::parse(text.substr(at, end - at), nullptr, false);
    if (end == std::string::npos || !head.is_object()) break;
    if (head.contains("shared")) {
      shared = std::make_shared<const std::string>(text.substr(end + 1, head.at("shared").get<size_t>()));
      sharing = head.at("requests").get<size_t>();
      at = end + 1 + shared->size();
      continue;
    }
    ProgramEnd result;
    result.exit_status = head.at("exit_status").get<int>();
    result.signal = head.at("signal").get<int>();
    result.timed_out = head.at("timed_out").get<bool>();
    result.too_long = head.at("too_long").get<bool>();
    result.output = text.substr(end + 1, head.at("bytes").get<size_t>());
    at = end + 1 + result.output.size();
    results.push_back({std::move(result), sharing > 0 ? shared : nullptr});
    if (sharing > 0) --sharing;
  }
  return results;
}

std::vector<Answer> runShare(const Path& program, const std::vector<Json>& requests, Limits limits) {
  Json batch = {{"batch", requests}, {"wall_s", limits.wall_s}};
  std::string input = batch.dump(-1, ' ', false, Json::error_handler_t::replace);
  limits.wall_s *= double(requests.size());
  ProgramEnd child = runChild(program, input, limits);
  std::vector<Answer> results = received(child.output);
  ProgramEnd lost = child;  // of what the child never came to
  lost.output.clear();
  results.resize(requests.size(), {lost, nullptr});
  return results;
}

}  // namespace

std::vector<Answer> runChildren(const Path& program, const std::vector<Json>& requests, const Limits& limits) {
  size_t shares = std::min<size_t>(std::max(1u, std::thread::hardware_concurrency()), requests.size());
  std::vector<std::vector<Json>> dealt(shares);
  for (size_t i = 0; i < requests.size(); ++i) dealt[i % shares].push_back(requests[i]);
  std::vector<std::future<std::vector<Answer>>> running;
  for (const auto& share : dealt) running.push_back(std::async(std::launch::async, runShare, program, share, limits));
  std::vector<Answer> results(requests.size());
  for (size_t k = 0; k < shares; ++k) {
    std::vector<Answer> some = running[k].get();
    for (size_t i = 0; i < some.size(); ++i) results[i * shares + k] = std::move(some[i]);
  }
  return results;
}

bool isBatch(const Json& request) { return request.contains("batch"); }

void answerBatch(const Json& batch, const Answering& answering) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  double wall_s = batch.at("wall_s").get<double>();
  auto requests = batch.at("batch").get<std::vector<Json>>();
  for (size_t first = 0, end = 0; first < requests.size(); first = end) {
    std::string shared = withoutArgument(requests[first]);
    while (end < requests.size() && withoutArgument(requests[end]) == shared) ++end;
    std::vector<Json> alike(requests.begin() + first, requests.begin() + end);
    if (alike.size() > 1 && answerLoaded(alike, wall_s, answering)) continue;
    for (const Json& request : alike) send(forked(request, wall_s, answering.evaluate));
  }
  ::_exit(0);
}

}  // namespace strobe::script
