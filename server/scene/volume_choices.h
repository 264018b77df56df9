// What is chosen for a volume where a document leaves it open.
#pragma once

#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {

glm::dvec3 volume_centre_mm(const VolumeFacts& volume);

/// Up to the patient's head; where the view runs along that axis, up to the front of the patient.
glm::dvec3 chosen_up(glm::dvec3 view_direction);

/// In front of the patient, `target_mm` in the middle; far enough that a volume whose centre is
/// there fits the field of view with 5 % to spare, each way.
glm::dvec3 chosen_eye_mm(const VolumeFacts& volume, Viewport viewport, glm::dvec3 target_mm,
                         double vertical_fov_degrees);

/// The same for the height that an orthographic view spans.
double chosen_view_height_mm(const VolumeFacts& volume, Viewport viewport);

/// On the surface of `iso_value` in the middle of the view, else in the middle of the volume.
glm::dvec3 chosen_lens_centre_mm(const VolumeFacts& volume, const Camera& camera, Viewport viewport,
                                 double iso_value);

/// 0.15 of the diagonal of the volume's material.
double chosen_lens_radius_mm(const VolumeFacts& volume);

}  // namespace cutaway
