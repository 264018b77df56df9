// What is chosen for a volume where a document leaves it open.
#pragma once

#include "scene/lens_placement.h"
#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

glm::dvec3 volume_centre_mm(const VolumeFacts& volume);

/// The middle of all voxels: where slices begin.
glm::dvec3 slices_centre_mm(const VolumeFacts& volume);
/// On a voxel's centre, so that slices along the grid begin with values as they were measured.
glm::dvec3 chosen_crosshair_mm(const VolumeFacts& volume);

/// Up to the patient's head; where the view runs along that axis, up to the front of the patient.
/// A slab that is looked at from its front has its own.
glm::dvec3 chosen_up(const VolumeFacts& volume, glm::dvec3 view_direction);

/// In front of the patient, or of the slab, `target_mm` in the middle; far enough that a volume
/// whose centre is there fits the field of view with 5 % to spare, each way.
glm::dvec3 chosen_eye_mm(const VolumeFacts& volume, Viewport viewport, glm::dvec3 target_mm,
                         double vertical_fov_degrees);

/// The same for the height that an orthographic view spans.
double chosen_view_height_mm(const VolumeFacts& volume, Viewport viewport);

/// The lens where it shows some of the focus (see placed_lens), in the middle of the volume where
/// the view misses the context. Its radius is the given one, else 0.15 of the diagonal of the
/// volume's material or a little more.
PlacedLens chosen_lens(const VolumeFacts& volume, const LensPlacementView& view,
                       std::optional<double> radius_mm);

}  // namespace cutaway
