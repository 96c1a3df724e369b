// SPDX-License-Identifier: MIT
// The trace of a run follows its format and has the times of one round.
#include <gtest/gtest.h>

#include "bench/report.h"
#include "bench/synthetic.h"

namespace strobe::bench::test {
namespace trace_test {

std::vector<Json> eventsOf(const Json& trace, int process, const std::string& phase) {
  std::vector<Json> events;
  for (const Json& event : trace.at("traceEvents"))
    if (event.at("pid") == process && event.at("ph") == phase) events.push_back(event);
  return events;
}

class Trace : public ::testing::Test {
 protected:
  bench::Run run_ = runOf(7, [](const std::string&, const std::string& pass, int round) {
    return 0.125 * double(pass.size()) + 0.25 * ((round * 3) % 7);
  });
  Json trace_ = Json::parse(traceOf(run_).dump());
};

TEST_F(Trace, HasAProcessPerShotWithItsName) {
  for (int process : {1, 2}) {
    std::vector<Json> names = eventsOf(trace_, process, "M");
    ASSERT_EQ(names.size(), 2u);
    EXPECT_EQ(names[0]["name"], "process_name");
    EXPECT_EQ(names[0]["args"]["name"], run_.shots[size_t(process - 1)].name());
    EXPECT_EQ(names[1]["name"], "thread_name");
  }
  EXPECT_TRUE(eventsOf(trace_, 3, "X").empty());
}

TEST_F(Trace, PassesFillTheFrameInOrder) {
  for (size_t i = 0; i < run_.shots.size(); ++i) {
    const ShotTimes& shot = run_.shots[i];
    std::vector<Json> events = eventsOf(trace_, int(i) + 1, "X");
    ASSERT_EQ(events.size(), shot.passes.size() + 2) << "the frame, its passes, the rest";
    EXPECT_EQ(events[0]["name"], "frame");
    EXPECT_EQ(events[0]["ts"], 0);
    double end_us = 0;
    for (size_t e = 1; e < events.size(); ++e) {
      EXPECT_NEAR(events[e]["ts"].get<double>(), end_us, 1e-9) << events[e];
      EXPECT_GE(events[e]["dur"].get<double>(), 0);
      end_us += events[e]["dur"].get<double>();
    }
    EXPECT_NEAR(events[0]["dur"].get<double>(), end_us, 1e-9);
    EXPECT_NEAR(end_us, 1000 * median(shot.ms), 1e-9) << "the median of seven rounds is one round";
    EXPECT_EQ(events[0]["args"]["round"], shot.typicalRound());
  }
}

TEST_F(Trace, EventsDescribeTheirPass) {
  for (const Json& event : eventsOf(trace_, 2, "X"))
    for (const char* field : {"name", "ph", "ts", "dur", "pid", "tid"}) EXPECT_TRUE(event.contains(field)) << field;
  const Json pass = eventsOf(trace_, 2, "X")[1];
  EXPECT_EQ(pass["args"], Json::parse(R"({"executions": 1, "bytes_read": 100, "bytes_written": 200, "rays": 7})"));
}

}  // namespace trace_test
}  // namespace strobe::bench::test
