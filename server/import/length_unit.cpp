#include "import/length_unit.h"

#include <string>

#include "import/data_root.h"

namespace cutaway::reading {

std::optional<double> millimetres_per(std::string_view unit) {
  const std::string name = lower_case(unit);
  const auto is_one_of = [&](auto... names) { return ((name == names) || ...); };
  if (is_one_of("mm", "millimeter", "millimeters", "millimetre", "millimetres")) return 1.0;
  if (is_one_of("cm", "centimeter", "centimeters", "centimetre", "centimetres")) return 10.0;
  if (is_one_of("m", "meter", "meters", "metre", "metres")) return 1000.0;
  if (is_one_of("um", "micron", "microns", "micrometer", "micrometers", "micrometre",
                "micrometres")) {
    return 0.001;
  }
  // The micro sign, the Greek letter, and ImageJ's escape of the former.
  if (is_one_of("\xC2\xB5m", "\xCE\xBCm", "\\u00b5m")) return 0.001;
  if (is_one_of("in", "inch", "inches")) return 25.4;
  return std::nullopt;
}

}  // namespace cutaway::reading
