// The scene that a session shows, and how a message changes it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "scene/client_message.h"
#include "scene/resolve.h"
#include "session/volume_library.h"

namespace cutaway {

/// The document, the viewports and the open volume, and the scene that follows from all of them.
/// Every change either takes effect whole or throws Error and changes nothing. Lives on the
/// session's strand.
class SceneState {
 public:
  struct Change {
    bool scene = false;                   ///< another scene than before; the revision went up
    std::array<bool, kViews> pictures{};  ///< which views show another picture than before
    bool chosen = false;                  ///< the resolved document says more than the client did
  };

  /// What the client said so far; once a scene is resolved, the whole of it, so that nothing chosen
  /// for the volume moves by itself later.
  const Json& document() const { return document_; }
  /// Without what was chosen for the open volume: a look that nobody touched is chosen anew, too.
  Json document_for_another_volume() const;
  const std::shared_ptr<const OpenVolume>& volume() const { return volume_; }
  /// Nothing until there are a volume and the 3-D picture's viewport.
  const std::shared_ptr<const Scene>& scene() const { return scene(ViewKind::volume); }
  /// The same scene with this view's viewport; nothing while it has none.
  const std::shared_ptr<const Scene>& scene(ViewKind view) const {
    return scenes_[static_cast<std::size_t>(view)];
  }
  std::uint32_t revision() const { return revision_; }
  /// How often a lens' place was looked for since this was asked last, for changes that were
  /// refused, too.
  int take_lens_searches() { return lenses_.take_searches(); }

  Change set_document(const Json& document);
  /// Of the view that is the viewport's kind.
  Change set_viewport(Viewport viewport);
  /// The view has no viewport any more.
  void close(ViewKind view);
  Change set_volume(std::shared_ptr<const OpenVolume> volume, const Json& document);

 private:
  using Viewports = std::array<Viewport, kViews>;  ///< 0x0: the view has none

  Change commit(Json document, const Viewports& viewports,
                std::shared_ptr<const OpenVolume> volume);
  void put_scenes(const Scene& scene, const Viewports& viewports, bool is_new_volume,
                  Change& change);

  Json document_ = Json::object();
  Viewports viewports_;
  std::shared_ptr<const OpenVolume> volume_;
  std::array<std::shared_ptr<const Scene>, kViews> scenes_;
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
