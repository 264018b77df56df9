#include "app/render_command.h"

#include <cstdio>
#include <fstream>
#include <future>

#include "app/terminal_progress.h"
#include "app/volume_argument.h"
#include "core/log.h"
#include "encode/png.h"
#include "render/loaded_facts.h"
#include "render/render_thread.h"
#include "scene/resolve.h"
#include "volume/phantoms.h"

namespace cutaway {

namespace {

constexpr int kLargestSidePx = 8192;
constexpr double kStillStepVoxels = 0.5;

Json read_document(const std::string& path) {
  std::ifstream file(path);
  if (!file)
    throw Error({.code = "invalid-scene", .message = "the scene cannot be read", .field = path});
  try {
    Json document = Json::parse(file);
    // A style carries its scene with a name and a description around it.
    return document.is_object() && document.contains("scene") ? document.at("scene") : document;
  } catch (const Json::exception& error) {
    throw Error({.code = "malformed-json", .message = error.what(), .field = path});
  }
}

void check_size(Viewport size) {
  if (std::min(size.width_px, size.height_px) >= 1 &&
      std::max(size.width_px, size.height_px) <= kLargestSidePx)
    return;
  throw Error({.code = "out-of-range",
               .message = "no picture of this size",
               .field = "--size",
               .expected = "1x1 to " + std::to_string(kLargestSidePx) + "x" +
                           std::to_string(kLargestSidePx) + " px",
               .received = std::to_string(size.width_px) + "x" + std::to_string(size.height_px)});
}

std::string volume_of(const RenderCommand& command, const Json& document) {
  return command.volume ? *command.volume : document.value("volume", phantom_id({}));
}

Pixels render_once(const RenderCommand& command, RenderRequest request) {
  RenderThread renderer({.require_gpu = command.require_gpu});
  log().info("OpenGL renderer: {}{}", renderer.info().renderer,
             renderer.info().is_software ? " (software)" : "");
  std::promise<RenderOutcome> promise;
  auto outcome = promise.get_future();
  renderer.submit(
      {std::move(request), [&](RenderOutcome result) { promise.set_value(std::move(result)); }});
  RenderOutcome result = outcome.get();
  if (const auto* error = std::get_if<Error>(&result)) throw *error;
  return std::move(std::get<RenderedFrame>(result).pixels);
}

void write_file(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
    throw Error({.code = "internal", .message = "the picture cannot be written", .field = path});
}

}  // namespace

void run_render(const RenderCommand& command) {
  Json document = read_document(command.scene_path);
  validate_scene_document(document);
  const Viewport size = command.size.value_or(document_viewport(document));
  check_size(size);
  const auto volume = load_volume_argument(volume_of(command, document), terminal_progress());
  const Scene scene = resolve_scene(document, facts_of(volume), size);
  const Pixels pixels =
      render_once(command, {.volume = volume,
                            .scene = std::make_shared<const Scene>(scene),
                            .settings = {.picture_size_px = {size.width_px, size.height_px},
                                         .supersampling = command.supersampling,
                                         .step_voxels = kStillStepVoxels,
                                         .layout = PixelLayout::rgba}});
  write_file(command.output_path, encode_png(pixels.planes.at(0), size.width_px, size.height_px));
}

}  // namespace cutaway
