#include "load/figures.h"

#include <cmath>
#include <cstdio>

namespace cutaway::load {

namespace {

int decimals(double value) {
  const double size = std::abs(value);
  if (value == std::round(value) || size >= 100.0) return 0;
  if (size >= 10.0) return 1;
  return size >= 0.1 ? 2 : 3;
}

}  // namespace

std::string figure(double value) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals(value), value);
  return text;
}

std::string figure(double value, const char* unit) {
  return figure(value) + (*unit == '\0' ? "" : " ") + unit;
}

}  // namespace cutaway::load
