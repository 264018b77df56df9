#include "app/render_command.h"

#include <future>
#include <iostream>

#include "app/output_file.h"
#include "app/picture_size.h"
#include "app/scene_file.h"
#include "app/terminal_progress.h"
#include "app/volume_argument.h"
#include "core/log.h"
#include "encode/png.h"
#include "render/loaded_facts.h"
#include "render/render_thread.h"
#include "render/scene_preparation.h"
#include "scene/first_look.h"
#include "scene/resolve.h"
#include "scene/unseen.h"
#include "volume/phantoms.h"

namespace cutaway {

namespace {

constexpr double kStillStepVoxels = 0.5;

std::string volume_of(const RenderCommand& command, const Json& document) {
  return command.volume ? *command.volume : document.value("volume", phantom_id({}));
}

using SharedVolume = std::shared_ptr<const LoadedVolume>;

/// The volume as the scene wants it prepared; `made` went through `preparation` already.
SharedVolume seen_volume(const SharedVolume& measured, const Scene& scene,
                         const VolumePreparation& preparation, const SharedVolume& made) {
  const VolumePreparation wanted = preparation_of(scene, *measured);
  if (wanted == preparation) return made;
  return wanted.is_nothing() ? measured : prepare(*measured, wanted, {});
}

Picture render_once(const RenderCommand& command, RenderRequest request) {
  RenderThread renderer({.require_gpu = command.require_gpu}, RenderLimits{});
  log().debug("OpenGL renderer: {}{}", renderer.info().renderer,
              renderer.info().is_software ? " (software)" : "");
  std::promise<RenderOutcome> promise;
  auto outcome = promise.get_future();
  renderer.submit(
      {std::move(request), [&](RenderOutcome result) { promise.set_value(std::move(result)); }});
  RenderOutcome result = outcome.get();
  if (const auto* error = std::get_if<Error>(&result)) throw *error;
  return std::move(std::get<RenderedFrame>(result).picture);
}

}  // namespace

void run_render(const RenderCommand& command) {
  const Json document = read_scene_file(command.scene_path);
  const Viewport size = command.size.value_or(document_viewport(document));
  check_picture_size(size);
  check_writable(command.output_path);
  const auto volume = load_volume_argument(volume_of(command, document), terminal_progress());
  const VolumePreparation first = preparation_of_first_look(*volume);
  const auto first_seen = first.is_nothing() ? volume : prepare(*volume, first, {});
  const VolumeFacts facts = facts_of(*volume, first_seen);
  const Scene scene = resolve_scene(with_first_look(document, facts), facts, size);
  for (const UnseenReason& reason : reasons_for_nothing(scene, facts))
    std::cerr << "cutaway render: " << in_words(reason) << '\n';
  const Picture picture =
      render_once(command, {.owner = "cutaway render",
                            .volume = seen_volume(volume, scene, first, first_seen),
                            .scene = std::make_shared<const Scene>(scene),
                            .settings = {.picture_size_px = {size.width_px, size.height_px},
                                         .supersampling = command.supersampling,
                                         .step_voxels = kStillStepVoxels,
                                         .layout = PixelLayout::rgba},
                            .is_followed = false});
  write_file(command.output_path, encode_png(picture).bytes);
}

}  // namespace cutaway
