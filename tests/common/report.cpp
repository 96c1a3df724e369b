// SPDX-License-Identifier: MIT
// Writes the results of a test program, a line at a time, to the file named by STROBE_TEST_RESULTS, so that a process
// that ends early leaves its results so far. Names a failed test with the command that runs it alone.
//   tests N                      number of selected tests
//   passed|failed NAME SECONDS
//   skipped NAME SECONDS REASON
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace strobe {
namespace {

std::string reasonOf(const ::testing::TestResult& result) {
  for (int i = 0; i < result.total_part_count(); ++i) {
    std::string reason = result.GetTestPartResult(i).message();
    if (result.GetTestPartResult(i).skipped()) return reason.substr(0, reason.find('\n'));
  }
  return "";
}

class Report : public ::testing::EmptyTestEventListener {
 public:
  void OnTestProgramStart(const ::testing::UnitTest& program) override {
    const char* file = std::getenv("STROBE_TEST_RESULTS");
    if (!file || ::testing::GTEST_FLAG(list_tests)) return;
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    lines_.open(file);
    lines_ << "tests " << program.test_to_run_count() << std::endl;
  }

  void OnTestEnd(const ::testing::TestInfo& test) override {
    const ::testing::TestResult& result = *test.result();
    std::string name = fmt::format("{}.{}", test.test_suite_name(), test.name());
    const char* end = result.Failed() ? "failed" : result.Skipped() ? "skipped" : "passed";
    lines_ << fmt::format("{} {} {:.3f}", end, name, double(result.elapsed_time()) / 1000);
    lines_ << (result.Skipped() ? " " + reasonOf(result) : "") << std::endl;
    if (result.Failed()) std::printf("alone: %s --gtest_filter='%s'\n", command().c_str(), name.c_str());
  }

 private:
  static std::string command() {
    const char* strobe = std::getenv("STROBE_PROGRAM");
    std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    return (strobe ? fmt::format("STROBE_PROGRAM='{}' ", strobe) : "") + "'" + program + "'";
  }

  std::ofstream lines_;
};

const bool kReports = [] {
  ::testing::UnitTest::GetInstance()->listeners().Append(new Report);
  return true;
}();

}  // namespace
}  // namespace strobe
