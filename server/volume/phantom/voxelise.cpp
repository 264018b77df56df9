#include "volume/phantom/voxelise.h"

#include <algorithm>
#include <array>

#include "volume/parallel.h"
#include "volume/phantom/noise.h"

namespace cutaway::phantom {

namespace {

constexpr int kBlock = 8;                 ///< voxels an edge
constexpr int kSuperblock = 32;           ///< what one turn of the parallel loop fills
constexpr float kScannerNoiseHu = 10.0f;  ///< standard deviation
constexpr std::uint32_t kScannerSeed = 4711;

/// The noise of one block: white noise smoothed with (1 2 1)/4 along each axis, which has no energy
/// left at the finest frequency. The hash of the voxel's place makes it independent of the block.
class ScannerNoise {
 public:
  explicit ScannerNoise(glm::ivec3 first_voxel) {
    std::size_t at = 0;
    for (int k = -1; k <= kBlock; ++k) {
      for (int j = -1; j <= kBlock; ++j) {
        for (int i = -1; i <= kBlock; ++i) values_[at++] = white(first_voxel + glm::ivec3(i, j, k));
      }
    }
    smooth(1);
    smooth(kEdge);
    smooth(kEdge * kEdge);
  }

  float at(int i, int j, int k) const { return values_[((k + 1) * kEdge + j + 1) * kEdge + i + 1]; }

 private:
  static constexpr int kEdge = kBlock + 2;
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
        superblocks_((size_ + kSuperblock - 1) / kSuperblock),
        voxel_mm_(float(geometry.spacing_mm.x)),
        origin_mm_(geometry.origin_patient_mm),
        voxels_(std::size_t(size_.x) * size_.y * size_.z) {}

  int superblock_count() const { return superblocks_.x * superblocks_.y * superblocks_.z; }

  void fill_superblock(int index) {
    const glm::ivec3 place(index % superblocks_.x, index / superblocks_.x % superblocks_.y,
                           index / (superblocks_.x * superblocks_.y));
    const Block superblock = block_at(kSuperblock * place, kSuperblock);
    const Layers near = layers_near(layers_, ball_about(superblock), voxel_mm_);
    const glm::ivec3 blocks = (superblock.size + kBlock - 1) / kBlock;
    for (int k = 0; k < blocks.z; ++k) {
      for (int j = 0; j < blocks.y; ++j) {
        for (int i = 0; i < blocks.x; ++i) {
          fill(block_at(superblock.first + kBlock * glm::ivec3(i, j, k), kBlock), near);
        }
      }
    }
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

  void fill(const Block& block, const Layers& candidates) {
    const Layers near = layers_near(candidates, ball_about(block), voxel_mm_);
    const ScannerNoise noise(block.first);
    for (int k = 0; k < block.size.z; ++k) {
      for (int j = 0; j < block.size.y; ++j) {
        std::uint16_t* row = voxels_.data() + offset(block.first + glm::ivec3(0, j, k));
        for (int i = 0; i < block.size.x; ++i) {
          const glm::vec3 p = position_mm(block.first + glm::ivec3(i, j, k));
          row[i] = to_stored(paint(near, p, voxel_mm_) + noise.at(i, j, k));
        }
      }
    }
  }

  glm::vec3 position_mm(glm::ivec3 voxel) const {
    return origin_mm_ + voxel_mm_ * glm::vec3(voxel);
  }
  std::size_t offset(glm::ivec3 voxel) const {
    return (std::size_t(voxel.z) * size_.y + voxel.y) * size_.x + voxel.x;
  }

  const Layers& layers_;
  glm::ivec3 size_;
  glm::ivec3 superblocks_;
  float voxel_mm_;
  glm::vec3 origin_mm_;
  std::vector<std::uint16_t> voxels_;
};

}  // namespace

std::vector<std::uint16_t> voxelise(const Layers& layers, const VoxeliseRequest& request,
                                    const std::stop_token& stop) {
  Voxeliser voxeliser(layers, request.geometry);
  run_parallel({.count = voxeliser.superblock_count(),
                .turn = [&](int index) { voxeliser.fill_superblock(index); },
                .progress = request.progress,
                .threads = request.threads},
               stop);
  return voxeliser.take();
}

}  // namespace cutaway::phantom
