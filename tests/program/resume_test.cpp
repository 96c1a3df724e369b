// SPDX-License-Identifier: MIT
// Sweeps that are interrupted and continue, run in several processes, or have changed inputs. Processes are killed 8
// times, with --all 30 times: during start, between points and while they write a point.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <map>
#include <random>
#include <regex>
#include <sstream>
#include <thread>

#include "base/files.h"
#include "base/json.h"
#include "common/all_cases.h"
#include "common/source.h"
#include "program/run.h"

namespace strobe::testing {
namespace resume_test {

// 300 points: 2 arms x 150 combinations, with 5 different truths.
const char* const kMany = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Many", size = { 64, 36 }, regions = { "whole", "inner" }, measures = { "rmse", "flip", "memory" },
  shots = { { name = "bar", scene = "oracles/bar" } },
  arms = { { name = "mcguire", pipeline = "mcguire2012" }, { name = "hybrid", pipeline = "hybrid" } },
  truth = { pipeline = "ground_truth", set = { samples = 16 } },
  vary = { experiment.grid { exposure = { 0.2, 0.4, 0.6, 0.8, 1 }, samples = experiment.linear(1, 30, 30) } },
}
)lua";

std::string few(const std::string& samples, const std::string& title = "Few") {
  std::string text = kMany;
  text.replace(text.find("Many"), 4, title);
  text.replace(text.find("{ 0.2, 0.4, 0.6, 0.8, 1 }"), 25, "{ 0.5 }");
  return text.replace(text.find("experiment.linear(1, 30, 30)"), 28, samples);
}

class Resume : public ::testing::Test {
 protected:
  std::string command(const std::string& out, const std::string& more = "", const std::string& name = "sweep") const {
    return name + " " + (folder_ / "x.lua") + " -o " + (folder_ / out) + " " + more;
  }
  std::string file(const std::string& out, const std::string& name) const {
    return contentOf(folder_ / (out + "/" + name));
  }
  // Names of drawn points and times of their last change.
  std::map<std::string, fs::file_time_type> points(const std::string& out) const {
    std::map<std::string, fs::file_time_type> found;
    if (fs::exists(folder_ / (out + "/points")))
      for (const auto& entry : fs::directory_iterator(folder_ / (out + "/points")))
        if (entry.path().extension() == ".json" && entry.path().stem().extension().empty())
          found[entry.path().filename()] = entry.last_write_time();
    return found;
  }
  // Kills a sweep `moment_s` after it has drawn this many points, or after 10 s.
  void killAt(const std::string& out, size_t points_drawn, double moment_s, const std::string& name = "sweep") const {
    pid_t child = ::fork();
    if (child == 0) {
      ::setpgid(0, 0);
      std::string line = "exec '" + programPath() + "' " + command(out, "", name) + " >/dev/null 2>&1";
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(127);
    }
    auto pause = [](double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); };
    for (int waited = 0; points(out).size() < points_drawn && waited < 1000; ++waited) pause(0.01);
    pause(moment_s);
    ::kill(-child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }

  // Interrupts a sweep after it has drawn this many points: all its processes like Ctrl-C, or only the first process
  // like a batch system.
  Outcome interruptAt(const std::string& out, size_t points_drawn, const std::string& more, bool all) const {
    const std::string err = folder_ / "interrupted.txt";
    pid_t child = ::fork();
    if (child == 0) {
      ::setpgid(0, 0);
      std::string line = "exec '" + programPath() + "' " + command(out, more) + " >/dev/null 2>" + err;
      ::execl("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      ::_exit(127);
    }
    for (int waited = 0; points(out).size() < points_drawn && waited < 3000; ++waited)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(all ? -child : child, all ? SIGINT : SIGTERM);
    int status = 0;
    ::waitpid(child, &status, 0);
    return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), "", contentOf(err)};
  }

  // A home with the shipped passes, scripts and shaders.
  std::string ownHome() const {
    std::string home = folder_ / "home";
    const char* source = std::getenv("STROBE_HOME");
    fs::path shipped = source ? fs::path(source) : sourceFolder();
    fs::create_directory(home);
    for (const char* part : {"passes", "scripts", "shaders"})
      fs::copy(shipped / part, home + "/" + part, fs::copy_options::recursive);
    return home;
  }

  void expectWholePictures(const std::string& out) const {
    if (!fs::exists(folder_ / (out + "/points"))) return;
    for (const auto& entry : fs::directory_iterator(folder_ / (out + "/points")))
      if (entry.path().extension() == ".png")
        EXPECT_TRUE(contentOf(entry.path()).ends_with("IEND\xae\x42\x60\x82")) << entry.path();
  }

  TemporaryFolder folder_;
};

