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
inline constexpr float kContrast = 350.0f;
inline constexpr float kSpongyBone = 430.0f;
inline constexpr float kCorticalBone = 1250.0f;
inline constexpr float kEnamel = 2300.0f;
}  // namespace hu

struct Tissue {
  float value_hu = hu::kAir;
  float texture_hu = 0.0f;  ///< amplitude of the variation
  float texture_mm = 4.0f;  ///< its scale
  std::uint32_t seed = 0;
  float blur_voxels =
      1.3f;  ///< half the width of its edge; the wider, the smoother its iso-surface
};

inline constexpr float kSkinBlurVoxels = 1.8f;
inline constexpr float kBoneBlurVoxels = 1.4f;

/// Layers are painted in order, each over those before it. Neighbours in the list that share a
/// shape and differ in their inset cost one evaluation.
struct Layer {
  ShapePtr shape;
  Tissue tissue;
  float inset_mm = 0.0f;  ///< how far inside the shape's surface the layer begins
};

using Layers = std::vector<Layer>;

/// Thickness of the skin over the fat: more than in life, so that fat does not blur into the skin's
/// own edge, and its iso-surface is smooth.
inline constexpr float kSkinMm = 3.2f;

struct BoneMeasures {
  float compact_mm = 1.9f;  ///< thickness of the compact bone over the spongy bone
  float compact_hu = hu::kCorticalBone;
  std::uint32_t seed = 0;
};

/// A coat of periosteum, compact bone, and spongy bone within. The coat gives the bone's edge the
/// same surroundings everywhere, in muscle and in fat, so that its iso-surface does not show them.
void add_bone(Layers& layers, const ShapePtr& bone, const BoneMeasures& measures);

Layers head_layers();
Layers abdomen_layers();
Layers knees_layers();

}  // namespace cutaway::phantom
