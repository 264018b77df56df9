// What a phantom is made of, and how it becomes voxels.
#pragma once

#include <cstdint>
#include <vector>

#include "volume/phantom/shape.h"

namespace cutaway::phantom {

/// Hounsfield units. Spongy bone stays clear of 250, the usual iso-value of bone, so that bone is
/// solid there.
namespace hu {
inline constexpr float kAir = -1000.0f;
inline constexpr float kFat = -95.0f;
inline constexpr float kFluid = 8.0f;
inline constexpr float kMarrow = -45.0f;
inline constexpr float kWhiteMatter = 27.0f;
inline constexpr float kGreyMatter = 40.0f;
inline constexpr float kSkin = 45.0f;
inline constexpr float kMuscle = 58.0f;
inline constexpr float kCartilage = 115.0f;
inline constexpr float kContrast = 310.0f;
inline constexpr float kSpongyBone = 430.0f;
inline constexpr float kCorticalBone = 1250.0f;
inline constexpr float kEnamel = 2300.0f;
}  // namespace hu

struct Tissue {
  float value_hu = hu::kAir;
  float texture_hu = 0.0f;  ///< amplitude of the variation
  float texture_mm = 4.0f;  ///< its scale
  std::uint32_t seed = 0;
};

/// Layers are painted in order, each over those before it.
struct Layer {
  ShapePtr shape;
  Tissue tissue;
};

using Layers = std::vector<Layer>;

Layers head_layers();
Layers abdomen_layers();
Layers knees_layers();

}  // namespace cutaway::phantom
