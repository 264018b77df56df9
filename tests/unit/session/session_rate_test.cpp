// What a client may ask in a time: messages, and the dearer ones among them.
#include "unit/session/session_fixture.h"

namespace cutaway {
namespace {

class SessionRateTest : public testing::SessionFixture {
 protected:
  SessionRateTest() {
    settings.messages = {.per_second = 10.0, .burst = 20.0};
    settings.lens_search_messages = 0.0;
    begin();
  }
  void begin() {
    restart();
    show_ball();
    strand->advance(Milliseconds(10'000.0));
  }
};

TEST_F(SessionRateTest, TooManyMessagesAreRefusedWithOneErrorASecond) {
  for (int i = 0; i < 1000; ++i) scene({{"lens", {{"radius_mm", i}}}});
  ASSERT_EQ(client.of_type("error").size(), 1);
  expect_error("rate-limited");
  EXPECT_EQ(client.last("error")["expected"], "10 a second");
  EXPECT_EQ(session->receive_text("{}"), Session::Reception::too_fast);
  EXPECT_EQ(session->receive_text(std::string(10'000, ' ')), Session::Reception::too_fast);
  EXPECT_EQ(session->receive_binary(), Session::Reception::too_fast);
}

TEST_F(SessionRateTest, AcknowledgementsAlwaysCount) {
  scene({{"lens", {{"radius_mm", 1.0}}}});
  for (int i = 0; i < 100; ++i) receive({{"type", "cancel_load"}});
  settle();
  EXPECT_FALSE(client.frames.empty());
  strand->advance(Milliseconds(300.0));
  EXPECT_FALSE(frames.idle()) << "the still frame found a credit";
}

TEST_F(SessionRateTest, TheRateRecovers) {
  for (int i = 0; i < 100; ++i) scene({{"lens", {{"radius_mm", i}}}});
  strand->advance(Milliseconds(1000.0));
  come_to_rest();
  client.texts.clear();
  scene({{"lens", {{"radius_mm", 77.0}}}});
  EXPECT_EQ(rendered().lens.radius_mm, 77.0);
  EXPECT_TRUE(client.of_type("error").empty());
}

/// Lets the lens be chosen anew, as often as somebody has the patience to ask.
class LensSearchRateTest : public SessionRateTest {
 protected:
  LensSearchRateTest() {
    settings.messages.burst = 100.0;
    settings.lens_search_messages = 40.0;
    begin();
  }
  static Json from_another_side(int step) {
    return {{"camera", {{"eye_mm", {step + 1.0, -600.0, 0.0}}}},
            {"lens", {{"centre_mm", nullptr}}}};
  }
  /// Sends it again and again, and counts those that were heeded.
  template <typename Message>
  int heeded(int times, Message message) {
    int count = 0;
    for (int i = 0; i < times; ++i) {
      const Json text = {
          {"type", "scene"}, {"input", ++input}, {"clock_ms", 1.0}, {"scene", message(i)}};
      if (session->receive_text(text.dump()) == Session::Reception::taken) ++count;
    }
    return count;
  }
};

TEST_F(LensSearchRateTest, LookingForALensCountsAsManyMessages) {
  EXPECT_EQ(heeded(50, from_another_side), 3);  // 41 each of 100, and the last one on credit
  expect_error("rate-limited");
  strand->advance(Milliseconds(10'000.0));
  EXPECT_EQ(heeded(50, from_another_side), 2);  // the credit is paid back first
}

TEST_F(LensSearchRateTest, AskingTheSameAgainCountsAsOne) {
  Json open_lens = {{"lens", {{"centre_mm", nullptr}, {"radius_mm", nullptr}}}};
  EXPECT_EQ(heeded(50, [&](int) { return open_lens; }), 50);
}

TEST_F(LensSearchRateTest, AReplacingSceneCountsAsWell) {
  for (int i = 0; i < 3; ++i) scene({{"camera", {{"vertical_fov_degrees", 20 + i}}}}, true);
  EXPECT_EQ(heeded(1, from_another_side), 0);
}

TEST_F(LensSearchRateTest, SoDoesOpeningAVolume) {
  for (const char* id : {"one", "two", "three"}) open(id);
  EXPECT_EQ(heeded(1, from_another_side), 0);
}

TEST_F(LensSearchRateTest, SoDoesAVolumeWithoutAViewport) {
  restart();
  open("ball");
  EXPECT_EQ(heeded(50, from_another_side), 2);
}

TEST_F(LensSearchRateTest, WhatTheSceneSaysItselfCountsAsOne) {
  EXPECT_EQ(heeded(50, [](int i) { return Json{{"camera", {{"eye_mm", {i, -600.0, 0.0}}}}}; }), 50);
}

}  // namespace
}  // namespace cutaway