TEST_F(Resume, KillsLoseNoPointsAndRepeatNone) {
  writeText(folder_ / "x.lua", kMany);
  ASSERT_EQ(run(command("whole"), "STROBE_VALIDATION=0").exit_code, 0);
  std::mt19937 random(1);
  std::map<std::string, fs::file_time_type> before;
  const int kills = allCases() ? 30 : 8;
  // One step draws up to about 100 points, and some points must be left.
  for (int i = 0; i < kills && before.size() < 150; ++i) {
    double moment = double(random()) / double(random.max());
    if (i % 5 == 0) killAt("killed", 0, 0.7 * moment);
    else killAt("killed", before.size() + random() % 6, 0.02 * moment);
    std::map<std::string, fs::file_time_type> now = points("killed");
    for (const auto& [name, time] : before) EXPECT_EQ(now.at(name), time) << "written again";
    before = now;
    expectWholePictures("killed");
  }
  EXPECT_GT(before.size(), 0u);
  EXPECT_LT(before.size(), 305u) << "no point was left to draw";

  // The report of an unfinished sweep has the same rows for drawn points.
  Outcome report = run("report " + (folder_ / "killed"), "STROBE_VALIDATION=0");
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_NE(report.err.find("strobe: not drawn yet: "), std::string::npos) << report.err;
  std::istringstream some(file("killed", "table.csv")), whole(file("whole", "table.csv"));
  size_t drawn = 0;
  for (std::string left, right; std::getline(some, left) && std::getline(whole, right);)
    if (left == right + "," || left == right + ",note") ++drawn;
    else EXPECT_TRUE(left.ends_with(",,,,not drawn")) << left;
  EXPECT_GT(drawn, 1u) << "rows besides the header";
  EXPECT_NE(file("killed", "result.md").find("Not drawn yet: "), std::string::npos);
  Outcome last = run(command("killed"), "STROBE_VALIDATION=0");
  ASSERT_EQ(last.exit_code, 0) << last.err;
  for (const auto& [name, time] : before) EXPECT_EQ(points("killed").at(name), time) << "written again";
  EXPECT_EQ(points("killed").size(), 305u);
  EXPECT_EQ(file("killed", "table.csv"), file("whole", "table.csv"));
  for (const char* part : {"points", "truth"})
    for (const auto& entry : fs::directory_iterator(folder_ / ("killed/" + std::string(part))))
      EXPECT_TRUE(
          std::regex_match(entry.path().filename().string(), std::regex("[0-9a-f]{32}_[0-9a-f]{8}\\.(json|png|exr)")))
          << entry.path() << " is an unfinished file";
}

// One line for any number of processes; it states the number of files.
TEST_F(Resume, InterruptedSweepReportsKeptPointsAndContinues) {
  writeText(folder_ / "x.lua", few("experiment.linear(1, 40, 40)"));
  for (const std::string more : {"", "--jobs 2", "--jobs 3"}) {
    const std::string out = "out" + more.substr(more.size() ? more.size() - 1 : 0);
    Outcome outcome = interruptAt(out, 4, more, more != "--jobs 3");
    EXPECT_EQ(outcome.exit_code, 75);
    std::smatch match;
    const std::regex line("(^|\n)interrupted; (\\d+) of 80 points (is|are) kept; the same command continues\n$");
    ASSERT_TRUE(std::regex_search(outcome.err, match, line)) << outcome.err;
    EXPECT_GE(std::stoi(match[2]), 2) << "two of four files may be truths";
    EXPECT_LT(std::stoi(match[2]), 80) << "the sweep was not interrupted";
    EXPECT_EQ(outcome.err.find("signal"), std::string::npos) << outcome.err;
    EXPECT_TRUE(copyIn(folder_ / out).empty());
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / out))
      EXPECT_TRUE(entry.path().extension() != ".part" && entry.path().extension() != ".lock") << entry.path();
  }
  // The same command runs at once, while processes of the interrupted sweep may still be ending.
  const std::map<std::string, fs::file_time_type> before = points("out2");
  ASSERT_EQ(run(command("out2"), "STROBE_VALIDATION=0").exit_code, 0);
  for (const auto& [name, time] : before) EXPECT_EQ(points("out2").at(name), time) << "written again";
  EXPECT_TRUE(copyIn(folder_ / "out2").empty());
}

