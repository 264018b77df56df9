#include "scene/client_message.h"

#include <map>

#include "scene/json_text.h"
#include "scene/schema.h"
#include "scene/schema_words.h"

namespace cutaway {

namespace {

InputStamp stamp_of(const Json& message) {
  return {message.at("input").get<std::uint32_t>(), message.at("clock_ms").get<double>()};
}

glm::dvec2 position_of(const Json& message) {
  const Json& position = message.at("position_px");
  return {position.at(0).get<double>(), position.at(1).get<double>()};
}

std::uint32_t request_of(const Json& message) { return message.at("request").get<std::uint32_t>(); }

ViewKind view_of(const Json& message) {
  return static_cast<ViewKind>(message.at("view").get<int>());
}

/// Nothing where the message leaves it out.
std::optional<std::string> text_of(const Json& message, const char* key) {
  if (!message.contains(key)) return {};
  return message.at(key).get<std::string>();
}

Json patch_of(const Json& message) { return message.value("scene", Json::object()); }

int width_of(const Json& message) { return message.at("width_px").get<int>(); }
int height_of(const Json& message) { return message.at("height_px").get<int>(); }

using Reading = ClientMessage (*)(const Json&);

const std::map<std::string, Reading, std::less<>>& readings() {
  static const std::map<std::string, Reading, std::less<>> all{
      {"scene",
       [](const Json& m) -> ClientMessage {
         return SceneMessage{stamp_of(m), m.at("scene"), m.at("replace").get<bool>()};
       }},
      {"viewport",
       [](const Json& m) -> ClientMessage {
         return ViewportMessage{view_of(m), stamp_of(m), width_of(m), height_of(m)};
       }},
      {"drag_lens",
       [](const Json& m) -> ClientMessage {
         return DragLensMessage{stamp_of(m), position_of(m)};
       }},
      {"pick",
       [](const Json& m) -> ClientMessage {
         return PickMessage{view_of(m), request_of(m), position_of(m)};
       }},
      {"cancel_load", [](const Json&) -> ClientMessage { return CancelLoadMessage{}; }},
      {"ack",
       [](const Json& m) -> ClientMessage {
         return AckMessage{view_of(m), m.at("frame").get<std::uint32_t>()};
       }},
      {"save_still",
       [](const Json& m) -> ClientMessage {
         return SaveStillMessage{view_of(m), request_of(m), width_of(m), height_of(m), patch_of(m)};
       }},
      {"preview",
       [](const Json& m) -> ClientMessage {
         return PreviewMessage{request_of(m), text_of(m, "style"), text_of(m, "volume"),
                               patch_of(m),   width_of(m),         height_of(m)};
       }},
      {"close_view", [](const Json& m) -> ClientMessage { return CloseViewMessage{view_of(m)}; }},
      {"presence",
       [](const Json& m) -> ClientMessage { return PresenceMessage{m.at("visible").get<bool>()}; }},
  };
  return all;
}

/// Null where the message has none.
Json message_type(const Json& message) {
  return message.is_object() ? message.value("type", Json()) : Json();
}

/// Nothing where the message sizes no picture.
std::optional<int> largest_side_of(const Json& message, const SideLimits& limits) {
  const Json type = message_type(message);
  if (type == "viewport") return limits.viewport_px;
  if (type == "save_still") return limits.still_px;
  return {};
}

/// Before the schema, which knows the largest limit that a server may have, not this one's.
void check_sides(const Json& message, const SideLimits& limits) {
  const std::optional<int> largest_px = largest_side_of(message, limits);
  if (!largest_px) return;
  const std::string range = "1 to " + std::to_string(*largest_px) + " px";
  for (const char* side : {"width_px", "height_px"}) {
    const auto px = message.find(side);
    if (px == message.end()) continue;
    const bool is_integer = px->is_number_integer();
    if (is_integer && *px >= 1 && *px <= *largest_px) continue;
    throw Error({.code = is_integer ? ErrorCode::out_of_range : ErrorCode::wrong_type,
                 .message = "the picture cannot have this size",
                 .field = pointer_to("", side),
                 .expected = is_integer ? range : "an integer from " + range,
                 .received = words_for_value(*px)});
  }
}

/// The message as far as it can be read although a number in it is too large; null where it cannot.
Json salvaged(std::string_view text) {
  try {
    return parse_json(with_numbers_held(std::string(text)));
  } catch (const Error&) {
    return {};
  }
}

/// What is wrong inside of a scene is named from that scene on.
Error seen_from_the_scene(const Error& error, std::string_view text) {
  constexpr std::string_view kScene = "/scene/";
  Error::Detail detail = error.detail();
  if (!detail.field.starts_with(kScene) || message_type(salvaged(text)) != "scene") return error;
  detail.field.erase(0, kScene.size() - 1);
  return Error(detail);
}

Json parse_message(std::string_view text) {
  try {
    return parse_json(text);
  } catch (const Error& error) {
    throw seen_from_the_scene(error, text);
  }
}

std::optional<std::uint32_t> counter(const Json& message, const char* key) {
  if (!message.is_object()) return {};
  const auto field = message.find(key);
  if (field == message.end() || !field->is_number_integer()) return {};
  const auto value = field->get<std::int64_t>();
  if (value < 0 || value > std::int64_t{UINT32_MAX}) return {};
  return static_cast<std::uint32_t>(value);
}

}  // namespace

ClientMessage parse_client_message(std::string_view text, const SideLimits& limits) {
  const Json message = parse_message(text);
  check_sides(message, limits);
  validate(message, "client-message");
  const auto& type = message.at("type").get_ref<const std::string&>();
  return readings().at(type)(with_defaults(message, "client-message"));
}

Error binary_message_error() {
  return Error(
      {.code = ErrorCode::not_text, .message = "a binary message", .expected = "JSON text"});
}

MessageEcho echo_of(std::string_view text) {
  const Json message = salvaged(text);
  return {counter(message, "input"), counter(message, "request")};
}

MessageEcho echo_of(const ClientMessage& message) {
  return std::visit(
      [](const auto& content) -> MessageEcho {
        if constexpr (requires { content.stamp; })
          return {.input = content.stamp.input};
        else if constexpr (requires { content.request; })
          return {.request = content.request};
        else
          return {};
      },
      message);
}

}  // namespace cutaway
