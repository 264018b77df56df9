#include "volume/phantom/voxelise.h"

#include <algorithm>
#include <array>

#include "volume/parallel.h"
#include "volume/phantom/noise.h"

namespace cutaway::phantom {

namespace {

// Edges of blocks, in voxels.
constexpr int kTurn = 32;       ///< what one turn of the parallel loop fills
constexpr int kNoiseBlock = 8;  ///< what shares one computation of noise
constexpr int kPaintBlock = 4;  ///< what shares one selection of shapes

constexpr float kScannerNoiseHu = 10.0f;  ///< standard deviation
constexpr std::uint32_t kScannerSeed = 4711;

/// The noise of one block: white noise smoothed with (1 2 1)/4 along each axis, which has no energy
/// left at the finest frequency. The hash of the voxel's place makes it independent of the block.
class ScannerNoise {
 public:
  explicit ScannerNoise(glm::ivec3 first_voxel) : first_voxel_(first_voxel) {
    std::size_t at = 0;
    for (int k = -1; k <= kNoiseBlock; ++k) {
      for (int j = -1; j <= kNoiseBlock; ++j) {
        for (int i = -1; i <= kNoiseBlock; ++i)
          values_[at++] = white(first_voxel + glm::ivec3(i, j, k));
      }
    }
    smooth(1);
    smooth(kEdge);
    smooth(kEdge * kEdge);
  }

  float at(glm::ivec3 voxel) const {
    const glm::ivec3 place = voxel - first_voxel_ + 1;
    return values_[(place.z * kEdge + place.y) * kEdge + place.x];
  }

 private:
  static constexpr int kEdge = kNoiseBlock + 2;
  static constexpr int kCount = kEdge * kEdge * kEdge;

  /// The sum of two uniform numbers, scaled so that the smoothed noise has the wanted deviation:
  /// the sum's variance is 2/3, and smoothing keeps (6/16)^3 of it.
  static float white(glm::ivec3 voxel) {
    constexpr float kScale = kScannerNoiseHu / 0.18750f;
    const std::uint32_t h = lattice_hash(voxel, kScannerSeed);
    return kScale * (float((h & 0xffffu) + (h >> 16)) * (1.0f / 32768.0f) - 2.0f);
  }

  void smooth(int stride) {
    const auto before = values_;
    for (int i = stride; i < kCount - stride; ++i) {
      values_[i] = 0.25f * (before[i - stride] + before[i + stride]) + 0.5f * before[i];
    }
  }

