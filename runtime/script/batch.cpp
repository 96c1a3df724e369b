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
#include "base/json_text.h"
#include "base/log.h"
#include "script/evaluate.h"

namespace strobe::script {

namespace {

constexpr size_t kMaxOutput = size_t{64} << 20;

// ---- in the child

void writeAll(int descriptor, const std::string& text) {
  for (size_t done = 0; done < text.size();) {
    ssize_t written = ::write(descriptor, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) ::_exit(1);
    if (written > 0) done += static_cast<size_t>(written);
  }
}

// Reads until the other end is closed. False if the time or the size exceeds its limit.
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

// Evaluates one request in a forked copy of this process.
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

// Sends a line of JSON with the end of a request, then its output. `loaded` is the number of the loaded data that the
// output refers to, or -1.
void send(const ProgramEnd& result, int loaded) {
  Json head = {{"exit_status", result.exit_status}, {"signal", result.signal}, {"timed_out", result.timed_out},
               {"too_long", result.too_long},       {"loaded", loaded},        {"bytes", result.output.size()}};
  writeAll(STDOUT_FILENO, head.dump() + "\n" + result.output);
}

std::string withoutArgument(Json request) {
  request.erase("argument");
  return textOf(request);
}

// Reader of the lines of a file descriptor.
class Lines {
 public:
  explicit Lines(int descriptor) : descriptor_(descriptor) {}

  std::optional<std::string> next() {
    char buffer[65536];
    for (;;) {
      if (size_t end = text_.find('\n', searched_); end != std::string::npos) {
        std::string line = text_.substr(0, end);
        text_.erase(0, end + 1);
        searched_ = 0;
        return line;
      }
      searched_ = text_.size();
      ssize_t got = ::read(descriptor_, buffer, sizeof buffer);
      if (got < 0 && errno == EINTR) continue;
      if (got > 0) text_.append(buffer, static_cast<size_t>(got));
      if (got > 0) continue;
      if (text_.empty()) return std::nullopt;
      searched_ = 0;
      return std::exchange(text_, {});
    }
  }

 private:
  int descriptor_;
  std::string text_;
  size_t searched_ = 0;
};

// A process that has loaded the data that requests share. It answers each request in a forked copy.
class Loader {
 public:
  // False if the data could not be loaded.
  bool start(int number, const Json& request, double wall_s, const Answering& answering) {
    int asks[2], says[2];
    if (::pipe2(asks, O_CLOEXEC) != 0 || ::pipe2(says, O_CLOEXEC) != 0) ::_exit(1);
    pid_t loader = ::fork();
    if (loader < 0) ::_exit(1);
    if (loader == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      ::close(asks[1]), ::close(says[0]);
      std::optional<std::string> shared = answering.load(request);
      if (!shared) ::_exit(1);
      Json head = {{"loaded", number}, {"shared", shared->size()}};
      writeAll(STDOUT_FILENO, head.dump() + "\n" + *shared);
      writeAll(says[1], "+");
      Lines lines(asks[0]);
      while (std::optional<std::string> line = lines.next()) {
        send(forked(Json::parse(*line), wall_s, answering.evaluate), number);
        writeAll(says[1], "+");
      }
      ::_exit(0);
    }
    ::close(asks[0]), ::close(says[1]);
    asks_ = asks[1], says_ = says[0];
    if (isDone()) return true;
    ::close(asks_), ::close(says_);
    while (::waitpid(loader, nullptr, 0) < 0 && errno == EINTR) continue;
    return false;
  }

  // False if the process ended without an answer.
  bool answer(const Json& request) {
    writeAll(asks_, textOf(request) + "\n");
    return isDone();
  }

 private:
  bool isDone() {
    char done = 0;
    while (::read(says_, &done, 1) < 0 && errno == EINTR) continue;
    return done == '+';
  }

  int asks_ = -1, says_ = -1;
};

// ---- in the parent

// Parser of the output of a child as it arrives: a line of JSON and its bytes, per answer.
class Arriving {
 public:
  Arriving(size_t count, std::map<int, std::shared_ptr<const std::string>>& loaded) : count_(count), loaded_(loaded) {}

  // Parses the output received so far. True if all answers are complete, or if the output is damaged.
  bool take(const std::string& text) {
    while (answers.size() < count_ && takeOne(text)) continue;
    return answers.size() == count_ || is_damaged_;
  }

  std::vector<Answer> answers;

