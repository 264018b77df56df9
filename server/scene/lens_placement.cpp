#include "scene/lens_placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "scene/lenses/lens_body.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

/// Of a square grid about the view's middle, so that a view of another shape finds the same place.
constexpr int kRaysToTheEdge = 10;
constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// A lens that fills less of its outline than this is as good as empty. A spine is out of reach
/// of a lens on the belly: then the lens leaves the middle of the view, or is larger or deeper, at
/// a price in what it fills.
constexpr double kNearlyEmpty = 0.25;
constexpr double kWorthwhile = 0.0;  // who keeps so much ends the search
constexpr double kPriceOfTheEdge = 0.4;
constexpr double kPriceOfDepth = 0.2;  // for a whole radius
constexpr double kPriceOfSize = 0.2;   // for a whole radius more

/// Of a slab's thickness: what is left is seen behind the focus, where a hole would show the
/// background. Of the lens' own depth at least a little, where the slab has none.
constexpr double kOpenedOfSlab = 0.75;
constexpr double kLeastOpened = 0.01;

/// One ray of the view with the distances (mm) at which it first meets each surface.
struct ProbedRay {
  ViewRay ray;
  double context_mm = kNoHit;
  double focus_mm = kNoHit;
  bool is_on_face = false;    ///< the context is met where the volume's box cuts it
  glm::ivec2 from_middle{0};  ///< in rays of the grid

  bool is_in_the_middle() const { return from_middle == glm::ivec2(0); }
  bool is_anywhere() const { return true; }
  bool is_above_or_below_the_middle() const { return from_middle.x == 0; }
  /// 0 in the middle of the view, 1 at the nearer edges.
  double off_middle() const { return glm::length(glm::dvec2(from_middle)) / kRaysToTheEdge; }

  glm::dvec3 context_point_mm(double deeper_mm) const {
    return ray.origin_mm + (context_mm + deeper_mm) * ray.direction;
  }
};

double distance_to_surface_mm(const VolumeFacts& volume, const ViewRay& ray,
                              const ValueBand& band) {
  const auto point = volume.first_surface_mm(ray.origin_mm, ray.direction, band);
  return point ? glm::distance(ray.origin_mm, *point) : kNoHit;
}

bool is_on_face(const VolumeFacts& volume, glm::dvec3 point_mm) {
  constexpr double kNear = 1e-4;
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 half_mm = volume.grid_half_axes_mm[axis];
    const double share =
        std::abs(glm::dot(point_mm - volume.grid_centre_mm, half_mm)) / glm::dot(half_mm, half_mm);
    if (share >= volume.outermost_share[axis] - kNear) return true;
  }
  return false;
}

ProbedRay probe(const VolumeFacts& volume, const LensPlacementView& view, glm::ivec2 from_middle) {
  const glm::dvec2 middle_px{0.5 * view.viewport.width_px, 0.5 * view.viewport.height_px};
  const double apart_px = std::min(middle_px.x, middle_px.y) / (kRaysToTheEdge + 0.5);
  const glm::dvec2 position_px = middle_px + apart_px * glm::dvec2(from_middle);
  ProbedRay probed{.ray = ray_through(view.camera, view.viewport, position_px),
                   .from_middle = from_middle};
  probed.context_mm = distance_to_surface_mm(volume, probed.ray, view.context);
  if (probed.context_mm == kNoHit) return probed;
  probed.is_on_face = is_on_face(volume, probed.context_point_mm(0.0));
  probed.focus_mm = distance_to_surface_mm(volume, probed.ray, view.focus);
  return probed;
}

std::vector<ProbedRay> probe_view(const VolumeFacts& volume, const LensPlacementView& view) {
  std::vector<ProbedRay> rays;
  for (int y = -kRaysToTheEdge; y <= kRaysToTheEdge; ++y) {
    for (int x = -kRaysToTheEdge; x <= kRaysToTheEdge; ++x)
      rays.push_back(probe(volume, view, {x, y}));
  }
  return rays;
}

/// Most of what is seen is a section: a slab, or a volume cropped within the body. There the cut is
/// the surface; what is left of the other one lies at the view's edge.
bool is_seen_as_section(const std::vector<ProbedRay>& rays) {
  const auto met =
      std::ranges::count_if(rays, [](const ProbedRay& ray) { return ray.context_mm != kNoHit; });
  return 2 * std::ranges::count_if(rays, &ProbedRay::is_on_face) > met;
}

