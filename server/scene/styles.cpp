#include "scene/styles.h"

#include <algorithm>

#include "core/error.h"
#include "scene/embedded.h"
#include "scene/schema.h"

namespace cutaway {

namespace {

constexpr const char* kFirst = "flagship";

/// Fills the modules' parameters only: what else a style leaves open stays as it is in the viewer's
/// scene.
Json completed(const Json& scene) {
  const Json filled = with_defaults(scene, "scene");
  Json result = scene;
  for (const char* branch : {"focus", "context"})
    for (const char* part : {"shading", "filters"})
      if (result.contains(branch) && result.at(branch).contains(part))
        result[branch][part] = filled.at(branch).at(part);
  return result;
}

Style style_from(const Json& document) {
  return {document.at("name").get<std::string>(), document.at("title").get<std::string>(),
          document.at("description").get<std::string>(), completed(document.at("scene"))};
}

std::vector<Style> read_styles() {
  std::vector<Style> all;
  for (const EmbeddedFile& file : embedded_styles()) {
    const Json document = Json::parse(file.text);
    validate(document, "style");
    all.push_back(style_from(document));
  }
  std::sort(all.begin(), all.end(), [](const Style& a, const Style& b) {
    return std::pair(a.name != kFirst, a.title) < std::pair(b.name != kFirst, b.title);
  });
  return all;
}

std::string names() {
  std::string text;
  for (const Style& style : styles()) text += (text.empty() ? "one of " : ", ") + style.name;
  return text;
}

}  // namespace

const std::vector<Style>& styles() {
  static const std::vector<Style> all = read_styles();
  return all;
}

const Style& style(const std::string& name) {
  const auto found = std::find_if(styles().begin(), styles().end(),
                                  [&](const Style& style) { return style.name == name; });
  if (found != styles().end()) return *found;
  throw Error(
      {.code = "unknown-style", .message = "no such style", .expected = names(), .received = name});
}

Json describe_styles() {
  Json all = Json::array();
  for (const Style& style : styles())
    all.push_back({{"name", style.name},
                   {"title", style.title},
                   {"description", style.description},
                   {"scene", style.scene}});
  return all;
}

}  // namespace cutaway
