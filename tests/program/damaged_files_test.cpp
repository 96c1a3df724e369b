// SPDX-License-Identifier: MIT
// Damaged files of a sweep or a capture: each is named, counts as missing and is made again. Commands end only with
// exit code 0, 1 or 2.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace damaged_files_test {

const char* const kExperiment = R"lua(
local experiment = require "strobe.experiment"
return experiment {
  title = "Damaged", size = { 32, 18 }, regions = { "whole", "inner" }, measures = { "rmse", "memory" },
  shots = { { name = "bar", scene = "oracles/bar", crops = { "inner" } } },
  arms = { { name = "none", pipeline = "none" }, { name = "mcguire", pipeline = "mcguire2012" } },
  truth = { pipeline = "ground_truth", set = { samples = 4 } },
  vary = { experiment.grid { exposure = { 0.2, 0.4, 0.6, 0.8 } } },
  layout = { pictures = { crop_size = { 8, 8 } }, front = { x = "memory" } },
}
)lua";

const char* const kCapture = R"lua(
return require "strobe.capture" {
  title = "Damaged", size = { 32, 18 }, layers = {},
  shots = { { name = "bar", scene = "oracles/bar" } },
  arms = { { name = "none", pipeline = "none" } },
}
)lua";

using Files = std::vector<fs::path>;

// Regular files below a folder, sorted by name.
Files filesIn(const fs::path& folder) {
  Files files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Files filesIn(const fs::path& folder, const std::string& ending) {
  Files files = filesIn(folder);
  std::erase_if(files, [&](const fs::path& file) { return !file.string().ends_with(ending); });
  return files;
}

size_t count(const std::string& text, const std::string& what) {
  size_t found = 0;
  for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
  return found;
}

// A complete sweep and a complete capture; each test damages a copy.
class DamagedFiles : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    writeText(path("x.lua"), kExperiment);
    writeText(path("c.lua"), kCapture);
    Outcome swept = program("sweep x.lua -o whole"), captured = program("capture c.lua -o taken");
    ASSERT_EQ(swept.exit_code + captured.exit_code, 0) << swept.err << captured.err;
    table_ = contentOf(path("whole/table.csv"));
    ASSERT_EQ(count(table_, "\n"), 1 + 4 * 2 * 2) << table_;
  }
  static void TearDownTestSuite() { folder_.reset(); }

  void SetUp() override { copyAnew(); }

  static void copyAnew() {
    for (const char* name : {"copy", "copy_taken"}) fs::remove_all(path(name));
    fs::copy(path("whole"), path("copy"), fs::copy_options::recursive);
    fs::copy(path("taken"), path("copy_taken"), fs::copy_options::recursive);
    writeText(path("copy.lua"), kExperiment);
  }

  static fs::path path(const std::string& name) { return folder_->path() / name; }

  static Outcome program(const std::string& arguments) {
    return runLine("cd '" + folder_->path().string() + "' && exec timeout 120 env STROBE_VALIDATION=0 '" +
                   programPath() + "' " + arguments);
  }

  // One line for each damaged file; afterwards no file is damaged.
  static void expectMadeAgain(size_t damaged) {
    Outcome first = program("sweep x.lua -o copy");
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(count(first.err, ": is damaged and counts as missing; it is made again"), damaged) << first.err;
    EXPECT_EQ(contentOf(path("copy/table.csv")), table_);
    Outcome report = program("report copy");
    EXPECT_EQ(report.exit_code, 0) << report.err;
    EXPECT_EQ(report.err, "");
    EXPECT_EQ(contentOf(path("copy/table.csv")), table_);
  }

  static inline std::unique_ptr<TemporaryFolder> folder_;
  static inline std::string table_;
};

TEST_F(DamagedFiles, OfPointsAreDrawnAgain) {
  Files points = filesIn(path("copy/points"), ".json");
  ASSERT_EQ(points.size(), 12u);
  const std::string whole = contentOf(points[0]), other = contentOf(points[11]);
  const std::vector<std::string> contents = {"",  whole.substr(0, 120),   "[]", "{}", "null",
                                             "3", std::string(200, '\0'), other};
  for (size_t i = 0; i < contents.size(); ++i) writeText(points[i], contents[i]);
  Outcome report = program("report copy");
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_EQ(count(report.err, ".json: is damaged and left out; run the same sweep again to make it\n"), 8u)
      << report.err;
  EXPECT_EQ(count(report.err, "not drawn yet: "), 1u) << report.err;
  EXPECT_EQ(count(report.err, "\n"), 9u) << report.err;
  EXPECT_EQ(count(contentOf(path("copy/table.csv")), "\n"), count(table_, "\n"));
  expectMadeAgain(8);
}

