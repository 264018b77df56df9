// What is found of volumes whose materials are known.
#include "volume/facts/findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/analytic_volumes.h"
#include "support/made_ct.h"
#include "volume/facts/components.h"
#include "volume/loaded_volume.h"

namespace cutaway {
namespace {

using test::hashed;
using Field = std::function<double(glm::dvec3)>;

/// Edges as wide as a scanner's: `inside` within the radius, `outside` beyond it.
double ball(glm::dvec3 p, double radius_mm, double inside, double outside, double width_mm = 1.2) {
  const double share = 0.5 * std::erfc((glm::length(p) - radius_mm) / (std::sqrt(2.0) * width_mm));
  return outside + share * (inside - outside);
}

double noise(glm::dvec3 p) {
  const auto at = [](double v) { return std::uint64_t(std::int64_t(std::lround(2.0 * v)) + 4096); };
  return std::sqrt(3.0) * hashed((at(p.x) << 40) ^ (at(p.y) << 20) ^ at(p.z));
}

/// Air, fat, muscle, bone.
double body(glm::dvec3 p) {
  const double skin = ball(p, 44.0, -100.0, -1000.0);
  return skin + ball(p, 38.0, 150.0, 0.0) + ball(p, 20.0, 850.0, 0.0) + 15.0 * noise(p);
}

Volume volume_of(const VolumeGeometry& geometry, const Field& field, const char* modality,
                 const char* units) {
  Volume volume = test::sampled_volume(geometry, field);
  volume.description.modality = modality;
  volume.description.units = units;
  return volume;
}

Findings of(const Volume& volume) { return find_out(volume, {}); }

TEST(Findings, OfACtAreSkinAndBone) {
  const Findings found = of(volume_of(test::centred_geometry(104), body, "CT", "HU"));
  EXPECT_EQ(found.kind, DataKind::hounsfield);
  EXPECT_EQ(found.outer.value, -300.0);
  EXPECT_EQ(found.inner.value, 250.0);
  EXPECT_FALSE(found.has_contrast);
}

/// The same anatomy where nothing says what its numbers are.
TEST(Findings, OfUnknownUnitsLieWhereTheBoundariesAre) {
  const Findings found = of(volume_of(test::centred_geometry(104), body, "", "none"));
  EXPECT_EQ(found.kind, DataKind::unknown);
  EXPECT_NEAR(found.outer.value, -550.0, 60.0);
  EXPECT_NEAR(found.inner.value, 475.0, 60.0);
}

TEST(Findings, HeedNeitherPaddingNorHotVoxels) {
  Volume volume = volume_of(
      test::centred_geometry(104),
      [](glm::dvec3 p) {
        const bool is_padding = glm::length(glm::dvec2(p)) > 51.0;
        return is_padding ? -3024.0 : std::round(body(p));
      },
      "", "none");
  auto& voxels = std::get<std::vector<float>>(volume.voxels);
  for (std::size_t i = 0; i < 20; ++i) voxels[50001 + 17 * i] = 30000.0F;
  volume.value_range = {-3024.0, 30000.0};
  const Findings found = of(volume);
  ASSERT_EQ(found.robust.sentinels, (std::vector<double>{-3024.0}));
  EXPECT_NEAR(found.robust.range.minimum, -1050.0, 60.0);
  EXPECT_NEAR(found.robust.range.maximum, 930.0, 60.0);
  EXPECT_NEAR(found.outer.value, -550.0, 60.0);
  EXPECT_NEAR(found.inner.value, 475.0, 60.0);
}

TEST(Findings, TellContrastMediumFromBone) {
  const Field vessels = [](glm::dvec3 p) {
    const double tissue = ball(p, 44.0, 40.0, -1000.0);
    const double vessel = ball({p.x, p.y, 0.0}, 13.0, 380.0, 0.0);
    const double spine = ball(p - glm::dvec3(0.0, 28.0, 0.0), 7.0, 600.0, 0.0, 3.0);
    return tissue + (glm::length(p) < 40.0 ? vessel : 0.0) + spine + 15.0 * noise(p);
  };
  const Findings found = of(volume_of(test::centred_geometry(104), vessels, "CT", "HU"));
  EXPECT_TRUE(found.has_contrast);
  EXPECT_NEAR(found.inner.value, 230.0, 80.0);
}

TEST(Findings, DoNotTakeMarrowInABonesShellForContrastMedium) {
  const Field knee = [](glm::dvec3 p) {
    const double tissue = ball(p, 44.0, 40.0, -1000.0);
    const double shell = ball(p, 24.0, 900.0, 0.0);
    const double marrow = ball(p, 20.0, -560.0, 0.0);
    return tissue + shell + marrow + 15.0 * noise(p);
  };
  const Findings found = of(volume_of(test::centred_geometry(104), knee, "CT", "HU"));
  EXPECT_FALSE(found.has_contrast);
  EXPECT_EQ(found.inner.from, "bone of a CT");
}

TEST(Findings, KnowMasksLabelsMapsAndNoise) {
  const VolumeGeometry geometry = test::centred_geometry(48);
  const auto kind_of = [&](const Field& field) {
    return of(volume_of(geometry, field, "", "none")).kind;
  };
  const Field mask = [](glm::dvec3 p) { return glm::length(p) < 6.0 ? 1.0 : 0.0; };
  EXPECT_EQ(kind_of(mask), DataKind::two_valued);
  EXPECT_NEAR(of(volume_of(geometry, mask, "", "none")).outer.value, 0.5, 1e-9);
  EXPECT_EQ(kind_of([](glm::dvec3 p) {
              return std::floor(std::max(0.0, 20.0 - glm::length(p)) / 5.0) * 7.0;
            }),
            DataKind::labels);
  EXPECT_EQ(kind_of([](glm::dvec3 p) {
              return ball(p - 8.0, 9.0, 3.0, 0.0) - ball(p + 8.0, 9.0, 3.0, 0.0) + 0.1 * noise(p);
            }),
            DataKind::signed_map);
  EXPECT_EQ(kind_of([](glm::dvec3 p) { return 100.0 + 20.0 * noise(p); }), DataKind::noise);
  EXPECT_EQ(kind_of([](glm::dvec3) { return 7.0; }), DataKind::constant);
  EXPECT_EQ(kind_of([](glm::dvec3 p) { return ball(p, 15.0, 0.8, 0.05) + 0.02 * noise(p); }),
            DataKind::unknown);
}

TEST(Findings, OfASignedMapAreAboveNothing) {
  const Field map = [](glm::dvec3 p) {
    return ball(p - 8.0, 9.0, 3.0, 0.0) - ball(p + 8.0, 9.0, 3.0, 0.0);
  };
  const Findings found = of(volume_of(test::centred_geometry(48), map, "", "none"));
  EXPECT_GT(found.outer.value, 0.5);
  EXPECT_GT(found.inner.value, found.outer.value);
}

/// A plate, turned by 30 degrees about x.
TEST(Findings, SeeASlabAlongItsShortAxis) {
  const double angle = glm::radians(30.0);
  const glm::dvec3 normal(0.0, -std::sin(angle), std::cos(angle));
  const Volume volume =
      test::slab_volume(test::centred_geometry(80), {.normal = normal, .half_thickness_mm = 5.0});
  const MaterialShape shape = of(volume).shape;
  EXPECT_TRUE(shape.is_slab());
  EXPECT_GT(std::abs(glm::dot(shape.axes[2], normal)), std::cos(glm::radians(5.0)));
}

/// Most of the volume is noise, whose iso-surfaces are larger than the plate's.
TEST(Findings, SeeAPlateInNoise) {
  const Volume volume = volume_of(
      test::centred_geometry(80),
      [](glm::dvec3 p) {
        const double beside = std::max(std::abs(p.z) - 6.0, glm::length(glm::dvec2(p)) - 30.0);
        return 0.4 * std::erfc(beside / 2.0) + 0.02 * noise(p);
      },
      "", "none");
  const Findings found = of(volume);
  EXPECT_NEAR(found.outer.value, 0.4, 0.12);
  EXPECT_TRUE(found.shape.is_slab());
}

TEST(Findings, TakeTheGridsAxisForASlabOfFewSlices) {
  const VolumeGeometry geometry =
      test::centred_geometry({64, 64, 3}, {1.0, 1.0, 1.0}, test::oblique_direction());
  const MaterialShape shape = of(test::sampled_volume(geometry, [](glm::dvec3 p) {
                                return glm::length(p) < 20.0 ? 40.0 : -1000.0 + noise(p);
                              })).shape;
  EXPECT_TRUE(shape.is_slab());
  EXPECT_NEAR(std::abs(glm::dot(shape.axes[2], geometry.direction_patient[2])), 1.0, 1e-9);
}

TEST(Findings, OfTinyAndFlatVolumesAreThere) {
  for (const glm::ivec3 size : {glm::ivec3(1), glm::ivec3(2, 2, 2), glm::ivec3(40, 1, 1),
                                glm::ivec3(5, 6, 1), glm::ivec3(3, 3, 300)}) {
    const Volume volume =
        volume_of(test::centred_geometry(size, glm::dvec3(1.0)), body, "CT", "HU");
    const Findings found = of(volume);
    EXPECT_TRUE(std::isfinite(found.outer.value) && std::isfinite(found.inner.value));
    EXPECT_TRUE(glm::all(glm::greaterThan(found.shape.extent_mm, glm::dvec3(0.0))));
  }
}

TEST(Findings, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(
      find_out(volume_of(test::centred_geometry(40), body, "CT", "HU"), source.get_token()),
      Cancelled);
}

/// All pairs.
TEST(DistanceTo, IsTheNearestCellsDistance) {
  const CellGrid grid{{9, 7, 6}, {1.0, 0.7, 2.5}};
  CellMask mask(grid.count(), 0);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = hashed(i) > 0.93 ? 1 : 0;
  const std::vector<float> field = distance_to_mm(grid, mask, {});
  const auto place = [&](std::size_t i) {
    const glm::u64vec3 cell(i % 9, i / 9 % 7, i / 63);
    return glm::dvec3(cell) * grid.spacing_mm;
  };
  for (std::size_t i = 0; i < mask.size(); ++i) {
    double nearest = 1e30;
    for (std::size_t k = 0; k < mask.size(); ++k)
      if (mask[k] != 0) nearest = std::min(nearest, glm::distance(place(i), place(k)));
    ASSERT_NEAR(field[i], nearest, 1e-4);
  }
}

TEST(ConnectedComponents, MeetAtCornersOrOnlyAtFaces) {
  // Two cells that meet at a corner, and one apart.
  CellMask mask(27, 0);
  mask[0] = mask[13] = mask[20] = 1;  // (0,0,0), (1,1,1), (2,0,2)
  const auto parts = [&](Connectivity connectivity) {
    return connected_components({3, 3, 3}, connectivity, mask, {}).all.size();
  };
  EXPECT_EQ(parts(Connectivity::faces), 3U);
  EXPECT_EQ(parts(Connectivity::corners), 1U);
}

/// By flooding, on a random set.
TEST(ConnectedComponents, AreThoseOfAFlood) {
  const glm::ivec3 size(14, 11, 9);
  CellMask mask(std::size_t(14) * 11 * 9, 0);
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = hashed(i) > 0.35 ? 1 : 0;
  CellMask left = mask;
  std::vector<std::size_t> sizes;
  for (std::size_t first = 0; first < left.size(); ++first) {
    if (left[first] == 0) continue;
    std::vector<std::size_t> open{first};
    left[first] = 0;
    std::size_t count = 0;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      ++count;
      const glm::ivec3 cell(int(at % 14), int(at / 14 % 11), int(at / 154));
      for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
          glm::ivec3 next = cell;
          next[axis] += side;
          if (next[axis] < 0 || next[axis] >= size[axis]) continue;
          const std::size_t to = (std::size_t(next.z) * 11 + next.y) * 14 + next.x;
          if (left[to] == 0) continue;
          left[to] = 0;
          open.push_back(to);
        }
      }
    }
    sizes.push_back(count);
  }
  std::vector<std::size_t> found;
  for (const Component& part : connected_components(size, Connectivity::faces, mask, {}).all)
    found.push_back(part.voxels);
  std::ranges::sort(sizes);
  std::ranges::sort(found);
  EXPECT_EQ(found, sizes);
}

}  // namespace
}  // namespace cutaway
