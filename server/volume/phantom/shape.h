// Solids as signed distance functions, and the ways to combine them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <memory>
#include <vector>

namespace cutaway::phantom {

/// The surroundings of a block of voxels.
struct Ball {
  glm::vec3 centre_mm{0.0f};
  float radius_mm = 0.0f;
};

struct Bounds {
  float low_mm = 0.0f;
  float high_mm = 0.0f;
};

class Shape;
using ShapePtr = std::shared_ptr<const Shape>;

/// Immutable. Patient space, mm.
class Shape {
 public:
  Shape() = default;
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  virtual ~Shape() = default;

  /// Negative inside, zero on the surface, close to the distance in mm near it.
  virtual float distance_mm(glm::vec3 position_mm) const = 0;

  /// Limits of distance_mm within `ball`: may be too wide, never too narrow.
  virtual Bounds bounds(const Ball& ball) const = 0;

  /// A shape with fewer parts and the same distances within `ball`; nothing where no part can be
  /// left out.
  virtual ShapePtr pruned(const Ball&) const { return nullptr; }
};

ShapePtr prune(const ShapePtr& shape, const Ball& ball);

// --- Solids

ShapePtr sphere(glm::vec3 centre_mm, float radius_mm);

/// Axes along x, y, z. Distances are those of a first-order estimate, exact on the surface.
ShapePtr ellipsoid(glm::vec3 centre_mm, glm::vec3 radii_mm);

/// The same with its own z axis along `up` and its y axis as near to patient y as that allows.
ShapePtr ellipsoid(glm::vec3 centre_mm, glm::vec3 radii_mm, glm::vec3 up);

/// A box with rounded edges; `half_mm` includes the rounding. `up` as above.
ShapePtr rounded_box(glm::vec3 centre_mm, glm::vec3 half_mm, float rounding_mm,
                     glm::vec3 up = {0.0f, 0.0f, 1.0f});

/// The side of a plane that `normal` points away from.
ShapePtr half_space(glm::vec3 point_mm, glm::vec3 normal);

struct Knot {
  glm::vec3 position_mm{0.0f};
  float radius_mm = 1.0f;
};

/// A round, tapering tube along straight lines between the knots.
ShapePtr rod(const std::vector<Knot>& knots);

/// A round, tapering tube along a Catmull-Rom curve through the knots. A `weight` below 1 makes the
/// section wider along that axis by 1/weight.
ShapePtr tube(const std::vector<Knot>& knots, glm::vec3 weight = glm::vec3(1.0f));

// --- Combinations

/// Union, with edges rounded over about `blend_mm`.
ShapePtr join(float blend_mm, std::vector<ShapePtr> parts);

/// Intersection.
ShapePtr meet(float blend_mm, std::vector<ShapePtr> parts);

/// `solid` without `tool`.
ShapePtr carve(float blend_mm, const ShapePtr& solid, const ShapePtr& tool);

ShapePtr complement(const ShapePtr& shape);

/// Surface moved outwards by `offset_mm` (inwards where negative).
ShapePtr grow(float offset_mm, const ShapePtr& shape);

/// The shape and its reflection in the plane x = 0; `shape` is given on the patient's left, x >= 0.
ShapePtr both_sides(const ShapePtr& shape);

/// The reflection in the plane x = 0.
ShapePtr reflected(const ShapePtr& shape);

ShapePtr moved(glm::vec3 offset_mm, const ShapePtr& shape);

/// Surface moved in and out by noise.
struct Roughness {
  float amplitude_mm = 0.0f;
  float scale_mm = 1.0f;
  std::uint32_t seed = 0;
};
ShapePtr roughen(const Roughness& roughness, const ShapePtr& shape);

/// Winding grooves, as the sulci of the brain: the zero lines of a noise whose domain is warped by
/// another.
struct Grooves {
  float depth_mm = 0.0f;
  float spacing_mm = 1.0f;
  float width = 0.2f;  ///< of the grooves, in units of the noise's amplitude
  std::uint32_t seed = 0;
};
ShapePtr groove(const Grooves& grooves, const ShapePtr& shape);

/// Winding sheets through all of space, as the fat that parts the bellies of muscles.
ShapePtr sheets(float thickness_mm, float spacing_mm, std::uint32_t seed);

}  // namespace cutaway::phantom
