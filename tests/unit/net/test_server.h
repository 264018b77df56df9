// A server on a free port of 127.0.0.1 with real sessions, whose frames and volumes come from the
// test's own ends.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>

#include "net/server.h"
#include "unit/session/fakes.h"

namespace cutaway::testing {

/// Renders on a thread of its own: `picture_bytes` of nothing in particular.
class ThreadedFrames final : public FrameSource {
 public:
  ThreadedFrames();
  ~ThreadedFrames() override;
  ThreadedFrames(const ThreadedFrames&) = delete;
  ThreadedFrames& operator=(const ThreadedFrames&) = delete;

  void submit(FrameRequest request, std::function<void(FrameOutcome)> done) override;
  void submit_still(FrameRequest request, std::function<void(StillOutcome)> done) override;
  bool renew(const FrameRequest& request) override;
  void release(std::uint64_t view) override;
  RendererDescription describe() const override { return {"threads", true}; }
  std::string trouble() const override { return ""; }

  /// Waits until the view's session has ended; false after a generous limit.
  bool wait_for_release(std::uint64_t view);
  bool is_released(std::uint64_t view);
  int rendered(std::uint64_t view);

  std::atomic<std::size_t> picture_bytes{5000};

 private:
  /// Of what was rendered, with a picture of so many bytes, or of nothing: it was replaced.
  using End = std::function<void(const FrameRequest* rendered, std::size_t picture_bytes)>;
  struct Job {
    FrameRequest request;
    End end;
  };

  void put(FrameRequest request, End end);
  void work(const std::stop_token& stop);

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::map<std::uint64_t, Job> waiting_;
  std::map<std::uint64_t, int> rendered_;
  std::set<std::uint64_t> released_;
  std::jthread thread_;
};

/// Opens any volume at once as a ball, from a thread of its own; "broken" as one that lets a
/// session run out of memory.
class ThreadedLibrary final : public VolumeLibrary {
 public:
  Json listing() const override;
  std::unique_ptr<OpenTicket> watch(std::function<void()> changed) override;
  std::unique_ptr<OpenTicket> open(const std::string& id, ProgressSink progress,
                                   std::function<void(OpenOutcome)> done) override;
  std::unique_ptr<OpenTicket> open_for_preview(const std::string& id,
                                               std::function<void(OpenOutcome)> done) override {
    return open(id, {}, std::move(done));
  }
  std::unique_ptr<OpenTicket> prepare(const Scene& /*scene*/,
                                      std::function<void()> /*ready*/) override {
    return nullptr;
  }
};

NetSettings test_settings();

class TestServer {
 public:
  explicit TestServer(const NetSettings& settings = test_settings(), SessionSettings session = {});
  ~TestServer();
  TestServer(const TestServer&) = delete;
  TestServer& operator=(const TestServer&) = delete;

  std::uint16_t port() const { return port_; }
  /// Returns once the server's run has.
  void stop();
  /// Live view of the n-th session, from 0.
  static std::uint64_t view_of_session(int n) { return (7 * static_cast<std::uint64_t>(n)) + 1; }

 private:
  Server::Hooks hooks(const SessionSettings& session);

  std::atomic<std::uint64_t> next_view_{1};
  Server server_;  ///< outlives the frames, which end on its strands

 public:
  ThreadedFrames frames;
  ThreadedLibrary library;
  PreviewCache previews;
  std::atomic<bool> in_trouble{false};
  std::atomic<bool> refuse_sessions{false};

 private:
  std::uint16_t port_;
  std::jthread thread_;
};

}  // namespace cutaway::testing
