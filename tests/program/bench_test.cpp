// SPDX-License-Identifier: MIT
// The command `strobe bench frames`: written files, comparison with a run and with a program, refusals. No test depends
// on a time.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace bench_test {

const std::string kMethods = "mcguire2012 mcguire2012:samples=4,jitter=hash hybrid ";
const std::string kShot = "--scene oracles/bar --size 32x18 ";

Outcome frames(const std::string& options, const std::string& environment = "STROBE_VALIDATION=0") {
  return run("bench frames " + options, environment);
}

class Bench : public ::testing::Test {
 protected:
  // A run that other tests compare with.
  static void SetUpTestSuite() {
    folder_ = new TemporaryFolder;
    first_ = frames(kMethods + kShot + "--rounds 2 -o " + (*folder_ / "out") + " --save " + (*folder_ / "saved.json"),
                    "STROBE_VALIDATION=1");
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override { ASSERT_EQ(first_.exit_code, 0) << first_.err; }

  static std::string saved() { return *folder_ / "saved.json"; }
  static Json fileOf(const std::string& name) { return Json::parse(contentOf(*folder_ / name)); }
  static void expectRefusal(const std::string& options, int code, const std::string& wanted) {
    Outcome outcome = frames(options + " --rounds 1");
    EXPECT_EQ(outcome.exit_code, code) << options;
    EXPECT_NE(outcome.err.find(wanted), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "") << options;
  }

  static TemporaryFolder* folder_;
  static Outcome first_;
};

TemporaryFolder* Bench::folder_ = nullptr;
Outcome Bench::first_;

TEST_F(Bench, WritesTimesOfEveryMethodAndPass) {
  Json run = fileOf("out/bench.json");
  EXPECT_EQ(run, fileOf("saved.json"));
  ASSERT_EQ(run["shots"].size(), 3u);
  EXPECT_EQ(run["shots"][1]["method"], "mcguire2012:samples=4,jitter=hash");
  EXPECT_EQ(run["shots"][1]["shot"]["set"], Json::parse(R"({"samples": 4, "jitter": "hash"})"));
  for (const Json& shot : run["shots"]) {
    EXPECT_EQ(shot["ms"].size(), 2u);
    EXPECT_GT(shot["passes"].size(), 2u);
    for (const Json& pass : shot["passes"]) {
      EXPECT_EQ(pass["ms"].size(), 2u);
      EXPECT_GT(pass["bytes_written"].get<int>(), 0) << pass["name"];
      EXPECT_GT(pass["executions"].get<int>(), 0) << pass["name"];
    }
  }
  for (const char* field : {"device", "strobe", "threads", "command"}) EXPECT_TRUE(run.contains(field)) << field;
}

TEST_F(Bench, WritesAPageAndATrace) {
  std::string page = contentOf(*folder_ / "out/index.html");
  for (const char* text :
       {"mcguire2012:samples=4,jitter=hash", "oracles/bar, 32x18", "<svg", "share of bytes", "Made by"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  for (const char* outside : {"src=\"http", "href=\"http", "@import"}) EXPECT_EQ(page.find(outside), std::string::npos);
  Json run = fileOf("out/bench.json"), trace = fileOf("out/trace.json");
  size_t passes = 0, complete = 0;
  for (const Json& shot : run["shots"]) passes += shot["passes"].size();
  for (const Json& event : trace["traceEvents"]) complete += event["ph"] == "X";
  EXPECT_EQ(complete, passes + 2 * 3) << "passes, and the frame and rest of each shot";
  EXPECT_NE(first_.out.find("ratio to mcguire2012"), std::string::npos) << first_.out;
  EXPECT_NE(first_.out.find("index.html"), std::string::npos) << first_.out;
  if (run["device"]["software"].get<bool>())
    EXPECT_NE(first_.out.find("not comparable across machines"), std::string::npos) << first_.out;
}

// A software device has no clock for passes in flight: its trace has only frames.
TEST_F(Bench, TimesFramesInFlight) {
  const std::string out = *folder_ / "in_flight";
  Outcome outcome = frames("mcguire2012 hybrid " + kShot + "--rounds 2 --in-flight 2 -o " + out, "STROBE_VALIDATION=1");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("from frame to frame"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("2 in flight at once"), std::string::npos) << outcome.out;
  Json run = fileOf("in_flight/bench.json");
  EXPECT_EQ(run["frames_in_flight"], 2);
  ASSERT_EQ(run["shots"].size(), 2u);
  const bool software = run["device"]["software"];
  for (const Json& shot : run["shots"]) {
    EXPECT_EQ(shot["interval_ms"].size(), 2u);
    EXPECT_EQ(shot["passes"].empty(), software) << "a software device has no clock for passes";
  }
  EXPECT_EQ(outcome.out.find("no clock for passes") != std::string::npos, software) << outcome.out;
  size_t complete = 0;
  const Json trace = fileOf("in_flight/trace.json");
  for (const Json& event : trace["traceEvents"]) complete += event["ph"] == "X";
  EXPECT_EQ(complete == 2, software) << complete << ", only frames";
  EXPECT_NE(run["command"].get<std::string>().find("--in-flight=2"), std::string::npos);
  EXPECT_FALSE(fileOf("out/bench.json")["shots"][0].contains("interval_ms"));
  expectRefusal("hybrid " + kShot + "--in-flight 9", 2, "Value 9 not in range 1 to 8");
}

TEST_F(Bench, ComparesWithASavedRun) {
  Outcome outcome = frames(kMethods + kShot + "--rounds 2 --json --against " + saved());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  Json run = Json::parse(outcome.out), before = fileOf("saved.json");
  EXPECT_EQ(run["comparison"]["moved"], 0) << "two rounds have no interval";
  EXPECT_EQ(run["comparison"]["gone"], Json::array());
  size_t parts = 0;
  for (size_t s = 0; s < 3; ++s) {
    parts += run["shots"][s]["passes"].size() + 2;
    for (size_t p = 0; p < run["shots"][s]["passes"].size(); ++p)
      for (const char* same : {"name", "bytes_read", "bytes_written", "rays", "executions"})
        EXPECT_EQ(run["shots"][s]["passes"][p][same], before["shots"][s]["passes"][p][same]) << same;
  }
  EXPECT_EQ(run["comparison"]["changes"].size(), parts);
}

TEST_F(Bench, TakesTurnsWithAnotherProgram) {
  Outcome outcome =
      frames("mcguire2012 " + kShot + "--exposure 0.25 --rounds 2 --blocks 2 --json --against " + programPath());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("block 2 of 2"), std::string::npos) << outcome.err;
  Json run = Json::parse(outcome.out), comparison = run["comparison"];
  EXPECT_EQ(run["shots"][0]["ms"].size(), 4u) << "two blocks of two rounds";
  EXPECT_EQ(run["shots"][0]["shot"]["exposure"], 0.25);
  EXPECT_EQ(comparison["run"]["shots"][0]["shot"], run["shots"][0]["shot"]) << "options are passed on";
  EXPECT_EQ(comparison["compared"], "alternating blocks");
  EXPECT_EQ(comparison["blocks"], 2);
  EXPECT_EQ(comparison["moved"], 0) << "two blocks have no interval";
}

TEST_F(Bench, RefusesMisuse) {
  expectRefusal("hybrid:samples " + kShot, 2, "'samples' is not NAME=VALUE");
  expectRefusal("hybrid:sampels=3 " + kShot, 2, "did you mean 'samples'?");
  expectRefusal("hybird " + kShot, 2, "did you mean 'hybrid'?");
  expectRefusal("hybrid hybrid " + kShot, 2, "method 'hybrid' is given twice");
  expectRefusal("hybrid --size 32x18 --size 32x18", 2, "--size '32x18' is given twice");
  expectRefusal("hybrid --size 32", 2, "--size '32' is not WIDTHxHEIGHT");
  expectRefusal("none hybrid --set samples=4 " + kShot, 2, "method 'none'");
  expectRefusal("hybrid " + kShot + "--against no.json", 2, "--against 'no.json': file not found");
  expectRefusal("hybrid --within 0.1 --against " + programPath(), 2, "--within cannot be used with a program");
}

TEST_F(Bench, RefusesOtherFiles) {
  const std::string page = *folder_ / "out/index.html";
  expectRefusal("hybrid " + kShot + "--against " + page, 1, page + ": is not a run of `strobe bench frames`");
  expectRefusal("hybrid " + kShot + "--against " + saved(), 1, "it also has 'mcguire2012, oracles/bar, 32x18'");
  expectRefusal(kMethods + kShot + "--exposure 0.25 --against " + saved(), 1, "has other options: exposure 0.5");
  expectRefusal("hybrid " + kShot + "--against /bin/false", 1, "/bin/false: cannot run these shots: exit code 1");
  expectRefusal("hybrid " + kShot + "--against /bin/true", 1, "/bin/true bench frames: is not a run of");
}

}  // namespace bench_test
}  // namespace strobe::testing
