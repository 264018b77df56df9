// Changes of JSON that keep it JSON: a byte changed here or there is refused before anything of
// ours is reached.
#pragma once

#include <nlohmann/json.hpp>
#include <random>

namespace cutaway::fuzz {

using Json = nlohmann::json;
using Generator = std::minstd_rand;

/// 0 to `limit` - 1.
inline std::size_t below(Generator& generator, std::size_t limit) { return generator() % limit; }

/// One change of `document`. Each target defines it: from change_anywhere, or from what more it
/// knows of its documents.
void change(Json& document, Generator& generator);

/// For documents of any kind: a value put in the place of another, a member taken away, doubled or
/// put elsewhere.
void change_anywhere(Json& document, Generator& generator);

}  // namespace cutaway::fuzz
