#include "load/link.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>

#include "load/delay_line.h"

namespace cutaway::load {
namespace {

const TimePoint kStart{std::chrono::hours(1)};

double seconds_since_start(TimePoint time) { return Seconds(time - kStart).count(); }

TEST(SimulatedLink, CarriesItsBytesPerSecond) {
  SimulatedLink link({.bytes_per_second = 625000});
  TimePoint now = kStart;
  std::size_t bytes = 0;
  while (bytes < 1250000) {
    bytes += link.chunk_bytes();
    now = link.transferred(link.chunk_bytes(), now);
  }
  EXPECT_NEAR(seconds_since_start(now), static_cast<double>(bytes) / 625000.0, 1e-5);
}

TEST(SimulatedLink, KeepsItsRateWhenTheReaderIsLate) {
  SimulatedLink link({.bytes_per_second = 1000});
  link.transferred(500, kStart);
  EXPECT_DOUBLE_EQ(
      seconds_since_start(link.transferred(500, kStart + std::chrono::milliseconds(300))), 1.0);
}

TEST(SimulatedLink, SavesNothingUpWhileIdle) {
  SimulatedLink link({.bytes_per_second = 1000});
  link.transferred(500, kStart);
  EXPECT_DOUBLE_EQ(seconds_since_start(link.transferred(500, kStart + std::chrono::seconds(10))),
                   10.5);
}

TEST(SimulatedLink, WithoutALimitTakesNoTime) {
  SimulatedLink link({});
  EXPECT_FALSE(link.limited());
  EXPECT_EQ(link.transferred(1U << 30, kStart), kStart);
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
