// SPDX-License-Identifier: MIT
#include "lab/reload_bench.h"

#include <unistd.h>

#include <algorithm>
#include <thread>

#include "base/log.h"
#include "math/statistics.h"
#include "page/table.h"

namespace strobe::lab {

namespace {

// An edit that puts a new number into a file.
struct EditKind {
  std::string what;
  std::string file;
  std::string line;   // inserted line; {} is the number
  std::string after;  // text before the inserted line; "" for the end of the file
};

std::vector<EditKind> kindsFor(const Session& session) {
  // Edits: the shader of the last pass in the plan, the library that most shaders share, the script of that pass, and
  // the script of the pipeline.
  const plan::Plan& plan = session.plan();
  const Home& home = session.bench().home();
  const plan::PassDesc& last = plan.passOf(plan.nodes.back());
  std::map<std::string, int> uses;
  for (const auto& [node, pipeline] : session.running().graph().pipelines())
    for (const auto& [file, hash] : pipeline->sources)
      if (std::string name = Home::withoutRoot(home.shown(file));
          name.starts_with("shaders/lib/") || name.starts_with("shaders/mixin/"))
        ++uses[home.shown(file)];
  auto most =
      std::max_element(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<EditKind> kinds = {{"shader of one pass", home.shown(graph::shaderFiles(home, last).front()),
                                  "\n  if (frame.frame == {}u) return;\n", ") {"}};
  if (most != uses.end())
    kinds.push_back({fmt::format("shader library of {} passes", most->second), most->first,
                     "\nconst int kTouched = {};\n", "#define"});
  kinds.push_back({"declaration of a pass", last.place.file, "\n-- {}\n", ""});
  kinds.push_back({"pipeline", plan.pipeline.file, "\n-- {}\n", ""});
  std::erase_if(kinds,
                [&](const EditKind& kind) { return !home.nameOf(home.fileShown(kind.file)); });  // not in the copy
  return kinds;
}

ReloadTiming once(Session& session, const EditKind& kind, int number) {
  Path file = session.bench().home().fileShown(kind.file);
  std::string good = readText(file);
  std::string line = fmt::format(fmt::runtime(kind.line), number);
  // The edited function `run` is the last function of a shader. In a library the line follows the first #define.
  size_t at = kind.after.empty()        ? good.size()
              : kind.after == "#define" ? good.find('\n', good.find(kind.after))
                                        : good.find(kind.after, good.rfind("void run(")) + 3;
  // Draw and wait, as a window does between two edits.
  std::set<std::string> wanted = {"color"};
  session.reload(false);
  session.draw(&wanted);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  writeFileAtomically(file, std::string(good).insert(at, line));
  double saved_s = clockSeconds();
  std::optional<Reload> told;
  while (!(told = session.reload(false))) std::this_thread::sleep_for(std::chrono::microseconds(500));
  double told_s = clockSeconds();
  if (!told->problems.empty()) throw Error(told->problems.front());
  session.draw(&wanted);
  double first_s = clockSeconds();
  session.draw(&wanted);
  double second_s = clockSeconds();
  writeFileAtomically(file, good);
  session.reload(true);
  session.draw(&wanted);

  ReloadTiming timing{kind.what,
                      0,
                      told->evaluate_ms,
                      told->compile_ms,
                      told->build_ms,
                      1000 * (first_s - told_s),
                      1000 * (second_s - first_s)};
  timing.watch = 1000 * (told_s - saved_s) - told->evaluate_ms - told->compile_ms - told->build_ms;
  return timing;
}

ReloadTiming medianOf(const std::vector<ReloadTiming>& all) {
  ReloadTiming result = all.front();
  for (double ReloadTiming::*part : {&ReloadTiming::watch, &ReloadTiming::evaluate, &ReloadTiming::compile,
                                     &ReloadTiming::build, &ReloadTiming::first_frame, &ReloadTiming::later_frame}) {
    std::vector<double> values;
    for (const ReloadTiming& one : all) values.push_back(one.*part);
    result.*part = median(values);
  }
  return result;
}

}  // namespace

std::vector<ReloadTiming> benchReload(Workbench& bench, const Shot& shot, int repeats) {
  Session session(bench, shot);
  session.reload(true);
  session.draw();
  std::vector<ReloadTiming> timings;
  // The number differs from other runs. Otherwise the shader cache of the driver on disk would shorten the first frame.
  int number = int(::getpid()) * 1000;
  for (const EditKind& kind : kindsFor(session)) {
    std::vector<ReloadTiming> all;
    for (int i = 0; i < repeats; ++i) all.push_back(once(session, kind, ++number % 2000000000));
    timings.push_back(medianOf(all));
  }
  return timings;
}

std::string tableOf(const std::vector<ReloadTiming>& timings) {
  page::Table table{"", {"edited"}};
  for (const char* part : {"watch", "evaluate", "compile", "build", "first frame", "later frame", "added"})
    table.columns.push_back({part, true});
  for (const ReloadTiming& t : timings) {
    table.add({t.edit});
    for (double ms : {t.watch, t.evaluate, t.compile, t.build, t.first_frame, t.later_frame})
      table.rows.back().push_back(fmt::format("{:.1f}", ms));
    table.rows.back().push_back({fmt::format("{:.1f}", t.added()), page::Emphasis::best});
  }
  return page::markdownOf(table);
}

}  // namespace strobe::lab
