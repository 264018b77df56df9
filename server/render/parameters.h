// Reading module parameters, which the schema has checked and completed.
#pragma once

#include <glm/glm.hpp>

#include "scene/json.h"

namespace cutaway {

inline float number(const Json& parameters, const char* name) {
  return parameters.at(name).get<float>();
}

inline glm::vec3 colour(const Json& parameters, const char* name) {
  const Json& channels = parameters.at(name);
  return {channels.at(0).get<float>(), channels.at(1).get<float>(), channels.at(2).get<float>()};
}

inline bool is_choice(const Json& parameters, const char* name, const char* value) {
  return parameters.at(name).get_ref<const std::string&>() == value;
}

}  // namespace cutaway
