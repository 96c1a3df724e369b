// SPDX-License-Identifier: MIT
// `strobe serve`: answers equal the command line.
#include <gtest/gtest.h>

#include "base/json.h"
#include "program/run.h"

namespace strobe::testing {
namespace serve_test {

class Serve : public ::testing::Test {
 protected:
  struct Answers {
    std::vector<Json> answers;
    Outcome outcome;
  };
  Answers answersTo(const std::vector<std::string>& requests) {
    std::string text;
    for (const std::string& request : requests) text += request + "\n";
    writeText(folder_ / "requests", text);
    Answers all{{}, run("serve < " + (folder_ / "requests"))};
    std::istringstream lines(all.outcome.out);
    for (std::string line; std::getline(lines, line);) all.answers.push_back(Json::parse(line));
    return all;
  }
  static std::string requestOf(const std::string& words) {
    std::istringstream stream(words);
    Json command = Json::array();
    for (std::string word; stream >> word;) command.push_back(word);
    return Json({{"command", command}}).dump();
  }

  TemporaryFolder folder_;
};

TEST_F(Serve, AnswersEqualTheCommandLine) {
  const std::vector<std::string> lines = {
      "render none --scene oracles/bar --size 32x18 --json --arrays " + (folder_ / "a"),
      "render mcguire2012 --scene oracles/bar --size 32x18 --json --arrays " + (folder_ / "b"),
      "render none --scene oracles/bar --size 32x18 --json --arrays " + (folder_ / "a"),
      "plan none --json",
      "help none",
      "--version",
      "render nnoe",
      "render none --size 3",
      "rendre none",
      "help --jsno"};
  std::vector<std::string> requests;
  for (const std::string& line : lines) requests.push_back(requestOf(line));
  const Answers all = answersTo(requests);
  ASSERT_EQ(all.answers.size(), lines.size()) << all.outcome.err;
  EXPECT_EQ(all.outcome.exit_code, 0);
  for (size_t i = 0; i < lines.size(); ++i) {
    const Json& answer = all.answers[i];
    const Outcome alone = run(lines[i]);
    const Json json = Json::parse(alone.out, nullptr, false);
    EXPECT_EQ(answer["exit"], alone.exit_code) << lines[i];
    EXPECT_EQ(answer["result"], json.is_discarded() ? Json(alone.out) : json) << lines[i];
    EXPECT_EQ(answer.contains("error") ? "strobe: " + answer["error"].get<std::string>() + "\n" : "",
              alone.exit_code ? alone.err : "")
        << lines[i];
  }
}

TEST_F(Serve, RefusesOtherCommandsAndOtherText) {
  const Answers all =
      answersTo({requestOf("live none"), requestOf("sweep x.lua"), "render none", "{\"command\": 3}", ""});
  ASSERT_EQ(all.answers.size(), 5u) << all.outcome.err;
  for (const Json& answer : all.answers) EXPECT_EQ(answer["exit"], 2);
  EXPECT_EQ(all.answers[0]["error"], "serve does not run 'live'; start it as a command: strobe live ...");
  EXPECT_NE(all.answers[2]["error"].get<std::string>().find("a request is one line"), std::string::npos);
}

TEST_F(Serve, PassBeyondItsTimeLimitEndsTheProgram) {
  const Answers all =
      answersTo({requestOf("help none"), requestOf("render ground_truth --size 64x36 --time-limit 0.000000001 --json"),
                 requestOf("help none")});
  EXPECT_EQ(all.answers.size(), 1u);
  EXPECT_EQ(all.outcome.exit_code, 1);
  EXPECT_NE(all.outcome.err.find("ran for more than 1e-09 s"), std::string::npos) << all.outcome.err;
}

}  // namespace serve_test
}  // namespace strobe::testing