TEST_F(Resume, TimeLimitStopsASweepThatContinues) {
  writeText(folder_ / "x.lua", few("experiment.linear(1, 12, 12)"));
  Outcome stopped = run(command("out", "--time-left 0.8"), "STROBE_VALIDATION=0");
  EXPECT_EQ(stopped.exit_code, 75);
  EXPECT_NE(stopped.err.find("the time is up (--time-left); "), std::string::npos) << stopped.err;
  EXPECT_NE(stopped.err.find("the same command continues\n"), std::string::npos) << stopped.err;
  EXPECT_EQ(run(command("out", "--time-left 1000"), "STROBE_VALIDATION=0").exit_code, 0);
}

// The run fails after its last point, before its results are written.
TEST_F(Resume, UnwritableResultsAreWrittenLater) {
  writeText(folder_ / "x.lua", few("{ 2 }"));
  fs::create_directories(folder_ / "out/report.html/in_the_way");
  Outcome outcome = run(command("out"), "STROBE_VALIDATION=0");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("out/report.html: cannot be written"), std::string::npos) << outcome.err;
  ASSERT_FALSE(fs::exists(folder_ / "out/result.json"));
  fs::remove_all(folder_ / "out/report.html");
  Outcome report = run("report " + (folder_ / "out"), "STROBE_VALIDATION=0");
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_NE(file("out", "table.csv").find("\n2,hybrid,bar,inner,0.5,2,"), std::string::npos);
  ASSERT_EQ(run(command("out"), "STROBE_VALIDATION=0").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out/unfinished.json"));
}

TEST_F(Resume, InterruptedDemoKeepsItsFileNames) {
  writeText(folder_ / "x.lua", R"lua(
local capture = require "strobe.capture"
local arms = { { name = "truth", pipeline = "ground_truth", set = { samples = 16 } } }
for i = 1, 60 do arms[i + 1] = { name = "hybrid " .. i, pipeline = "hybrid", set = { samples = i } } end
return capture {
  title = "Many", size = { 64, 36 }, layers = {}, measures = { "rmse" }, truth = "truth",
  shots = { { name = "bar", scene = "oracles/bar" } }, arms = arms,
}
)lua");
  killAt("out", 3, 0, "demo");
  ASSERT_FALSE(fs::exists(folder_ / "out/demo.json"));
  Outcome outcome = run("report " + (folder_ / "out"), "STROBE_VALIDATION=0");
  ASSERT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("strobe: not drawn yet: "), std::string::npos) << outcome.err;
  EXPECT_NE(file("out", "demo.md").find("Not drawn yet: "), std::string::npos);
  for (const char* name : {"demo.json", "demo.html"}) EXPECT_TRUE(fs::exists(folder_ / ("out/" + std::string(name))));
  EXPECT_FALSE(fs::exists(folder_ / "out/result.json"));
}

// Names of points are hashes of their inputs, and each point has the hash of its picture.
TEST_F(Resume, ResultsDoNotDependOnProcessesOrOrder) {
  writeText(folder_ / "x.lua", few("{ 2, 3, 5, 8 }"));
  ASSERT_EQ(run(command("one")).exit_code, 0);
  Outcome two = run(command("two", "--jobs 2"));
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(file("two", "table.csv"), file("one", "table.csv"));
  writeText(folder_ / "x.lua", few("{ 8, 5, 3, 2 }"));
  ASSERT_EQ(run(command("backwards")).exit_code, 0);
  ASSERT_EQ(points("one").size(), 9u);
  for (const auto& [name, time] : points("one"))
    for (const char* other : {"two", "backwards"})
      EXPECT_EQ(file(other, "points/" + name), file("one", "points/" + name)) << other;
}

