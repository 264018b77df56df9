// The ends of a session under a test's control: frames that are finished by hand, volumes that open
// by hand, a client that keeps what it was sent.
#pragma once

#include <algorithm>
#include <deque>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/check.h"
#include "scene/frame_header.h"
#include "session/client_sink.h"
#include "session/frame_source.h"
#include "session/volume_library.h"

namespace cutaway::testing {

/// One place for each view, as the renderer has; a request begins when the test says so.
class FakeFrames final : public FrameSource {
 public:
  struct Job {
    FrameRequest request;
    std::variant<std::function<void(FrameOutcome)>, std::function<void(StillOutcome)>> done;
  };

  void submit(FrameRequest request, std::function<void(FrameOutcome)> done) override {
    drop_waiting(request.view);
    ++submitted;
    waiting_.push_back({std::move(request), std::move(done)});
  }
  void submit_still(FrameRequest request, std::function<void(StillOutcome)> done) override {
    drop_waiting(request.view);
    ++stills_submitted;
    waiting_.push_back({std::move(request), std::move(done)});
  }
  bool renew(const FrameRequest& request) override {
    for (Job& job : waiting_) {
      if (job.request.view != request.view) continue;
      job.request = request;
      ++renewed;
      return true;
    }
    return false;
  }
  void release(std::uint64_t view) override {
    released.insert(view);
    drop_waiting(view);
  }
  RendererDescription describe() const override { return {"a fake", true}; }
  std::string trouble() const override { return ""; }

  bool idle() const { return waiting_.empty() && begun_.empty(); }
  std::size_t waiting() const { return waiting_.size(); }

  /// The oldest waiting request can no longer be replaced.
  const FrameRequest& begin() {
    begun_.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
    return begun_.back().request;
  }
  /// The newest begun request ends before the others.
  void overtake() { std::ranges::rotate(begun_, std::prev(begun_.end())); }
  /// Ends the oldest begun request, or the oldest waiting one.
  FrameRequest finish(std::uint32_t render_us = 5000, std::size_t bytes = 100) {
    Job job = next();
    const auto made = [&](auto picture) {
      const Viewport viewport = job.request.scene->viewport;
      picture.size_px = {viewport.width_px, viewport.height_px};
      picture.bytes.assign(bytes, 0xAB);
      return Made<decltype(picture)>{.picture = std::move(picture),
                                     .revision = job.request.revision,
                                     .quality = job.request.quality,
                                     .render_us = render_us,
                                     .encode_us = 1000};
    };
    if (const auto* still = std::get_if<1>(&job.done)) {
      (*still)(made(PngPicture()));
    } else {
      std::get<0>(job.done)(made(JpegPicture()));
    }
    return job.request;
  }
  void fail(const Error& error) { end(next(), error); }

  int submitted = 0;
  int stills_submitted = 0;
  int renewed = 0;
  std::set<std::uint64_t> released;

 private:
  template <typename Outcome>
  static void end(const Job& job, const Outcome& outcome) {
    std::visit([&](const auto& done) { done(outcome); }, job.done);
  }
  Job next() {
    std::deque<Job>& from = begun_.empty() ? waiting_ : begun_;
    check(!from.empty(), "a frame was asked for");
    Job job = std::move(from.front());
    from.pop_front();
    return job;
  }
  void drop_waiting(std::uint64_t view) {
    std::erase_if(waiting_, [view](Job& job) {
      if (job.request.view != view) return false;
      end(job, FrameReplaced{});
      return true;
    });
  }

  std::deque<Job> waiting_;
  std::deque<Job> begun_;
};

/// A ball around the origin whose value falls by 1 per mm from `centre_value`.
class BallVolume final : public OpenVolume {
 public:
  explicit BallVolume(std::string id, double centre_value = 200.0, std::string first_style = {});

  const VolumeFacts& facts() const override { return facts_; }
  const std::string& units() const override { return units_; }
  const Json& summary() const override { return summary_; }
  std::optional<double> value_at(glm::dvec3 position_mm) const override;
  std::optional<double> value_to_the_faces(glm::dvec3 position_mm) const override {
    return value_at(position_mm);
  }

 private:
  double centre_value_;
  std::string units_ = "HU";
  VolumeFacts facts_;
  Json summary_;
};

class FakeLibrary final : public VolumeLibrary {
 public:
  struct Wish {
    std::string id;
    ProgressSink progress;
    std::function<void(OpenOutcome)> done;
    bool withdrawn = false;
  };

  Json listing() const override { return listing_; }
  std::unique_ptr<OpenTicket> watch(std::function<void()> changed) override;
  std::unique_ptr<OpenTicket> open(const std::string& id, ProgressSink progress,
                                   std::function<void(OpenOutcome)> done) override;

  std::unique_ptr<OpenTicket> open_for_preview(const std::string& id,
                                               std::function<void(OpenOutcome)> done) override {
    return open(id, {}, std::move(done));
  }

  /// Of the ball: nothing is to be prepared where `prepares` is false.
  std::unique_ptr<OpenTicket> prepare(const Scene& scene, std::function<void()> ready) override;

  /// Ends the newest wish with a ball.
  void finish();
  void fail(const Error& error);
  void progress(LoadStage stage, double fraction) { wishes.back()->progress(stage, fraction); }
  void change_listing(Json listing);

  std::vector<std::shared_ptr<Wish>> wishes;
  double centre_value = 200.0;
  std::string first_style;
  bool prepares = false;
  struct Preparing {
    Scene scene;
    std::function<void()> ready;
    bool withdrawn = false;
  };
  std::vector<std::shared_ptr<Preparing>> preparing;

 private:
  Json listing_ = {{"volumes", Json::array()}, {"refused", Json::array()}, {"scanning", false}};
  std::shared_ptr<std::function<void()>> changed_ = std::make_shared<std::function<void()>>();
};

class FakeClient final : public ClientSink {
 public:
  struct Picture {
    FrameHeader header;
    std::function<void(bool)> done;
  };

  void send_text(std::string message) override { texts.push_back(Json::parse(message)); }
  void send_latest_text(std::string message) override { send_text(std::move(message)); }
  void send_frame(ViewKind /*view*/, std::vector<std::uint8_t> message,
                  std::function<void(bool)> done) override {
    frames.push_back({decode_frame(message).header, std::move(done)});
  }
  void send_still(std::vector<std::uint8_t> message, std::function<void(bool)> done) override {
    stills.push_back({decode_frame(message).header, std::move(done)});
  }

  std::vector<Json> of_type(const std::string& type) const;
  /// The newest message of a type; null where none came.
  Json last(const std::string& type) const;

  std::vector<Json> texts;
  std::vector<Picture> frames;
  std::vector<Picture> stills;
};

}  // namespace cutaway::testing
