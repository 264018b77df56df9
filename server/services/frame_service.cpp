#include "services/frame_service.h"

#include <chrono>
#include <cmath>

#include "core/log.h"
#include "encode/jpeg.h"
#include "encode/png.h"
#include "services/picture_tiles.h"

namespace cutaway {

namespace {

PixelLayout layout_for(const FrameRequest& request) {
  if (request.encoding == PictureEncoding::png) return PixelLayout::rgba;
  return request.quality.chroma == ChromaSampling::yuv420 ? PixelLayout::yuv420
                                                          : PixelLayout::yuv444;
}

RenderSettings settings_for(const FrameRequest& request) {
  const Viewport& viewport = request.scene->viewport;
  const double scale = request.quality.resolution_scale;
  const auto scaled = [&](int side_px) {
    return std::max(1, static_cast<int>(std::lround(side_px * scale)));
  };
  return {.picture_size_px = {scaled(viewport.width_px), scaled(viewport.height_px)},
          .resolution_scale = scale,
          .supersampling = request.quality.supersampling,
          .step_voxels = request.quality.step_voxels,
          .layout = layout_for(request)};
}

std::vector<std::uint8_t> compress(const Pixels& pixels, int jpeg_quality) {
  const int width_px = pixels.size_px.x;
  const int height_px = pixels.size_px.y;
  if (pixels.layout == PixelLayout::rgba)
    return encode_png(pixels.planes.at(0), width_px, height_px);
  return encode_jpeg({.width_px = width_px,
                      .height_px = height_px,
                      .halved_chroma = pixels.layout == PixelLayout::yuv420,
                      .planes = {pixels.planes.at(0), pixels.planes.at(1), pixels.planes.at(2)}},
                     jpeg_quality);
}

Frame encoded_frame(const RenderedFrame& rendered) {
  const auto begun = std::chrono::steady_clock::now();
  const auto& request = *static_cast<const FrameRequest*>(rendered.label.get());
  Frame frame{.picture = compress(rendered.pixels, request.quality.jpeg_quality),
              .width_px = rendered.pixels.size_px.x,
              .height_px = rendered.pixels.size_px.y,
              .revision = request.revision,
              .quality = request.quality,
              .render_us = rendered.render_us,
              .cast_rays = rendered.cast_rays};
  const auto spent = std::chrono::steady_clock::now() - begun;
  frame.encode_us = static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(spent).count());
  return frame;
}

Error volume_gone(const std::string& id) {
  return Error({.code = "no-volume",
                .message = "the volume is not in memory any more",
                .field = "/volume",
                .received = id});
}

FrameOutcome frame_of(const RenderOutcome& outcome) {
  if (std::holds_alternative<RenderReplaced>(outcome)) return FrameReplaced{};
  if (const auto* error = std::get_if<Error>(&outcome)) return *error;
  try {
    return encoded_frame(std::get<RenderedFrame>(outcome));
  } catch (const Error& error) {
    return error;
  } catch (const std::exception& failure) {
    log().error("a frame could not be compressed: {}", failure.what());
    return Error({.code = "render-failed", .message = "the picture could not be compressed"});
  }
}

void hand_over(const RenderOutcome& outcome, const std::function<void(FrameOutcome)>& done) {
  try {
    done(frame_of(outcome));
  } catch (const std::exception& failure) {
    log().error("a frame was not taken: {}", failure.what());
  }
}

}  // namespace

FrameService::FrameService(const RendererSettings& settings, FindVolume find_volume)
    : find_volume_(std::move(find_volume)),
      encoders_(settings.encode_threads),
      renderer_(std::make_unique<RenderThread>(
          gl::ContextOptions{.require_gpu = settings.require_gpu}, settings.limits)),
      large_stills_(std::make_unique<LargeStills>(*renderer_)) {}

FrameService::~FrameService() {
  // The renderer first: what it still had waiting ends on the encoders' pool.
  large_stills_.reset();
  renderer_.reset();
  encoders_.finish();
}

RenderRequest FrameService::render_request(const FrameRequest& request) const {
  return {.view = request.view,
          .share = request.share,
          .volume = find_volume_(request.scene->volume),
          .scene = request.scene,
          .settings = settings_for(request),
          .label = std::make_shared<const FrameRequest>(request),
          .yields = request.quality.still};
}

void FrameService::submit(FrameRequest request, Done done) {
  RenderRequest to_render = render_request(request);
  if (!to_render.volume) return end(volume_gone(request.scene->volume), std::move(done));
  if (PictureTiles::is_due(to_render.settings.picture_size_px)) {
    // Compressed on the thread that made it, where it keeps no live frame waiting.
    large_stills_->add(
        std::move(to_render),
        [done = std::move(done)](const RenderOutcome& outcome) { hand_over(outcome, done); });
    return;
  }
  renderer_->submit({std::move(to_render), [this, done = std::move(done)](RenderOutcome outcome) {
                       end(std::move(outcome), done);
                     }});
}

// Posted, since a newer request may be replacing this one inside its own submit.
void FrameService::end(RenderOutcome outcome, Done done) {
  encoders_.post(
      [outcome = std::move(outcome), done = std::move(done)] { hand_over(outcome, done); });
}

bool FrameService::renew(const FrameRequest& request) {
  const RenderRequest to_render = render_request(request);
  return to_render.volume && renderer_->renew(to_render);
}

void FrameService::release(std::uint64_t view) {
  large_stills_->release(view);
  renderer_->release(view);
}

RendererDescription FrameService::describe() const {
  return {.name = renderer_->info().renderer, .software = renderer_->info().is_software};
}

std::string FrameService::trouble() const {
  return renderer_->is_lost() ? "the graphics device was lost" : "";
}

UploadTarget FrameService::upload_target() {
  return {.largest_edge_voxels = renderer_->info().largest_edge_voxels,
          .upload = [this](const auto& volume, const auto& progress, const std::stop_token& stop) {
            renderer_->upload(volume, progress, stop);
          }};
}

}  // namespace cutaway