TEST_F(Resume, AddedValueDrawsOnlyNewPoints) {
  writeText(folder_ / "x.lua", few("{ 2, 8 }"));
  ASSERT_EQ(run(command("out"), "STROBE_VALIDATION=0").exit_code, 0);
  auto before = points("out");
  ASSERT_EQ(before.size(), 5u);
  writeText(folder_ / "x.lua", few("{ 2, 4, 8 }"));
  ASSERT_EQ(run(command("out"), "STROBE_VALIDATION=0").exit_code, 0);
  auto after = points("out");
  EXPECT_EQ(after.size(), 7u);
  for (const auto& [name, time] : before) EXPECT_EQ(after.at(name), time);
  EXPECT_NE(file("out", "table.csv").find("\n6,hybrid,bar,inner,0.5,8,"), std::string::npos)
      << file("out", "table.csv");

  // Points drawn on another machine are merged by copying them.
  writeText(folder_ / "x.lua", few("{ 16 }"));
  ASSERT_EQ(run(command("elsewhere"), "STROBE_VALIDATION=0").exit_code, 0);
  fs::copy(folder_ / "elsewhere/points", folder_ / "out/points",
           fs::copy_options::recursive | fs::copy_options::skip_existing);
  auto merged = points("out");
  writeText(folder_ / "x.lua", few("{ 2, 4, 8, 16 }"));
  ASSERT_EQ(run(command("out"), "STROBE_VALIDATION=0").exit_code, 0);
  EXPECT_EQ(points("out"), merged) << "no new point was drawn";
}

TEST_F(Resume, LinearPicturesAreKeptOnRequest) {
  writeText(folder_ / "x.lua", few("{ 2 }"));
  ASSERT_EQ(run(command("out"), "STROBE_VALIDATION=0").exit_code, 0);
  auto without = points("out");
  ASSERT_EQ(run(command("out", "--exr"), "STROBE_VALIDATION=0").exit_code, 0);
  ASSERT_EQ(points("out").size(), without.size());
  for (const auto& [name, time] : points("out")) {
    Path point = folder_ / ("out/points/" + name);
    for (const char* ending : {".png", ".exr", ".record.json"})
      EXPECT_TRUE(fs::exists(Path(point).replace_extension(ending))) << name << ending;
    Json record = Json::parse(contentOf(Path(point).replace_extension(".record.json")));
    EXPECT_EQ(record["outputs"]["color"], Json::parse(contentOf(point))["image"]) << "hash of the measured picture";
  }
}

// Measures of a sweep equal the results of `compare` for the kept files.
TEST_F(Resume, MeasuresMatchCompare) {
  const std::map<std::string, std::string> names = {{"rmse", "rmse"},
                                                    {"mse", "mse"},
                                                    {"flip", "ldr_flip"},
                                                    {"flip_max", "ldr_flip_max"},
                                                    {"hdr_flip", "hdr_flip"},
                                                    {"psnr", "psnr"},
                                                    {"hdr_flip_max", "hdr_flip_max"},
                                                    {"ssim", "ssim"},
                                                    {"relmse", "relmse"},
                                                    {"ms_ssim", "ms_ssim"},
                                                    {"smape", "smape"},
                                                    {"relmse_trimmed", "relmse_trimmed"}};
  std::string measures;
  for (const auto& [name, key] : names) measures += "\"" + name + "\", ";
  writeText(folder_ / "x.lua", R"lua(return require "strobe.experiment" {
    title = "All", size = { 192, 180 }, regions = { "whole" }, measures = { )lua" +
                                   measures + R"lua( },
    shots = { { name = "bar", scene = "oracles/bar" } }, arms = { { name = "sharp", pipeline = "none" } },
    truth = { pipeline = "ground_truth", set = { samples = 16 } } })lua");
  Outcome swept = run(command("out", "--exr"), "STROBE_VALIDATION=0");
  ASSERT_EQ(swept.exit_code, 0) << swept.err;
  Json group = Json::parse(file("out", "result.json"))["groups"][0]["points"];
  auto picture = [&](size_t i) { return folder_ / ("out/points/" + group[i]["key"].get<std::string>() + ".exr"); };
  Outcome compared = run("compare " + picture(1) + " " + picture(0) + " --json");
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  Json said = Json::parse(compared.out);
  for (const auto& [name, key] : names) {
    const Json& values = group[1]["values"][name];
    double value = values.begin()->get<double>();
    EXPECT_NEAR(value, said[key].get<double>(), 1e-6 * std::abs(value)) << name;
  }
  // Other programs also read the file of truth as a colour picture.
  for (const auto& entry : fs::directory_iterator(folder_ / "out/truth")) {
    Outcome same = run("compare " + picture(0) + " " + entry.path().string() + " --json");
    ASSERT_EQ(same.exit_code, 0) << same.err;
    EXPECT_EQ(Json::parse(same.out)["mse"], 0);
    Outcome info = runLine("oiiotool --info -v '" + entry.path().string() + "'");
    if (info.exit_code == 0) EXPECT_NE(info.out.find("channel list: R, G, B, A\n"), std::string::npos) << info.out;
  }
}

