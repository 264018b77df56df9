#include "scene/server_message.h"

#include "scene/modules.h"
#include "scene/resolve.h"
#include "scene/scene_json.h"
#include "scene/styles.h"
#include "scene/unseen.h"

namespace cutaway {

NLOHMANN_JSON_SERIALIZE_ENUM(LoadStage, {{LoadStage::read, "read"},
                                         {LoadStage::decode, "decode"},
                                         {LoadStage::min_max, "min_max"},
                                         {LoadStage::upload, "upload"}})
NLOHMANN_JSON_SERIALIZE_ENUM(LoadEnd, {{LoadEnd::ready, "ready"},
                                       {LoadEnd::cancelled, "cancelled"},
                                       {LoadEnd::failed, "failed"}})
NLOHMANN_JSON_SERIALIZE_ENUM(PictureBranch,
                             {{PictureBranch::focus, "focus"}, {PictureBranch::context, "context"}})
NLOHMANN_JSON_SERIALIZE_ENUM(UnseenCode, {{UnseenCode::volume_empty, "volume-empty"},
                                          {UnseenCode::above_all_values, "above-all-values"},
                                          {UnseenCode::below_all_values, "below-all-values"},
                                          {UnseenCode::fills_the_volume, "fills-the-volume"},
                                          {UnseenCode::transparent, "transparent"},
                                          {UnseenCode::lens_covered, "lens-covered"},
                                          {UnseenCode::lens_empty, "lens-empty"}})

namespace {

Json json_from(const WireLimits& limits) {
  return {{"message_bytes", limits.message_bytes},
          {"viewport_side_px", limits.viewport_side_px},
          {"still_side_px", limits.still_side_px},
          {"viewport_pixels", limits.viewport_pixels},
          {"frames_in_flight", limits.frames_in_flight}};
}

void add_if_any(Json& message, const char* key, const std::string& text) {
  if (!text.empty()) message[key] = text;
}

}  // namespace

Json capabilities_message(const ServerDescription& description) {
  return {{"type", "capabilities"},
          {"protocol", kSubprotocol},
          {"server", description.server},
          {"renderer", description.renderer},
          {"software_renderer", description.software_renderer},
          {"limits", json_from(description.limits)},
          {"modules", describe_modules()},
          {"styles", describe_styles()},
          {"notice", description.notice}};
}

Json volumes_message(const Json& listing) {
  Json message = listing;
  message["type"] = "volumes";
  return message;
}

Json loading_message(const std::string& volume, LoadStage stage, double fraction) {
  return {{"type", "loading"}, {"volume", volume}, {"stage", stage}, {"fraction", fraction}};
}

Json loading_message(const std::string& volume, LoadEnd end) {
  return {{"type", "loading"}, {"volume", volume}, {"stage", end}, {"fraction", 1.0}};
}

Json queued_message(int place) { return {{"type", "queued"}, {"place", place}}; }

Json scene_message(std::uint32_t revision, std::uint32_t input, const Scene& scene) {
  return {{"type", "scene"},
          {"revision", revision},
          {"input", input},
          {"scene", scene_document(scene)}};
}

Json scene_message(std::uint32_t revision, std::uint32_t input, const Scene& scene,
                   const Json& volume) {
  Json message = scene_message(revision, input, scene);
  message["volume"] = volume;
  return message;
}

Json picked_message(std::uint32_t request, const std::optional<PickedPoint>& point) {
  Json message{{"type", "picked"}, {"request", request}};
  if (!point) return message;
  message["position_mm"] = vector_json(point->position_mm);
  message["value"] = point->value;
  message["units"] = point->units;
  if (point->branch) message["branch"] = *point->branch;
  return message;
}

Json unseen_message(const std::vector<UnseenReason>& reasons) {
  Json list = Json::array();
  for (const UnseenReason& reason : reasons) {
    Json entry{{"code", reason.code}, {"message", in_words(reason)}};
    if (reason.branch) entry["branch"] = *reason.branch;
    if (reason.value) entry["value"] = *reason.value;
    if (reason.limit) entry["limit"] = *reason.limit;
    list.push_back(std::move(entry));
  }
  return {{"type", "unseen"}, {"reasons", std::move(list)}};
}

Json error_message(const Error& error, const MessageEcho& echo) {
  const Error::Detail& detail = error.detail();
  Json message{{"type", "error"},
               {"code", std::string(code_word(detail.code))},
               {"message", detail.message}};
  add_if_any(message, "field", detail.field);
  add_if_any(message, "expected", detail.expected);
  add_if_any(message, "received", detail.received);
  if (echo.input) message["input"] = *echo.input;
  if (echo.request) message["request"] = *echo.request;
  return message;
}

}  // namespace cutaway
