// SPDX-License-Identifier: MIT
#include "lab/evaluation.h"

#include <algorithm>

#include "base/hash.h"
#include "base/log.h"
#include "plan/settings.h"

namespace strobe::lab {

// Texts of `files`. A text comes from `given`, from `known` if its hash matches, or from the file. A file that changed
// since the evaluation is left out; the next check for changes reports it.
static script::Texts textsOf(const std::vector<script::Dependency>& files, const script::Texts& given,
                             const script::Texts& known) {
  script::Texts texts;
  for (const auto& file : files) {
    auto held = given.find(file.path);
    if (held != given.end()) {
      texts.insert(*held);
      continue;
    }
    held = known.find(file.path);
    if (held != known.end() && hashText(held->second) == file.hash) {
      texts.insert(*held);
      continue;
    }
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file.path, ignored)) continue;
    try {
      std::string text = readText(file.path);
      if (hashText(text) == file.hash) texts[file.path] = std::move(text);
    } catch (const Error&) {
      continue;
    }
  }
  return texts;
}

Evaluation evaluated(const Home& home, const std::string& pipeline, const script::Settings& sets,
                     const script::Limits& limits, const script::Texts& known) {
  Evaluation evaluation;
  evaluation.pipeline = script::evaluatePipeline(home, {pipeline, sets}, &evaluation.scripts, limits);
  evaluation.texts = textsOf(evaluation.scripts, {}, known);
  return evaluation;
}

std::shared_ptr<const Evaluation> derivedEvaluation(const script::Settings& sets, const ByScripts& by_scripts) {
  script::Settings deciding, rest = sets;
  std::shared_ptr<const Evaluation> base;
  // Run the scripts until no other setting decides the graph.
  for (bool more = true; more;) {
    base = by_scripts(deciding);
    if (!base) return nullptr;
    auto first = std::stable_partition(rest.begin(), rest.end(), [&](const script::Setting& set) {
      return !plan::decidesGraph(base->pipeline, set.first);
    });
    more = first != rest.end();
    deciding.insert(deciding.end(), first, rest.end());
    rest.erase(first, rest.end());
  }
  if (rest.empty()) return base;
  try {
    return std::make_shared<Evaluation>(
        Evaluation{plan::withSettings(base->pipeline, rest), base->scripts, base->texts});
  } catch (const Error&) {
    return nullptr;
  }
}

Stamps stampsOf(const std::vector<script::Dependency>& files) {
  Stamps stamps;
  for (const auto& file : files) stamps.add(file.path);
  return stamps;
}

bool isCurrent(const std::vector<script::Dependency>& files) {
  return std::all_of(files.begin(), files.end(),
                     [](const auto& file) { return script::hashOfPath(file.path) == file.hash; });
}

Attempt attempt(const Home& home, const Shot& shot, const script::Texts& texts, const script::Limits& limits,
                bool lenient, const script::Texts& known) {
  Attempt tried;
  double started_s = clockSeconds();
  try {
    script::PipelineRequest request{shot.pipeline, shot.sets, texts};
    auto* dropped = lenient ? &tried.dropped : nullptr;
    tried.good.pipeline = script::evaluatePipeline(home, request, &tried.good.scripts, limits, dropped);
    tried.good.texts = textsOf(tried.good.scripts, texts, known);
    tried.usable = true;
  } catch (const std::exception& error) {  // an `Error`, or a folder removed while it is listed
    tried.problems.push_back(error.what());
  }
  tried.ms = 1000 * (clockSeconds() - started_s);
  return tried;
}

// Good texts of the files that have changed since.
static script::Texts changedTexts(const script::Texts& good) {
  script::Texts changed;
  for (const auto& [file, text] : good)
    if (script::hashOfPath(file) != hashText(text)) changed[file] = text;
  return changed;
}

Attempt attemptAround(const Home& home, const Shot& shot, const Evaluation& good, const script::Limits& limits) {
  Attempt newest = attempt(home, shot, {}, limits, true, good.texts);
  if (newest.usable || good.texts.empty()) return newest;
  script::Texts changed = changedTexts(good.texts), put_back;
  std::vector<std::string> problems = newest.problems;
  double ms = newest.ms;
  while (put_back.size() < changed.size()) {
    size_t before = put_back.size();
    for (const auto& [file, text] : changed)
      if (problems.back().find(home.shown(file)) != std::string::npos) put_back[file] = text;
    if (put_back.size() == before) put_back = changed;
    if (put_back.size() == changed.size()) break;  // no other combination is left
    Attempt around = attempt(home, shot, put_back, limits, true, good.texts);
    ms += around.ms;
    problems.insert(problems.end(), around.problems.begin(), around.problems.end());
    if (!around.usable) continue;
    around.problems = problems;
    around.refused = newest.good.scripts;
    around.ms = ms;
    return around;
  }
  newest.problems = problems;
  newest.ms = ms;
  return newest;
}

}  // namespace strobe::lab
