// What a volume's values are: anatomy on a scale, a map of both signs, names of structures.
#pragma once

#include "volume/facts/value_tally.h"

namespace cutaway {

enum class DataKind {
  hounsfield,  ///< CT in HU
  mr,
  emission,    ///< PET, SPECT
  unknown,     ///< any other scale
  signed_map,  ///< nothing at 0, findings above and below
  two_valued,  ///< a mask
  labels,      ///< integers that are names
  noise,       ///< neighbours have nothing in common
  constant,
};

/// For people: "CT in Hounsfield units".
const char* name_of(DataKind kind);

/// Neighbouring voxels as far as they tell the kind, from 2^17 places, the same ones each time.
struct NeighbourFacts {
  double equal_share = 0.0;  ///< equal pairs among those without the most frequent value
  /// Mean squared difference of a pair over twice the variance: 1 where they are independent.
  double independence = 0.0;
};
NeighbourFacts neighbour_facts(const Volume& volume, const ValueTally& tally,
                               const ValueRange& robust);

/// Neighbours are asked before the header: a mask that was saved as CT is a mask, and so are
/// labels, but for numbers below 0.
DataKind data_kind(const VolumeDescription& description, const ValueTally& tally,
                   const RobustRange& robust, const NeighbourFacts& neighbours);

}  // namespace cutaway
