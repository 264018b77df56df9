#include "net/out_queue.h"

#include <gtest/gtest.h>

namespace cutaway {
namespace {

std::string text_of(const std::optional<OutQueue::Message>& message) {
  return message ? std::get<std::string>(message->content) : "(nothing)";
}

std::uint8_t first_byte(const std::optional<OutQueue::Message>& message) {
  return std::get<std::vector<std::uint8_t>>(message.value().content).at(0);
}

TEST(OutQueue, GivesTextsInOrderThenTheFrameThenTheStill) {
  OutQueue queue(100);
  queue.put_still({3}, nullptr);
  queue.put_frame(0, {2}, nullptr);
  EXPECT_TRUE(queue.put_text("one"));
  EXPECT_TRUE(queue.put_text("two"));
  EXPECT_EQ(text_of(queue.take()), "one");
  EXPECT_EQ(text_of(queue.take()), "two");
  EXPECT_EQ(first_byte(queue.take()), 2);
  EXPECT_EQ(first_byte(queue.take()), 3);
  EXPECT_FALSE(queue.take().has_value());
}

TEST(OutQueue, ANewerFrameReplacesTheWaitingOne) {
  OutQueue queue(100);
  std::vector<bool> sent;
  queue.put_frame(0, {1}, [&](bool ok) { sent.push_back(ok); });
  queue.put_frame(0, {2}, [&](bool ok) { sent.push_back(ok); });
  EXPECT_EQ(sent, std::vector{false});
  EXPECT_EQ(first_byte(queue.take()), 2);
  EXPECT_FALSE(queue.take().has_value());
}

TEST(OutQueue, KeepsTheNewestFrameOfEachViewInTheOrderOfTheViews) {
  OutQueue queue(100);
  queue.put_frame(2, {1}, nullptr);
  queue.put_frame(0, {2}, nullptr);
  queue.put_frame(2, {3}, nullptr);
  EXPECT_EQ(first_byte(queue.take()), 3);
  EXPECT_EQ(first_byte(queue.take()), 2);
  EXPECT_FALSE(queue.take().has_value());
}

TEST(OutQueue, RefusesTextsBeyondItsBound) {
  OutQueue queue(10);
  EXPECT_TRUE(queue.put_text("123456"));
  EXPECT_FALSE(queue.put_text("12345"));
  EXPECT_TRUE(queue.put_text("1234"));
  EXPECT_EQ(text_of(queue.take()), "123456");
  EXPECT_TRUE(queue.put_text("12345"));
}

TEST(OutQueue, TheLatestOfItsKindReplacesTheWaitingOneAndNothingElse) {
  OutQueue queue(10);
  EXPECT_TRUE(queue.put_latest_text("1234"));
  EXPECT_TRUE(queue.put_text("text"));
  EXPECT_TRUE(queue.put_latest_text("abcdef"));
  EXPECT_FALSE(queue.put_text("x"));
  EXPECT_EQ(text_of(queue.take()), "text");
  EXPECT_EQ(text_of(queue.take()), "abcdef");
  EXPECT_FALSE(queue.take().has_value());
}

TEST(OutQueue, TakesOneTextOfAnyLength) {
  OutQueue queue(10);
  EXPECT_TRUE(queue.put_text("a list of many volumes"));
  EXPECT_FALSE(queue.put_text("x"));
  EXPECT_EQ(text_of(queue.take()), "a list of many volumes");
  EXPECT_TRUE(queue.put_text("x"));
}

TEST(OutQueue, TellsAllThatWaitsWhenItIsAbandoned) {
  OutQueue queue(100);
  int lost = 0;
  queue.put_frame(0, {1}, [&](bool ok) { lost += ok ? 0 : 1; });
  queue.put_still({1}, [&](bool ok) { lost += ok ? 0 : 1; });
  EXPECT_TRUE(queue.put_text("text"));
  queue.abandon();
  EXPECT_EQ(lost, 2);
  EXPECT_FALSE(queue.take().has_value());
}

}  // namespace
}  // namespace cutaway
