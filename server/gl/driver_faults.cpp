#include "gl/driver_faults.h"

#include <cstdlib>
#include <optional>

#include "core/log.h"

namespace cutaway::gl {

namespace {

constexpr const char* kWidth = "LP_NATIVE_VECTOR_WIDTH";
constexpr const char* kProcessor = "GALLIUM_OVERRIDE_CPU_CAPS";

std::optional<long> vector_bits_asked_for() {
  const char* text = std::getenv(kWidth);
  if (text == nullptr) return std::nullopt;
  char* end = nullptr;
  const long bits = std::strtol(text, &end, 0);
  if (end == text) return std::nullopt;
  return bits;
}

}  // namespace

void work_around_driver_faults() {
  constexpr long kWide = 256;
  const auto bits = vector_bits_asked_for();
  if (!bits || *bits >= kWide || std::getenv(kProcessor) != nullptr) return;
  setenv(kWidth, "128", 1);
  setenv(kProcessor, "avx", 1);  // at most that
  log().info("{}={}: 128 is taken, and no AVX-512, which Mesa does not bear with it", kWidth,
             *bits);
}

}  // namespace cutaway::gl
