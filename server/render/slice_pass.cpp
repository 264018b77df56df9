#include "render/slice_pass.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/slice_geometry.h"

namespace cutaway {

SliceKey slice_key(const Scene& scene, const GpuVolume& volume, const RenderSettings& settings) {
  const VolumeGeometry& geometry = volume.volume().geometry;
  const Camera camera = slice_camera(scene, half_axes_mm(geometry));
  return {.volume = volume.identity(),
          .rays = in_tile(view_rays(camera, scene.viewport, geometry), settings),
          .window = scene.slices.window,
          .supersampling = settings.supersampling};
}

SlicePass::SlicePass(const gl::ShaderLibrary& shaders)
    : program_(shaders, "rays.vert", "slice.frag") {}

void SlicePass::run(const SliceKey& key, const GpuVolume& volume, const gl::Framebuffer& target,
                    const gl::PixelRect& strip, const gl::FullscreenTriangle& triangle) const {
  const double half_width = 0.5 * key.window.width;
  const float black = volume.to_stored(key.window.centre - half_width);
  const float white = volume.to_stored(key.window.centre + half_width);
  program_.use();
  volume.set_uniforms(program_, 0);
  set_view_rays(program_, key.rays);
  program_.set("black", black);
  // A window may be narrower than floats tell apart.
  const float narrowest = std::max(std::abs(black), 1.0F) * std::numeric_limits<float>::epsilon();
  program_.set("per_grey", 1.0F / std::max(white - black, narrowest));
  program_.set("supersampling", key.supersampling);
  target.bind(strip);
  triangle.draw();
}

}  // namespace cutaway
