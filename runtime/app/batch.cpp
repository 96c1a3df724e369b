// SPDX-License-Identifier: MIT
#include "app/batch.h"

#include <cstdio>
#include <filesystem>

#include "base/log.h"
#include "base/numbers.h"
#include "base/process.h"
#include "lab/shot.h"

namespace strobe::app {

namespace {

// Name of the script in the folder of the results.
std::string scriptName(const BatchOptions& options) {
  if (options.sbatch) return "sweep.sbatch";
  return options.form == "parallel" ? "sweep.parallel" : options.form == "snakemake" ? "sweep.smk" : "sweep.sh";
}

std::string scriptOf(const BatchOptions& options, const BatchJob& job) {
  if (options.sbatch) return sbatchScript(job);
  return options.form == "parallel"    ? parallelScript(job)
         : options.form == "snakemake" ? snakefile(job)
                                       : shellScript(job);
}

// Command line that starts the script.
std::string startLine(const BatchOptions& options, const BatchJob& job, const Path& script) {
  if (options.sbatch) return submitLine(job, script);
  return (options.form == "snakemake" ? fmt::format("snakemake --cores all --keep-going -s ") : "bash ") +
         lab::shellWord(script.string());
}

// Writes the script. A file with other text, perhaps edited, gets the ending "~".
void writeScript(const Path& script, const std::string& text) {
  if (std::filesystem::exists(script) && readText(script) != text) {
    const Path kept = script.string() + "~";
    std::filesystem::rename(script, kept);
    note(fmt::format("the script of an earlier call is now {}", kept.string()));
  }
  writeFileAtomically(script, text);
}

// Submits a job and returns its number.
std::string submitted(const Words& options, const Path& script) {
  Program sbatch{.arguments = {"sbatch", "--parsable"}};
  sbatch.arguments.insert(sbatch.arguments.end(), options.begin(), options.end());
  ProgramEnd end;
  try {
    end = run(sbatch);
  } catch (const Error&) {
    throw Error(fmt::format("sbatch is not found: Slurm is not installed here; the script is {}", script.string()));
  }
  while (end.errors.ends_with('\n')) end.errors.pop_back();
  if (!end.succeeded()) throw Error(fmt::format("Slurm refuses the job: {}", end.errors));
  return end.output.substr(0, end.output.find_first_of(";\n"));
}

void submit(const BatchJob& job, const Path& script) {
  const std::string array = submitted({script.string()}, script);
  const std::string report = submitted(reportOptions(job, array), script);
  std::printf("submitted: job %s with %s, then job %s with the report\n", array.c_str(),
              countText(size_t(job.tasks), "task").c_str(), report.c_str());
}

}  // namespace

void addBatch(CLI::App& command, BatchOptions& options) {
  CLI::Option* sbatch =
      command.add_flag("--sbatch", options.sbatch, "draw nothing; write OUT/sweep.sbatch, a job array for Slurm");
  command
      .add_option("--export", options.form,
                  "draw nothing; write the shares as a script of GNU parallel, Snakemake or bash")
      ->check(CLI::IsMember({"parallel", "snakemake", "shell"}))
      ->type_name("parallel|snakemake|shell")
      ->excludes(sbatch);
  command
      .add_option("--tasks", options.tasks,
                  "number of shares of the script (default: one per 20 points, at most 16, at most one per truth)")
      ->check(CLI::Range(1, 1000));
  command.add_option("--time", options.time, "time limit of a task, with --sbatch")
      ->type_name("HH:MM:SS")
      ->needs(sbatch);
  command.add_option("--gpus", options.gpus, "GPUs of a task, with --sbatch")->check(CLI::Range(0, 64))->needs(sbatch);
  command.add_flag("--submit", options.submit, "submit the script, and after it the job of the report")->needs(sbatch);
}

void startBatch(const BatchOptions& options, BatchJob job, size_t points, size_t truths, const Path& out) {
  job.tasks = options.tasks > 0 ? options.tasks : tasksFor(points, truths);
  job.time = options.time, job.gpus = options.gpus;
  job.logs = std::filesystem::absolute(out).lexically_normal() / "logs";
  const std::string text = scriptOf(options, job);
  const Path script = out / scriptName(options);
  std::filesystem::create_directories(job.logs);
  writeScript(script, text);
  note(fmt::format("{} in {}; {}", countText(points, "point"), countText(size_t(job.tasks), "task"), script.string()));
  if (options.submit) return submit(job, script);
  std::printf("%s\n", startLine(options, job, script).c_str());
}

}  // namespace strobe::app
