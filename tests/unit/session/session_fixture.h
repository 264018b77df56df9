// A session with everything around it under the test's control.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "session/session.h"
#include "unit/session/fake_strand.h"
#include "unit/session/fakes.h"

namespace cutaway::testing {

inline constexpr const char* kSessionName = "session 1 of 192.0.2.7";

class SessionFixture : public ::testing::Test {
 protected:
  SessionFixture() { restart(); }

  /// The same session anew, with the settings as they are now.
  void restart() {
    session = nullptr;
    client = {};
    session = std::make_unique<Session>(
        SessionWiring{.name = kSessionName,
                      .strand = strand,
                      .frames = frames,
                      .volumes = library,
                      .client = client,
                      .live_views = {1, 4, 5, 6},
                      .still_view = 2,
                      .preview_view = 3,
                      .volume_preview_view = 7,
                      .previews = previews,
                      .capabilities = std::make_shared<const std::string>(
                          R"({"type":"capabilities","protocol":"cutaway.v1"})")},
        settings);
    session->start();
  }

  void receive(const Json& message) {
    session->receive_text(message.dump());
    strand->run();
  }
  std::uint32_t scene(const Json& scene, bool replace = false) {
    receive({{"type", "scene"},
             {"input", ++input},
             {"clock_ms", 1.0},
             {"scene", scene},
             {"replace", replace}});
    return input;
  }
  std::uint32_t viewport(int width_px, int height_px) {
    receive({{"type", "viewport"},
             {"input", ++input},
             {"clock_ms", 1.0},
             {"width_px", width_px},
             {"height_px", height_px}});
    return input;
  }
  void open(const std::string& id) {
    scene({{"volume", id}});
    library.finish();
    strand->run();
  }
  /// Renders and acknowledges until nothing is asked for, and lets the still frame pass.
  void come_to_rest() {
    do {
      settle();
      strand->advance(Milliseconds(300.0));
    } while (!frames.idle());
  }
  /// Renders and acknowledges what is asked for now.
  void settle() {
    while (!frames.idle()) {
      frames.finish();
      strand->run();
      receive({{"type", "ack"}, {"frame", client.frames.back().header.frame}});
    }
  }
  /// A session that shows a ball and is at rest.
  void show_ball() {
    viewport(640, 480);
    open("ball");
    come_to_rest();
    client.texts.clear();
    client.frames.clear();
  }
  /// The newest request that was made of the renderer.
  Scene rendered() {
    const FrameRequest request = frames.finish();
    strand->run();
    receive({{"type", "ack"}, {"frame", client.frames.back().header.frame}});
    return *request.scene;
  }
  void expect_error(const std::string& code, const std::string& field = "") const {
    const Json error = client.last("error");
    ASSERT_FALSE(error.is_null()) << "no error came";
    EXPECT_EQ(error["code"], code) << error;
    EXPECT_EQ(error.value("field", ""), field) << error;
  }
  std::vector<std::string> loading_stages() const {
    std::vector<std::string> stages;
    for (const Json& message : client.of_type("loading")) stages.push_back(message["stage"]);
    return stages;
  }

  std::shared_ptr<FakeStrand> strand = std::make_shared<FakeStrand>();
  FakeFrames frames;
  FakeLibrary library;
  PreviewCache previews;
  FakeClient client;
  SessionSettings settings;
  std::uint32_t input = 0;
  std::unique_ptr<Session> session;
};

}  // namespace cutaway::testing
