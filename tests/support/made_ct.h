// CTs of which it is known, voxel by voxel, what is body and what holds it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "volume/volume.h"

namespace cutaway::test {

/// What a place holds, patient space, mm.
struct MadePlace {
  double hu = -1000.0;
  bool is_body = false;
  bool is_couch = false;
};

struct MadeCt {
  Volume volume;
  std::vector<std::uint8_t> body;  ///< by voxel, i fastest
  std::vector<std::uint8_t> couch;
};

/// 16-bit, with noise of `noise_hu` standard deviation that a hash makes of a voxel's place.
MadeCt made_ct(const VolumeGeometry& geometry, double noise_hu,
               const std::function<MadePlace(glm::dvec3)>& place);

/// A torso about z: fat, muscle, lungs of air, a spine and ribs' worth of bone. Its back is at
/// y = 75 mm; it is 220 mm wide.
MadePlace made_torso(glm::dvec3 p);

/// In turn: the first that holds something.
std::function<MadePlace(glm::dvec3)> any_of(
    std::vector<std::function<MadePlace(glm::dvec3)>> places);

/// A plate under a back at y = 75 mm, along all of z.
std::function<MadePlace(glm::dvec3)> made_couch(double gap_mm, double thickness_mm,
                                                double hu = -100.0);

/// A number from -1 to 1, evenly spread, that only depends on the place.
double hashed(std::uint64_t place);

}  // namespace cutaway::test
