#include "app/config.h"

#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <sstream>

#include "app/config_keys.h"
#include "core/error.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

/// Reads one file's keys and knows where in it each stands.
class ConfigFile {
 public:
  explicit ConfigFile(const fs::path& file) : file_(file) {}

  void read(Config& config) const;

 private:
  void read_table(std::string_view table, const toml::node& node, Config& config) const;
  void read_key(const ConfigKey& key, const toml::node& node, Config& config) const;
  void set(const IntegerKey& kind, const toml::node& node, Config& config) const;
  void set(const NumberKey& kind, const toml::node& node, Config& config) const;
  void set(const BooleanKey& kind, const toml::node& node, Config& config) const;
  void set(const TextKey& kind, const toml::node& node, Config& config) const;
  void set(const PathKey& kind, const toml::node& node, Config& config) const;
  void set(const TextListKey& kind, const toml::node& node, Config& config) const;
  void set(const PathListKey& kind, const toml::node& node, Config& config) const;

  template <typename T>
  T value(const toml::node& node, const char* expected) const;
  std::vector<std::string> texts(const toml::node& node) const;
  fs::path from_here(const std::string& path) const;
  std::string where(const toml::source_region& source) const;
  [[noreturn]] void refuse(const toml::node& node, Error::Detail detail) const;

  fs::path file_;
};

std::string text_of(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& content) { text << content; });
  return text.str();
}

std::string names_in(std::string_view table) {
  std::string names;
  for (const ConfigKey& key : config_keys()) {
    if (key.table != table) continue;
    names += (names.empty() ? "" : ", ") + std::string(key.name);
  }
  return names;
}

std::string table_names() {
  std::string names;
  std::string_view last;
  for (const ConfigKey& key : config_keys()) {
    if (key.table == last) continue;
    last = key.table;
    names += (names.empty() ? "[" : ", [") + std::string(last) + "]";
  }
  return names;
}

void ConfigFile::read(Config& config) const {
  std::ifstream stream(file_);
  if (!stream) {
    throw Error({.code = ErrorCode::internal,
                 .message = "the configuration cannot be read",
                 .field = file_.string(),
                 .expected = "a TOML file"});
  }
  try {
    const toml::table document = toml::parse(stream, file_.string());
    for (const auto& [name, node] : document) read_table(name.str(), node, config);
  } catch (const toml::parse_error& error) {
    throw Error({.code = ErrorCode::wrong_type,
                 .message = "the configuration is not TOML: " + std::string(error.description()),
                 .field = where(error.source())});
  }
}

void ConfigFile::read_table(std::string_view table, const toml::node& node, Config& config) const {
  const std::string known = names_in(table);
  if (known.empty() || !node.is_table()) {
    refuse(node, {.code = ErrorCode::unknown_field,
                  .message = "unknown table or key '" + std::string(table) + "'",
                  .expected = "tables " + table_names()});
  }
  for (const auto& [name, value] : *node.as_table()) {
    const std::string_view wanted = name.str();
    const auto key = std::ranges::find_if(config_keys(), [&](const ConfigKey& each) {
      return each.table == table && each.name == wanted;
    });
    if (key == config_keys().end()) {
      refuse(value, {.code = ErrorCode::unknown_field,
                     .message = "unknown key '" + std::string(wanted) + "' in [" +
                                std::string(table) + "]",
                     .expected = known});
    }
    read_key(*key, value, config);
  }
}

void ConfigFile::read_key(const ConfigKey& key, const toml::node& node, Config& config) const {
  try {
    std::visit([&](const auto& kind) { set(kind, node, config); }, key.kind);
  } catch (const Error& error) {
    Error::Detail detail = error.detail();
    if (detail.field.empty()) detail.field = where(node.source());
    detail.message = std::string(key.table) + "." + std::string(key.name) + ": " + detail.message;
    throw Error(detail);
  }
}

