#include "app/scene_file.h"

#include <fstream>
#include <string>

#include "core/error.h"
#include "scene/json_text.h"
#include "scene/resolve.h"
#include "scene/schema.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 20;

Error unreadable() {
  return Error({.code = ErrorCode::invalid_scene,
                .message = "the scene cannot be read",
                .expected = "a file with a scene or style document (JSON)"});
}

// No more than the limit is ever read: the size that a file claims may be no truth.
std::string read_text(const fs::path& file) {
  std::error_code failed;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || fs::is_directory(file, failed)) throw unreadable();
  std::string text(kMostBytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad()) throw unreadable();
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > kMostBytes) {
    throw Error({.code = ErrorCode::too_large,
                 .message = "the scene's file is too large",
                 .expected = "at most " + std::to_string(kMostBytes) + " bytes"});
  }
  return text;
}

}  // namespace

Json read_scene_file(const fs::path& file) {
  try {
    Json scene = parse_json(read_text(file));
    // A style carries its scene with a name and a description around it.
    if (scene.is_object() && scene.contains("scene")) {
      validate(scene, "style");
      return scene["scene"];
    }
    validate_scene_document(scene);
    return scene;
  } catch (const Error& error) {
    Error::Detail detail = error.detail();
    detail.field = file.string() + (detail.field.empty() ? "" : "#" + detail.field);
    throw Error(detail);
  }
}

}  // namespace cutaway
