// One ray through a volume for the reference renderer: where it is, what it meets, and which parts
// of it the lens gives to which branch.
#pragma once

#include <array>
#include <optional>

#include "scene/scene.h"
#include "scene/view_geometry.h"
#include "support/reference_funnel.h"
#include "support/reference_lens.h"
#include "volume/volume.h"

namespace cutaway::reference {

enum class BranchName { context, focus };

/// A stretch of the ray in which only one branch exists.
struct RayPart {
  BranchName branch = BranchName::context;
  Interval stretch;
  std::optional<glm::dvec3> face;  ///< normal of the cut where it starts in material
  bool starts_open = false;        ///< material at the start does not count
};

struct SurfaceHit {
  double distance_mm = 0.0;
  glm::dvec3 normal{0.0};
  bool is_cut = false;  ///< a face of the lens, the funnel or the volume's box
};

class Ray {
 public:
  /// `picture_height_px` tells how far apart the rays of neighbouring pixels are.
  Ray(const Scene& scene, const Volume& volume, const ViewRay& ray, double step_mm,
      int picture_height_px);

  const Interval& in_volume() const { return box_; }
  glm::dvec3 direction() const { return ray_.direction; }
  double value(double distance_mm) const;
  /// Outward normal of the material, towards the viewer; patient space.
  glm::dvec3 gradient_normal(double distance_mm) const;
  /// The end of the step that begins at `distance_mm`: steps are counted from the box's entry.
  double step_end_mm(double distance_mm, const Interval& stretch) const;

  RayPart whole(BranchName branch) const;
  /// In front of the cutaway's lens, inside, behind; a funnel takes of the first and the last.
  std::array<RayPart, 3> cutaway_parts() const;
  bool is_under_lens() const;
  /// Whether the context that is met there is seen through the lens or the funnel's cut.
  bool is_behind_lens(double distance_mm) const;
  /// What of the context the lens and the funnel take away; empty: nothing.
  Interval taken_from_context() const;
  /// Whether the band is met just before or behind the lens: then the lens has cut it off.
  bool goes_on_outside(const RayPart& in_lens, const ValueBand& band) const;

  /// The first point in the branch's band within the part.
  std::optional<SurfaceHit> first_surface(const RayPart& part, const ValueBand& band) const;

 private:
  glm::dvec3 position_mm(double distance_mm) const;
  glm::dvec3 index_at(double distance_mm) const;
  glm::dvec3 facing(glm::dvec3 normal) const;
  Interval box_interval() const;
  Interval lens_interval() const;
  double clear_mm() const;
  double rim_depth_mm(const RayPart& in_lens) const;
  double bisect(double near_mm, double far_mm, const ValueBand& band) const;
  std::optional<glm::dvec3> lens_face(double distance_mm) const;
  glm::dvec3 box_face() const;

  const Camera& camera_;
  const Lens& scene_lens_;
  ReferenceLens lens_;
  ReferenceFunnel funnel_;
  const Volume& volume_;
  ViewRay ray_;
  glm::dmat4 to_index_;
  double step_mm_;
  int picture_height_px_;
  Interval box_;
  double funnel_end_mm_;
};

}  // namespace cutaway::reference
