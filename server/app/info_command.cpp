#include "app/info_command.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

#include "core/printable.h"
#include "services/named_path.h"
#include "volume/facts/findings.h"
#include "volume/phantoms.h"

namespace cutaway {

namespace fs = std::filesystem;

namespace {

using OrderedJson = nlohmann::ordered_json;

/// What is printed of a volume: everything but its voxels.
struct Facts {
  VolumeDescription description;
  VolumeGeometry geometry;
  ValueRange value_range;
  Findings findings;
};

struct Report {
  std::vector<Facts> volumes;
  std::vector<RefusedFile> refused;
};

/// -0.0 says nothing more than 0.
std::array<double, 3> plain(glm::dvec3 v) { return {v.x + 0.0, v.y + 0.0, v.z + 0.0}; }

std::array<double, 9> row_major(const glm::dmat3& m) {
  std::array<double, 9> values{};
  auto value = values.begin();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) *value++ = m[column][row] + 0.0;
  }
  return values;
}

std::array<int, 3> extents(const Facts& facts) {
  const glm::ivec3 size = facts.geometry.size_voxels;
  return {size.x, size.y, size.z};
}

OrderedJson chosen_json(const ChosenValue& chosen) {
  return {{"value", chosen.value}, {"from", chosen.from}};
}

OrderedJson first_look_json(const Findings& findings) {
  OrderedJson json = {
      {"kind", name_of(findings.kind)},
      {"robust_range", std::array{findings.robust.range.minimum, findings.robust.range.maximum}},
      {"padding", findings.robust.sentinels},
      {"outer_iso_value", chosen_json(findings.outer)},
      {"inner_iso_value", chosen_json(findings.inner)},
      {"contrast_medium", findings.has_contrast},
      {"extent_mm", plain(findings.shape.extent_mm)},
      {"slab", findings.shape.is_slab()}};
  if (findings.body) {
    json["body_ml"] = findings.body->body_ml;
    json["couch_ml"] = findings.body->removed_ml;
  }
  return json;
}

OrderedJson to_json(const Facts& facts) {
  const VolumeDescription& description = facts.description;
  return {{"id", description.id},
          {"title", description.title},
          {"format", description.format},
          {"modality", description.modality},
          {"size", extents(facts)},
          {"spacing_mm", plain(facts.geometry.spacing_mm)},
          {"origin_lps_mm", plain(facts.geometry.origin_patient_mm)},
          {"direction_lps", row_major(facts.geometry.direction_patient)},
          {"value_range", std::array{facts.value_range.minimum, facts.value_range.maximum}},
          {"units", description.units},
          {"first_look", first_look_json(facts.findings)},
          {"warnings", description.warnings}};
}

void print_json(const Report& report, std::ostream& out) {
  OrderedJson document = {{"volumes", OrderedJson::array()}, {"refused", OrderedJson::array()}};
  for (const auto& facts : report.volumes) document["volumes"].push_back(to_json(facts));
  for (const auto& [path, reason] : report.refused) {
    document["refused"].push_back({{"path", path.string()}, {"reason", reason}});
  }
  out << document.dump(2, ' ', false, OrderedJson::error_handler_t::replace) << '\n';
}

void print_first_look(const Findings& findings, std::ostream& out) {
  const ValueRange& range = findings.robust.range;
  out << fmt::format("  kind       {}{}; {:.6g} to {:.6g} without strays and padding\n",
                     name_of(findings.kind), findings.has_contrast ? ", contrast medium" : "",
                     range.minimum, range.maximum)
      << fmt::format("  context    from {:.6g}: {}\n", findings.outer.value, findings.outer.from)
      << fmt::format("  focus      from {:.6g}: {}\n", findings.inner.value, findings.inner.from)
      << fmt::format("  extent     {:.4g} mm{}\n",
                     fmt::join(plain(findings.shape.extent_mm), " x "),
                     findings.shape.is_slab() ? ", seen along the shortest" : "");
  if (findings.body)
    out << fmt::format("  body       {:.0f} ml; couch and the like {:.0f} ml\n",
                       findings.body->body_ml, findings.body->removed_ml);
}

