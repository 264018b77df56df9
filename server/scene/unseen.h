// Why a picture shows less than its user expects: values and places that leave nothing to see.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "scene/server_message.h"
#include "scene/volume_facts.h"

namespace cutaway {

/// One a cause; none where something of each branch that is drawn can be seen, as far as some 400
/// rays tell. Of a slice: none. Thread-safe.
std::vector<UnseenReason> reasons_for_nothing(const Scene& scene, const VolumeFacts& volume);

/// A sentence.
std::string in_words(const UnseenReason& reason);

}  // namespace cutaway
