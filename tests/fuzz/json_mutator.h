// Changes of JSON that keep it JSON: a byte changed here or there is refused before anything of
// ours is reached.
#pragma once

#include <string>
#include <string_view>

namespace cutaway::fuzz {

/// `text` with one change by `seed`: a value put in the place of another, a member taken away,
/// doubled or renamed. Text that is not JSON comes back as it is.
std::string mutated_json(std::string_view text, unsigned seed);

}  // namespace cutaway::fuzz
