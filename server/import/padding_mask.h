// Which voxels of a volume their file declares to have no value.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cutaway::reading {

/// A bit a voxel, so that it takes little beside them. Several threads may mark at once; who asks
/// does so when all have ended.
class PaddingMask {
 public:
  PaddingMask() = default;
  explicit PaddingMask(std::size_t voxels) : bits_((voxels + 7) / 8) {}

  bool empty() const { return bits_.empty(); }
  void mark(std::size_t voxel) {
    std::atomic_ref(bits_[voxel / 8]).fetch_or(bit(voxel), std::memory_order_relaxed);
  }
  bool holds(std::size_t voxel) const { return (bits_[voxel / 8] & bit(voxel)) != 0; }

 private:
  static std::uint8_t bit(std::size_t voxel) { return std::uint8_t(1U << (voxel % 8)); }

  std::vector<std::uint8_t> bits_;
};

}  // namespace cutaway::reading
