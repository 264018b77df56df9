#include "import/length_unit.h"

#include <string>

#include "import/data_root.h"

namespace cutaway::reading {

bool is_no_length(std::string_view unit) {
  const std::string name = lower_case(trimmed(unit));
  const auto is_one_of = [&](auto... names) { return ((name == names) || ...); };
  return is_one_of("", "none", "pixel", "pixels", "px", "voxel", "voxels", "reference frame");
}

std::optional<double> millimetres_per(std::string_view unit) {
  const std::string name = lower_case(unit);
  const auto is_one_of = [&](auto... names) { return ((name == names) || ...); };
  if (is_one_of("mm", "millimeter", "millimeters", "millimetre", "millimetres")) return 1.0;
  if (is_one_of("cm", "centimeter", "centimeters", "centimetre", "centimetres")) return 10.0;
  if (is_one_of("m", "meter", "meters", "metre", "metres")) return 1000.0;
  if (is_one_of("um", "micron", "microns", "micrometer", "micrometers", "micrometre",
                "micrometres")) {
    return 1e-3;
  }
  // The micro sign in UTF-8, in Latin-1 and as ImageJ and XML escape it, and the Greek letter.
  if (is_one_of("\xC2\xB5m", "\xB5m", "\\u00b5m", "&#181;m", "&#xb5;m", "\xCE\xBCm", "&#956;m"))
    return 1e-3;
  if (is_one_of("nm", "nanometer", "nanometers", "nanometre", "nanometres")) return 1e-6;
  if (is_one_of("\xC3\x85", "\xC5", "&#197;", "angstrom", "angstroms")) return 1e-7;
  if (is_one_of("pm", "picometer", "picometers", "picometre", "picometres")) return 1e-9;
  if (is_one_of("in", "inch", "inches")) return 25.4;
  return std::nullopt;
}

}  // namespace cutaway::reading
