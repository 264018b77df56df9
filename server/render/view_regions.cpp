#include "render/view_regions.h"

#include <limits>

#include "scene/lenses/lens_body.h"
#include "scene/view_geometry.h"

namespace cutaway {

namespace {

constexpr int kMarginPx = 2;

/// A box given by its middle and half edges, as it is projected; the whole picture where a part of
/// it lies behind the eye.
class Projection2D {
 public:
  Projection2D(const Scene& scene, const RenderSettings& settings)
      : scene_(scene), picture_size_px_(settings.picture_size_px), tile_(tile_of(settings)) {}

  gl::PixelRect box(glm::dvec3 middle_mm, const glm::dmat3& half_edges_mm) const {
    glm::dvec2 low(std::numeric_limits<double>::max());
    glm::dvec2 high(std::numeric_limits<double>::lowest());
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 signs((corner & 1) * 2 - 1, (corner & 2) - 1, (corner & 4) / 2 - 1);
      const auto at = project_px(scene_.camera, scene_.viewport, middle_mm + half_edges_mm * signs);
      if (!at) return {{0, 0}, picture_size_px_};
      low = glm::min(low, *at);
      high = glm::max(high, *at);
    }
    return in_picture(low, high);
  }

 private:
  gl::PixelRect in_picture(glm::dvec2 low, glm::dvec2 high) const {
    const glm::dvec2 size(picture_size_px_);
    const glm::dvec2 begin(tile_.begin_px);
    const glm::dvec2 scale = glm::dvec2(tile_.whole_size_px) /
                             glm::dvec2(scene_.viewport.width_px, scene_.viewport.height_px);
    const auto inside = [&](glm::dvec2 at) {
      return glm::ivec2(glm::clamp(at, glm::dvec2(0.0), size));
    };
    return {inside(glm::floor(low * scale) - begin - double(kMarginPx)),
            inside(glm::ceil(high * scale) - begin + double(kMarginPx))};
  }

  const Scene& scene_;
  glm::ivec2 picture_size_px_;
  PictureTile tile_;
};

gl::PixelRect volume_region(const Projection2D& projection, const VolumeGeometry& geometry) {
  const glm::dvec3 half = 0.5 * glm::dvec3(geometry.size_voxels - 1);
  const glm::dmat4 to_patient = index_to_patient(geometry);
  glm::dmat3 half_edges(0.0);
  for (int axis = 0; axis < 3; ++axis) half_edges[axis] = glm::dvec3(to_patient[axis]) * half[axis];
  return projection.box(glm::dvec3(to_patient * glm::dvec4(half, 1.0)), half_edges);
}

gl::PixelRect lens_region(const Projection2D& projection, const Scene& scene) {
  if (scene.lens.mode == LensMode::none || scene.lens.radius_mm <= 0.0) return {};
  const CameraAxes axes = camera_axes(scene.camera);
  const LensBody body(scene.lens);
  const auto half_edge = [&](glm::dvec3 axis) { return body.reach_mm(axis) * axis; };
  return projection.box(scene.lens.centre_mm,
                        {half_edge(axes.right), half_edge(axes.up), half_edge(axes.backward)});
}

}  // namespace

gl::PixelRect common_part(const gl::PixelRect& a, const gl::PixelRect& b) {
  return {glm::max(a.begin, b.begin), glm::min(a.end, b.end)};
}

std::vector<gl::PixelRect> parts_around(const gl::PixelRect& outer, const gl::PixelRect& inner) {
  const gl::PixelRect hole = common_part(outer, inner);
  if (hole.is_empty()) return {outer};
  std::vector<gl::PixelRect> parts = {{outer.begin, {outer.end.x, hole.begin.y}},
                                      {{outer.begin.x, hole.end.y}, outer.end},
                                      {{outer.begin.x, hole.begin.y}, {hole.begin.x, hole.end.y}},
                                      {{hole.end.x, hole.begin.y}, {outer.end.x, hole.end.y}}};
  std::erase_if(parts, [](const gl::PixelRect& part) { return part.is_empty(); });
  return parts;
}

ViewRegions view_regions(const Scene& scene, const VolumeGeometry& part,
                         const RenderSettings& settings) {
  const Projection2D projection(scene, settings);
  ViewRegions regions;
  regions.volume = volume_region(projection, part);
  regions.branches[kContext] = regions.volume;
  regions.branches[kFocus] = common_part(regions.volume, lens_region(projection, scene));
  return regions;
}

gl::PixelRect scaled(const gl::PixelRect& region, int factor) {
  return {region.begin * factor, region.end * factor};
}

}  // namespace cutaway
