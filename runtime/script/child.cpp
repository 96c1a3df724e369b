// SPDX-License-Identifier: MIT
// The processes of a script server. The first process compiles scripts but runs none, so that a script cannot harm it.
// It forks a process for each request, or a loader for each pipeline file: a process that has run the file, and forks
// for each request for the file.
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <list>
#include <map>
#include <new>
#include <sstream>
#include <utility>

#include "base/error.h"
#include "base/json_text.h"
#include "script/channel.h"
#include "script/evaluate.h"
#include "script/sandbox.h"
#include "script/server.h"

namespace strobe::script {

namespace {

constexpr int kControl = STDIN_FILENO;  // messages to and from the process that started this one
constexpr int kConnection = 3;          // in a forked process: the request, and its answer

// State for signal handlers and Lua hooks, which have no argument for it. A process runs one evaluation at a time.
Sandbox* g_sandbox = nullptr;
double g_cpu_s = 0;

// ---- one request

[[noreturn]] void answer(const Json& json) {
  std::string text = textOf(json);
  for (size_t done = 0; done < text.size();) {
    ssize_t written = ::write(kConnection, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) break;
    if (written > 0) done += static_cast<size_t>(written);
  }
  ::_exit(0);
}

Json filesJson() {
  Json files = Json::array();
  for (const Dependency& file : g_sandbox->files())
    files.push_back({{"path", file.path.string()}, {"shown", file.shown}, {"hash", file.hash}});
  return files;
}

Json problemJson(const Problem& problem) {
  return {{"file", problem.place.file}, {"line", problem.place.line}, {"message", problem.message}};
}

// Lua hook, called at an instruction of the script after its processor time is used up.
void stopEndlessScript(lua_State* lua, lua_Debug*) {
  const char* text = "stopped: more than {} s of processor time (the limit for a script); endless loop?";
  Problem problem{Sandbox::userPlace(lua, 0), fmt::format(fmt::runtime(text), g_cpu_s)};
  answer({{"errors", {problemJson(problem)}}, {"files", filesJson()}});
}

void onTimer(int) {
  lua_sethook(g_sandbox->state(), stopEndlessScript, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

void setTimer(int which, double seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(seconds);
  timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - std::floor(seconds)) * 1e6);
  ::setitimer(which, &timer, nullptr);
}

// Sets a limit that this process can lift again.
void setLimit(int resource, rlim_t value) {
  rlimit limits{};
  ::getrlimit(resource, &limits);
  limits.rlim_cur = std::min(value, limits.rlim_max);
  ::setrlimit(resource, &limits);
}

// Starts the limits of a request. The limit of the sandbox's processor time reports a line. The wider limits of the
// process end calls that do not return to Lua's loop (a long library call).
void startLimits(const Json& request) {
  g_cpu_s = request.at("cpu_s").get<double>();
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // these need an unlimited address space
  setLimit(RLIMIT_AS, request.at("memory_mb").get<rlim_t>() << 21);
#endif
  setLimit(RLIMIT_CPU, rlim_t(std::ceil(g_cpu_s + 0.25)));
  struct sigaction action {};
  action.sa_handler = onTimer;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGPROF, &action, nullptr);
  setTimer(ITIMER_PROF, g_cpu_s);
  setTimer(ITIMER_REAL, request.at("wall_s").get<double>());
}

void liftLimits() {
  setTimer(ITIMER_PROF, 0);
  setTimer(ITIMER_REAL, 0);
  lua_sethook(g_sandbox->state(), nullptr, 0, 0);
  setLimit(RLIMIT_AS, RLIM_INFINITY);
  setLimit(RLIMIT_CPU, RLIM_INFINITY);
}

Json readRequest() {
  std::string text;
  char buffer[65536];
  for (;;) {
    const ssize_t got = ::read(kConnection, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0 && text.empty()) ::_exit(0);  // the program has ended
    if (got <= 0) return Json::parse(text);
    text.append(buffer, static_cast<size_t>(got));
  }
}

void setTask(const Json& request) {
  Sandbox::Task task;
  task.main = request.at("main").get<std::string>();
  task.shown = request.at("shown").get<std::string>();
  task.own_folder = request.at("own_folder").get<bool>();
  task.preset = request.value("preset", "");
  task.preset_shown = request.value("preset_shown", "");
  task.texts = request.at("texts").get<std::map<std::string, std::string>>();
  task.memory_bytes = request.at("memory_mb").get<size_t>() << 20;
  g_sandbox->setTask(std::move(task));
}

// Result of a function of run.lua. Its mistakes are the answer to the request.
Json resultOf(const std::string& function, const Json& argument) {
  Json result;
  if (g_sandbox->run(function, argument, result)) return result;
  if (g_sandbox->outOfMemory()) answer({{"out_of_memory", true}, {"files", filesJson()}});
  Json errors = Json::array();
  for (const Problem& problem : g_sandbox->problems()) errors.push_back(problemJson(problem));
  answer({{"errors", errors}, {"files", filesJson()}});
}

// Descriptions that requests for a loaded file have in common, as texts.
struct LoadedTexts {
  std::vector<std::string> passes;
  std::string params;
};

[[noreturn]] void evaluate(const Json& request, const LoadedTexts& loaded = {}) {
  setTask(request);
  startLimits(request);
  const std::string function = request.at("function").get<std::string>();
  Json result = resultOf(function, request.at("argument"));
  if (function == "pipeline") {
    for (Json& pass : result.at("passes"))
      pass = pass.is_number() ? loaded.passes.at(pass.get<size_t>() - 1) : textOf(pass);
    result["params"] = result.contains("params") ? textOf(result["params"]) : loaded.params;
  }
  answer({{"files", filesJson()}, {"result", std::move(result)}});
}

// ---- processes for many requests

std::map<pid_t, int> g_running;  // connections of the processes that evaluate requests

// Forks a process that answers on `connection`. Returns 0 in this process. `control`, if given, is its end of a channel
// to the present process.
pid_t forked(int connection, int control = -1) {
  const pid_t process = ::fork();
  if (process > 0) g_running[process] = connection;
  if (process < 0) ::close(connection);
  if (process != 0) return process;
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (control >= 0) ::dup2(control, kControl);
  ::dup2(connection, kConnection);
  ::closefrom(kConnection + 1);
  g_running.clear();
  return 0;
}

// Appends the status of each process that has ended to its answer.
void sendStatus() {
  int status = 0;
  for (pid_t ended = 0; (ended = ::waitpid(-1, &status, WNOHANG)) > 0;) {
    auto found = g_running.find(ended);
    if (found == g_running.end()) continue;
    ::dprintf(found->second, "\n%d", status);
    ::close(found->second);
    g_running.erase(found);
  }
}

// Waits for a message on one of the sockets, or for the end of a process. Returns the sockets with messages.
std::vector<int> waitFor(const std::vector<int>& sockets) {
  std::vector<pollfd> waiting;
  for (int socket : sockets) waiting.push_back({socket, POLLIN, 0});
  sigset_t none;
  ::sigemptyset(&none);
  const int ready = ::ppoll(waiting.data(), waiting.size(), nullptr, &none);
  sendStatus();
  std::vector<int> result;
  for (const pollfd& one : waiting)
    if (ready > 0 && one.revents) result.push_back(one.fd);
  return result;
}

// Text of the message that files are loaded: a line, then two lines per file. A message has room for 1,000 files.
std::string namesOfFiles() {
  constexpr size_t kMost = size_t{1} << 17;
  std::string text = "files";
  for (const Dependency& file : g_sandbox->files())
    if (text.size() < kMost) text += fmt::format("\n{}\n{}", file.path.string(), file.shown);
  return text;
}

// Runs the file of the request on `kConnection`. Then answers this request and all further ones in forked processes. A
// request after a change of a loaded file goes back to the server.
[[noreturn]] void load() {
  const Json first = readRequest();
  setTask(first);
  startLimits(first);
  const Json common = resultOf("load", {});
  liftLimits();
  LoadedTexts loaded{{}, textOf(common.at("params"))};
  for (const Json& pass : common.at("passes")) loaded.passes.push_back(textOf(pass));
  g_sandbox->prepareSources();
  sendMessage(kControl, {namesOfFiles()});
  if (forked(kConnection) == 0) evaluate(first, loaded);
  for (bool more = true; more || !g_running.empty();) {
    if (waitFor(more ? std::vector{kControl} : std::vector<int>()).empty()) continue;
    std::optional<Message> message = receiveMessage(kControl);
    more = message.has_value();
    if (!more) continue;
    const bool current = g_sandbox->stamps().current();
    if (current && forked(message->file) == 0) evaluate(readRequest(), loaded);
    if (current) continue;
    sendMessage(kControl, *message);
    ::close(message->file);
  }
  ::_exit(0);
}

// The first process.
class Server {
 public:
  [[noreturn]] void serve() {
    for (;;) {
      std::vector<int> sockets = {kControl};
      for (const Loader& loader : loaders_) sockets.push_back(loader.channel);
      for (int socket : waitFor(sockets)) {
        std::optional<Message> message = receiveMessage(socket);
        if (socket != kControl) take(socket, std::move(message));
        else if (message) dispatch(message->text, message->file);
        else ::_exit(0);  // the program has ended
      }
    }
  }

