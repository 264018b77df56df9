#include "unit/import/nrrd_writer.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "unit/import/import_test_support.h"

namespace cutaway::test::nrrd {
namespace {

std::string vector_text(glm::dvec3 v) { return fmt::format("({},{},{})", v.x, v.y, v.z); }

std::vector<std::int16_t> ramp() {
  const auto values = ramp_values(kSize, kSteps, kOrigin);
  return {values.begin(), values.end()};
}

}  // namespace

std::string header(const std::string& space, glm::dvec3 flip, const std::string& encoding,
                   const std::string& rest) {
  return "NRRD0005\n# by hand\ntype: short\ndimension: 3\nspace: " + space +
         "\nsizes: 4 3 5\nspace directions: " + vector_text(kSteps[0] * flip) + " " +
         vector_text(kSteps[1] * flip) + " " + vector_text(kSteps[2] * flip) +
         "\nspace origin: " + vector_text(kOrigin * flip) +
         "\nkinds: domain domain domain\nendian: little\nencoding: " + encoding + "\n" + rest +
         "key:=a value\n";
}

std::string ramp_bytes(bool big_endian) { return bytes_of_numbers(ramp(), big_endian); }

std::string text_of_ramp() {
  std::string text;
  for (const auto value : ramp())
    text += std::to_string(value) + (text.size() % 7 == 0 ? "\n" : " ");
  return text;
}

std::string hex_of(const std::string& bytes) {
  std::string text;
  for (const char c : bytes)
    text +=
        fmt::format("{:02x}{}", static_cast<unsigned char>(c), text.size() % 35 == 0 ? "\n" : "");
  return text;
}

}  // namespace cutaway::test::nrrd
