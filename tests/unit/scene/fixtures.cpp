#include "unit/scene/fixtures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "scene/client_message.h"
#include "scene/json_text.h"
#include "scene/resolve.h"
#include "scene/schema.h"
#include "unit/scene/sphere_facts.h"

namespace cutaway {

namespace {

namespace fs = std::filesystem;

// The load script's belong to tests/load: the server does not know that schema.
std::vector<fs::path> files(const std::string& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry :
       fs::directory_iterator(fs::path(CUTAWAY_SOURCE_DIR) / "protocol/fixtures" / folder)) {
    if (!entry.path().stem().string().starts_with("load-script")) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string content(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string schema_of(const std::string& name) {
  for (const char* schema : {"client-message", "server-message", "scene", "style", "volumes"})
    if (name.starts_with(schema)) return schema;
  throw std::invalid_argument("the fixture's name begins with no schema's: " + name);
}

}  // namespace

std::vector<Fixture> valid_fixtures() {
  std::vector<Fixture> fixtures;
  for (const fs::path& path : files("valid"))
    fixtures.push_back({path.stem(), schema_of(path.stem()), content(path), {}});
  return fixtures;
}

std::vector<Fixture> invalid_fixtures() {
  std::vector<Fixture> fixtures;
  for (const fs::path& path : files("invalid")) {
    const Json wrapper = Json::parse(content(path));
    const std::string text = wrapper.contains("text") ? wrapper.at("text").get<std::string>()
                                                      : wrapper.at("document").dump();
    fixtures.push_back({path.stem(), wrapper.at("schema"), text, wrapper.at("error")});
  }
  return fixtures;
}

std::map<std::string, Json> json_fixtures(const std::string& folder) {
  std::map<std::string, Json> fixtures;
  for (const fs::path& path : files(folder))
    if (path.extension() == ".json") fixtures.emplace(path.stem(), Json::parse(content(path)));
  return fixtures;
}

std::map<std::string, std::vector<std::uint8_t>> binary_fixtures(const std::string& folder) {
  std::map<std::string, std::vector<std::uint8_t>> fixtures;
  for (const fs::path& path : files(folder)) {
    if (path.extension() != ".bin") continue;
    const std::string bytes = content(path);
    fixtures.emplace(path.stem(), std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  }
  return fixtures;
}

void accept(const std::string& schema, const std::string& text) {
  if (schema == "client-message") {
    parse_client_message(text);
  } else if (schema == "scene") {
    resolve_scene(parse_json(text), ball_facts(), {640, 480});
  } else {
    validate(parse_json(text), schema);
  }
}

}  // namespace cutaway
