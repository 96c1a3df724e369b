// SPDX-License-Identifier: MIT
// Options of `sweep` that write a script instead of drawing: `--sbatch`, `--export`.
#pragma once

#include <CLI/CLI.hpp>

#include "app/batch_script.h"

namespace strobe::app {

// Options of a script: its form, the number of its tasks, and their requests to Slurm.
struct BatchOptions {
  bool sbatch = false, submit = false;
  std::string form;  // of --export: "parallel", "snakemake", "shell"; "": none
  int tasks = 0;     // 0: `tasksFor` the points and truths
  int gpus = 0;
  std::string time;

  bool isWanted() const { return sbatch || !form.empty(); }
};

void addBatch(CLI::App& command, BatchOptions& options);

// Completes the job by the options, writes its script into `out` and prints the command line that starts it. With
// `submit`, gives the script and the job of the report to Slurm. Throws `Error` (exit code 1) without Slurm.
void startBatch(const BatchOptions& options, BatchJob job, size_t points, size_t truths, const Path& out);

}  // namespace strobe::app
