// SPDX-License-Identifier: MIT
#include "base/process.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cstdlib>
#include <future>

#include "base/error.h"
#include "base/log.h"
#include "common/refusal.h"

namespace strobe {
namespace process_test {

Program shell(const std::string& script) { return {.arguments = {"sh", "-c", script}}; }

// Input of one piece, for one run.
std::function<std::string()> once(std::string text) {
  return [text = std::move(text)]() mutable { return std::exchange(text, {}); };
}

TEST(Process, ReadsItsInputAndKeepsItsStreamsApart) {
  Program program = shell("read line; echo \"got $line\"; echo oops >&2; exit 3");
  program.input = once("words\n");
  ProgramEnd end = run(program);
  EXPECT_EQ(end.output, "got words\n");
  EXPECT_EQ(end.errors, "oops\n");
  EXPECT_EQ(end.code(), 3);
  EXPECT_FALSE(end.succeeded());
  program.errors = Program::Errors::with_output;
  program.input = once("words\n");
  EXPECT_EQ(run(program).output, "got words\noops\n");
}

// More than a pipe holds, in both directions and on both streams.
TEST(Process, LargeInputAndOutputPass) {
  Program program = shell("tee /dev/stderr");
  const std::string text(3 << 20, 'x');
  program.input = once(text);
  ProgramEnd end = run(program);
  EXPECT_TRUE(end.output == text);
  EXPECT_TRUE(end.errors == text);
  program.arguments = {"true"};  // reads nothing
  program.input = once(text);
  EXPECT_TRUE(run(program).succeeded());
}

// Input larger than memory is supplied in pieces.
TEST(Process, InputIsSuppliedInPieces) {
  Program program = shell("cat");
  int piece = 0;
  program.input = [&] { return ++piece <= 300 ? std::string(10000, char('a' + piece % 26)) : std::string(); };
  ProgramEnd end = run(program);
  EXPECT_EQ(end.output.size(), 3000000u);
  EXPECT_EQ(end.output.back(), 'a' + 300 % 26);
  EXPECT_TRUE(end.succeeded());

  program = shell("head -c 3; exec <&-; exit 4");  // and stops reading
  program.input = [] { return std::string(1 << 20, 'x'); };
  end = run(program);
  EXPECT_EQ(end.output, "xxx");
  EXPECT_EQ(end.code(), 4);

  program = shell("cat; sleep 100");
  program.input = []() -> std::string { throw Error("no more"); };
  double started_s = clockSeconds();
  EXPECT_THROW(run(program), Error);
  EXPECT_LT(clockSeconds() - started_s, 50);
}

TEST(Process, InheritsTheEnvironmentWithOverrides) {
  ::setenv("STROBE_TEST_KEPT", "kept", 1);
  ::setenv("STROBE_TEST_GIVEN", "ours", 1);
  Program program = shell("echo $STROBE_TEST_KEPT $STROBE_TEST_GIVEN $STROBE_TEST_GIVEN_TOO");
  program.environment = {"STROBE_TEST_GIVEN=own", "STROBE_TEST_GIVEN_TOO=too"};
  EXPECT_EQ(run(program).output, "kept own too\n");
  ::unsetenv("STROBE_TEST_KEPT");
  ::unsetenv("STROBE_TEST_GIVEN");
}

TEST(Process, SignalIsNamed) {
  ProgramEnd end = run(shell("kill -SEGV $$"));
  EXPECT_EQ(end.signal, SIGSEGV);
  EXPECT_EQ(end.code(), 128 + SIGSEGV);
}

TEST(Process, MissingProgramIsAnError) {
  EXPECT_EQ(testing::refusalOf([&] { run({.arguments = {"/nonexistent/program"}}); }),
            "'/nonexistent/program' cannot be started: No such file or directory");
}

// The child of the child holds the stream open: the whole group has to end.
TEST(Process, WallClockLimitKillsTheGroup) {
  for (const char* script : {"sleep 60 & sleep 60", "exec >/dev/null 2>&1; sleep 60"}) {
    Program program = shell(script);
    program.wall_s = 0.2;
    ProgramEnd end = run(program);
    EXPECT_TRUE(end.timed_out) << script;
    EXPECT_FALSE(end.succeeded()) << script;
    EXPECT_EQ(end.signal, SIGKILL) << script;
    EXPECT_LT(end.seconds, 10) << script;
  }
}

TEST(Process, OutputIsBounded) {
  Program program = shell("printf 123456; sleep 0.1; printf 789; echo end >&2");
  program.output_bytes = 7;
  program.drops_rest = true;
  ProgramEnd end = run(program);
  EXPECT_EQ(end.output, "1234567");
  EXPECT_EQ(end.errors, "end\n");
  EXPECT_TRUE(end.too_long);
  EXPECT_EQ(end.code(), 0);
  program = shell("yes");
  end = run(program);
  EXPECT_TRUE(end.too_long);
  EXPECT_EQ(end.output.size(), program.output_bytes);
  EXPECT_EQ(end.signal, SIGKILL);
}

TEST(Process, CallbackRunsMeanwhile) {
  int calls = 0;
  Program program = shell("sleep 0.3");
  program.meanwhile = [&] { ++calls; };
  run(program);
  EXPECT_GE(calls, 5);
}

TEST(Process, ThreadsRunProgramsConcurrently) {
  std::vector<std::future<std::string>> outputs;
  for (int i = 0; i < 32; ++i)
    outputs.push_back(std::async(std::launch::async, [i] { return run(shell("echo " + std::to_string(i))).output; }));
  for (size_t i = 0; i < outputs.size(); ++i) EXPECT_EQ(outputs[i].get(), std::to_string(i) + "\n");
}

}  // namespace process_test
}  // namespace strobe
