// The documents of this folder: what each says, the picture it had when it was recorded, and how
// far from that it may be today.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/json.h"

namespace cutaway::test {

/// How far an old document's picture may be from its old picture. The mean hardly moves where a
/// small part of a picture changes, such as the lines of a filter: the share does.
struct MostDifference {
  double mean = 1.0;            ///< in 1/255, over pixels and channels
  double share_above_2 = 0.01;  ///< of the pixels: those with a channel more than 2/255 off
};

struct GoldenDocument {
  std::string name;
  Json scene;
  std::filesystem::path picture;
  MostDifference allowed;  ///< more than usual only where exceptions.json says why
};

/// All of documents/, by name. Throws std::runtime_error for an exception without a reason or
/// without its document.
std::vector<GoldenDocument> golden_documents();

struct OldOwnStyle {
  std::string name;  ///< of the document that a scene became when this was put on
  Json scene;        ///< as the page exported it
};

/// All of own_styles/*.scene.json, by name.
std::vector<OldOwnStyle> old_own_styles();

}  // namespace cutaway::test
