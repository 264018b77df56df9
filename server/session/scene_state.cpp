#include "session/scene_state.h"

#include <algorithm>
#include <utility>

namespace cutaway {

namespace {

constexpr Viewport kAnyViewport{1024, 768};

// Does the complete document have a field that the other leaves open? Values that were only brought
// into another form (an up direction made square to the view) do not count.
bool says_more(const Json& complete, const Json& document) {
  if (complete.is_object()) {
    return std::ranges::any_of(complete.items(), [&document](const auto& field) {
      const auto said = document.find(field.key());
      return said == document.end() || says_more(field.value(), *said);
    });
  }
  if (!complete.is_array()) return false;
  for (std::size_t i = 0; i < complete.size(); ++i) {
    if (i >= document.size() || says_more(complete[i], document[i])) return true;
  }
  return false;
}

// In a live session the document's viewport says nothing; the viewport message does.
Json without_viewport(Json document) {
  document.erase("viewport");
  return document;
}

}  // namespace

SceneState::Change SceneState::set_document(const Json& document) {
  return commit(document, viewport_, volume_);
}

SceneState::Change SceneState::set_viewport(Viewport viewport) {
  return commit(document_, viewport, volume_);
}

SceneState::Change SceneState::set_volume(std::shared_ptr<const OpenVolume> volume,
                                          const Json& document) {
  return commit(document, viewport_, std::move(volume));
}

SceneState::Change SceneState::commit(Json document, Viewport viewport,
                                      std::shared_ptr<const OpenVolume> volume) {
  Change change;
  if (volume && viewport == Viewport{}) {
    // Throws now what it would throw later.
    resolve_scene(document, volume->facts(), kAnyViewport, lenses_);
  } else if (volume) {
    auto scene =
        std::make_shared<const Scene>(resolve_scene(document, volume->facts(), viewport, lenses_));
    Json complete = scene_document(*scene);
    change.picture = !scene_ || *scene != *scene_ || volume != volume_;
    change.chosen = says_more(without_viewport(complete), document);
    document = std::move(complete);
    if (change.picture) scene_ = std::move(scene);
  }
  document_ = std::move(document);
  viewport_ = viewport;
  volume_ = std::move(volume);
  if (change.picture) ++revision_;
  return change;
}

std::optional<std::string> volume_of(const Json& document) {
  const auto volume = document.find("volume");
  if (volume == document.end() || !volume->is_string()) return std::nullopt;
  return volume->get<std::string>();
}

Json changed_document(const Json& document, const Json& patch, bool replace) {
  Json changed = patch_scene_document(replace ? Json::object() : document, patch);
  if (!changed.contains("volume") && document.contains("volume")) {
    changed["volume"] = document["volume"];
  }
  return changed;
}

bool opens_a_field(const Json& patch) {
  if (patch.is_null()) return true;
  return patch.is_object() &&
         std::ranges::any_of(patch, [](const Json& field) { return opens_a_field(field); });
}

}  // namespace cutaway