template <typename T>
T ConfigFile::value(const toml::node& node, const char* expected) const {
  const std::optional<T> found = node.value_exact<T>();
  if (found) return *found;
  refuse(node, {.code = ErrorCode::wrong_type,
                .message = "a value of another type is needed",
                .expected = expected,
                .received = text_of(node)});
}

void ConfigFile::set(const IntegerKey& kind, const toml::node& node, Config& config) const {
  const auto number = value<std::int64_t>(node, "an integer");
  if (number < kind.minimum || number > kind.maximum) {
    refuse(node, {.code = ErrorCode::out_of_range,
                  .message = "the value is out of its range",
                  .expected = std::to_string(kind.minimum) + " to " + std::to_string(kind.maximum),
                  .received = std::to_string(number)});
  }
  kind.set(config, number);
}

void ConfigFile::set(const NumberKey& kind, const toml::node& node, Config& config) const {
  const double number = node.is_integer()
                            ? static_cast<double>(value<std::int64_t>(node, "a number"))
                            : value<double>(node, "a number");
  if (!(number >= kind.minimum && number <= kind.maximum)) {
    std::ostringstream range;
    range << kind.minimum << " to " << kind.maximum;
    refuse(node, {.code = ErrorCode::out_of_range,
                  .message = "the value is out of its range",
                  .expected = range.str(),
                  .received = text_of(node)});
  }
  kind.set(config, number);
}

void ConfigFile::set(const BooleanKey& kind, const toml::node& node, Config& config) const {
  kind.set(config, value<bool>(node, "true or false"));
}

void ConfigFile::set(const TextKey& kind, const toml::node& node, Config& config) const {
  kind.set(config, value<std::string>(node, "a text"));
}

void ConfigFile::set(const PathKey& kind, const toml::node& node, Config& config) const {
  kind.set(config, from_here(value<std::string>(node, "a path")));
}

void ConfigFile::set(const TextListKey& kind, const toml::node& node, Config& config) const {
  kind.set(config, texts(node));
}

void ConfigFile::set(const PathListKey& kind, const toml::node& node, Config& config) const {
  std::vector<fs::path> paths;
  for (const std::string& text : texts(node)) paths.push_back(from_here(text));
  kind.set(config, paths);
}

std::vector<std::string> ConfigFile::texts(const toml::node& node) const {
  const toml::array* list = node.as_array();
  if (list == nullptr) {
    refuse(node, {.code = ErrorCode::wrong_type,
                  .message = "a value of another type is needed",
                  .expected = "a list of texts",
                  .received = text_of(node)});
  }
  std::vector<std::string> found;
  for (const toml::node& each : *list) found.push_back(value<std::string>(each, "a text"));
  return found;
}

fs::path ConfigFile::from_here(const std::string& path) const {
  return path.empty() ? fs::path() : fs::absolute(file_).parent_path() / path;
}

std::string ConfigFile::where(const toml::source_region& source) const {
  return file_.string() + ":" + std::to_string(source.begin.line);
}

void ConfigFile::refuse(const toml::node& node, Error::Detail detail) const {
  detail.field = where(node.source());
  throw Error(std::move(detail));
}

Error bad_listen(const std::string& text) {
  return Error({.code = ErrorCode::out_of_range,
                .message = "this is no address to listen on",
                .expected = "ADDRESS:PORT, as 127.0.0.1:8080 or [::1]:8080",
                .received = text});
}

}  // namespace

void parse_listen(const std::string& text, NetSettings& settings) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos || colon == 0) throw bad_listen(text);
  std::string address = text.substr(0, colon);
  if (address.starts_with('[') && address.ends_with(']')) {
    address = address.substr(1, address.size() - 2);
  }
  std::uint16_t port = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data() + colon + 1, end, port);
  if (parsed.ec != std::errc{} || parsed.ptr != end) throw bad_listen(text);
  settings.address = address;
  settings.port = port;
}

void read_config_file(const fs::path& file, Config& config) { ConfigFile(file).read(config); }

}  // namespace cutaway
