// What is taken of the machine's memory where nobody has said how much.
#include <gtest/gtest.h>

#include "core/machine_memory.h"
#include "render/render_limits.h"
#include "services/volume_service.h"

namespace cutaway {
namespace {

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

TEST(MemoryLimits, VolumesTakeHalfOfTheMachineUnlessToldOtherwise) {
  EXPECT_EQ(memory_limit({}), machine_memory_bytes() / 2);
  EXPECT_EQ(memory_limit({.memory_bytes = 5'000'000}), 5'000'000);
}

TEST(MemoryLimits, ASoftwareRenderersTexturesFollowTheMachine) {
  const RenderLimits limits = limits_for({}, true, 4 * kGiB);
  EXPECT_EQ(limits.volume_bytes, kGiB);
  EXPECT_EQ(limits.view_bytes, kGiB / 2);
  EXPECT_EQ(limits_for({}, true, 64 * kGiB).view_bytes, 2 * kGiB);
}

TEST(MemoryLimits, ThoseOfAGpuDoNot) {
  const RenderLimits limits = limits_for({}, false, 4 * kGiB);
  EXPECT_EQ(limits.volume_bytes, 8 * kGiB);
  EXPECT_EQ(limits.view_bytes, 2 * kGiB);
}

TEST(MemoryLimits, WhatIsSetStands) {
  const RenderLimits wanted{.volume_bytes = 3, .view_bytes = 5, .step = 7};
  EXPECT_EQ(limits_for(wanted, true, 4 * kGiB), wanted);
  EXPECT_EQ(limits_for(wanted, false, 4 * kGiB), wanted);
}

TEST(MemoryLimits, AreSaidInGibibytes) { EXPECT_EQ(gibibytes(3 * kGiB / 2), "1.5 GiB"); }

// Everything that is held at once, with room beside it.
TEST(MemoryLimits, TogetherStayBelowTheMachinesMemory) {
  const RenderLimits limits = limits_for({}, true, machine_memory_bytes());
  EXPECT_LT(memory_limit({}) + limits.volume_bytes + limits.view_bytes, machine_memory_bytes());
}

}  // namespace
}  // namespace cutaway
