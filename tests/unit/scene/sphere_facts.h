// A volume that is nothing but a ball, in closed form: skin at its radius, bone at half of it.
#pragma once

#include <cmath>

#include "scene/volume_facts.h"

namespace cutaway {

inline constexpr double kBallRadius_mm = 80.0;
inline constexpr double kBoneRadius_mm = 65.0;
inline constexpr glm::dvec3 kBallCentre_mm{10.0, -20.0, 30.0};

inline std::optional<glm::dvec3> first_point_on_ball(glm::dvec3 origin_mm, glm::dvec3 direction,
                                                     double radius_mm) {
  const glm::dvec3 to_origin = origin_mm - kBallCentre_mm;
  const double along = glm::dot(to_origin, direction);
  const double under_root = along * along - glm::dot(to_origin, to_origin) + radius_mm * radius_mm;
  if (under_root < 0.0) return {};
  const double distance_mm = -along - std::sqrt(under_root);
  if (distance_mm < 0.0) return {};
  return origin_mm + distance_mm * direction;
}

/// Wider (x 200) than high (z 180) and deep (y 160) mm, iso-values -200 and 250.
inline VolumeFacts ball_facts() {
  VolumeFacts facts;
  facts.id = "ball";
  facts.bounds_minimum_mm = kBallCentre_mm - glm::dvec3(100.0, 80.0, 90.0);
  facts.bounds_maximum_mm = kBallCentre_mm + glm::dvec3(100.0, 80.0, 90.0);
  facts.diagonal_mm = glm::length(facts.bounds_maximum_mm - facts.bounds_minimum_mm);
  facts.grid_centre_mm = kBallCentre_mm;
  facts.middle_voxel_mm = kBallCentre_mm + glm::dvec3(0.5, 0.0, 0.5);
  facts.grid_half_axes_mm = glm::dmat3(1.0);
  for (int axis = 0; axis < 3; ++axis) facts.grid_half_axes_mm[axis][axis] = 100.0 - 10.0 * axis;
  facts.outermost_share = glm::dvec3(2.0);  // the ball is whole, and touches the grid's faces
  facts.window_centre = 40.0;
  facts.window_width = 400.0;
  facts.minimum_value = -1000.0;
  facts.maximum_value = 2000.0;
  facts.outer_iso_value = -200.0;
  facts.inner_iso_value = 250.0;
  facts.first_surface_mm = [](glm::dvec3 origin_mm, glm::dvec3 direction, const ValueBand& band) {
    return first_point_on_ball(origin_mm, direction,
                               band.lower > 0.0 ? kBoneRadius_mm : kBallRadius_mm);
  };
  return facts;
}

}  // namespace cutaway