// One changed digit of a value: a valid point with another value.
TEST_F(DamagedFiles, WithAnotherValueAreFound) {
  for (const fs::path& point : filesIn(path("copy/points"), ".json")) {
    std::string text = contentOf(point);
    size_t at = text.find("\"whole\": 0.0");
    if (at == std::string::npos) continue;
    text[at + 12] = text[at + 12] == '9' ? '1' : char(text[at + 12] + 1);
    writeText(point, text);
    return expectMadeAgain(1);
  }
  FAIL() << "no point has an error";
}

TEST_F(DamagedFiles, OfTruthsAreDrawnAgain) {
  Files truths = filesIn(path("copy/truth"), ".exr");
  ASSERT_EQ(truths.size(), 4u);
  fs::resize_file(truths[0], 200);
  writeText(truths[1], "");
  fs::copy_file(filesIn(path("copy/points"), ".png")[0], truths[2], fs::copy_options::overwrite_existing);
  fs::copy_file(path("whole/truth") / truths[0].filename(), truths[3], fs::copy_options::overwrite_existing);
  for (const fs::path& point : filesIn(path("copy/points"), ".json")) fs::remove(point);
  expectMadeAgain(4);
}

// A valid EXR file of the right size with another text.
TEST_F(DamagedFiles, OfATruthWithAnotherTextAreFound) {
  const fs::path truth = filesIn(path("copy/truth"), ".exr")[0];
  std::string text = contentOf(truth);
  size_t at = text.find("ground_truth");
  ASSERT_NE(at, std::string::npos);
  text[at] = 'G';
  writeText(truth, text);
  for (const fs::path& point : filesIn(path("copy/points"), ".json")) fs::remove(point);
  expectMadeAgain(1);
}

TEST_F(DamagedFiles, OfPicturesAreDrawnAgain) {
  Files shown = filesIn(path("copy/points"), ".png");
  fs::resize_file(shown[0], 30);
  fs::copy_file(path("copy/report.png"), shown[1], fs::copy_options::overwrite_existing);
  // Damage files of three points, in the order of their names.
  fs::resize_file(filesIn(path("copy/bar"), ".exr")[0], 100);
  writeText(filesIn(path("copy/bar"), ".png")[1], "x");
  writeText(filesIn(path("copy/bar"), ".record.json")[2], "{");
  const size_t damaged = 5;
  Outcome report = program("report copy");
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_EQ(count(report.err, ": is damaged and left out"), damaged) << report.err;
  expectMadeAgain(damaged);
}

TEST_F(DamagedFiles, OfTheFolderAreWrittenAgain) {
  const std::string experiment = contentOf(path("copy/experiment.json"));
  for (const std::string& content : {experiment.substr(0, 20), std::string(), contentOf(path("copy/result.json"))}) {
    copyAnew();
    writeText(path("copy/experiment.json"), content);
    expectMadeAgain(1);
  }
  // A file of another experiment is not damaged.
  writeText(path("copy.lua"), std::string(kExperiment).replace(std::string(kExperiment).find("Damaged"), 7, "Another"));
  Outcome refused = program("sweep copy.lua -o copy");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("has points of another experiment, 'Damaged', not of 'Another'"), std::string::npos);

  fs::resize_file(path("copy/result.json"), 200);
  Outcome report = program("report copy");
  EXPECT_EQ(report.exit_code, 1);
  EXPECT_EQ(report.err,
            "strobe: copy/result.json: is not a result of an experiment, or is damaged; the same sweep writes it "
            "again\n");
  expectMadeAgain(0);
}

// ---- Random damage

// Damages a file in a random way.
void damage(const fs::path& file, const Files& others, std::mt19937& random) {
  auto below = [&](size_t n) { return size_t(random() % std::max<size_t>(n, 1)); };
  std::string text = contentOf(file);
  switch (below(6)) {
    case 0:
      text.resize(below(text.size()));
      break;
    case 1:
      text.clear();
      break;
    case 2: {
      size_t from = below(text.size()), to = from + below(text.size() - from) + 1;
      for (size_t i = from; i < std::min(to, text.size()); ++i) text[i] = '\0';
      break;
    }
    case 3:
      text = contentOf(others[below(others.size())]);
      break;
    case 4: {
      const char* const kStubs[] = {"[]", "{}", "null", "3", "\"text\"", "{\"title\": \"Damaged\"}"};
      text = kStubs[below(std::size(kStubs))];
      break;
    }
    default:
      for (size_t i = 0, flips = 1 + below(8); i < flips && !text.empty(); ++i)
        text[below(text.size())] ^= char(1 << below(8));
  }
  writeText(file, text);
}