 private:
  bool takeOne(const std::string& text) {
    const size_t end = text.find('\n', at_);
    if (is_damaged_ || end == std::string::npos) return false;
    const Json head = Json::parse(text.begin() + ptrdiff_t(at_), text.begin() + ptrdiff_t(end), nullptr, false);
    is_damaged_ = !head.is_object();
    if (is_damaged_) return false;
    const bool is_shared = head.contains("shared");
    const size_t bytes = head.at(is_shared ? "shared" : "bytes").get<size_t>();
    if (text.size() - end - 1 < bytes) return false;
    std::string body = text.substr(end + 1, bytes);
    at_ = end + 1 + bytes;
    const int loaded = head.at("loaded").get<int>();
    if (is_shared) {
      loaded_[loaded] = std::make_shared<const std::string>(std::move(body));
      return true;
    }
    ProgramEnd result;
    result.exit_status = head.at("exit_status").get<int>();
    result.signal = head.at("signal").get<int>();
    result.timed_out = head.at("timed_out").get<bool>();
    result.too_long = head.at("too_long").get<bool>();
    result.output = std::move(body);
    auto shared = loaded_.find(loaded);
    answers.push_back({std::move(result), shared == loaded_.end() ? nullptr : shared->second, false});
    return true;
  }

  size_t count_;
  std::map<int, std::shared_ptr<const std::string>>& loaded_;
  size_t at_ = 0;
  bool is_damaged_ = false;
};

}  // namespace

std::vector<Answer> Children::ask(Child& child, const std::vector<Json>& requests) const {
  const Json batch = {{"batch", requests}, {"wall_s", limits_.wall_s}};
  Arriving arriving(requests.size(), child.loaded);
  ProgramEnd lost = child.program.ask(textOf(batch) + "\n", limits_.wall_s * double(requests.size() + 1),
                                      [&](const std::string& text) { return arriving.take(text); });
  child.is_lost = arriving.answers.size() < requests.size();
  lost.output.clear();  // the output does not belong to the missing answers
  arriving.answers.resize(requests.size(), {lost, nullptr, true});
  return std::move(arriving.answers);
}

std::vector<std::vector<size_t>> Children::dealt(const std::vector<Json>& requests, size_t shares) {
  constexpr double kLoad = 3.0;  // cost of loading a file, in requests
  std::vector<std::vector<size_t>> result(shares);
  std::vector<double> work(shares, 0.0);
  for (size_t i = 0; i < requests.size(); ++i) {
    const std::string needed = withoutArgument(requests[i]);
    auto workWith = [&](size_t k) { return work[k] + (children_[k]->asked_for.count(needed) ? 1.0 : 1.0 + kLoad); };
    size_t least = 0;
    for (size_t k = 1; k < shares; ++k)
      if (workWith(k) < workWith(least)) least = k;
    work[least] = workWith(least);
    children_[least]->asked_for.insert(needed);
    result[least].push_back(i);
  }
  return result;
}

std::vector<Answer> Children::answers(const std::vector<Json>& requests) {
  const size_t shares = std::min<size_t>(std::max(1u, std::thread::hardware_concurrency()), requests.size());
  std::erase_if(children_, [](const std::unique_ptr<Child>& child) { return child->is_lost; });
  while (children_.size() < shares) children_.push_back(std::make_unique<Child>(startedChild(program_, limits_)));
  const std::vector<std::vector<size_t>> shared_out = dealt(requests, shares);
  std::vector<std::future<std::vector<Answer>>> running;
  for (size_t k = 0; k < shares; ++k) {
    std::vector<Json> own;
    for (size_t i : shared_out[k]) own.push_back(requests[i]);
    running.push_back(std::async(std::launch::async, [&, k, own = std::move(own)] { return ask(*children_[k], own); }));
  }
  std::vector<Answer> results(requests.size());
  for (size_t k = 0; k < shares; ++k) {
    std::vector<Answer> some = running[k].get();
    for (size_t i = 0; i < some.size(); ++i) results[shared_out[k][i]] = std::move(some[i]);
  }
  return results;
}

// ---- in the child

static Lines& input() {
  static Lines lines(STDIN_FILENO);
  return lines;
}

std::optional<std::string> readLine() { return input().next(); }

void answerBatches(std::string line, const Answering& answering) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::map<std::string, std::optional<Loader>> loaders;  // by request without argument; empty if loading failed
  for (std::optional<std::string> next = std::move(line); next; next = readLine()) {
    const Json batch = Json::parse(*next);
    const double wall_s = batch.at("wall_s").get<double>();
    for (const Json& request : batch.at("batch")) {
      if (!answering.loads(request)) {
        send(forked(request, wall_s, answering.evaluate), -1);
        continue;
      }
      auto [known, is_new] = loaders.try_emplace(withoutArgument(request));
      std::optional<Loader>& loader = known->second;
      if (is_new && !loader.emplace().start(int(loaders.size()), request, wall_s, answering)) loader.reset();
      if (!loader) send(forked(request, wall_s, answering.evaluate), -1);
      else if (!loader->answer(request)) ::_exit(1);
    }
  }
  ::_exit(0);
}

}  // namespace strobe::script
