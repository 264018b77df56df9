#include "scene/relative_lengths.h"

#include <optional>
#include <string_view>

#include "core/error.h"
#include "scene/json_text.h"

namespace cutaway {

namespace {

constexpr std::string_view kSuffix = "_per_mille";

/// `X` of `X_per_mille`.
std::optional<std::string> pixels_name(const std::string& name) {
  if (!name.ends_with(kSuffix)) return std::nullopt;
  return name.substr(0, name.size() - kSuffix.size());
}

std::string other_name(const std::string& name) {
  return pixels_name(name).value_or(per_mille_name(name));
}

bool says(const Json& object, const std::string& key) {
  const auto found = object.find(key);
  return found != object.end() && !found->is_null();
}

void refuse_in(const Json& value, const std::string& pointer) {
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) refuse_in(value[i], pointer_to(pointer, i));
  }
  if (!value.is_object()) return;
  for (const auto& [key, field] : value.items()) {
    const auto pixels = pixels_name(key);
    if (pixels && says(value, key) && says(value, *pixels))
      throw Error({.code = ErrorCode::invalid_scene,
                   .message = key + " is " + *pixels + " in another unit, and both are there",
                   .field = pointer_to(pointer, key),
                   .expected = "one of the two",
                   .received = json_text(field)});
    refuse_in(field, pointer_to(pointer, key));
  }
}

}  // namespace

std::string per_mille_name(const std::string& name) { return name + std::string(kSuffix); }

bool is_per_mille(const std::string& name) { return pixels_name(name).has_value(); }

void refuse_both_lengths(const Json& document) { refuse_in(document, ""); }

void forget_other_lengths(Json& module, const Json& patch) {
  for (const auto& [key, value] : patch.items())
    if (!value.is_null() && !says(patch, other_name(key))) module.erase(other_name(key));
}

Module in_pixels(Module module, int viewport_height_px) {
  const Json said = module.parameters;
  for (const auto& [key, value] : said.items()) {
    const auto pixels = pixels_name(key);
    if (!pixels) continue;
    module.parameters[*pixels] = value.get<double>() / 1000.0 * viewport_height_px;
    module.parameters.erase(key);
  }
  return module;
}

}  // namespace cutaway
