// Values at which materials meet.
#pragma once

#include <optional>

#include "volume/facts/edge_statistics.h"

namespace cutaway {

/// The outermost boundary: the lowest peak of the strength among those with at least a tenth of the
/// largest area and a third of the largest such strength; else the lowest peak of the mean
/// gradient. It lies in the middle of the two materials.
std::optional<double> outer_boundary(const EdgeStatistics& edges);

/// Within a body whose outer boundary is at `outer`: the greatest peak of area times strength at
/// least 0.15 of the range above it, with at least a fiftieth of the largest area; else that of
/// strength alone. `inside`: of what lies well within the body.
std::optional<double> inner_boundary(const EdgeStatistics& inside, double outer);

/// HU. The boundary of vessels where contrast medium fills them: where a calm material of 200 to
/// 550 HU is more common than what is less dense. Nothing where there is none.
std::optional<double> contrast_boundary(const EdgeStatistics& inside);

}  // namespace cutaway
