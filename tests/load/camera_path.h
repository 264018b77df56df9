// Where a client's camera is, told from where the server put it first.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace cutaway::load {

/// The eye's place on its way around the target, from the home camera.
struct Pose {
  double azimuth_degrees = 0.0;    ///< about the home camera's up direction
  double elevation_degrees = 0.0;  ///< towards that direction
  double distance = 1.0;           ///< to the target, as a share of the home camera's
};

class CameraPath {
 public:
  /// `camera` as a resolved scene has it: patient space, mm.
  explicit CameraPath(const nlohmann::json& camera);

  glm::dvec3 eye_mm(const Pose& pose) const;
  /// A `scene` message without `input` and `clock_ms` that moves the camera there.
  nlohmann::json message(const Pose& pose) const;

 private:
  glm::dvec3 target_mm_;
  glm::dvec3 offset_mm_;  ///< from the target to the eye
  glm::dvec3 up_;
  double view_height_mm_ = 0.0;  ///< of an orthographic camera; else 0
};

}  // namespace cutaway::load
