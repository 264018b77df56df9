// The keys of the configuration file: name, kind, range and place of each, once.
#pragma once

#include <functional>
#include <string_view>
#include <variant>
#include <vector>

#include "app/config.h"

namespace cutaway {

struct IntegerKey {
  std::int64_t minimum;
  std::int64_t maximum;
  std::function<void(Config&, std::int64_t)> set;
};
struct NumberKey {
  double minimum;
  double maximum;
  std::function<void(Config&, double)> set;
};
struct BooleanKey {
  std::function<void(Config&, bool)> set;
};
/// May throw Error; the reader adds where.
struct TextKey {
  std::function<void(Config&, const std::string&)> set;
};
struct PathKey {
  std::function<void(Config&, const std::filesystem::path&)> set;
};
struct TextListKey {
  std::function<void(Config&, const std::vector<std::string>&)> set;
};
struct PathListKey {
  std::function<void(Config&, const std::vector<std::filesystem::path>&)> set;
};

struct ConfigKey {
  std::string_view table;
  std::string_view name;
  std::variant<IntegerKey, NumberKey, BooleanKey, TextKey, PathKey, TextListKey, PathListKey> kind;
};

const std::vector<ConfigKey>& config_keys();

}  // namespace cutaway
