#include "scene/lens_placement.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "scene/view_geometry.h"

namespace cutaway {

namespace {

constexpr int kRaysASide = 21;  // odd, so that one of them is the view's middle
constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// What focus in the lens is worth against its place: a lens at the view's edge has to fill this
/// much more of its outline than one in the middle.
constexpr double kPriceOfTheEdge = 0.4;

/// A lens on the surface that fills less of its outline than this shows next to nothing. A spine
/// is out of reach of a lens on the belly: then it may be larger and lie deeper, at a price.
constexpr double kNextToNothing = 0.1;
constexpr double kPriceOfDepth = 0.2;  // for a whole radius
constexpr double kPriceOfSize = 0.2;   // for a whole radius more

/// What another place has to be better by, so that a lens leaves the middle for a reason only.
constexpr double kWorthLeavingTheMiddle = 0.1;

/// One ray of the view with the distances (mm) at which it first meets each surface.
struct ProbedRay {
  ViewRay ray;
  double context_mm = kNoHit;
  double focus_mm = kNoHit;
  double off_middle = 0.0;  ///< 0 in the middle of the view, 1 at the nearer edges

  glm::dvec3 context_point_mm(double deeper_mm) const {
    return ray.origin_mm + (context_mm + deeper_mm) * ray.direction;
  }
};

double distance_to_surface_mm(const VolumeFacts& volume, const ViewRay& ray,
                              const ValueBand& band) {
  const auto point = volume.first_surface_mm(ray.origin_mm, ray.direction, band);
  return point ? glm::distance(ray.origin_mm, *point) : kNoHit;
}

ProbedRay probe(const VolumeFacts& volume, const LensPlacementView& view, glm::dvec2 position_px) {
  ProbedRay probed{.ray = ray_through(view.camera, view.viewport, position_px)};
  probed.context_mm = distance_to_surface_mm(volume, probed.ray, view.context);
  if (probed.context_mm != kNoHit)
    probed.focus_mm = distance_to_surface_mm(volume, probed.ray, view.focus);
  const glm::dvec2 middle_px{0.5 * view.viewport.width_px, 0.5 * view.viewport.height_px};
  probed.off_middle =
      glm::distance(position_px, middle_px) / std::max(1.0, std::min(middle_px.x, middle_px.y));
  return probed;
}

std::vector<ProbedRay> probe_view(const VolumeFacts& volume, const LensPlacementView& view) {
  std::vector<ProbedRay> rays;
  const glm::dvec2 size_px{view.viewport.width_px, view.viewport.height_px};
  for (int row = 0; row < kRaysASide; ++row) {
    for (int column = 0; column < kRaysASide; ++column) {
      const glm::dvec2 cell(column, row);
      rays.push_back(probe(volume, view, (cell + 0.5) / double(kRaysASide) * size_px));
    }
  }
  return rays;
}

/// The ray's way through a sphere (mm along the ray); nothing where it misses.
std::optional<glm::dvec2> through_sphere_mm(const ViewRay& ray, glm::dvec3 centre_mm,
                                            double radius_mm) {
  const glm::dvec3 to_centre = centre_mm - ray.origin_mm;
  const double nearest_mm = glm::dot(to_centre, ray.direction);
  const double under_root =
      radius_mm * radius_mm - glm::dot(to_centre, to_centre) + nearest_mm * nearest_mm;
  if (under_root <= 0.0) return std::nullopt;
  const double half_mm = std::sqrt(under_root);
  return glm::dvec2(nearest_mm - half_mm, nearest_mm + half_mm);
}

/// Share of the lens' outline in which the focus would be seen, by the cutaway's four-case rule:
/// where no context lies before the lens, and the focus within. A lens that is half beside the body
/// or behind skin is half wasted, so all of its outline counts.
double share_with_focus(const std::vector<ProbedRay>& rays, glm::dvec3 centre_mm,
                        double radius_mm) {
  int crossed = 0;
  int filled = 0;
  for (const ProbedRay& probed : rays) {
    const auto lens_mm = through_sphere_mm(probed.ray, centre_mm, radius_mm);
    if (!lens_mm) continue;
    ++crossed;
    if (probed.context_mm >= lens_mm->x && probed.focus_mm < lens_mm->y) ++filled;
  }
  return crossed > 0 ? static_cast<double>(filled) / crossed : 0.0;
}

/// A lens that might be chosen: its middle under the context's surface by `depth` radii, and its
/// radius `size` times the asked one.
struct Form {
  double depth = 0.0;
  double size = 1.0;
};
constexpr std::array kOnTheSurface = {Form{}};
constexpr std::array kAnyForm = {Form{},         Form{0.35, 1.0}, Form{0.7, 1.0},
                                 Form{0.0, 1.4}, Form{0.35, 1.4}, Form{0.7, 1.4}};

struct Choice {
  PlacedLens lens;
  double share = 0.0;  ///< of its outline that shows the focus
  double worth = -kNoHit;
};

Choice choice_at(const ProbedRay& candidate, const Form& form, const std::vector<ProbedRay>& rays,
                 double radius_mm) {
  Choice choice;
  choice.lens.radius_mm = form.size * radius_mm;
  choice.lens.centre_mm = candidate.context_point_mm(form.depth * choice.lens.radius_mm);
  choice.share = share_with_focus(rays, choice.lens.centre_mm, choice.lens.radius_mm);
  choice.worth = choice.share - kPriceOfTheEdge * candidate.off_middle -
                 kPriceOfDepth * form.depth - kPriceOfSize * (form.size - 1.0);
  return choice;
}

template <typename Forms>
Choice best_choice(const std::vector<ProbedRay>& rays, const Forms& forms, double radius_mm) {
  Choice best;
  for (const ProbedRay& candidate : rays) {
    if (candidate.context_mm == kNoHit) continue;
    for (const Form& form : forms) {
      const Choice choice = choice_at(candidate, form, rays, radius_mm);
      if (choice.worth > best.worth) best = choice;
    }
  }
  return best;
}

/// The lens leaves the middle of the view for a reason only.
Choice best_on_the_surface(const std::vector<ProbedRay>& rays, double radius_mm) {
  const Choice best = best_choice(rays, kOnTheSurface, radius_mm);
  const ProbedRay& middle = rays.at(rays.size() / 2);
  if (middle.context_mm == kNoHit) return best;
  const Choice in_the_middle = choice_at(middle, {}, rays, radius_mm);
  return best.worth > in_the_middle.worth + kWorthLeavingTheMiddle ? best : in_the_middle;
}

}  // namespace

std::optional<PlacedLens> placed_lens(const VolumeFacts& volume, const LensPlacementView& view,
                                      double radius_mm) {
  if (!volume.first_surface_mm) return std::nullopt;
  const std::vector<ProbedRay> rays = probe_view(volume, view);
  Choice best = best_on_the_surface(rays, radius_mm);
  if (best.worth == -kNoHit) return std::nullopt;
  if (best.share < kNextToNothing) best = best_choice(rays, kAnyForm, radius_mm);
  return best.lens;
}

}  // namespace cutaway
