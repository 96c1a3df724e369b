// SPDX-License-Identifier: MIT
// Scripts that draw the shares of a sweep on a cluster or on several processors.
#pragma once

#include <string>
#include <vector>

#include "base/files.h"

namespace strobe::app {

using Words = std::vector<std::string>;

// A sweep in several tasks: its commands, and its requests to Slurm.
struct BatchJob {
  std::string name;  // of the job
  Words sweep;       // command of one task, without its share; the program first
  Words report;      // command that lays out the results of all tasks
  Path start;        // folder where the commands start, absolute
  Path logs;         // folder of the log files, absolute
  int tasks = 1;
  std::string time;  // limit of one run of a task, "HH:MM:SS" or "D-HH:MM:SS"; "": the limit of the partition
  int gpus = 0;      // per task
};

// Number of tasks of a sweep: one per 20 points, at most one per truth, 1 to 16. A task draws many points, because it
// compiles its shaders once. Without a truth of its own, a task would have no points.
int tasksFor(size_t points, size_t truths);

// Seconds of `BatchJob::time`. Throws `Error` (exit code 2) for another text.
int secondsOf(const std::string& time);

// Script of a job array, for `sbatch`. A task takes its share from the variables of the array. A task that is stopped
// before it is done (exit code 75) enters the queue again.
std::string sbatchScript(const BatchJob& job);
// Command line that submits the script, and after it the job of the report.
std::string submitLine(const BatchJob& job, const Path& script);
// Options of `sbatch` for the job of the report; `after`: number of the array.
Words reportOptions(const BatchJob& job, const std::string& after);

// Shell script that runs the tasks by GNU parallel, or as background processes; then the report.
std::string parallelScript(const BatchJob& job);
std::string shellScript(const BatchJob& job);
// Snakefile with one rule for the shares and one for the report.
std::string snakefile(const BatchJob& job);

}  // namespace strobe::app
