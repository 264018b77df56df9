#include "app/serve_command.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <numeric>
#include <utility>

#include "core/log.h"
#include "core/machine_memory.h"
#include "core/process.h"
#include "net/server.h"
#include "scene/json_text.h"
#include "scene/server_message.h"
#include "services/frame_service.h"
#include "services/volume_service.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

/// A still that takes about a second on two cores, and yields to what comes meanwhile.
constexpr std::int64_t kStillRaysInSoftware = 4'000'000;
/// The whole resolution takes some 10 times the budget of a frame there.
constexpr double kFirstScaleInSoftware = 0.5;
/// Frames are drawn in turns, but a picture's buffers are made at once: those of 2560 x 1600 pixels
/// take a third of a second where the processor has to fill them.
constexpr std::int64_t kViewportPixelsInSoftware = 4'096'000;

/// The parts of a running server. The listener comes first, so that an address that cannot be had
/// is said at once; nobody is answered before run. What is declared later is destroyed earlier:
/// loads end before what they upload to, frames that are still under way end on strands that still
/// stand.
class Serving {
 public:
  explicit Serving(const Config& config);

  std::string url() const { return server_.url(); }
  void run(const std::function<void()>& on_ready) { server_.run(on_ready); }

 private:
  Server::Hooks hooks();
  std::unique_ptr<Session> make_session(const std::string& name, std::shared_ptr<Strand> strand,
                                        ClientSink& client);

  SessionSettings session_settings_;
  std::shared_ptr<const std::string> capabilities_;
  std::atomic<std::uint64_t> next_view_{1};
  PreviewCache previews_;
  Server server_;
  std::unique_ptr<FrameService> frames_;
  std::unique_ptr<VolumeService> volumes_;
};

std::array<std::uint64_t, kViews> views_from(std::uint64_t first) {
  std::array<std::uint64_t, kViews> views{};
  std::iota(views.begin(), views.end(), first);
  return views;
}

std::string capabilities_text(const Config& config, const SessionSettings& session,
                              const RendererDescription& renderer) {
  return json_text(capabilities_message(
      {.server = "cutaway " CUTAWAY_VERSION,
       .renderer = renderer.name,
       .software_renderer = renderer.software,
       .limits = {.message_bytes = static_cast<std::int64_t>(config.net.message_bytes),
                  .viewport_pixels = session.viewport_pixels,
                  .viewport_side_px = session.viewport_side_px,
                  .still_side_px = session.still_side_px,
                  .frames_in_flight = session.frames_in_flight},
       .notice = config.notice}));
}

void say_renderer(const RendererDescription& renderer) {
  log().info("renderer: {}", renderer.name);
  if (!renderer.software) return;
  log().warn("NO GPU IS USED: pictures are rendered in software, slowly and at low resolution");
}

void say_memory(const VolumeSettings& volumes, const RenderLimits& renderer) {
  log().info("memory: at most {} for volumes, {} for their textures, {} for views",
             gibibytes(memory_limit(volumes)), gibibytes(renderer.volume_bytes),
             gibibytes(renderer.view_bytes));
}

fs::path this_executable() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error);
}

VolumeSettings with_reader(VolumeSettings settings) {
  settings.reader = this_executable();
  return settings;
}

void check_data(const std::vector<fs::path>& data) {
  for (const fs::path& path : data) {
    if (fs::exists(path)) continue;
    throw Error({.code = ErrorCode::unknown_volume,
                 .message = "there is no such data folder",
                 .field = path.string(),
                 .expected = "a folder or file with volumes"});
  }
}

Serving::Serving(const Config& config)
    : session_settings_(config.session), server_(config.net, hooks()) {
  frames_ = std::make_unique<FrameService>(
      config.renderer, [this](const Scene& scene) { return volumes_->seen_in(scene); });
  volumes_ = std::make_unique<VolumeService>(with_reader(config.volumes), frames_->upload_target());
  const RendererDescription renderer = frames_->describe();
  say_renderer(renderer);
  say_memory(config.volumes, frames_->limits());
  SessionSettings& settings = session_settings_;
  if (settings.viewport_pixels == 0) {
    settings.viewport_pixels =
        renderer.software ? kViewportPixelsInSoftware : SessionSettings().viewport_pixels;
  }
  if (renderer.software) {
    settings.still_rays = std::min(settings.still_rays, kStillRaysInSoftware);
    settings.first_resolution_scale =
        std::min(settings.first_resolution_scale, kFirstScaleInSoftware);
  }
  capabilities_ =
      std::make_shared<const std::string>(capabilities_text(config, session_settings_, renderer));
}

Server::Hooks Serving::hooks() {
  return {.sources = {.volumes = [this] { return volumes_->listing(); },
                      .trouble = [this] { return frames_->trouble(); }},
          .make_session = [this](const std::string& name, std::shared_ptr<Strand> strand,
                                 ClientSink& client) {
            return make_session(name, std::move(strand), client);
          }};
}

std::unique_ptr<Session> Serving::make_session(const std::string& name,
                                               std::shared_ptr<Strand> strand, ClientSink& client) {
  const std::uint64_t view = next_view_.fetch_add(kViews + 3);
  return std::make_unique<Session>(SessionWiring{.name = name,
                                                 .strand = std::move(strand),
                                                 .frames = *frames_,
                                                 .volumes = *volumes_,
                                                 .client = client,
                                                 .live_views = views_from(view),
                                                 .still_view = view + kViews,
                                                 .preview_view = view + kViews + 1,
                                                 .volume_preview_view = view + kViews + 2,
                                                 .previews = previews_,
                                                 .capabilities = capabilities_},
                                   session_settings_);
}

}  // namespace

fs::path find_web_root(const fs::path& configured) {
  if (!configured.empty()) return configured;
  const fs::path here = this_executable().parent_path();
  const std::array places = {here / "web-client", here / "../../web-client/dist",
                             here / "../share/cutaway/web-client",
                             fs::path("/usr/share/cutaway/web-client")};
  for (const fs::path& place : places) {
    if (fs::is_regular_file(place / "index.html")) return fs::canonical(place);
  }
  return {};
}

void run_serve(const Config& config) {
  log().set_level(spdlog::level::from_str(config.log_level));
  survive_stray_signals();
  if (!config.core_dumps) forbid_core_dumps();
  check_data(config.volumes.data);
  Config complete = config;
  complete.net.web_root = find_web_root(config.net.web_root);
  Serving serving(complete);
  if (complete.net.web_root.empty()) {
    log().warn("the web client is not built: only the API is served");
  }
  serving.run([&serving] {
    std::printf("Cutaway is at %s\n", serving.url().c_str());
    std::fflush(stdout);
  });
}

}  // namespace cutaway
