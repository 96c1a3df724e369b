// SPDX-License-Identifier: MIT
#include "app/batch_script.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/process.h"
#include "common/refusal.h"

namespace strobe::app {
namespace batch_script_test {

BatchJob job() {
  return {.name = "samples",
          .sweep = {"/opt/strobe", "sweep", "x.lua", "-o", "out/my samples", "--only", "arm=a b"},
          .report = {"/opt/strobe", "report", "out/my samples", "--experiment", "x.lua"},
          .start = "/lab",
          .logs = "/lab/out/my samples/logs",
          .tasks = 4};
}

// Bash parses the script without running it.
void expectBash(std::string script) {
  ProgramEnd end = run({.arguments = {"bash", "-n"}, .input = [&] { return std::exchange(script, {}); }});
  EXPECT_TRUE(end.succeeded()) << end.errors;
}

TEST(BatchScript, WritesASlurmJobArray) {
  BatchJob with_gpus = job();
  with_gpus.time = "01:00:00", with_gpus.gpus = 1;
  const std::string script = sbatchScript(with_gpus);
  EXPECT_EQ(script, R"(#!/bin/bash
#SBATCH --job-name=samples
#SBATCH --array=1-4
#SBATCH --gpus=1
#SBATCH --time=01:00:00
#SBATCH --output='/lab/out/my samples/logs/%A_%a.log'
#SBATCH --open-mode=append
#SBATCH --requeue --signal=TERM@60
cd /lab || exit
srun /opt/strobe sweep x.lua -o 'out/my samples' --only 'arm=a b' --time-left 3480
code=$?
[ $code -ne 75 ] || scontrol requeue "$SLURM_JOB_ID"  # stopped before its end: continue later
exit $code
)");
  EXPECT_LE(std::count(script.begin(), script.end(), '\n'), 15);
  expectBash(script);
  EXPECT_EQ(sbatchScript(job()).find("--time"), std::string::npos) << "the limit of the partition";
  EXPECT_EQ(submitLine(job(), "out/my samples/sweep.sbatch"),
            "job=$(sbatch --parsable 'out/my samples/sweep.sbatch') && sbatch --job-name=samples_report "
            "--dependency=afterany:$job --chdir=/lab '--output=/lab/out/my samples/logs/report.log' "
            "'--wrap=/opt/strobe report '\\''out/my samples'\\'' --experiment x.lua'");
  expectBash(submitLine(job(), "a b"));
}

TEST(BatchScript, WritesAGnuParallelScript) {
  EXPECT_EQ(parallelScript(job()), R"(#!/bin/bash
cd /lab || exit
parallel --jobs 4 --retries 2 --joblog '/lab/out/my samples/logs/parallel.tsv' '/opt/strobe sweep x.lua -o '\''out/my samples'\'' --only '\''arm=a b'\'' --share {}/4 >>'\''/lab/out/my samples/logs'\''/share_{}.log 2>&1' ::: {1..4}
/opt/strobe report 'out/my samples' --experiment x.lua
)");
  expectBash(parallelScript(job()));
}

TEST(BatchScript, WritesAPlainShellScript) {
  EXPECT_EQ(shellScript(job()), R"(#!/bin/bash
cd /lab || exit
for share in {1..4}; do
  /opt/strobe sweep x.lua -o 'out/my samples' --only 'arm=a b' --share $share/4 >>'/lab/out/my samples/logs'/share_$share.log 2>&1 &
done
wait
/opt/strobe report 'out/my samples' --experiment x.lua
)");
  expectBash(shellScript(job()));
}

TEST(BatchScript, WritesASnakefile) {
  BatchJob braces = job();
  braces.start = "/lab/{a}", braces.report[2] = "{out}";
  EXPECT_EQ(snakefile(braces), R"(workdir: "/lab/{a}"

rule report:
    input: expand("/lab/out/my samples/logs/share_{share}.done", share=range(1, 5))
    output: touch("/lab/out/my samples/logs/report.done")
    shell: "/opt/strobe report '{{out}}' --experiment x.lua"

rule share:
    output: touch("/lab/out/my samples/logs/share_{share}.done")
    log: "/lab/out/my samples/logs/share_{share}.log"
    retries: 1
    shell: "/opt/strobe sweep x.lua -o 'out/my samples' --only 'arm=a b' --share {wildcards.share}/4 >>{log:q} 2>&1"
)");
}

TEST(BatchScript, HasATaskPerTwentyPointsAndATruthPerTask) {
  EXPECT_EQ(tasksFor(1, 1), 1);
  EXPECT_EQ(tasksFor(60, 12), 3);
  EXPECT_EQ(tasksFor(60, 1), 1);
  EXPECT_EQ(tasksFor(100000, 50), 16);
}

TEST(BatchScript, LeavesTimeBeforeTheLimit) {
  EXPECT_EQ(secondsOf("00:30:00"), 1800);
  EXPECT_EQ(secondsOf("1-02:00:05"), 93605);
  for (const char* wrong : {"1h", "30", "1:2:3", "-1:00:00", ""})
    EXPECT_EQ(testing::refusalOf([&] { secondsOf(wrong); }),
              "--time " + std::string(wrong) + ": expected HH:MM:SS or D-HH:MM:SS");
  BatchJob brief = job();
  brief.time = "00:02:00";
  EXPECT_NE(sbatchScript(brief).find("--time-left 60\n"), std::string::npos) << "half of a short limit";
}

}  // namespace batch_script_test
}  // namespace strobe::app
