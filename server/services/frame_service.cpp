#include "services/frame_service.h"

#include <chrono>
#include <cmath>

#include "core/log.h"
#include "encode/jpeg.h"
#include "encode/png.h"

namespace cutaway {

namespace {

/// A still that takes more than this until it is compressed is made by turn: no limit that a
/// client has to know.
constexpr std::size_t kLargeStillBytes = std::size_t{16} << 20;

PixelLayout layout_for(const FrameRequest& request) {
  return request.quality.chroma == ChromaSampling::yuv420 ? PixelLayout::yuv420
                                                          : PixelLayout::yuv444;
}

RenderSettings settings_for(const FrameRequest& request, PixelLayout layout) {
  const Viewport& viewport = request.scene->viewport;
  const double scale = request.quality.resolution_scale;
  const auto scaled = [&](int side_px) {
    return std::max(1, static_cast<int>(std::lround(side_px * scale)));
  };
  return {.picture_size_px = {scaled(viewport.width_px), scaled(viewport.height_px)},
          .resolution_scale = scale,
          .supersampling = request.quality.supersampling,
          .step_voxels = request.quality.step_voxels,
          .light = request.quality.light == LightDetail::full ? kFullLight : kQuickLight,
          .layout = layout};
}

bool is_large(const RenderRequest& still) {
  const PlaneShape shape = plane_shapes(PixelLayout::rgba, still.settings.picture_size_px).front();
  return packed_bytes(shape.size_px, shape.bytes_per_pixel) > kLargeStillBytes;
}

void compress(const Picture& picture, int jpeg_quality, JpegPicture& file) {
  file = encode_jpeg(picture, jpeg_quality);
}

void compress(const Picture& picture, int /*jpeg_quality*/, PngPicture& file) {
  file = encode_png(picture);
}

template <typename PictureFile>
Made<PictureFile> compressed(const RenderedFrame& rendered) {
  const auto begun = std::chrono::steady_clock::now();
  const auto& request = *static_cast<const FrameRequest*>(rendered.label.get());
  Made<PictureFile> made{.revision = request.revision,
                         .quality = request.quality,
                         .render_us = rendered.render_us,
                         .cast_rays = rendered.cast_rays};
  compress(rendered.picture, request.quality.jpeg_quality, made.picture);
  const auto spent = std::chrono::steady_clock::now() - begun;
  made.encode_us = static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(spent).count());
  return made;
}

Error volume_gone(const std::string& id) {
  return Error({.code = ErrorCode::unknown_volume,
                .message = "the volume is not in memory any more",
                .field = "/scene/volume",
                .received = id});
}

/// Of a variant of what was made, FrameReplaced and Error.
template <typename Outcome>
Outcome outcome_of(const RenderOutcome& outcome, const std::string& session) {
  if (std::holds_alternative<RenderReplaced>(outcome)) return FrameReplaced{};
  if (const auto* error = std::get_if<Error>(&outcome)) return *error;
  using PictureFile = decltype(std::variant_alternative_t<0, Outcome>::picture);
  try {
    return compressed<PictureFile>(std::get<RenderedFrame>(outcome));
  } catch (const Error& error) {
    return error;
  } catch (const std::exception& failure) {
    log().error("{}: a picture could not be compressed: {}", session, failure.what());
    return Error(
        {.code = ErrorCode::render_failed, .message = "the picture could not be compressed"});
  }
}

template <typename Outcome>
void hand_over(const RenderOutcome& outcome, const std::string& session,
               const std::function<void(Outcome)>& done) {
  try {
    done(outcome_of<Outcome>(outcome, session));
  } catch (const std::exception& failure) {
    log().error("{}: a picture was not taken: {}", session, failure.what());
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

RenderRequest FrameService::render_request(const FrameRequest& request, PixelLayout layout) const {
  return {.view = request.view,
          .share = request.share,
          .owner = request.session,
          .volume = find_volume_(*request.scene),
          .scene = request.scene,
          .settings = settings_for(request, layout),
          .label = std::make_shared<const FrameRequest>(request)};
}

RenderRequest FrameService::live_request(const FrameRequest& request) const {
  RenderRequest live = render_request(request, layout_for(request));
  live.yields = request.quality.still;
  return live;
}

RenderRequest FrameService::still_request(const FrameRequest& request) const {
  RenderRequest still = render_request(request, PixelLayout::rgba);
  still.is_followed = false;
  return still;
}

void FrameService::submit(FrameRequest request, std::function<void(FrameOutcome)> done) {
  RenderRequest live = live_request(request);
  if (!live.volume)
    return end(volume_gone(request.scene->volume), request.session, std::move(done));
  renderer_->submit(
      {std::move(live), [this, session = request.session, done = std::move(done)](
                            RenderOutcome outcome) { end(std::move(outcome), session, done); }});
}

void FrameService::submit_still(FrameRequest request, std::function<void(StillOutcome)> done) {
  RenderRequest still = still_request(request);
  if (!still.volume)
    return end(volume_gone(request.scene->volume), request.session, std::move(done));
  if (is_large(still)) {
    // Compressed on the thread that made it, where it keeps no live frame waiting.
    large_stills_->add(std::move(still),
                       [session = request.session, done = std::move(done)](
                           const RenderOutcome& outcome) { hand_over(outcome, session, done); });
    return;
  }
  renderer_->submit(
      {std::move(still), [this, session = request.session, done = std::move(done)](
                             RenderOutcome outcome) { end(std::move(outcome), session, done); }});
}

// Posted, since a newer request may be replacing this one inside its own submit.
template <typename Outcome>
void FrameService::end(RenderOutcome outcome, const std::string& session,
                       std::function<void(Outcome)> done) {
  encoders_.post([outcome = std::move(outcome), session, done = std::move(done)] {
    hand_over(outcome, session, done);
  });
}

bool FrameService::renew(const FrameRequest& request) {
  const RenderRequest live = live_request(request);
  return live.volume && renderer_->renew(live);
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
