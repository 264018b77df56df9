// A scene's lens as a body in patient space: all that rays, regions and outlines ask of it.
#pragma once

#include <optional>

#include "scene/lenses/lens_shape.h"
#include "scene/scene.h"
#include "scene/view_geometry.h"

namespace cutaway {

/// A unit body, turned, stretched and moved. Patient space, mm.
class LensBody {
 public:
  /// The lens' radius is above 0.
  explicit LensBody(const Lens& lens);

  /// The same lens elsewhere, `size` times as large.
  LensBody at(glm::dvec3 centre_mm, double size) const;

  /// Where the ray enters and leaves, mm along it, behind its origin too; nothing where it misses.
  std::optional<glm::dvec2> interval_mm(const ViewRay& ray) const;

  const UnitBody& body() const { return *body_; }
  glm::dvec3 centre_mm() const { return centre_mm_; }
  /// How far it reaches from its middle along a unit direction or against it.
  double reach_mm(glm::dvec3 direction) const;
  /// Half edges of the box that holds it, along its own axes.
  const glm::dmat3& half_edges_mm() const { return half_edges_mm_; }
  /// Linear part; the body's own coordinates per mm.
  const glm::dmat3& body_from_patient() const { return body_from_patient_; }
  /// The most that a length grows by that.
  double body_per_mm() const;

 private:
  const UnitBody* body_;
  glm::dvec3 centre_mm_;
  glm::dmat3 half_edges_mm_;
  glm::dmat3 body_from_patient_;  ///< its inverse, kept: each ray asks for it
};

}  // namespace cutaway
