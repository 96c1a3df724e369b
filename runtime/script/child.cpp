// SPDX-License-Identifier: MIT
// The child process: one evaluation, then the answer on stdout.
#include <malloc.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>

#include "base/hash.h"
#include "base/json_text.h"
#include "script/batch.h"
#include "script/evaluate.h"
#include "script/process.h"
#include "script/sandbox.h"

namespace strobe::script {

namespace {

// State for the signal handler and its hook, which have no argument for it.
Sandbox* g_sandbox = nullptr;
Json g_roots;            // roots of the sandbox's home folder
size_t g_memory_mb = 0;  // memory limit of the sandbox
double g_cpu_s = 0;
bool g_has_task = false;
bool g_loading = false;     // loading only: no request to answer yet
bool g_names_files = true;  // the answer has the list of files

[[noreturn]] void answer(const Json& json) {
  std::string text = textOf(json);
  for (size_t done = 0; done < text.size();) {
    ssize_t written = ::write(STDOUT_FILENO, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) break;
    if (written > 0) done += static_cast<size_t>(written);
  }
  ::_exit(0);
}

Json filesJson(const Sandbox& sandbox) {
  Json files = Json::array();
  if (!g_names_files) return files;
  for (const Dependency& file : sandbox.files()) {
    files.push_back({{"path", file.path.string()}, {"shown", file.shown}, {"hash", file.hash}});
  }
  return files;
}

Json problemJson(const Problem& problem) {
  return {{"file", problem.place.file}, {"line", problem.place.line}, {"message", problem.message}};
}

// Lua hook, called at an instruction of the script after its processor time is used up.
void stopEndlessScript(lua_State* lua, lua_Debug*) {
  if (g_loading) ::_exit(1);
  const char* text = "stopped: more than {} s of processor time (the limit for a script); endless loop?";
  Problem problem{Sandbox::userPlace(lua, 0), fmt::format(fmt::runtime(text), g_cpu_s)};
  answer({{"errors", {problemJson(problem)}}, {"files", filesJson(*g_sandbox)}});
}

void onTimer(int) {
  lua_sethook(g_sandbox->state(), stopEndlessScript, LUA_MASKCALL | LUA_MASKRET | LUA_MASKLINE | LUA_MASKCOUNT, 1);
}

// Starts the processor time limit that reports a line. The wider limit of the process ends it without a line.
void startTimer(double cpu_s) {
  struct sigaction action {};
  action.sa_handler = onTimer;
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGPROF, &action, nullptr);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(cpu_s);
  timer.it_value.tv_usec = static_cast<suseconds_t>((cpu_s - std::floor(cpu_s)) * 1e6);
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

// Stops the timer after loading: the process then waits for any number of requests.
void stopTimer() {
  const itimerval none{};
  ::setitimer(ITIMER_PROF, &none, nullptr);
  lua_sethook(g_sandbox->state(), nullptr, 0, 0);
}

// Makes a sandbox with the requested roots and memory limit, or keeps the present one if it has these.
void makeSandbox(const Json& asked) {
  Json roots = asked.at("roots");
  const size_t memory_mb = asked.at("memory_mb").get<size_t>();
  if (g_sandbox && roots == g_roots && memory_mb == g_memory_mb) return;
  g_sandbox = new Sandbox(Home(roots.get<std::vector<Path>>()), memory_mb << 20);
  g_roots = std::move(roots);
  g_memory_mb = memory_mb;
}

// The sandbox of this process. A process runs one evaluation at a time.
Sandbox& sandboxFor(const Json& request) {
  g_cpu_s = request.at("cpu_s").get<double>();
  g_names_files = request.at("names_files").get<bool>();
  if (!g_has_task) {
    makeSandbox(request);
    Sandbox::Task task;
    task.main = request.at("main").get<std::string>();
    task.shown = request.at("shown").get<std::string>();
    task.own_folder = request.at("own_folder").get<bool>();
    task.preset = request.value("preset", "");
    task.preset_shown = request.value("preset_shown", "");
    task.texts = request.at("texts").get<std::map<std::string, std::string>>();
    g_sandbox->setTask(std::move(task));
    g_has_task = true;
  }
  startTimer(g_cpu_s);
  return *g_sandbox;
}

// Files of pipelines only can be loaded in advance, because their contents do not depend on settings.
bool loads(const Json& request) { return request.at("function") == "pipeline"; }

std::optional<std::string> load(const Json& request) {
  g_loading = true;
  Json passes;
  bool loaded = sandboxFor(request).run("load", {}, passes);
  stopTimer();
  g_loading = false;
  if (!loaded) return std::nullopt;
  g_sandbox->prepareSources();
  return textOf(passes);
}

// Touches the memory pages that a request will need, so that the system maps them now and the allocator keeps them.
void touchMemory() {
  constexpr size_t kBytes = size_t{8} << 20;
  ::mallopt(M_MMAP_THRESHOLD, int(2 * kBytes));
  ::mallopt(M_TRIM_THRESHOLD, int(2 * kBytes));
  auto* pages = static_cast<char*>(std::malloc(kBytes));
  for (size_t at = 0; pages && at < kBytes; at += 4096) static_cast<volatile char&>(pages[at]) = 0;
  std::free(pages);
}

// Prepares this process for a request announced by `expectChildren`.
void readAhead(const Json& asked) {
  makeSandbox(asked);
  for (const Json& file : asked.at("ahead"))
    g_sandbox->readAhead(file.at("path").get<std::string>(), file.at("shown").get<std::string>());
  touchMemory();
}

std::string hashOfData(const Json& json) {
  const std::vector<uint8_t> bytes = Json::to_msgpack(json);
  return hashBytes(bytes.data(), bytes.size());
}

// Hashes of the passes and parameters of a pipeline. Passes and parameters that are in `known` are removed from
// `pipeline`: a pass becomes its number, as in `load` of run.lua.
Json withoutKnown(Json& pipeline, const Json& known) {
  const auto passes = known.at("passes").get<std::vector<std::string>>();
  Json hashes = {{"passes", Json::array()}, {"params", hashOfData(pipeline.at("params"))}};
  for (Json& pass : pipeline.at("passes")) {
    std::string hash = hashOfData(pass);
    auto found = std::find(passes.begin(), passes.end(), hash);
    if (found != passes.end()) pass = found - passes.begin() + 1;
    hashes["passes"].push_back(std::move(hash));
  }
  if (hashes["params"] == known.at("params")) pipeline.erase("params");
  return hashes;
}

void evaluate(const Json& request) {
  Sandbox& sandbox = sandboxFor(request);
  Json result;
  if (sandbox.run(request.at("function").get<std::string>(), request.at("argument"), result)) {
    Json answered = {{"files", filesJson(sandbox)}};
    if (request.contains("known")) answered["hashes"] = withoutKnown(result, request["known"]);
    answered["result"] = std::move(result);
    answer(answered);
  }
  if (sandbox.outOfMemory()) answer({{"out_of_memory", true}, {"files", filesJson(sandbox)}});
  Json errors = Json::array();
  for (const Problem& problem : sandbox.problems()) errors.push_back(problemJson(problem));
  answer({{"errors", errors}, {"files", filesJson(sandbox)}});
}

}  // namespace

void runScriptChild() {
  // At the limit of the address space even destructors may fail to allocate memory, so the process ends at once.
  std::set_new_handler([] { ::_exit(kOutOfMemory); });
  try {
    std::optional<std::string> line = readLine();
    if (!line) ::_exit(0);  // the parent sent no request
    Json request = Json::parse(*line);
    if (request.contains("ahead")) {
      readAhead(request);
      line = readLine();
      if (!line) ::_exit(0);
      request = Json::parse(*line);
    }
    if (request.contains("batch")) answerBatches(std::move(*line), {evaluate, loads, load});
    evaluate(request);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "script child: %s\n", error.what());
  }
  ::_exit(1);
}

}  // namespace strobe::script