 private:
  struct Loader {
    std::string file;  // "": no more requests for this process
    int channel = -1;
    pid_t process = -1;
    bool is_ready = false;
    std::vector<Message> waiting = {};  // requests until the file is loaded
  };

  static void evaluateAlone(int connection) {
    if (forked(connection) == 0) evaluate(readRequest());
  }

  void dispatch(const std::string& file, int connection) {
    if (file == kNoFile) return evaluateAlone(connection);
    auto loader = std::find_if(loaders_.begin(), loaders_.end(), [&](const Loader& one) { return one.file == file; });
    if (loader == loaders_.end()) return start(file, connection);
    loaders_.splice(loaders_.end(), loaders_, loader);
    if (loader->is_ready) forward(*loader, {file, connection});
    else loader->waiting.push_back({file, connection});
  }

  void start(const std::string& file, int connection) {
    constexpr size_t kMost = 64;
    if (loaders_.size() >= kMost) retire(loaders_.front());
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) return evaluateAlone(connection);
    const pid_t process = forked(connection, ends[1]);
    if (process == 0) load();
    ::close(ends[1]);
    loaders_.push_back({file, ends[0], process});
  }

  static void forward(Loader& loader, const Message& message) {
    if (!sendMessage(loader.channel, message)) return evaluateAlone(message.file);
    ::close(message.file);
  }

