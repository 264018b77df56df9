#include "volume/phantom/abdomen_parts.h"
#include "volume/phantom/noise.h"

namespace cutaway::phantom {

namespace {

/// -1..1, the same for the same place in the list.
float jitter(int index, std::uint32_t seed) {
  return float(lattice_hash({index, 0, 0}, seed) >> 8) * (2.0f / 16777216.0f) - 1.0f;
}

/// A tube whose radius swells and narrows: the pouches of the colon.
ShapePtr pouched(const std::vector<Knot>& course) {
  constexpr int kPouches = 3;
  std::vector<Knot> knots;
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    for (int p = 0; p < 2 * kPouches; ++p) {
      const float t = float(p) / (2 * kPouches);
      const float swell = p % 2 == 0 ? 0.84f : 1.1f;
      const Knot& a = course[i];
      const Knot& b = course[i + 1];
      knots.push_back({a.position_mm + t * (b.position_mm - a.position_mm),
                       swell * (a.radius_mm + t * (b.radius_mm - a.radius_mm))});
    }
  }
  knots.push_back(course.back());
  return tube(knots);
}

}  // namespace

ShapePtr stomach() {
  const ShapePtr fundus = tube({{{36, 6, 162}, 12},
                                {{54, 4, 138}, 30},
                                {{62, -16, 112}, 28},
                                {{56, -44, 86}, 24},
                                {{24, -58, 72}, 19},
                                {{-8, -50, 72}, 14},
                                {{-26, -30, 70}, 11}});
  const ShapePtr duodenum = tube({{{-26, -30, 70}, 12},
                                  {{-46, -14, 62}, 12},
                                  {{-46, -8, 26}, 12},
                                  {{-26, -4, 8}, 11},
                                  {{8, -14, 14}, 10}});
  return meet(4, {join(4, {fundus, duodenum}), grow(-5, abdomen_cavity())});
}

ShapePtr colon() {
  const ShapePtr right = pouched(
      {{{-86, -8, -72}, 24}, {{-98, 8, -30}, 23}, {{-100, 10, 20}, 21}, {{-84, -16, 46}, 20}});
  const ShapePtr across = pouched({{{-84, -16, 46}, 20},
                                   {{-54, -46, 30}, 19},
                                   {{0, -54, 14}, 18},
                                   {{54, -46, 34}, 18},
                                   {{92, -8, 66}, 18}});
  const ShapePtr left = pouched({{{92, -8, 66}, 18},
                                 {{102, 22, 30}, 16},
                                 {{100, 22, -30}, 16},
                                 {{80, 4, -78}, 16},
                                 {{44, -6, -98}, 16},
                                 {{14, 20, -92}, 16},
                                 {{4, 40, -116}, 17},
                                 {{0, 44, -150}, 18}});
  return meet(3, {join(4, {right, across, left}), grow(-3, abdomen_cavity())});
}

/// Loops that run to and fro in rows, each row a little lower, before and behind in turn.
ShapePtr small_bowel() {
  constexpr int kRows = 7;
  constexpr int kKnotsPerRow = 5;
  std::vector<Knot> knots;
  for (int row = 0; row < kRows; ++row) {
    for (int i = 0; i < kKnotsPerRow; ++i) {
      const int at = row * kKnotsPerRow + i;
      const float along = float(i) / (kKnotsPerRow - 1) * 2.0f - 1.0f;
      const float x = (row % 2 == 0 ? along : -along) * 60.0f + 8.0f * jitter(at, 1);
      const float y = (row % 2 == 0 ? -46.0f : -16.0f) + 10.0f * jitter(at, 2);
      const float z = -4.0f - 15.0f * float(row) + 13.0f * jitter(at, 3);
      knots.push_back({{x, y, z}, 12.5f + 1.5f * jitter(at, 4)});
    }
  }
  return meet(3, {tube(knots), grow(-5, abdomen_cavity())});
}

}  // namespace cutaway::phantom
