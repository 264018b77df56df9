// What is found of a volume once, at load, and shared by all who look at it.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "volume/facts/body_mask.h"
#include "volume/facts/data_kind.h"
#include "volume/facts/material_shape.h"

namespace cutaway {

/// A number with where it comes from, for people.
struct ChosenValue {
  double value = 0.0;
  std::string from;
};

/// Immutable.
struct Findings {
  DataKind kind = DataKind::unknown;
  RobustRange robust;
  ChosenValue outer;  ///< iso-values: of the context
  ChosenValue inner;  ///< and of the focus; the outer one again where no inner boundary means any
  bool has_contrast = false;             ///< CT: contrast medium in vessels
  std::shared_ptr<const BodyMask> body;  ///< of a CT with air around it; else null
  MaterialShape shape;

  /// Whether there is a couch, headrest or the like to be hidden.
  bool has_couch() const;
};

Findings find_out(const Volume& volume, const std::stop_token& stop);

/// What they take in memory.
std::uint64_t byte_size(const Findings& findings);

}  // namespace cutaway
