#include "unit/net/test_server.h"

#include <new>
#include <utility>

namespace cutaway::testing {

namespace {

constexpr std::chrono::seconds kGenerousTime{30};

class NoTicket final : public OpenTicket {};

class ThreadTicket final : public OpenTicket {
 public:
  explicit ThreadTicket(std::jthread thread) : thread_(std::move(thread)) {}

 private:
  std::jthread thread_;
};

class BrokenVolume final : public OpenVolume {
 public:
  const VolumeFacts& facts() const override { throw std::bad_alloc(); }
  const std::string& units() const override { throw std::bad_alloc(); }
  const Json& summary() const override { throw std::bad_alloc(); }
  std::optional<double> value_at(glm::dvec3) const override { return std::nullopt; }
  std::optional<double> value_to_the_faces(glm::dvec3) const override { return std::nullopt; }
};

std::uint16_t port_of(const std::string& url) {
  return static_cast<std::uint16_t>(std::stoi(url.substr(url.rfind(':') + 1)));
}

template <typename PictureFile>
Made<PictureFile> made_for(const FrameRequest& request, std::size_t bytes) {
  const Viewport viewport = request.scene->viewport;
  return {
      .picture = {{viewport.width_px, viewport.height_px}, std::vector<std::uint8_t>(bytes, 0x5A)},
      .revision = request.revision,
      .quality = request.quality,
      .render_us = 100,
      .encode_us = 50};
}

}  // namespace

ThreadedFrames::ThreadedFrames() : thread_([this](const std::stop_token& stop) { work(stop); }) {}

ThreadedFrames::~ThreadedFrames() {
  thread_.request_stop();
  thread_.join();
  for (auto& [view, job] : waiting_) job.end(nullptr, 0);
}

void ThreadedFrames::submit(FrameRequest request, std::function<void(FrameOutcome)> done) {
  put(std::move(request), [done = std::move(done)](const FrameRequest* rendered, auto bytes) {
    if (rendered == nullptr) return done(FrameReplaced{});
    done(made_for<JpegPicture>(*rendered, bytes));
  });
}

void ThreadedFrames::submit_still(FrameRequest request, std::function<void(StillOutcome)> done) {
  put(std::move(request), [done = std::move(done)](const FrameRequest* rendered, auto bytes) {
    if (rendered == nullptr) return done(FrameReplaced{});
    done(made_for<PngPicture>(*rendered, bytes));
  });
}

void ThreadedFrames::put(FrameRequest request, End end) {
  End replaced;
  {
    const std::lock_guard lock(mutex_);
    Job& job = waiting_[request.view];
    replaced = std::exchange(job.end, std::move(end));
    job.request = std::move(request);
  }
  changed_.notify_all();
  if (replaced) replaced(nullptr, 0);
}

bool ThreadedFrames::renew(const FrameRequest& request) {
  const std::lock_guard lock(mutex_);
  const auto job = waiting_.find(request.view);
  if (job == waiting_.end()) return false;
  job->second.request = request;
  return true;
}

void ThreadedFrames::release(std::uint64_t view) {
  End replaced;
  {
    const std::lock_guard lock(mutex_);
    released_.insert(view);
    if (auto job = waiting_.extract(view)) replaced = std::move(job.mapped().end);
  }
  changed_.notify_all();
  if (replaced) replaced(nullptr, 0);
}

bool ThreadedFrames::wait_for_release(std::uint64_t view) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, kGenerousTime, [&] { return released_.contains(view); });
}

bool ThreadedFrames::is_released(std::uint64_t view) {
  const std::lock_guard lock(mutex_);
  return released_.contains(view);
}

int ThreadedFrames::rendered(std::uint64_t view) {
  const std::lock_guard lock(mutex_);
  return rendered_[view];
}

void ThreadedFrames::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !waiting_.empty(); })) {
    Job job = std::move(waiting_.extract(waiting_.begin()).mapped());
    ++rendered_[job.request.view];
    lock.unlock();
    job.end(&job.request, picture_bytes);
    lock.lock();
  }
}

Json ThreadedLibrary::listing() const {
  return {
      {"volumes", {{{"id", "ball"}, {"title", "A ball"}, {"format", "test"}, {"modality", ""}}}},
      {"refused", Json::array()},
      {"scanning", false}};
}

std::unique_ptr<OpenTicket> ThreadedLibrary::watch(std::function<void()>) {
  return std::make_unique<NoTicket>();
}

std::unique_ptr<OpenTicket> ThreadedLibrary::open(const std::string& id, ProgressSink progress,
                                                  std::function<void(OpenOutcome)> done) {
  return std::make_unique<ThreadTicket>(std::jthread([id, progress, done] {
    progress(LoadStage::read, 0.5);
    if (id == "broken") return done(std::make_shared<const BrokenVolume>());
    done(std::make_shared<const BallVolume>(id));
  }));
}

NetSettings test_settings() {
  NetSettings settings;
  settings.port = 0;
  return settings;
}

TestServer::TestServer(const NetSettings& settings, SessionSettings session)
    : server_(settings, hooks(session)),
      port_(port_of(server_.url())),
      thread_([this] { server_.run(); }) {}

TestServer::~TestServer() { stop(); }

void TestServer::stop() {
  server_.stop();
  if (thread_.joinable()) thread_.join();
}

Server::Hooks TestServer::hooks(const SessionSettings& session) {
  return {.sources = {.volumes = [this] { return library.listing(); },
                      .trouble = [this] { return in_trouble ? "no GPU" : ""; }},
          .make_session = [this, session](const std::string& name, std::shared_ptr<Strand> strand,
                                          ClientSink& client) {
            if (refuse_sessions) throw std::bad_alloc();
            const std::uint64_t view = next_view_.fetch_add(7);
            return std::make_unique<Session>(
                SessionWiring{.name = name,
                              .strand = std::move(strand),
                              .frames = frames,
                              .volumes = library,
                              .client = client,
                              .live_views = {view, view + 1, view + 2, view + 3},
                              .still_view = view + 4,
                              .preview_view = view + 5,
                              .volume_preview_view = view + 6,
                              .previews = previews,
                              .capabilities = std::make_shared<const std::string>(
                                  R"({"type":"capabilities"})")},
                session);
          }};
}

}  // namespace cutaway::testing
