#include "fuzz/json_mutator.h"

#include <string>
#include <string_view>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer's name
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed);
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace cutaway::fuzz {

namespace {

/// Every place of the document, itself first.
void collect(Json& place, std::vector<Json*>& places) {
  places.push_back(&place);
  if (!place.is_structured()) return;
  for (Json& child : place) collect(child, places);
}

/// Numbers at which programs go wrong, and values of other types than was expected.
Json edge_value(Generator& generator) {
  static const Json values = Json::parse(R"([0, -1, 1, 2, 3, 4, 255, 256, 2048, 2049, 8192, 8193,
    65535, 65536, 2147483647, 2147483648, 4294967295, 4294967296, 9007199254740993,
    9223372036854775807, 18446744073709551615, -2147483649, -9223372036854775808, 0.5, -0.0, 1e-9,
    1e-320, 1e9, 1e38, 1e39, 1e300, -1e300, 360, 100000.5, null, true, false, "", "x", "scene",
    "phantom:head", "../..", "\u0000", "\ud83d\ude00", [], {}, [0, 0, 0], [1, 0, 0, 0], [[[[]]]]])");
  return values.at(below(generator, values.size()));
}

Json nearby(const Json& number, Generator& generator) {
  static constexpr double kFactors[] = {-1.0, 0.0, 0.5, 2.0, 10.0, 1000.0, 1e-6};
  const auto value = number.get<double>();
  if (number.is_number_integer() && below(generator, 2) == 0) {
    return number.get<std::int64_t>() / 2 + static_cast<std::int64_t>(below(generator, 4096));
  }
  return value * kFactors[below(generator, std::size(kFactors))];
}

void change_members(Json& place, Json other, Generator& generator) {
  if (place.empty() || below(generator, 3) == 0) {
    if (place.is_object()) place[below(generator, 2) == 0 ? "name" : "x"] = std::move(other);
    if (place.is_array()) place.push_back(std::move(other));
  } else {
    auto child = place.begin();
    std::advance(child, static_cast<std::ptrdiff_t>(below(generator, place.size())));
    place.erase(child);
  }
}

}  // namespace

void change_anywhere(Json& document, Generator& generator) {
  std::vector<Json*> places;
  collect(document, places);
  Json& place = *places[below(generator, places.size())];
  const Json other = *places[below(generator, places.size())];
  if (place.is_structured() && below(generator, 4) != 0) {
    change_members(place, other, generator);
  } else if (place.is_number() && below(generator, 2) == 0) {
    place = nearby(place, generator);
  } else {
    place = below(generator, 4) == 0 ? other : edge_value(generator);
  }
}

namespace {

/// Text that is not JSON comes back as it is.
std::string mutated(std::string_view text, unsigned seed) {
  Json document = Json::parse(text, nullptr, false);
  if (document.is_discarded()) return std::string(text);
  Generator generator(seed + 1);
  change(document, generator);
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

}  // namespace cutaway::fuzz

/// Mostly changes of the document; now and then of bytes, for the parser's own sake.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                    unsigned seed) {
  if (seed % 16 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string text =
      cutaway::fuzz::mutated({reinterpret_cast<const char*>(data), size}, seed / 16);
  if (text.size() > most || std::equal(text.begin(), text.end(), data, data + size)) {
    return LLVMFuzzerMutate(data, size, most);
  }
  std::copy(text.begin(), text.end(), data);
  return text.size();
}