void print_lines(const Report& report, std::ostream& out) {
  for (const auto& facts : report.volumes) {
    const VolumeDescription& description = facts.description;
    const std::string modality = description.modality.empty() ? "" : ", " + description.modality;
    const std::string unit = description.units == "none" ? "" : " " + description.units;
    out << fmt::format("{}\n  title      {}\n  format     {}{}\n", printable(description.id),
                       printable(description.title), description.format, printable(modality))
        << fmt::format("  size       {} voxels\n", fmt::join(extents(facts), " x "))
        << fmt::format("  spacing    {:.6g} mm\n",
                       fmt::join(plain(facts.geometry.spacing_mm), " x "))
        << fmt::format("  origin     {:.6g} mm (LPS)\n",
                       fmt::join(plain(facts.geometry.origin_patient_mm), ", "))
        << fmt::format("  direction  {:.4g}\n",
                       fmt::join(row_major(facts.geometry.direction_patient), " "))
        << fmt::format("  values     {:.6g} to {:.6g}{}\n", facts.value_range.minimum,
                       facts.value_range.maximum, unit);
    print_first_look(facts.findings, out);
    for (const auto& warning : description.warnings)
      out << "  warning    " << printable(warning) << '\n';
  }
  for (const auto& [path, reason] : report.refused) {
    out << "refused " << printable(path.string()) << "\n  " << printable(reason) << '\n';
  }
  if (report.volumes.empty() && report.refused.empty()) out << "no volumes\n";
}

Facts facts_of(Volume volume) {
  Findings findings = find_out(volume, {});
  return {std::move(volume.description), volume.geometry, volume.value_range, std::move(findings)};
}

Report read_all(const Listing& listing, const InfoReaders& readers) {
  Report report{.volumes = {}, .refused = listing.refused};
  for (const auto& source : listing.volumes) {
    try {
      report.volumes.push_back(facts_of(readers.read(source)));
    } catch (const Error& error) {
      Error::Detail detail = error.detail();
      const fs::path path = detail.field.empty() ? source.files.front() : fs::path(detail.field);
      detail.field.clear();
      report.refused.push_back({path, Error(detail).what()});
    }
  }
  return report;
}

Report examine(const std::string& path, const InfoReaders& readers) {
  if (const auto phantom = parse_phantom_id(path)) {
    return {{facts_of(make_phantom(*phantom, {}, {}))}, {}};
  }
  if (!readers.scan) {
    throw Error({.code = ErrorCode::volume_refused,
                 .message = "this build reads no files",
                 .field = path,
                 .expected = "phantom:head, phantom:abdomen or phantom:knees"});
  }
  const NamedPath named = named_path(fs::absolute(path));
  return read_all(readers.scan(named.path, named.root), readers);
}

/// Of a file without a volume; empty where all is well.
std::string failure_of(const std::string& path, const Report& report) {
  std::error_code failed;
  if (!fs::is_regular_file(path, failed) || !report.volumes.empty()) return "";
  return path + ": " +
         (report.refused.empty() ? "no volume of a known format" : report.refused.front().reason);
}

}  // namespace

int run_info(const InfoRequest& request, const InfoReaders& readers, std::ostream& out,
             std::ostream& errors) {
  std::string failure;
  try {
    const Report report = examine(request.path, readers);
    request.as_json ? print_json(report, out) : print_lines(report, out);
    failure = out.flush() ? failure_of(request.path, report) : "the report cannot be written";
  } catch (const Error& error) {
    failure = error.what();
  }
  if (failure.empty()) return 0;
  errors << "cutaway info: " << printable(failure) << '\n';
  return 1;
}

}  // namespace cutaway
