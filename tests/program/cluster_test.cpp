// SPDX-License-Identifier: MIT
// Shares of a sweep under real schedulers: Slurm's daemons on the loopback device, GNU parallel, Snakemake and bash.
// The table of each equals the table of one process.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/files.h"
#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace cluster_test {

// 60 points: two arms at 30 combinations, with six different truths.
const char* const kSixty = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Sixty", size = { 64, 36 }, regions = { "whole", "inner" }, measures = { "rmse", "flip" },
  shots = { { name = "bar", scene = "oracles/bar" } },
  arms = { { name = "mcguire", pipeline = "mcguire2012" }, { name = "hybrid", pipeline = "hybrid" } },
  truth = { pipeline = "ground_truth", set = { samples = 16 } },
  vary = { experiment.grid { exposure = experiment.linear(0.5, 1, 6), samples = { 1, 2, 4, 8, 16 } } },
}
)lua";

bool has(const std::string& program) { return runLine("PATH=$PATH:/usr/sbin command -v " + program).exit_code == 0; }

// Waits until `is_reached()`, for at most a minute.
template <class Is>
bool waitUntil(const Is& is_reached) {
  for (int tries = 0; tries < 600; ++tries) {
    if (is_reached()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

// A program in the background, ended with the object.
class Daemon {
 public:
  explicit Daemon(const std::string& line) : child_(::fork()) {
    if (child_ != 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::execl("/bin/sh", "sh", "-c", ("PATH=$PATH:/usr/sbin exec " + line + " >/dev/null 2>&1").c_str(), nullptr);
    ::_exit(127);
  }
  ~Daemon() { end(SIGTERM); }
  void end(int signal) {
    if (child_ > 0) ::kill(child_, signal), ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  pid_t child_;
};

class Cluster : public ::testing::Test {
 protected:
  void SetUp() override { writeText(folder_ / "x.lua", kSixty); }

  std::string sweep(const std::string& out, const std::string& more = "") const {
    return "sweep " + (folder_ / "x.lua") + " -o " + (folder_ / out) + " " + more;
  }
  // Points drawn so far, without truths.
  size_t drawn(const std::string& out) const {
    std::error_code none;
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_ / (out + "/points"), none))
      count += entry.path().extension() == ".json";
    return count;
  }
  std::string table(const std::string& out) const { return contentOf(folder_ / (out + "/table.csv")); }
  // Table of a sweep in one process.
  std::string expected() const {
    Outcome outcome = run(sweep("one"), "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return table("one");
  }
  // Every point occurs once per region, with the numbers of a sweep in one process.
  void expectWhole(const std::string& out) const {
    std::istringstream lines(table(out));
    std::set<std::string> points;
    size_t rows = 0;
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line); ++rows) points.insert(line.substr(0, line.find(',')));
    EXPECT_EQ(points.size(), 60u);
    EXPECT_EQ(rows, 120u);
    EXPECT_EQ(table(out), expected());
  }
  // Logs of all tasks, for messages.
  std::string logs(const std::string& out) const {
    std::string text;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_ / (out + "/logs"), none))
      text += "---- " + entry.path().filename().string() + "\n" + contentOf(entry.path());
    return text;
  }
  // Writes the script of a scheduler.
  std::string script(const std::string& out, const std::string& options, const std::string& name) const {
    Outcome outcome = run(sweep(out, "--tasks 4 " + options), "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("60 points in 4 tasks"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.out.find(name), std::string::npos) << outcome.out;
    return folder_ / (out + "/" + name);
  }

  TemporaryFolder folder_;
};

TEST_F(Cluster, GnuParallelRepeatsAKilledShare) {
  if (!has("parallel")) GTEST_SKIP() << "GNU parallel is missing";
  const std::string file = script("out", "--export parallel", "sweep.parallel");
  // Kills the program of the first share once.
  std::thread killer([&] {
    waitUntil([&] {
      std::error_code none;
      for (const auto& entry : fs::directory_iterator(folder_ / "out/.workers", none)) {
        if (entry.path().extension() != ".json" || drawn("out") < 4) continue;
        const Json state = Json::parse(contentOf(entry.path()), nullptr, false);
        if (!state.is_object() || state.value("share", "") != "1/4") continue;
        const std::string process = entry.path().stem().extension().string().substr(1);
        return ::kill(pid_t(std::stol(process)), SIGKILL) == 0;
      }
      return false;
    });
  });
  Outcome outcome = runLine("STROBE_VALIDATION=0 bash " + file);
  killer.join();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string log = contentOf(folder_ / "out/logs/share_1.log");
  const size_t first = log.find(" left to draw");
  EXPECT_NE(log.find(" left to draw", first + 1), std::string::npos) << "the share ran once: " << log;
  expectWhole("out");
}

TEST_F(Cluster, BashRunsAllSharesAtOnce) {
  Outcome outcome = runLine("STROBE_VALIDATION=0 bash " + script("out", "--export shell", "sweep.sh"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expectWhole("out");
}

// Snakemake is not installed for the tests, because it depends on 680 MB of cloud libraries.
TEST_F(Cluster, SnakemakeRunsTheShares) {
  const std::string file = script("out", "--export snakemake", "sweep.smk");
  if (!has("snakemake")) GTEST_SKIP() << "Snakemake is missing";
  const std::string home = "HOME=" + (folder_ / "home") + " XDG_CACHE_HOME=" + (folder_ / "cache");
  Outcome outcome = runLine("cd " + folder_.path().string() + " && env " + home +
                            " STROBE_VALIDATION=0 snakemake --cores 2 --nolock -s " + file);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expectWhole("out");
}

TEST_F(Cluster, SubmitWithoutSlurmIsOneClearLine) {
  Outcome outcome = run(sweep("out", "--sbatch --submit"), "STROBE_VALIDATION=0 PATH=/nowhere");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("strobe: sbatch is not found: Slurm is not installed here; the script is " +
                             (folder_ / "out/sweep.sbatch")),
            std::string::npos)
      << outcome.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/sweep.sbatch"));
  EXPECT_FALSE(fs::exists(folder_ / "out/points"));
  EXPECT_EQ(run(sweep("out", "--submit"), "STROBE_VALIDATION=0").exit_code, 2);
  EXPECT_EQ(run(sweep("out", "--sbatch --time 1h"), "STROBE_VALIDATION=0").exit_code, 2);
}

TEST_F(Cluster, EditedScriptIsKept) {
  const std::string file = script("out", "--sbatch", "sweep.sbatch");
  writeText(file, contentOf(file) + "# edited\n");
  script("out", "--sbatch", "sweep.sbatch");
  EXPECT_TRUE(contentOf(file + "~").ends_with("# edited\n"));
  EXPECT_TRUE(contentOf(file).ends_with("exit $code\n"));
}

// Slurm's daemons with all files in a temporary folder.
class Slurm : public Cluster {
 protected:
  void SetUp() override {
    Cluster::SetUp();
    if (!has("slurmctld") || !has("slurmd") || !has("munged")) GTEST_SKIP() << "Slurm is missing (slurm-wlm, munge)";
    if (::geteuid() != 0) GTEST_SKIP() << "Slurm's daemons need root";
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    host_ = std::string(host).substr(0, std::string(host).find('.'));
    writeText(folder_ / "munge.key", std::string(1024, 'k'));
    fs::permissions(folder_ / "munge.key", fs::perms::owner_read);
    writeText(folder_ / "slurm.conf", configuration());
    fs::create_directory(folder_ / "spool");
    ::setenv("SLURM_CONF", (folder_ / "slurm.conf").c_str(), 1);
    ::setenv("STROBE_VALIDATION", "0", 1);
    auto at = [&](const std::string& name) { return (folder_ / name); };
    munge_ = std::make_unique<Daemon>("munged --foreground --force --key-file=" + at("munge.key") +
                                      " --socket=" + at("munge.socket") + " --pid-file=" + at("munge.pid") +
                                      " --log-file=" + at("munge.log") + " --seed-file=" + at("munge.seed"));
    ASSERT_TRUE(waitUntil([&] { return fs::exists(at("munge.socket")); }));
    startController();
    node_ = std::make_unique<Daemon>("slurmd -D -N " + host_);
    ASSERT_TRUE(waitUntil([&] { return slurm("sinfo -h -o %T") == "idle\n"; })) << contentOf(at("slurmctld.log"));
  }
  void TearDown() override {
    if (node_) slurm("scancel --user=root; sleep 1");
    node_.reset(), controller_.reset(), munge_.reset();
    ::unsetenv("SLURM_CONF"), ::unsetenv("STROBE_VALIDATION");
  }

  std::string configuration() const {
    const std::string at = folder_.path().string();
    const int port = 20000 + int(::getpid()) % 20000;
    return fmt::format(
        "ClusterName=strobe\nSlurmctldHost={0}(127.0.0.1)\nSlurmctldPort={1}\nSlurmdPort={2}\nSlurmUser=root\n"
        "SlurmdUser=root\nAuthInfo=socket={3}/munge.socket\nStateSaveLocation={3}/state\nSlurmdSpoolDir={3}/spool\n"
        "SlurmctldPidFile={3}/slurmctld.pid\nSlurmdPidFile={3}/slurmd.pid\nSlurmctldLogFile={3}/slurmctld.log\n"
        "SlurmdLogFile={3}/slurmd.log\nReturnToService=2\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\n"
        "SelectType=select/cons_tres\nSelectTypeParameters=CR_CPU\nJobAcctGatherType=jobacct_gather/none\n"
        "AccountingStorageType=accounting_storage/none\nMpiDefault=none\nKillWait=5\n"
        "SchedulerParameters=sched_interval=1,batch_sched_delay=1\nSlurmdParameters=config_overrides\n"
        "NodeName={0} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\nPartitionName=all Nodes={0} Default=YES State=UP\n",
        host_, port, port + 1, at);
  }
  void startController() { controller_ = std::make_unique<Daemon>("slurmctld -D"); }

  // Output of a line with commands of Slurm.
  std::string slurm(const std::string& line) const { return runLine(line).out; }
  bool isRunning(const std::string& task) const { return slurm("squeue -h -o %T -j " + task) == "RUNNING\n"; }
  // Jobs that have not ended.
  std::string queue() const { return slurm("squeue -h -o '%i %T'"); }
  // True if all jobs of these options have ended. False while the controller starts.
  bool isEmpty(const std::string& options = "") const {
    Outcome outcome = runLine("squeue -h " + options);
    return outcome.exit_code == 0 && outcome.out.empty();
  }
  // Lets requeued jobs start now instead of after two minutes.
  void hurry(const std::string& array) const {
    slurm("for task in $(squeue -h -r -t PENDING -o %i -j " + array +
          "); do scontrol update jobid=$task starttime=now; done");
  }
  // Submits the array and its report, and returns the number of the array.
  std::string submitted() const {
    Outcome outcome = run(sweep("out", "--sbatch --tasks 4 --time 00:10:00 --submit"), "STROBE_VALIDATION=0");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const size_t begin = outcome.out.find("job ") + 4;
    return outcome.out.substr(begin, outcome.out.find(' ', begin) - begin);
  }

  std::string host_;
  std::unique_ptr<Daemon> munge_, controller_, node_;
};

TEST_F(Slurm, DrawsEveryPointOnceThroughKillRequeueAndControllerLoss) {
  const std::string array = submitted();
  ASSERT_TRUE(waitUntil([&] { return drawn("out") >= 4 && isRunning(array + "_1") && isRunning(array + "_2"); }))
      << queue() << logs("out");
  slurm("scancel --signal=KILL " + array + "_1; scontrol requeue " + array + "_2");
  controller_->end(SIGTERM);
  startController();
  ASSERT_TRUE(waitUntil([&] {
    hurry(array);
    return isEmpty("-j " + array);
  })) << queue();
  ASSERT_TRUE(waitUntil([&] { return isEmpty(); })) << queue();
  const std::string report = contentOf(folder_ / "out/logs/report.log");
  EXPECT_NE(report.find("not drawn yet: "), std::string::npos) << "missing the points of the killed task\n"
                                                               << logs("out") << slurm("scontrol show jobs");
  EXPECT_LT(drawn("out"), 66u);
  EXPECT_NE(logs("out").find("share 2/4: "), std::string::npos) << "missing the log of the requeued task\n"
                                                                << logs("out") << slurm("scontrol show jobs");

  // The same script again draws the points of the killed task.
  submitted();
  ASSERT_TRUE(waitUntil([&] { return isEmpty(); })) << queue();
  EXPECT_EQ(drawn("out"), 66u);
  expectWhole("out");
  EXPECT_TRUE(fs::exists(folder_ / "out/report.html"));
}

}  // namespace cluster_test
}  // namespace strobe::testing
