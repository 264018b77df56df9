// Where a lens goes that nobody has placed, and how large it is.
#pragma once

#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// What the view shows without a lens decides: its camera, its picture's size and the two surfaces;
/// and which shape the lens has.
struct LensPlacementView {
  Camera camera;
  Viewport viewport;
  ValueBand context;
  ValueBand focus;
  Module shape;
  bool operator==(const LensPlacementView&) const = default;
};

/// Patient space, mm.
struct PlacedLens {
  glm::dvec3 centre_mm{0.0};
  double radius_mm = 0.0;
};

/// Of radius `radius_mm` on the context's surface in the middle of the view. Where less than a
/// quarter of it would show the focus: above or below the middle, there also up to 1.4 times
/// as large and up to 0.7 of its radius under the surface; else beside the middle. Where the
/// volume's box cuts the context only if no other place is worth it, or the cut is most of what is
/// seen. Of a slab it opens three quarters of the thickness, so that something is seen behind the
/// focus. Nothing where the view misses the context's surface. Another shape of the viewport leaves
/// the place as it is. Looks along some 400 rays: tens of milliseconds for a large volume.
/// Thread-safe.
std::optional<PlacedLens> placed_lens(const VolumeFacts& volume, const LensPlacementView& view,
                                      double radius_mm);

/// What of the focus a cutaway lens shows. `covered`: context lies before all of it.
enum class SightOfFocus { some, covered, empty };

/// By the same rays; `some` where none of them meets the lens, too.
SightOfFocus sight_of_focus(const VolumeFacts& volume, const LensPlacementView& view,
                            const PlacedLens& lens);

}  // namespace cutaway
