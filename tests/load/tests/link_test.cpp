#include "load/link.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>

#include "load/delay_line.h"

namespace cutaway::load {
namespace {

const TimePoint kStart{std::chrono::hours(1)};

double seconds_since_start(TimePoint time) { return Seconds(time - kStart).count(); }

/// Reads so many bytes, each piece as soon as the link has carried the one before and the reader
/// has woken up so much later; how long it took, s.
double time_for(std::size_t bytes, SimulatedLink& link, Clock::duration late) {
  TimePoint now = kStart;
  for (std::size_t got = 0; got < bytes; got += link.chunk_bytes())
    now = link.transferred(link.chunk_bytes(), now, now) + late;
  return seconds_since_start(now);
}

TEST(SimulatedLink, CarriesItsBytesPerSecond) {
  SimulatedLink link({.bytes_per_second = 625000});
  EXPECT_NEAR(time_for(1250000, link, {}), 2.0, 0.03);
}

TEST(SimulatedLink, KeepsItsRateWhenTheReaderWakesLate) {
  SimulatedLink link({.bytes_per_second = 625000});
  EXPECT_NEAR(time_for(1250000, link, std::chrono::microseconds(800)), 2.0, 0.03);
}

TEST(SimulatedLink, KeepsItsRateWhenThereIsMoreThanItCarries) {
  SimulatedLink link({.bytes_per_second = 1000});
  const TimePoint asked = kStart - std::chrono::seconds(1);
  link.transferred(500, asked, kStart);
  const TimePoint soon = kStart + std::chrono::milliseconds(300);
  EXPECT_DOUBLE_EQ(seconds_since_start(link.transferred(500, soon, soon)), 1.0);
}

TEST(SimulatedLink, SavesNothingUpWhileIdle) {
  SimulatedLink link({.bytes_per_second = 1000});
  const TimePoint later = kStart + std::chrono::seconds(10);
  link.transferred(500, kStart, kStart);
  EXPECT_DOUBLE_EQ(seconds_since_start(link.transferred(500, kStart, later)), 10.5);
}

TEST(SimulatedLink, WithoutALimitTakesNoTime) {
  SimulatedLink link({});
  EXPECT_FALSE(link.limited());
  EXPECT_EQ(link.transferred(1U << 30, kStart, kStart), kStart);
  EXPECT_EQ(link.receive_buffer_bytes(), 0);
}

TEST(SimulatedLink, ReadsInPiecesOfMillisecondsAndHidesNoQueue) {
  const SimulatedLink link({.bytes_per_second = 625000});
  EXPECT_EQ(link.chunk_bytes(), 1250U);
  EXPECT_LE(link.receive_buffer_bytes(), 625000 / 40);
}

TEST(SimulatedLink, DelaysByItsDelay) {
  EXPECT_EQ(SimulatedLink({.delay_ms = 2.5}).delay(), std::chrono::microseconds(2500));
}

/// Runs until nothing is left to do; what was popped.
std::vector<int> popped(boost::asio::io_context& context, DelayLine<int>& line) {
  std::vector<int> items;
  boost::asio::co_spawn(
      context,
      [&]() -> boost::asio::awaitable<void> {
        std::optional<int> item = co_await line.pop();
        while (item) {
          items.push_back(*item);
          item = co_await line.pop();
        }
      },
      boost::asio::detached);
  context.run();
  return items;
}

TEST(DelayLine, KeepsTheOrderAndLosesNothingWhenFinished) {
  boost::asio::io_context context;
  DelayLine<int> line(context.get_executor());
  const TimePoint now = Clock::now();
  line.push(1, now);
  line.push(2, now + std::chrono::milliseconds(5));
  line.push(3, now + std::chrono::milliseconds(10));
  line.finish();
  EXPECT_EQ(popped(context, line), (std::vector<int>{1, 2, 3}));
  EXPECT_GE(Clock::now(), now + std::chrono::milliseconds(10));
}

TEST(DelayLine, LosesWhatIsUnderWayWhenClosed) {
  boost::asio::io_context context;
  DelayLine<int> line(context.get_executor());
  line.push(1, Clock::now() + std::chrono::hours(1));
  line.close();
  EXPECT_TRUE(popped(context, line).empty());
}

}  // namespace
}  // namespace cutaway::load
