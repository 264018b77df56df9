// The bodies that lenses are made of, in coordinates of their own.
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace cutaway {

/// A convex body that holds the origin and fills the cube of -1..1. Its functions stand in a file
/// that is GLSL and C++ alike; unit_body.glsl says what each gives. Lengths are in the body's own
/// coordinates, and the parameter of a ray is the caller's: an affine map keeps it.
/// Gauge, normal, offset and rim are what shaders ask of it: here, tests hold them against closed
/// forms.
struct UnitBody {
  const char* shader;  ///< that file
  glm::dvec2 (*interval)(glm::dvec3 origin, glm::dvec3 direction);
  double (*gauge)(glm::dvec3 position);
  glm::dvec3 (*normal)(glm::dvec3 position);
  double (*offset)(glm::dvec3 origin, glm::dvec3 direction);
  double (*rim)(glm::dvec3 origin, glm::dvec3 direction, glm::dvec2 interval, double reach);
  /// Its outline for clients: radius and z of corners from one end of its axis z to the other.
  std::span<const glm::dvec2> profile;
  bool is_round = true;  ///< about z; else square, with sides at x and y = +-radius
};

extern const UnitBody kUnitBall;
extern const UnitBody kUnitBox;
extern const UnitBody kUnitCylinder;
extern const UnitBody kUnitCone;

}  // namespace cutaway
