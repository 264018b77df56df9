#include <gtest/gtest.h>

#include "scene/client_message.h"
#include "scene/json_text.h"
#include "scene/resolve.h"
#include "scene/schema.h"
#include "scene/server_message.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {
namespace {

void expect_valid(const Json& message) {
  EXPECT_NO_THROW(validate(parse_json(json_text(message)), "server-message")) << message.dump(1);
}

Json summary() {
  return Json::parse(R"({"id": "ball", "title": "Ball", "modality": "", "units": "none",
      "size_voxels": [2, 2, 2], "spacing_mm": [1, 1, 1], "origin_mm": [0, 0, 0],
      "axes": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "bounds_minimum_mm": [0, 0, 0],
      "bounds_maximum_mm": [1, 1, 1], "diagonal_mm": 1.7, "value_range": [0, 1],
      "outer_iso_value": 0.2, "inner_iso_value": 0.6, "histogram": [4, 4], "warnings": []})");
}

TEST(ClientMessage, IsReadWithItsFields) {
  const auto scene = std::get<SceneMessage>(parse_client_message(
      R"({"type": "scene", "input": 4294967295, "clock_ms": 2.5, "scene": {"lens": null}})"));
  EXPECT_EQ(scene.stamp.input, 4294967295U);
  EXPECT_EQ(scene.stamp.clock_ms, 2.5);
  EXPECT_EQ(scene.scene, Json::parse(R"({"lens": null})"));
  EXPECT_FALSE(scene.replace);

  const auto viewport = std::get<ViewportMessage>(parse_client_message(
      R"({"type": "viewport", "input": 1, "clock_ms": 0, "width_px": 800, "height_px": 600})"));
  EXPECT_EQ(viewport.width_px, 800);
  EXPECT_EQ(viewport.height_px, 600);

  const auto drag = std::get<DragLensMessage>(parse_client_message(
      R"({"type": "drag_lens", "input": 1, "clock_ms": 0, "position_px": [1.5, -2]})"));
  EXPECT_EQ(drag.position_px, glm::dvec2(1.5, -2));

  const auto pick = std::get<PickMessage>(
      parse_client_message(R"({"type": "pick", "request": 9, "position_px": [3, 4]})"));
  EXPECT_EQ(pick.request, 9U);
  EXPECT_EQ(pick.position_px, glm::dvec2(3, 4));

  const auto still = std::get<SaveStillMessage>(parse_client_message(
      R"({"type": "save_still", "request": 2, "width_px": 10, "height_px": 20})"));
  EXPECT_EQ(still.height_px, 20);
  EXPECT_EQ(std::get<AckMessage>(parse_client_message(R"({"type": "ack", "frame": 5})")).frame, 5U);
  EXPECT_TRUE(std::holds_alternative<CancelLoadMessage>(
      parse_client_message(R"({"type": "cancel_load"})")));
}

TEST(ClientMessage, ARefusedOneIsStillEchoed) {
  const MessageEcho echo = echo_of(R"({"type": "fly", "input": 7, "request": -1})");
  EXPECT_EQ(echo.input, 7U);
  EXPECT_EQ(echo.request, std::nullopt);
  EXPECT_EQ(echo_of("[").input, std::nullopt);
  EXPECT_EQ(echo_of("[1]").input, std::nullopt);
  EXPECT_EQ(echo_of(R"({"input": 1.5, "request": 4294967296})").request, std::nullopt);
  EXPECT_EQ(echo_of(R"({"input": 18446744073709551615})").input, std::nullopt);
}

TEST(ClientMessage, AnUnderstoodOneIsEchoed) {
  EXPECT_EQ(echo_of(ClientMessage(SceneMessage{{3, 0.0}, {}, false})).input, 3U);
  EXPECT_EQ(echo_of(ClientMessage(PickMessage{ViewKind::volume, 4, {}})).request, 4U);
  EXPECT_EQ(echo_of(ClientMessage(AckMessage{ViewKind::volume, 5})).input, std::nullopt);
}

TEST(ServerMessage, EachFollowsTheSchema) {
  expect_valid(capabilities_message({"cutaway 0.1.0", "none", true, {}, "Not for diagnostic use"}));
  expect_valid(queued_message(3));
  expect_valid(volumes_message(Json::parse(R"({"volumes": [], "refused": []})")));
  for (const LoadStage stage :
       {LoadStage::read, LoadStage::decode, LoadStage::min_max, LoadStage::upload})
    expect_valid(loading_message("ball", stage, 0.5));
  for (const LoadEnd end : {LoadEnd::ready, LoadEnd::cancelled, LoadEnd::failed})
    expect_valid(loading_message("ball", end));
  expect_valid(picked_message(1, {}));
  expect_valid(picked_message(1, PickedPoint{{1, 2, 3}, -100.0, "HU", PictureBranch::context}));
  const Scene scene = resolve_scene(Json::object(), ball_facts(), {640, 480});
  expect_valid(scene_message(4, 0, scene, summary()));
  expect_valid(scene_message(5, 4294967295U, scene));
}

TEST(ServerMessage, SaysWhichPartOfTheWireWords) {
  EXPECT_EQ(
      loading_message("v", LoadStage::min_max, 0.25),
      Json::parse(R"({"type": "loading", "volume": "v", "stage": "min_max", "fraction": 0.25})"));
  EXPECT_EQ(loading_message("v", LoadEnd::failed).at("stage"), "failed");
  EXPECT_EQ(picked_message(1, PickedPoint{{}, 0.0, "HU", PictureBranch::context}).at("branch"),
            "context");
  EXPECT_FALSE(picked_message(1, {}).contains("position_mm"));
}

TEST(ServerMessage, AnErrorNamesWhatApplies) {
  const Error error({.code = ErrorCode::out_of_range, .message = "m", .field = "/lens/radius_mm"});
  const Json message = error_message(error, {.input = 17});
  expect_valid(message);
  EXPECT_EQ(message, Json::parse(R"({"type": "error", "code": "out-of-range", "message": "m",
      "field": "/lens/radius_mm", "input": 17})"));
  expect_valid(error_message(binary_message_error()));
}

}  // namespace
}  // namespace cutaway
