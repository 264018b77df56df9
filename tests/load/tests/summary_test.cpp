#include "load/summary.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "load/verdict.h"

namespace cutaway::load {
namespace {

/// A client that moved from 1 s to 9 s and had so many frames a second, each so late.
Record moving_client(double first_frame_s, double frames_per_second, float latency_ms,
                     int role = 0) {
  Record record{
      .role = role, .first_message_s = first_frame_s - 0.5, .first_frame_s = first_frame_s};
  record.moving = {{1.0, 9.0}};
  const int count = static_cast<int>(8.0 * frames_per_second);
  for (int i = 0; i < count; ++i) {
    const double at_s = 1.0 + (i + 1) / frames_per_second;
    record.frames.push_back(
        {.at_s = at_s, .latency_ms = latency_ms, .bytes = 1000, .moving = true});
  }
  return record;
}

Script script_of(int roles) {
  Script script;
  script.roles.resize(static_cast<std::size_t>(roles));
  return script;
}

const Check& check(const std::vector<Check>& checks, const std::string& name) {
  return *std::ranges::find(checks, name, &Check::name);
}

TEST(Summary, CountsOnceEveryClientHasAFrame) {
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {moving_client(0.5, 10, 20), moving_client(5.0, 10, 20)};
  const Summary all = summarise(script_of(1), outcome);
  EXPECT_DOUBLE_EQ(all.window.begin_s, 5.0);
  EXPECT_DOUBLE_EQ(all.clients[0].moving_s, 4.0);
  EXPECT_NEAR(all.clients[0].frames_per_second, 10.0, 0.3);
  EXPECT_DOUBLE_EQ(all.first_frame_s.max, 0.5);
  EXPECT_EQ(all.latency_ms.p95, 20.0);
  EXPECT_NEAR(all.bytes_per_second, 2 * 40 * 1000 / 5.0, 500.0);
}

TEST(Summary, FairnessIsWithinARole) {
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {moving_client(0.5, 8, 20), moving_client(0.5, 12, 20),
                     moving_client(0.5, 40, 5, 1)};
  const Summary all = summarise(script_of(2), outcome);
  EXPECT_NEAR(*all.fairness, 0.2, 1e-6);
  EXPECT_NEAR(*all.least_frames_per_second, 8.0, 1e-6);
}

TEST(Summary, SlowReadersAreReportedAndNotJudged) {
  Script script = script_of(2);
  script.roles[1].reading = ReadingStop{.stops_after_s = 1, .for_s = 5};
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {moving_client(0.5, 10, 20), moving_client(0.5, 1, 5000, 1)};
  const Summary all = summarise(script, outcome);
  EXPECT_EQ(all.latency_ms.max, 20.0);
  EXPECT_NEAR(*all.least_frames_per_second, 10.0, 1e-6);
  EXPECT_EQ(all.roles[1].latency_ms.max, 5000.0);
}

TEST(Summary, SeesLatencyAndMemoryGrow) {
  RunOutcome outcome{.seconds = 9.0};
  outcome.clients = {moving_client(0.0, 10, 20)};
  for (FrameSample& frame : outcome.clients[0].frames)
    if (frame.at_s > 6.0) frame.latency_ms = 80.0F;
  for (int i = 1; i < 9; ++i) outcome.memory.push_back({i * 1.0, i < 7 ? 100.0 : 130.0});
  const Summary all = summarise(script_of(1), outcome);
  EXPECT_NEAR(*all.latency_growth_ms, 60.0, 1e-4);
  EXPECT_DOUBLE_EQ(*all.memory_growth_mib, 30.0);
}

TEST(Verdict, SaysExpectedAndMeasured) {
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {moving_client(0.5, 10, 20)};
  const Summary all = summarise(script_of(1), outcome);
  const auto checks = judge({.latency_p95_ms = 10.0, .frames_per_second = 5.0}, all);
  EXPECT_FALSE(all_held(checks));
  EXPECT_FALSE(check(checks, "latency p95").held);
  EXPECT_EQ(check(checks, "latency p95").expected, "at most 10 ms");
  EXPECT_EQ(check(checks, "latency p95").measured, "20 ms");
  EXPECT_TRUE(check(checks, "frames per second").held);
  EXPECT_TRUE(check(checks, "errors").held);
}

TEST(Verdict, NothingMeasuredHasNotHeld) {
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {Record{}};
  const auto checks = judge({.latency_p95_ms = 10.0}, summarise(script_of(1), outcome));
  EXPECT_FALSE(check(checks, "clients without a frame").held);
  EXPECT_FALSE(check(checks, "latency p95").held);
  EXPECT_EQ(check(checks, "latency p95").measured, "nothing");
}

TEST(Verdict, MemoryIsJudgedOnlyWhereItWasWatched) {
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {moving_client(0.5, 10, 20)};
  EXPECT_TRUE(all_held(judge({.memory_growth_mib = 1.0}, summarise(script_of(1), outcome))));
  outcome.memory = {{1.0, 100.0}};  // and it went away
  EXPECT_FALSE(all_held(judge({.memory_growth_mib = 1.0}, summarise(script_of(1), outcome))));
}

TEST(Verdict, OneStaleFrameIsTooMany) {
  RunOutcome outcome{.seconds = 10.0};
  outcome.clients = {moving_client(0.5, 10, 20)};
  outcome.clients[0].stale_frames = 1;
  EXPECT_FALSE(all_held(judge({}, summarise(script_of(1), outcome))));
}

}  // namespace
}  // namespace cutaway::load
