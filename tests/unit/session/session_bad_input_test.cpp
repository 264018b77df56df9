// What a client can send wrong: each is answered with an error that names code, field, limit and
// what came; the last good state stands and the session goes on.
#include "unit/session/session_fixture.h"

namespace cutaway {
namespace {

class SessionBadInputTest : public testing::SessionFixture {
 protected:
  SessionBadInputTest() { show_ball(); }

  /// The bad message makes neither frame nor state; a good one after it works.
  void expect_unharmed() {
    EXPECT_TRUE(frames.idle());
    const std::uint32_t next = scene({{"lens", {{"radius_mm", 11.0 + input}}}});
    EXPECT_FALSE(frames.idle());
    settle();
    EXPECT_EQ(client.frames.back().header.input, next);
  }
  Json error() const { return client.last("error"); }
};

TEST_F(SessionBadInputTest, MalformedJson) {
  for (const char* text : {"", "{", "nonsense", "{\"type\":", "[1,2", "\"", "{\"a\":1}}", "\x01"}) {
    client.texts.clear();
    session->receive_text(text);
    expect_error("malformed-json");
  }
  expect_unharmed();
}

TEST_F(SessionBadInputTest, DeepNesting) {
  session->receive_text(std::string(30'000, '['));
  expect_error("malformed-json");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, JsonThatIsNoMessage) {
  for (const char* text : {"1", "null", "[]", "\"scene\"", "true"}) {
    client.texts.clear();
    session->receive_text(text);
    expect_error("wrong-type");
  }
  session->receive_text("{}");
  expect_error("missing-field", "/type");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, BinaryWhereTextIsExpected) {
  session->receive_binary();
  expect_error("not-text");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, UnknownMessage) {
  receive({{"type", "reboot"}});
  expect_error("unknown-message", "/type");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, UnknownFieldOfAMessage) {
  receive({{"type", "cancel_load"}, {"why", "no"}});
  expect_error("unknown-field", "/why");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, UnknownFieldOfTheScene) {
  const std::uint32_t bad = scene({{"lens", {{"sharpness", 1}}}});
  expect_error("unknown-field", "/lens/sharpness");
  EXPECT_EQ(error()["input"], bad);
  expect_unharmed();
}

TEST_F(SessionBadInputTest, MissingField) {
  receive({{"type", "viewport"}, {"input", 1}, {"clock_ms", 1}, {"width_px", 5}});
  expect_error("missing-field", "/height_px");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, WrongType) {
  const std::uint32_t bad = scene({{"lens", {{"radius_mm", "big"}}}});
  expect_error("wrong-type", "/lens/radius_mm");
  EXPECT_EQ(error()["input"], bad);
  scene({{"volume", 7}});
  expect_error("wrong-type", "/volume");
  scene({{"camera", 7}});
  expect_error("wrong-type", "/camera");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, OutOfRangeNamesTheLimitAndWhatCame) {
  scene({{"lens", {{"radius_mm", -5.0}}}});
  expect_error("out-of-range", "/lens/radius_mm");
  EXPECT_NE(error()["expected"].get<std::string>().find("2000"), std::string::npos) << error();
  EXPECT_NE(error()["received"].get<std::string>().find("-5"), std::string::npos) << error();
  expect_unharmed();
}

TEST_F(SessionBadInputTest, NonFiniteNumber) {
  session->receive_text(
      R"({"type":"scene","input":1,"clock_ms":0,"scene":{"lens":{"radius_mm":1e999}}})");
  EXPECT_EQ(error()["code"], "not-finite") << error();
  session->receive_text(
      R"({"type":"scene","input":1,"clock_ms":0,"scene":{"lens":{"radius_mm":NaN}}})");
  EXPECT_EQ(error()["code"], "malformed-json") << error();
  expect_unharmed();
}

TEST_F(SessionBadInputTest, ANonFiniteNumberIsNamedFromItsSceneAndTheMessageEchoed) {
  session->receive_text(
      R"({"type":"scene","scene":{"lens":{"radius_mm":1e999}},"clock_ms":0,"input":7})");
  expect_error("not-finite", "/lens/radius_mm");
  EXPECT_EQ(error()["input"], 7);
  session->receive_text(R"({"type":"pick","position_px":[5,1e999],"request":9})");
  expect_error("not-finite", "/position_px/1");
  EXPECT_EQ(error()["request"], 9);
  session->receive_text(R"({"type":"pick","request":9,"scene":{"lens":1e999}})");
  expect_error("not-finite", "/scene/lens");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, UnknownVolume) {
  scene({{"volume", "nowhere"}});
  library.fail(
      Error({.code = ErrorCode::unknown_volume, .message = "no such volume", .field = "/volume"}));
  strand->run();
  expect_error("unknown-volume", "/volume");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, UnknownModule) {
  scene({{"focus", {{"shading", {{"name", "x-ray-glow"}}}}}});
  EXPECT_EQ(error()["code"], "unknown-module") << error();
  expect_unharmed();
}

TEST_F(SessionBadInputTest, ACameraAtItsTarget) {
  scene({{"camera", {{"eye_mm", {1, 2, 3}}, {"target_mm", {1, 2, 3}}}}});
  EXPECT_EQ(error()["code"], "invalid-scene") << error();
  expect_unharmed();
}

TEST_F(SessionBadInputTest, ACameraInsideTheBoneIsNoError) {
  scene({{"camera", {{"eye_mm", {1, 2, 3}}, {"target_mm", {0, 0, 0}}, {"up", {0, 0, 1}}}},
         {"lens", {{"mode", "none"}}}});
  EXPECT_TRUE(client.of_type("error").empty());
  receive({{"type", "pick"}, {"request", 1}, {"position_px", {320, 240}}});
  // An eye in the material sees no cut where it stands, and a ball has nothing further on.
  EXPECT_FALSE(client.last("picked").contains("position_mm"));
  receive(
      {{"type", "drag_lens"}, {"input", ++input}, {"clock_ms", 1}, {"position_px", {320, 240}}});
  settle();
  EXPECT_TRUE(client.of_type("error").empty());
}

TEST_F(SessionBadInputTest, AViewportOf100000Squared) {
  const std::uint32_t bad = viewport(100'000, 100'000);
  expect_error("out-of-range", "/width_px");
  EXPECT_EQ(error()["input"], bad);
  EXPECT_EQ(error()["expected"], "1 to 4096 px");
  EXPECT_EQ(error()["received"], "100000");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, ASideOutOfRangeIsAnsweredWithTheSessionsOwnLimit) {
  settings.viewport_side_px = 1000;
  settings.still_side_px = 2000;
  restart();
  show_ball();
  for (const std::int64_t side : {0L, -1L, 2001L, 100'000L, 5'000'000'000L}) {
    receive({{"type", "viewport"},
             {"input", 1},
             {"clock_ms", 1},
             {"width_px", side},
             {"height_px", 5}});
    expect_error("out-of-range", "/width_px");
    EXPECT_EQ(error()["expected"], "1 to 1000 px");
    receive({{"type", "save_still"}, {"request", 3}, {"width_px", 5}, {"height_px", side}});
    expect_error("out-of-range", "/height_px");
    EXPECT_EQ(error()["expected"], "1 to 2000 px");
    EXPECT_EQ(error()["received"], std::to_string(side));
  }
  for (const Json& side : {Json(1.5), Json("5"), Json()}) {
    receive({{"type", "viewport"},
             {"input", 1},
             {"clock_ms", 1},
             {"width_px", side},
             {"height_px", 5}});
    expect_error("wrong-type", "/width_px");
    EXPECT_EQ(error()["expected"], "an integer from 1 to 1000 px");
  }
  receive({{"type", "preview"},
           {"request", 1},
           {"style", "toon"},
           {"width_px", 600},
           {"height_px", 5}});
  expect_error("out-of-range", "/width_px");
  EXPECT_EQ(error()["expected"], "an integer from 1 to 512 px");
}

TEST_F(SessionBadInputTest, AViewportOverTheConfiguredLimits) {
  viewport(4097, 10);
  expect_error("out-of-range", "/width_px");
  EXPECT_EQ(error()["expected"], "1 to 4096 px");
  EXPECT_EQ(error()["received"], "4097");
  viewport(10, 5000);
  expect_error("out-of-range", "/height_px");
  viewport(4096, 4096);
  expect_error("out-of-range", "/width_px");
  EXPECT_EQ(error()["expected"], "width_px times height_px at most 9437184");
  receive({{"type", "save_still"}, {"request", 3}, {"width_px", 8193}, {"height_px", 10}});
  expect_error("out-of-range", "/width_px");
  EXPECT_EQ(error()["request"], 3);
  expect_unharmed();
}

TEST_F(SessionBadInputTest, AnAcknowledgementOfAFrameNeverSent) {
  receive({{"type", "ack"}, {"frame", 123'456}});
  expect_error("out-of-range", "/frame");
  expect_unharmed();
}

TEST_F(SessionBadInputTest, AskingSomethingOfASessionThatShowsNothing) {
  restart();
  receive({{"type", "pick"}, {"request", 8}, {"position_px", {0, 0}}});
  expect_error("no-volume");
  EXPECT_EQ(error()["request"], 8);
  receive({{"type", "drag_lens"}, {"input", 1}, {"clock_ms", 1}, {"position_px", {0, 0}}});
  expect_error("no-volume");
  receive({{"type", "save_still"}, {"request", 9}, {"width_px", 5}, {"height_px", 5}});
  expect_error("no-volume");
}

TEST_F(SessionBadInputTest, ABadPartSpoilsTheWholeMessageAndNothingElse) {
  const std::uint32_t bad =
      scene({{"background", {{"colour", {1, 1, 1}}}}, {"lens", {{"radius_mm", -1}}}});
  EXPECT_EQ(error()["input"], bad);
  scene({{"lens", {{"radius_mm", 3.0}}}});
  EXPECT_NE(rendered().background.colour, glm::dvec3(1, 1, 1));
}

TEST_F(SessionBadInputTest, ARendererThatFailsIsReportedAndTheSessionGoesOn) {
  scene({{"lens", {{"radius_mm", 3.0}}}});
  frames.fail(Error({.code = ErrorCode::render_failed, .message = "the GPU is gone"}));
  strand->run();
  expect_error("render-failed");
  strand->advance(Milliseconds(1000.0));
  expect_unharmed();
}

TEST_F(SessionBadInputTest, AMessageThatIsTooLargeIsRefusedWithItsLimit) {
  show_ball();
  session->receive_too_large(70'000, 65'536);
  expect_error("too-large");
  EXPECT_EQ(client.last("error")["expected"], "at most 65536 bytes");
  EXPECT_EQ(client.last("error")["received"], "70000 bytes");
  scene({{"lens", {{"radius_mm", 10.0}}}});
  EXPECT_EQ(rendered().lens.radius_mm, 10.0);
}

}  // namespace
}  // namespace cutaway