  glm::ivec3 first_voxel_;
  std::array<float, kCount> values_{};
};

/// 1 inside, 0 outside, a smooth ramp of twice `blur_mm` between.
float coverage(float distance_mm, float blur_mm) {
  const float t = glm::clamp(0.5f - 0.5f * distance_mm / blur_mm, 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

float tissue_value(const Tissue& tissue, glm::vec3 p) {
  if (tissue.texture_hu == 0.0f) return tissue.value_hu;
  return tissue.value_hu +
         tissue.texture_hu * gradient_noise(p * (1.0f / tissue.texture_mm), tissue.seed);
}

/// The layers that show within the ball, with their shapes cut down to it.
Layers layers_near(const Layers& layers, const Ball& ball, float voxel_mm) {
  Layers near;
  const Shape* whole = nullptr;
  ShapePtr part;
  for (const Layer& layer : layers) {
    const float blur_mm = layer.tissue.blur_voxels * voxel_mm;
    const Bounds bounds = layer.shape->bounds(ball);
    if (bounds.low_mm + layer.inset_mm >= blur_mm) continue;
    if (bounds.high_mm + layer.inset_mm <= -blur_mm) near.clear();
    if (layer.shape.get() != whole) part = prune(layer.shape, ball);
    whole = layer.shape.get();
    near.push_back({part, layer.tissue, layer.inset_mm});
  }
  return near;
}

/// From the last layer, which lies over the others, to the first that still shows.
float paint(const Layers& layers, glm::vec3 p, float voxel_mm) {
  float value = 0.0f;
  float uncovered = 1.0f;
  const Shape* shape = nullptr;
  float distance_mm = 0.0f;
  for (auto layer = layers.rbegin(); layer != layers.rend() && uncovered > 0.0f; ++layer) {
    if (layer->shape.get() != shape) distance_mm = layer->shape->distance_mm(p);
    shape = layer->shape.get();
    const float blur_mm = layer->tissue.blur_voxels * voxel_mm;
    const float share = uncovered * coverage(distance_mm + layer->inset_mm, blur_mm);
    if (share > 0.0f) value += share * tissue_value(layer->tissue, p);
    uncovered -= share;
  }
  return value + uncovered * hu::kAir;
}

std::uint16_t to_stored(float value_hu) {
  const float stored = value_hu + float(kStoredOffsetHu) + 0.5f;
  return std::uint16_t(std::clamp(stored, 0.0f, float(kStoredLimit)));
}

/// A box of voxels.
struct Block {
  glm::ivec3 first{0};
  glm::ivec3 size{0};
};

class Voxeliser {
 public:
  Voxeliser(const Layers& layers, const VolumeGeometry& geometry)
      : layers_(layers),
        size_(geometry.size_voxels),
        turns_((size_ + kTurn - 1) / kTurn),
        voxel_mm_(float(geometry.spacing_mm.x)),
        origin_mm_(geometry.origin_patient_mm),
        voxels_(std::size_t(size_.x) * size_.y * size_.z) {}

  int turn_count() const { return turns_.x * turns_.y * turns_.z; }

  void fill_turn(int index) {
    const glm::ivec3 place(index % turns_.x, index / turns_.x % turns_.y,
                           index / (turns_.x * turns_.y));
    fill(block_at(kTurn * place, kTurn), kTurn, layers_);
  }

  std::vector<std::uint16_t> take() { return std::move(voxels_); }

 private:
  Block block_at(glm::ivec3 first, int edge) const {
    return {first, glm::min(glm::ivec3(edge), size_ - first)};
  }

  Ball ball_about(const Block& block) const {
    const glm::vec3 half_mm = 0.5f * voxel_mm_ * glm::vec3(block.size - 1);
    return {position_mm(block.first) + half_mm, glm::length(half_mm)};
  }

  template <typename Function>
  void for_each_part(const Block& block, int edge, const Function& function) const {
    const glm::ivec3 parts = (block.size + edge - 1) / edge;
    for (int k = 0; k < parts.z; ++k) {
      for (int j = 0; j < parts.y; ++j) {
        for (int i = 0; i < parts.x; ++i) {
          function(block_at(block.first + edge * glm::ivec3(i, j, k), edge));
        }
      }
    }
  }

  /// Halves the block, with ever fewer candidates, down to the blocks of noise.
  void fill(const Block& block, int edge, const Layers& candidates) {
    const Layers near = layers_near(candidates, ball_about(block), voxel_mm_);
    if (edge > kNoiseBlock) {
      for_each_part(block, edge / 2, [&](const Block& part) { fill(part, edge / 2, near); });
      return;
    }
    const ScannerNoise noise(block.first);
    for_each_part(block, kPaintBlock, [&](const Block& part) {
      paint_block(part, layers_near(near, ball_about(part), voxel_mm_), noise);
    });
  }

  void paint_block(const Block& block, const Layers& near, const ScannerNoise& noise) {
    for_each_part(block, 1, [&](const Block& voxel) {
      const float value_hu = paint(near, position_mm(voxel.first), voxel_mm_);
      voxels_[offset(voxel.first)] = to_stored(value_hu + noise.at(voxel.first));
    });
  }

  glm::vec3 position_mm(glm::ivec3 voxel) const {
    return origin_mm_ + voxel_mm_ * glm::vec3(voxel);
  }
  std::size_t offset(glm::ivec3 voxel) const {
    return (std::size_t(voxel.z) * size_.y + voxel.y) * size_.x + voxel.x;
  }

  const Layers& layers_;
  glm::ivec3 size_;
  glm::ivec3 turns_;
  float voxel_mm_;
  glm::vec3 origin_mm_;
  std::vector<std::uint16_t> voxels_;
};

}  // namespace

std::vector<std::uint16_t> voxelise(const Layers& layers, const VoxeliseRequest& request,
                                    const std::stop_token& stop) {
  Voxeliser voxeliser(layers, request.geometry);
  run_parallel({.count = voxeliser.turn_count(),
                .turn = [&](int index) { voxeliser.fill_turn(index); },
                .progress = request.progress,
                .threads = request.threads},
               stop);
  return voxeliser.take();
}

}  // namespace cutaway::phantom