/// Share of the lens' outline in which the focus would be seen, by the cutaway's four-case rule:
/// where no context lies before the lens, and the focus within. A lens that is half beside the body
/// or behind skin is half wasted, so all of its outline counts; but of one that stands out of a
/// slab what dips into it.
double share_with_focus(const std::vector<ProbedRay>& rays, const LensBody& lens,
                        bool only_what_dips) {
  int crossed = 0;
  int filled = 0;
  for (const ProbedRay& probed : rays) {
    const auto lens_mm = lens.interval_mm(probed.ray);
    if (!lens_mm || (only_what_dips && lens_mm->y <= probed.context_mm)) continue;
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
using Forms = std::vector<Form>;

struct Choice {
  PlacedLens lens;
  double share = 0.0;  ///< of its outline that shows the focus
  double worth = -kNoHit;
};

/// A lens that is looked for a place.
struct Asked {
  LensBody body;  ///< anywhere
  double radius_mm;
  std::optional<SlabView> slab;
};

/// Where the lens opens a part of the slab only; its middle lies before the slab as a rule.
glm::dvec3 centre_at_slab_mm(glm::dvec3 on_surface_mm, const SlabView& slab, const LensBody& lens) {
  const double reach_mm = lens.reach_mm(slab.to_viewer);
  const double thickness_mm = 2.0 * glm::length(slab.half_axes_mm[2]);
  const double opened_mm = std::max(kOpenedOfSlab * thickness_mm, kLeastOpened * reach_mm);
  return on_surface_mm + std::max(reach_mm - opened_mm, 0.0) * slab.to_viewer;
}

Choice choice_at(const ProbedRay& candidate, const Form& form, const std::vector<ProbedRay>& rays,
                 const Asked& asked) {
  Choice choice;
  choice.lens.radius_mm = form.size * asked.radius_mm;
  const LensBody body = asked.body.at({}, form.size);
  choice.lens.centre_mm =
      asked.slab ? centre_at_slab_mm(candidate.context_point_mm(0.0), *asked.slab, body)
                 : candidate.context_point_mm(form.depth * choice.lens.radius_mm);
  choice.share =
      share_with_focus(rays, body.at(choice.lens.centre_mm, 1.0), asked.slab.has_value());
  choice.worth = choice.share - kPriceOfTheEdge * candidate.off_middle() -
                 kPriceOfDepth * form.depth - kPriceOfSize * (form.size - 1.0);
  return choice;
}

/// The places and forms among which one is chosen.
struct Candidates {
  bool (ProbedRay::*are_these)() const;
  Forms forms;
  bool on_faces = false;  ///< of the volume's box, which cuts the anatomy there
};

bool shows_more(const Choice& a, const Choice& b) {
  const bool a_shows = a.share >= kNearlyEmpty;
  const bool b_shows = b.share >= kNearlyEmpty;
  if (a_shows != b_shows) return a_shows;
  return a_shows ? a.worth > b.worth : a.share > b.share;
}

/// The best choice of them; nothing where the view misses the context's surface at all of them.
std::optional<Choice> best_choice(const std::vector<ProbedRay>& rays, const Candidates& candidates,
                                  const Asked& asked) {
  std::optional<Choice> best;
  for (const ProbedRay& candidate : rays) {
    if (candidate.context_mm == kNoHit || candidate.is_on_face != candidates.on_faces) continue;
    if (!(candidate.*candidates.are_these)()) continue;
    for (const Form& form : candidates.forms) {
      const Choice choice = choice_at(candidate, form, rays, asked);
      if (!best || shows_more(choice, *best)) best = choice;
    }
  }
  return best;
}

/// In the order in which they are tried.
const std::array<Candidates, 7>& all_candidates() {
  static const Forms on_the_surface{{}};
  static const Forms any{{}, {0.35, 1.0}, {0.7, 1.0}, {0.0, 1.4}, {0.35, 1.4}, {0.7, 1.4}};
  static const std::array<Candidates, 7> candidates{
      Candidates{&ProbedRay::is_in_the_middle, on_the_surface},
      Candidates{&ProbedRay::is_above_or_below_the_middle, on_the_surface},
      Candidates{&ProbedRay::is_above_or_below_the_middle, any},
      Candidates{&ProbedRay::is_anywhere, on_the_surface},
      Candidates{&ProbedRay::is_anywhere, any},
      Candidates{&ProbedRay::is_in_the_middle, on_the_surface, true},
      Candidates{&ProbedRay::is_anywhere, any, true}};
  return candidates;
}

}  // namespace

// Who shows something is taken; else the one that shows most, where all show nothing the first.
std::optional<PlacedLens> placed_lens(const VolumeFacts& volume, const LensPlacementView& view,
                                      double radius_mm) {
  if (!volume.first_surface_mm) return std::nullopt;
  std::vector<ProbedRay> rays = probe_view(volume, view);
  if (volume.slab || is_seen_as_section(rays)) {
    for (ProbedRay& ray : rays) ray.is_on_face = false;
  }
  const Asked asked{LensBody({.shape = view.shape, .radius_mm = radius_mm}), radius_mm,
                    volume.slab};
  std::optional<Choice> best;
  for (const Candidates& candidates : all_candidates()) {
    const std::optional<Choice> choice = best_choice(rays, candidates, asked);
    if (choice && (!best || shows_more(*choice, *best))) best = choice;
    if (best && best->share >= kNearlyEmpty && best->worth >= kWorthwhile) break;
  }
  if (!best) return std::nullopt;
  return best->lens;
}

SightOfFocus sight_of_focus(const VolumeFacts& volume, const LensPlacementView& view,
                            const PlacedLens& lens) {
  if (!volume.first_surface_mm) return SightOfFocus::some;
  const LensBody body(
      {.shape = view.shape, .centre_mm = lens.centre_mm, .radius_mm = lens.radius_mm});
  bool is_met = false;
  bool is_open = false;
  for (const ProbedRay& probed : probe_view(volume, view)) {
    const auto lens_mm = body.interval_mm(probed.ray);
    if (!lens_mm) continue;
    is_met = true;
    const bool uncovered = probed.context_mm >= lens_mm->x;
    if (uncovered && probed.focus_mm < lens_mm->y) return SightOfFocus::some;
    is_open = is_open || uncovered;
  }
  if (!is_met) return SightOfFocus::some;
  return is_open ? SightOfFocus::empty : SightOfFocus::covered;
}

}  // namespace cutaway
