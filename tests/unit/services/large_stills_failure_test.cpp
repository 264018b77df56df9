// What a renderer throws at a large still reaches the one who asked for it.
#include <gtest/gtest.h>

#include <future>
#include <memory>
#include <new>
#include <stdexcept>

#include "services/large_stills.h"

namespace cutaway {
namespace {

/// Throws at views 1 to 3, and finishes the others at once.
void submit(const RenderJob& job) {
  if (job.view() == 1) throw Error({.code = ErrorCode::too_large, .message = "no such picture"});
  if (job.view() == 2) throw std::bad_alloc();
  if (job.view() == 3) throw std::runtime_error("words for the log");
  job.done(RenderedFrame{.render_us = 7});
}

class LargeStillsFailure : public testing::Test {
 protected:
  RenderOutcome made(std::uint64_t view) {
    auto promise = std::make_shared<std::promise<RenderOutcome>>();
    auto outcome = promise->get_future();
    stills_.add({.view = view},
                [promise](RenderOutcome result) { promise->set_value(std::move(result)); });
    return outcome.get();
  }

  void expect_error(std::uint64_t view, ErrorCode code, const std::string& words) {
    const RenderOutcome outcome = made(view);
    ASSERT_TRUE(std::holds_alternative<Error>(outcome));
    EXPECT_EQ(std::get<Error>(outcome).detail().code, code);
    EXPECT_EQ(std::get<Error>(outcome).what(), words);
  }

  LargeStills stills_{{.submit = submit, .release = [](std::uint64_t) {}}};
};

TEST_F(LargeStillsFailure, IsHandedOverAsAnErrorAndTheNextIsMade) {
  expect_error(1, ErrorCode::too_large, "no such picture");
  expect_error(2, ErrorCode::too_large,
               "there is not enough memory for a picture of this size (/width_px)");
  expect_error(3, ErrorCode::render_failed, "the picture could not be drawn");
  const RenderOutcome next = made(4);
  ASSERT_TRUE(std::holds_alternative<RenderedFrame>(next));
  EXPECT_EQ(std::get<RenderedFrame>(next).render_us, 7U);
}

}  // namespace
}  // namespace cutaway
