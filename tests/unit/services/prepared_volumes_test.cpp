// A volume as scenes have it prepared: at a first look, after a change, and where memory is short.
#include <future>

#include "scene/resolve.h"
#include "services/opened_volume.h"
#include "unit/services/volume_waiter.h"

namespace cutaway {
namespace {

using testing::Heard;
using testing::no_renderer;

constexpr const char* kHead = "phantom:head@64";

/// A service that shows the head.
struct Shown {
  explicit Shown(std::uint64_t memory_bytes)
      : service(VolumeSettings{.memory_bytes = memory_bytes}, no_renderer()),
        ticket(service.open(kHead, heard.progress(), heard.done())),
        volume(heard.volume()) {}

  Scene scene(const char* document = "{}") const {
    return resolve_scene(Json::parse(document), volume->facts(), {64, 48});
  }

  VolumeService service;
  Heard heard;
  std::unique_ptr<OpenTicket> ticket;
  std::shared_ptr<const OpenVolume> volume;
};

TEST(PreparedVolumes, AreThereAtAFirstLook) {
  Shown shown(100'000'000);
  const auto measured = shown.service.loaded(kHead);
  ASSERT_NE(measured->findings.body, nullptr);
  const Scene first = shown.scene();
  EXPECT_TRUE(first.preparation.fill_context);
  EXPECT_NE(shown.service.seen_in(first), measured);
  EXPECT_EQ(shown.service.prepare(first, [] {}), nullptr) << "nothing to wait for";
}

TEST(PreparedVolumes, LeaveSlicesAndOldDocumentsWhatWasMeasured) {
  Shown shown(100'000'000);
  const auto measured = shown.service.loaded(kHead);
  Scene slice = shown.scene();
  slice.viewport.kind = ViewKind::axial;
  EXPECT_EQ(shown.service.seen_in(slice), measured);
  const Scene old = shown.scene(R"({"context": {"surface": {"iso_value": -200}}})");
  EXPECT_EQ(shown.service.seen_in(old), measured);
  EXPECT_EQ(shown.service.prepare(old, [] {}), nullptr);
}

TEST(PreparedVolumes, AreMadeAnewWhereTheSurfaceMoves) {
  Shown shown(100'000'000);
  const auto first = shown.service.seen_in(shown.scene());
  Scene moved = shown.scene();
  moved.preparation.fill_context = false;
  const auto measured = shown.service.loaded(kHead);
  EXPECT_EQ(shown.service.seen_in(moved), measured) << "until it is made";
  std::promise<void> ready;
  const auto ticket = shown.service.prepare(moved, [&ready] { ready.set_value(); });
  ASSERT_NE(ticket, nullptr);
  ready.get_future().wait();
  const auto seen = shown.service.seen_in(moved);
  EXPECT_NE(seen, measured);
  EXPECT_NE(seen, first);
  moved.focus.surface.band.lower = 400.0;
  EXPECT_EQ(shown.service.seen_in(moved), seen) << "it differs in islands alone";
  EXPECT_EQ(shown.service.seen_in(shown.scene()), first) << "it is kept";
}

TEST(PreparedVolumes, AreNotMadeWhereMemoryIsShort) {
  Shown shown(1'300'000);
  EXPECT_EQ(shown.service.seen_in(shown.scene()), shown.service.loaded(kHead));
}

TEST(PreparedVolumes, ArePickedAsTheyAreSeen) {
  Shown shown(100'000'000);
  const Scene first = shown.scene();
  const glm::dvec3 from_mm = first.camera.eye_mm;
  const glm::dvec3 ahead = glm::normalize(first.camera.target_mm - from_mm);
  const auto seen = shown.volume->probe(first)(from_mm, ahead, first.context.surface.band);
  ASSERT_TRUE(seen.has_value());
  EXPECT_NEAR(*shown.volume->value_at(*seen), first.context.surface.band.lower, 60.0);
}

}  // namespace
}  // namespace cutaway
