// What a frame may cost and what form its pixels come in; how it looks is in the scene.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "core/picture.h"

namespace cutaway {

/// Each way. Shading has a program for each number.
inline constexpr int kMostSupersampling = 4;

/// Where a picture lies in a larger one of the scene's whole viewport.
struct PictureTile {
  glm::ivec2 begin_px{0};
  glm::ivec2 whole_size_px{0};
  bool operator==(const PictureTile&) const = default;
};

/// Rays from each point to the light, and samples along each. No rays: as if nothing were in the
/// way.
struct LightQuality {
  int directions = 16;  ///< of ambient light, 0..kMostLightDirections
  int samples = 16;
  int shadow_rays = 4;
  int shadow_samples = 24;
  bool operator==(const LightQuality&) const = default;
};
inline constexpr int kMostLightDirections = 64;
inline constexpr LightQuality kNoLight{0, 0, 0, 0};
inline constexpr LightQuality kQuickLight{2, 6, 1, 8};
inline constexpr LightQuality kFullLight;

struct RenderSettings {
  glm::ivec2 picture_size_px{0};
  std::optional<PictureTile> tile;  ///< else the picture is the whole viewport
  double resolution_scale =
      1.0;  ///< picture pixels per viewport pixel: filters' radii are in viewport pixels
  int supersampling = 1;     ///< rays a pixel each way, 1..kMostSupersampling
  double step_voxels = 1.0;  ///< ray step in units of the smallest spacing
  LightQuality light;
  bool skip_empty_space = true;  ///< off only to prove that it changes nothing
  PixelLayout layout = PixelLayout::rgba;
};

inline PictureTile tile_of(const RenderSettings& settings) {
  return settings.tile.value_or(PictureTile{{0, 0}, settings.picture_size_px});
}

}  // namespace cutaway
