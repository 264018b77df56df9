// The scene that a session shows, and how a message changes it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "scene/resolve.h"
#include "session/ends.h"

namespace cutaway {

/// The document, the viewport and the open volume, and the scene that follows from all three. Every
/// change either takes effect whole or throws Error and changes nothing. Lives on the session's
/// strand.
class SceneState {
 public:
  struct Change {
    bool picture = false;  ///< another picture than before; the revision went up
    bool chosen = false;   ///< the resolved document says more than the client did
  };

  /// What the client said so far; once a scene is resolved, the whole of it, so that nothing chosen
  /// for the volume moves by itself later.
  const Json& document() const { return document_; }
  const std::shared_ptr<const OpenVolume>& volume() const { return volume_; }
  Viewport viewport() const { return viewport_; }
  /// Nothing until there are a volume and a viewport.
  const std::shared_ptr<const Scene>& scene() const { return scene_; }
  std::uint32_t revision() const { return revision_; }
  /// How often a lens' place was looked for since this was asked last, for changes that were
  /// refused, too.
  int take_lens_searches() { return lenses_.take_searches(); }

  Change set_document(const Json& document);
  Change set_viewport(Viewport viewport);
  Change set_volume(std::shared_ptr<const OpenVolume> volume, const Json& document);

 private:
  Change commit(Json document, Viewport viewport, std::shared_ptr<const OpenVolume> volume);

  Json document_ = Json::object();
  Viewport viewport_;
  std::shared_ptr<const OpenVolume> volume_;
  std::shared_ptr<const Scene> scene_;
  std::uint32_t revision_ = 0;
  LensMemory lenses_;
};

/// The id that a document asks for; nothing where it leaves the volume open.
std::optional<std::string> volume_of(const Json& document);

/// `document` patched, or with `replace` the patch alone; where that leaves the volume open it
/// stays as in `document`.
Json changed_document(const Json& document, const Json& patch, bool replace);

/// Whether a patch takes a field back to what is chosen for it: the client cannot know to what.
bool opens_a_field(const Json& patch);

}  // namespace cutaway