  // Sends no more requests to the process, which ends after the last one.
  static void retire(Loader& loader) {
    ::shutdown(loader.channel, SHUT_WR);
    loader.file.clear();
  }

  // Message of a loader: the end of the process, a request that it refuses because a file has changed, or the files
  // that it has loaded.
  void take(int channel, std::optional<Message> message) {
    auto loader =
        std::find_if(loaders_.begin(), loaders_.end(), [&](const Loader& one) { return one.channel == channel; });
    if (loader == loaders_.end()) return;
    if (!message) {
      ::close(channel);
      for (const Message& one : loader->waiting) evaluateAlone(one.file);
      loaders_.erase(loader);
    } else if (message->file >= 0) {
      retire(*loader);
      dispatch(message->text, message->file);
    } else {
      loader->is_ready = true;
      // The loader sends the status of its first request too.
      if (const auto first = g_running.extract(loader->process)) ::close(first.mapped());
      for (const Message& one : std::exchange(loader->waiting, {})) forward(*loader, one);
      compile(message->text);
    }
  }

  // Compiles loaded files, for loaders that follow.
  static void compile(const std::string& files) {
    std::istringstream lines(files);
    std::string path, shown;
    std::getline(lines, shown);
    while (std::getline(lines, path) && std::getline(lines, shown)) g_sandbox->compileAhead(path, shown);
  }

  std::list<Loader> loaders_;  // least recently used first
};

void prepareSignals() {
  sigset_t mask;
  ::sigemptyset(&mask);
  ::sigaddset(&mask, SIGCHLD);
  ::sigprocmask(SIG_SETMASK, &mask, nullptr);
  ::signal(SIGCHLD, [](int) {});  // ends `ppoll`
  ::signal(SIGPIPE, SIG_IGN);
  setLimit(RLIMIT_CORE, 0);
}

}  // namespace

void runScriptChild(int argc, char** argv) {
  // At the limit of the address space even destructors may fail to allocate memory, so the process ends at once.
  std::set_new_handler([] { ::_exit(kOutOfMemory); });
  try {
    prepareSignals();
    g_sandbox = new Sandbox(Home(std::vector<Path>(argv + 2, argv + argc)));
    Server().serve();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "script child: %s\n", error.what());
  }
  ::_exit(1);
}

}  // namespace strobe::script