// The command ended with its own exit code and its own messages.
void expectEnded(const Outcome& outcome, const std::string& what) {
  EXPECT_TRUE(outcome.exit_code >= 0 && outcome.exit_code <= 2) << what << ": " << outcome.exit_code << "\n"
                                                                << outcome.err;
  for (const char* foreign : {"json.exception", "std::", "vector::", "basic_string", "map::at", "stoi",
                              "filesystem error", "bad_alloc", "internal error", "terminate", "what():"})
    EXPECT_EQ(outcome.err.find(foreign), std::string::npos) << what << ": " << outcome.err;
}

class AnyDamage : public DamagedFiles {
 protected:
  // Damages a file of the sweep, and sometimes removes a point, so that the sweep reads the files it needs.
  static std::string damageSweep(std::mt19937& random) {
    Files files = filesIn(path("copy"));
    std::erase_if(files, [](const fs::path& file) {
      const std::string name = file.filename();
      return name == ".lock" || name == "result.md" || file.extension() == ".html" || file.extension() == ".csv" ||
             file.extension() == ".svg" || name == "report.png" || name.ends_with("timings.json");
    });
    if (random() % 4 == 0) fs::copy_file(path("copy/result.json"), path("copy/unfinished.json"));
    const fs::path file = random() % 6 == 0 ? path("copy/unfinished.json") : files[random() % files.size()];
    if (!fs::exists(file)) fs::copy_file(path("copy/result.json"), file);
    damage(file, files, random);
    if (random() % 2) {
      Files points = filesIn(path("copy/points"), ".json");
      fs::remove(points[random() % points.size()]);
    }
    return file.lexically_relative(path("")).string();
  }

  static void trySweep(std::mt19937& random, const std::string& trial) {
    const std::string what = trial + damageSweep(random);
    Outcome report = program("report copy");
    expectEnded(report, "report, " + what);
    Outcome swept = program("sweep x.lua -o copy");
    expectEnded(swept, "sweep, " + what);
    EXPECT_EQ(swept.exit_code, 0) << what << "\n" << swept.err;
    EXPECT_LE(count(swept.err, ": is damaged and counts"), 1u) << what << "\n" << swept.err;
    EXPECT_EQ(contentOf(path("copy/table.csv")), table_) << what;
  }

  static void tryExperiment(std::mt19937& random, const std::string& trial) {
    damage(path("copy.lua"), filesIn(path("copy")), random);
    expectEnded(program("sweep copy.lua -o copy"), "sweep, " + trial + "copy.lua");
    expectEnded(program("report copy --experiment copy.lua"), "report, " + trial + "copy.lua");
  }

  static void tryCapture(std::mt19937& random, const std::string& trial) {
    Files files = filesIn(path("copy_taken"));
    std::erase_if(files, [](const fs::path& file) { return file.filename() == "timings.json"; });
    const bool of_manifest = random() % 2;
    const fs::path file = of_manifest ? path("copy_taken/manifest.json") : files[random() % files.size()];
    damage(file, files, random);
    if (random() % 4 == 0) fs::remove(path("copy_taken/SHA256SUMS"));
    const std::string what = trial + file.lexically_relative(path("")).string();
    expectEnded(program("diff taken copy_taken"), "diff, " + what);
    expectEnded(program("verify copy_taken"), "verify, " + what);
    Outcome again = program("capture c.lua -o copy_taken");
    expectEnded(again, "capture, " + what);
    EXPECT_EQ(program("diff taken copy_taken").exit_code, 0) << what << "\n" << again.err;
  }
};

// Value of an environment variable, or another number.
int numberIn(const char* variable, int otherwise) {
  const char* value = std::getenv(variable);
  return value ? std::atoi(value) : otherwise;
}

// STROBE_DAMAGED_COPIES: number of copies. STROBE_DAMAGED_FIRST: number of the first copy, so that processes can share
// a long run.
TEST_F(AnyDamage, EndsWithOneLineAndIsRepaired) {
  const int first = numberIn("STROBE_DAMAGED_FIRST", 0), copies = numberIn("STROBE_DAMAGED_COPIES", 4);
  for (int i = first; i < first + copies && !HasFailure(); ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    copyAnew();
    const std::string trial = "copy " + std::to_string(i) + ": ";
    const int kind = i % 4;
    if (kind == 2) tryExperiment(random, trial);
    else if (kind == 3) tryCapture(random, trial);
    else trySweep(random, trial);
  }
}

}  // namespace damaged_files_test
}  // namespace strobe::testing
