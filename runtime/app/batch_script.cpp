// SPDX-License-Identifier: MIT
#include "app/batch_script.h"

#include <algorithm>
#include <regex>

#include "base/error.h"
#include "base/json.h"
#include "lab/shot.h"

namespace strobe::app {

namespace {

// Time from the signal to the end of the job, seconds. Slurm sends the signal up to 60 s earlier.
constexpr int kWarning_s = 60;

// Time that a task may use, seconds: it ends before Slurm sends the signal. Half of a limit below four minutes.
int timeLeft(int limit_s) { return std::max(limit_s - 2 * kWarning_s, limit_s / 2); }

std::string lineOf(const Words& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(lab::shellWord(word));
  return fmt::format("{}", fmt::join(quoted, " "));
}

std::string doubled(const std::string& text, const std::string& letters) {
  std::string result;
  for (char c : text) result += std::string(letters.find(c) == std::string::npos ? 1 : 2, c);
  return result;
}

std::string shellHead(const BatchJob& job) {
  return fmt::format("#!/bin/bash\ncd {} || exit\n", lab::shellWord(job.start.string()));
}

// Text of a Snakefile. A brace is the start of a wildcard, unless it is doubled.
std::string pythonText(const std::string& text) { return Json(text).dump(); }
std::string bracesDoubled(const std::string& text) { return doubled(text, "{}"); }

}  // namespace

int tasksFor(size_t points, size_t truths) { return int(std::clamp<size_t>(std::min(points / 20, truths), 1, 16)); }

int secondsOf(const std::string& time) {
  static const std::regex form("(?:(\\d{1,3})-)?(\\d{1,3}):(\\d\\d):(\\d\\d)");
  std::smatch parts;
  if (!std::regex_match(time, parts, form))
    throw Error(fmt::format("--time {}: expected HH:MM:SS or D-HH:MM:SS", time), {}, 2);
  auto number = [&](size_t i) { return parts[i].matched ? std::stoi(parts[i]) : 0; };
  return ((number(1) * 24 + number(2)) * 60 + number(3)) * 60 + number(4);
}

std::string sbatchScript(const BatchJob& job) {
  std::string text = "#!/bin/bash\n";
  auto add = [&text](const std::string& options) { text += "#SBATCH " + options + "\n"; };
  add("--job-name=" + lab::shellWord(job.name));
  add(fmt::format("--array=1-{}", job.tasks));
  if (job.gpus > 0) add(fmt::format("--gpus={}", job.gpus));
  if (!job.time.empty()) add("--time=" + job.time);
  add("--output=" + lab::shellWord(doubled(job.logs.string(), "%") + "/%A_%a.log"));
  add("--open-mode=append");
  add(fmt::format("--requeue --signal=TERM@{}", kWarning_s));
  Words sweep = job.sweep;
  if (!job.time.empty()) sweep.insert(sweep.end(), {"--time-left", std::to_string(timeLeft(secondsOf(job.time)))});
  return text + fmt::format("cd {} || exit\nsrun {}\ncode=$?\n", lab::shellWord(job.start.string()), lineOf(sweep)) +
         "[ $code -ne 75 ] || scontrol requeue \"$SLURM_JOB_ID\"  # stopped before its end: continue later\n"
         "exit $code\n";
}

Words reportOptions(const BatchJob& job, const std::string& after) {
  return {"--job-name=" + job.name + "_report", "--dependency=afterany:" + after, "--chdir=" + job.start.string(),
          "--output=" + doubled(job.logs.string(), "%") + "/report.log", "--wrap=" + lineOf(job.report)};
}

std::string submitLine(const BatchJob& job, const Path& script) {
  return fmt::format(
      "job=$(sbatch --parsable {}) && sbatch {}", lab::shellWord(script.string()),
      std::regex_replace(lineOf(reportOptions(job, "JOB")), std::regex("afterany:JOB"), "afterany:$job"));
}

std::string parallelScript(const BatchJob& job) {
  const std::string sweep = fmt::format("{} --share {{}}/{} >>{}/share_{{}}.log 2>&1", lineOf(job.sweep), job.tasks,
                                        lab::shellWord(job.logs.string()));
  return shellHead(job) +
         fmt::format("parallel --jobs {0} --retries 2 --joblog {1} {2} ::: {{1..{0}}}\n", job.tasks,
                     lab::shellWord((job.logs / "parallel.tsv").string()), lab::shellWord(sweep)) +
         lineOf(job.report) + "\n";
}

std::string shellScript(const BatchJob& job) {
  return shellHead(job) +
         fmt::format(
             "for share in {{1..{0}}}; do\n  {1} --share $share/{0} >>{2}/share_$share.log 2>&1 &\ndone\nwait\n",
             job.tasks, lineOf(job.sweep), lab::shellWord(job.logs.string())) +
         lineOf(job.report) + "\n";
}

std::string snakefile(const BatchJob& job) {
  auto log = [&](const std::string& name) { return pythonText(bracesDoubled(job.logs.string()) + "/" + name); };
  const std::string share = fmt::format(" --share {{wildcards.share}}/{} >>{{log:q}} 2>&1", job.tasks);
  return fmt::format(
      "workdir: {}\n\n"
      "rule report:\n"
      "    input: expand({}, share=range(1, {}))\n"
      "    output: touch({})\n"
      "    shell: {}\n\n"
      "rule share:\n"
      "    output: touch({})\n"
      "    log: {}\n"
      "    retries: 1\n"
      "    shell: {}\n",
      pythonText(job.start.string()), log("share_{share}.done"), job.tasks + 1, log("report.done"),
      pythonText(bracesDoubled(lineOf(job.report))), log("share_{share}.done"), log("share_{share}.log"),
      pythonText(bracesDoubled(lineOf(job.sweep)) + share));
}

}  // namespace strobe::app
