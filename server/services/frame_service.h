// Where sessions' frames come from: the render thread, then a pool that compresses.
#pragma once

#include <functional>
#include <memory>

#include "core/worker_pool.h"
#include "render/render_thread.h"
#include "services/large_stills.h"
#include "services/settings.h"
#include "services/upload_target.h"
#include "session/frame_source.h"

namespace cutaway {

/// Thread-safe. Destroying it ends every request that is under way.
class FrameService : public FrameSource {
 public:
  /// Finds the volume of a scene in memory, as the scene has it prepared; nothing where it is not
  /// there any more.
  using FindVolume = std::function<std::shared_ptr<const LoadedVolume>(const Scene& scene)>;

  /// Throws StartUpError (renderer_unavailable).
  FrameService(const RendererSettings& settings, FindVolume find_volume);
  ~FrameService() override;

  void submit(FrameRequest request, std::function<void(FrameOutcome)> done) override;
  void submit_still(FrameRequest request, std::function<void(StillOutcome)> done) override;
  bool renew(const FrameRequest& request) override;
  void release(std::uint64_t view) override;
  RendererDescription describe() const override;
  std::string trouble() const override;

  const RenderLimits& limits() const { return renderer_->info().limits; }

  /// Works for as long as this does.
  UploadTarget upload_target();

 private:
  RenderRequest render_request(const FrameRequest& request, PixelLayout layout) const;
  RenderRequest live_request(const FrameRequest& request) const;
  RenderRequest still_request(const FrameRequest& request) const;
  template <typename Outcome>
  void end(RenderOutcome outcome, const std::string& session, std::function<void(Outcome)> done);

  FindVolume find_volume_;
  WorkerPool encoders_;
  std::unique_ptr<RenderThread> renderer_;
  std::unique_ptr<LargeStills> large_stills_;  ///< of the renderer, and gone before it
};

}  // namespace cutaway
