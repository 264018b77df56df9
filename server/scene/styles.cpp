#include "scene/styles.h"

#include <algorithm>

#include "core/error.h"
#include "scene/embedded.h"
#include "scene/module_aliases.h"
#include "scene/scene_fields.h"
#include "scene/schema.h"

namespace cutaway {

namespace {

/// Every style says all of a look, so that one replaces another: what its file leaves out comes
/// from the schema's defaults.
Json completed(const Json& scene) {
  return only_fields(with_defaults(without_aliases(scene), "scene"), BelongsTo::look);
}

Style style_from(const Json& file) {
  const Json document = with_defaults(file, "style");
  return {document.at("name").get<std::string>(), document.at("title").get<std::string>(),
          document.at("description").get<std::string>(), document.at("group").get<std::string>(),
          completed(file.at("scene"))};
}

std::vector<Style> read_styles() {
  std::vector<Style> all;
  for (const EmbeddedFile& file : embedded_styles()) {
    const Json document = Json::parse(file.text);
    validate(document, "style");
    all.push_back(style_from(document));
  }
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
  throw Error({.code = ErrorCode::unknown_style,
               .message = "no such style",
               .field = "/style",
               .expected = names(),
               .received = name});
}

Json describe_styles() {
  Json all = Json::array();
  for (const Style& style : styles())
    all.push_back({{"name", style.name},
                   {"title", style.title},
                   {"description", style.description},
                   {"group", style.group},
                   {"scene", style.scene}});
  return all;
}

}  // namespace cutaway