// A shader is edited in the middle of the sweep; the sweep continues with the original shader.
TEST_F(Resume, EditsDuringASweepHaveNoEffect) {
  const std::string home = ownHome();
  std::string environment = "STROBE_VALIDATION=0 STROBE_HOME=" + home;
  // The last values need a shader that no earlier value needs.
  std::string text = few("experiment.linear(1, 150, 150)");
  size_t from = text.find("experiment.grid"), to = text.find(" } }", from) + 2;
  text.replace(
      from, to - from,
      "experiment.each { " + text.substr(from, to - from) + ", experiment.grid { weights = { \"uniform\" } } }");
  std::string hybrid = ", { name = \"hybrid\", pipeline = \"hybrid\" }";
  text.erase(text.find(hybrid), hybrid.size());
  writeText(folder_ / "x.lua", text);
  ASSERT_EQ(run(command("plain"), environment).exit_code, 0);

  std::thread editor([&] {
    for (int waited = 0; points("edited").size() < 5 && waited < 3000; ++waited)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    writeText(home + "/shaders/gather/mcguire2012.glsl", "void main() { broken }");
    writeText(home + "/shaders/gather/uniform.glsl", "void main() { broken }");
  });
  Outcome edited = run(command("edited"), environment);
  editor.join();
  EXPECT_EQ(edited.exit_code, 0) << edited.err;
  EXPECT_EQ(file("edited", "table.csv"), file("plain", "table.csv"));
}

// The same for a pipeline and a scene beside the experiment; commands name the original files.
TEST_F(Resume, EditsBesideTheExperimentHaveNoEffect) {
  const fs::path home = ownHome();
  fs::create_directories(home / "experiments");
  const std::vector<std::string> files = {"experiments/card.lua", "experiments/own.lua"};
  writeText(home / files[0], kCardScene);
  fs::copy(home / "scripts/pipelines/mcguire2012.lua", home / files[1]);
  writeText(home / "experiments/x.lua", R"lua(return require "strobe.experiment" {
    title = "Beside", size = { 64, 36 }, regions = { "whole" }, measures = { "rmse" },
    shots = { { name = "card", scene = "card.lua" } }, arms = { { name = "own", pipeline = "own.lua" } },
    truth = { pipeline = "ground_truth", set = { samples = 4 } }, expect = { { "it is drawn", function() return true end } },
  })lua");
  const std::string line = fmt::format("sweep {} -o {} ", (home / "experiments/x.lua").string(), folder_ / "edited");
  std::thread editor = spoilOnceCopied(home, folder_ / "edited", files);
  Outcome edited = run(line, "STROBE_VALIDATION=0 STROBE_HOME=" + home.string());
  editor.join();
  EXPECT_EQ(edited.exit_code, 0) << edited.err;
  EXPECT_NE(contentOf(home / files[1]).find("edited"), std::string::npos);
  Json result = Json::parse(file("edited", "result.json"));
  std::string command = result["groups"][0]["points"][1]["command"];
  for (const std::string& one : files) {
    EXPECT_NE(command.find((home / one).string()), std::string::npos) << command;
    EXPECT_EQ(result["inputs"].count("strobe:" + one), 1u) << result["inputs"];
  }
  EXPECT_EQ(result["arms"][0]["pipeline"], (home / files[1]).string());
}

}  // namespace resume_test
}  // namespace strobe::testing
