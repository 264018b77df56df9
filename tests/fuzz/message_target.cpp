// Text from a client: a message or an error in words, nothing else; a scene in it is drawn or
// refused in words.
#include "core/error.h"
#include "fuzz/planted_fault.h"
#include "scene/client_message.h"
#include "scene/json_text.h"
#include "scene/resolve.h"
#include "unit/scene/sphere_facts.h"

namespace {

using namespace cutaway;

void resolve(const SceneMessage& message) {
  static const VolumeFacts facts = ball_facts();
  static const Json first = scene_document(resolve_scene(Json{{"version", 1}}, facts, Viewport{}));
  const Json document =
      patch_scene_document(message.replace ? Json::object() : first, message.scene);
  const Scene scene = resolve_scene(document, facts, document_viewport(document));
  (void)json_text(scene_document(scene));
  fuzz::planted_fault(scene.focus.filters.size() > 1);
}

void judge(std::string_view text) {
  const ClientMessage message = parse_client_message(text);
  (void)echo_of(message);
  if (const auto* scene = std::get_if<SceneMessage>(&message)) resolve(*scene);
}

}  // namespace

/// -1 keeps what is not JSON out of the corpus, where it would soon outnumber what can be read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)echo_of(text);
  try {
    judge(text);
  } catch (const Error& error) {
    (void)json_text(Json(error.detail().message + error.detail().received));
    return error.detail().code == ErrorCode::malformed_json ? -1 : 0;
  }
  return 0;
}
