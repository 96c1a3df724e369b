// SPDX-License-Identifier: MIT
#include "study/processes.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <optional>

#include "base/log.h"
#include "study/point_renderer.h"
#include "study/watch.h"

namespace strobe::study {

namespace {

// State shared by all processes; each process takes the next group.
struct Shared {
  std::atomic<size_t> next = 0;
  std::atomic<int> cost = 0, cost_done = 0;
  std::atomic<bool> outlined = false;
};

[[noreturn]] void renderShare(const Experiment& experiment, const MakeBench& make, const Store& store,
                              const Started& started, Shared& shared) {
  int code = 0;
  try {
    std::unique_ptr<lab::Workbench> bench = make();
    lab::Batch batch(*bench);
    std::vector<TaskGroup> groups = tasksOf(experiment, batch);
    if (!shared.outlined.exchange(true)) {
      Results outline = outlineOf(experiment, groups, batch);
      started(outline);
      takePoints(outline, store.folder());
      announce(outline);
      shared.cost = leftOf(groups, store).cost;
    }
    PointRenderer renderer(experiment, batch, store);
    for (size_t i; (i = shared.next++) < groups.size();)
      renderer.render(groups[i], [&](int by) { shared.cost_done += by; });
    bench->device().refuseMessages();
  } catch (const std::exception& error) {
    warn(error.what());
    code = 1;
  }
  ::_exit(code);
}

// Removes the children that have ended; true if each of these succeeded. Does not wait for other children of this
// process.
bool reapEnded(std::vector<pid_t>& children) {
  bool good = true;
  std::erase_if(children, [&good](pid_t child) {
    int status = 0;
    pid_t ended = ::waitpid(child, &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
    if (ended > 0 && WIFSIGNALED(status))
      warn(fmt::format("process {} of the sweep was ended by signal {} ({})", child, WTERMSIG(status),
                       ::strsignal(WTERMSIG(status))));
    good = good && ended > 0 && status == 0;
    return true;
  });
  return good;
}

}  // namespace

bool renderInProcesses(const Experiment& experiment, const MakeBench& make, const Store& store, int jobs,
                       const Started& started, const std::function<Results()>& now) {
  void* memory = ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error("cannot allocate memory for several processes");
  Shared& shared = *new (memory) Shared;
  std::vector<pid_t> children;
  for (int i = 0; i < jobs; ++i) {
    pid_t child = ::fork();
    if (child == 0) {
      ::prctl(PR_SET_PDEATHSIG, SIGKILL);
      renderShare(experiment, make, store, started, shared);
    }
    if (child > 0) children.push_back(child);
    else warn(fmt::format("process {} of {} cannot be started: {}", i + 1, jobs, std::strerror(errno)));
  }
  bool good = children.size() == size_t(jobs);
  std::optional<Watch> watch;
  for (int shown = 0; !children.empty();) {
    if (!watch && shared.cost > 0) watch.emplace(now).begin("drawing", shared.cost);
    int done = shared.cost_done;
    if (watch) watch->advance(done - shown), shown = done;
    const size_t running = children.size();
    good = reapEnded(children) && good;
    if (children.size() == running) ::usleep(100000);
  }
  if (watch) watch->end();
  ::munmap(memory, sizeof(Shared));
  return good;
}

}  // namespace strobe::study
