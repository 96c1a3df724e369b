// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>

#include "app/commands.h"
#include "app/files.h"
#include "app/numbers.h"
#include "app/shot_options.h"
#include "base/log.h"
#include "bench/measure.h"
#include "bench/report.h"

namespace strobe::app {

namespace {

struct FramesOptions {
  ShotOptions shot;
  std::vector<std::string> methods;
  lab::Rounds rounds{15, 100, 0};
  std::string out, save, against;
  double moved = 0.05;
  int blocks = 8;
  size_t in_flight = 0;  // 0: chosen by the device
  bool json = false;
};

// Shot options that may be given several times.
const std::set<std::string> kSeveral = {"scene", "size"};
constexpr const char* kUsualSize = "320x180";

// ---- command line

void requireDifferent(const std::string& what, const std::vector<std::string>& texts) {
  std::set<std::string> seen;
  for (const std::string& text : texts)
    if (!seen.insert(text).second) throw Error(fmt::format("{} '{}' is given twice", what, text), {}, 2);
}

// Pipelines without blur first: the first is the base of the others.
std::vector<std::string> shippedMethods(const Home& home) {
  std::vector<std::string> names;
  for (plan::PipelineDesc::Kind kind : {plan::PipelineDesc::Kind::Sharp, plan::PipelineDesc::Kind::Method})
    for (const std::string& name : script::pipelinesOfKind(home, kind)) names.push_back(name);
  return names;
}

bench::Subject subjectOf(const Home& home, FramesOptions& options) {
  bench::Subject subject;
  if (options.methods.empty()) options.methods = shippedMethods(home);
  subject.scenes = options.shot.given("scene");
  std::vector<std::string> sizes = options.shot.given("size");
  if (subject.scenes.empty()) subject.scenes = {lab::Shot().scene};
  if (sizes.empty()) sizes = {kUsualSize};
  requireDifferent("method", options.methods);
  requireDifferent("--scene", subject.scenes);
  requireDifferent("--size", sizes);
  for (const std::string& size : sizes) subject.sizes.push_back(lab::parseSize(size));
  for (const std::string& text : options.methods) subject.methods.push_back(bench::methodFrom(text));
  options.shot.pipeline = subject.methods.front().pipeline;
  subject.shot = options.shot.resolve();
  return subject;
}

lab::Rounds roundsOf(const FramesOptions& options) {
  lab::Rounds rounds = options.rounds;
  rounds.most = rounds.within > 0 ? std::max(rounds.least, rounds.most) : rounds.least;
  return rounds;
}

// Arguments that repeat the measurement, also with the program of another revision.
std::vector<std::string> wordsOf(const FramesOptions& options, const bench::Subject& subject) {
  std::vector<std::string> words = {"bench", "frames"};
  words.insert(words.end(), options.methods.begin(), options.methods.end());
  for (const std::string& scene : subject.scenes) words.push_back("--scene=" + scene);
  for (const auto& size : subject.sizes) words.push_back(fmt::format("--size={}x{}", size[0], size[1]));
  for (const std::string& word : options.shot.words(kSeveral)) words.push_back(word);
  words.push_back(fmt::format("--rounds={}", options.rounds.least));
  if (options.in_flight > 0) words.push_back(fmt::format("--in-flight={}", options.in_flight));
  return words;
}

// Command line that repeats the run.
std::string commandOf(const FramesOptions& options, const bench::Subject& subject) {
  std::string line = "strobe";
  for (const std::string& word : wordsOf(options, subject)) line += " " + lab::shellWord(word);
  if (options.rounds.within > 0)
    line += fmt::format(" --within={} --most-rounds={}", options.rounds.within, options.rounds.most);
  if (!options.against.empty()) line += " --against=" + lab::shellWord(options.against);
  return line;
}

bool isProgram(const std::string& file) {
  return std::filesystem::is_regular_file(file) && ::access(file.c_str(), X_OK) == 0;
}

void requireSound(const FramesOptions& options) {
  if (!options.out.empty()) requireWritable(options.out);
  if (!options.save.empty()) requireWritable(std::filesystem::absolute(options.save).parent_path(), "--save");
  if (options.against.empty()) return;
  if (!std::filesystem::is_regular_file(options.against))
    throw Error(fmt::format("--against '{}': file not found", options.against), {}, 2);
  if (isProgram(options.against) && options.rounds.within > 0)
    throw Error("--within cannot be used with a program in --against, where each of the --blocks has --rounds rounds",
                {}, 2);
}

// ---- measurement

// Runs and their comparison. `comparison` points into `run` or `turns.first`, which must stay in place.
struct MeasuredRun {
  bench::Run run;
  bench::Turns turns;
  std::optional<bench::TimeComparison> comparison;
};

void measureAlone(const Home& home, const FramesOptions& options, const bench::Subject& subject,
                  MeasuredRun& measured) {
  lab::Workbench bench(home, subject.shot.device, validationWanted());
  if (options.in_flight > 0) bench.frames_in_flight = options.in_flight;
  std::optional<bench::Run> saved;
  if (!options.against.empty()) {
    saved = bench::readRun(options.against);
    bench::requireSameShots(bench::outlineOf(bench, bench::shotsOf(subject)), *saved, options.against);
  }
  measured.run = bench::measure(bench, bench::shotsOf(subject), roundsOf(options));
  bench.device().refuseMessages();
  if (saved) measured.comparison = bench::compared(measured.run, *saved, options.moved);
}

void measureInTurn(const Home& home, const FramesOptions& options, const bench::Subject& subject,
                   MeasuredRun& measured) {
  bench::outlineOf(*std::make_unique<lab::Workbench>(home, subject.shot.device, false), bench::shotsOf(subject));
  std::vector<std::string> words = wordsOf(options, subject);
  words.push_back("--json");
  std::string own = std::filesystem::read_symlink("/proc/self/exe"), other = std::filesystem::absolute(options.against);
  measured.turns = bench::runInTurn(own, other, words, options.blocks,
                                    [&](int done) { note(fmt::format("block {} of {}", done, options.blocks)); });
  measured.run = bench::joined(measured.turns.first);
  measured.comparison = bench::compared(measured.turns.first, measured.turns.second, options.moved);
}

// ---- output

Json jsonOf(const MeasuredRun& measured) {
  Json json = bench::toJson(measured.run);
  if (!measured.comparison) return json;
  json["comparison"] = bench::toJson(*measured.comparison);
  if (!measured.turns.second.empty()) json["comparison"]["run"] = bench::toJson(bench::joined(measured.turns.second));
  return json;
}

std::vector<Path> write(const FramesOptions& options, const MeasuredRun& measured) {
  std::vector<Path> files;
  auto keep = [&](const Path& file, const std::string& text) {
    files.push_back(file);
    writeFileAtomically(file, text);
  };
  if (!options.save.empty()) keep(options.save, bench::toJson(measured.run).dump(1) + "\n");
  if (options.out.empty()) return files;
  const bench::TimeComparison* comparison = measured.comparison ? &*measured.comparison : nullptr;
  const Path folder = options.out;
  keep(folder / "index.html", page::htmlOf(bench::pageOf(measured.run, comparison)));
  keep(folder / "bench.json", jsonOf(measured).dump(1) + "\n");
  keep(folder / "trace.json", bench::traceOf(measured.run).dump() + "\n");
  return files;
}

void frames(const Home& home, FramesOptions options) {
  bench::Subject subject = subjectOf(home, options);
  requireSound(options);
  MeasuredRun measured;
  if (!options.against.empty() && isProgram(options.against)) measureInTurn(home, options, subject, measured);
  else measureAlone(home, options, subject, measured);
  measured.run.command = commandOf(options, subject);
  if (measured.comparison) measured.comparison->against = options.against;
  std::vector<Path> files = write(options, measured);
  if (options.json) {
    std::printf("%s\n", jsonOf(measured).dump(1).c_str());
    return;
  }
  std::fputs(bench::textOf(measured.run, measured.comparison ? &*measured.comparison : nullptr).c_str(), stdout);
  for (const Path& file : files) std::printf("%s\n", file.c_str());
}

}  // namespace

void registerBenchFrames(CLI::App& bench, const Home& home) {
  auto options = std::make_shared<FramesOptions>();
  CLI::App* command = bench.add_subcommand("frames", "Measure the frame time of each method, all methods in turn");
  command->add_option("pipelines", options->methods,
                      "PIPELINE or PIPELINE:NAME=VALUE,NAME=VALUE with its own settings; the first is the base "
                      "(default: the pipeline without blur, then all methods)");
  command
      ->add_option("--rounds", options->rounds.least,
                   "timed frames of each method; with a program in --against, per block")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      ->add_option("--within", options->rounds.within,
                   "draw more rounds until the 95 % interval of each median is within this share of the median "
                   "(default: no more rounds)")
      ->check(aboveZero());
  command->add_option("--most-rounds", options->rounds.most, "maximum number of rounds with --within")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      ->add_option("--in-flight", options->in_flight,
                   "frames of a method that are in flight at once (default: 1 on a software device, else 2)")
      ->check(CLI::Range(1, 8));
  command->add_option("-o,--out", options->out, "folder for index.html, bench.json and trace.json");
  command->add_option("--save", options->save, "file for the times, for a later --against");
  command->add_option("--against", options->against,
                      "a saved run, or the program of another revision, which runs alternately with this program");
  command
      ->add_option("--moved", options->moved, "smallest change of a time that counts as moved, as a share of the time")
      ->check(aboveZero())
      ->capture_default_str();
  command->add_option("--blocks", options->blocks, "number of runs of each program, with a program in --against")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print the times as JSON");
  options->shot.addTo(*command, kSeveral);
  command->get_option("--size")->description(fmt::format("WIDTHxHEIGHT in pixels (default: {})", kUsualSize));
  command->callback([options, &home] { frames(home, *options); });
}

}  // namespace strobe::app
