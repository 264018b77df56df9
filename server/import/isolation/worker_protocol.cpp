#include "import/isolation/worker_protocol.h"

#include <cmath>
#include <utility>

#include "import/refusal.h"

namespace cutaway::reading {

namespace {

[[noreturn]] void refuse_report(const std::string& field) {
  throw Error({.code = ErrorCode::volume_refused,
               .message = "a reader's report is not usable",
               .field = field});
}

Json numbers(glm::dvec3 v) { return {v.x, v.y, v.z}; }

double finite_number(const Json& json) {
  const double value = json.get<double>();
  if (!std::isfinite(value)) refuse_report("number");
  return value;
}

glm::dvec3 vector_from(const Json& json) {
  return {finite_number(json.at(0)), finite_number(json.at(1)), finite_number(json.at(2))};
}

Json to_json(const VolumeDescription& description) {
  Json json = {{"id", description.id},         {"title", description.title},
               {"format", description.format}, {"modality", description.modality},
               {"units", description.units},   {"warnings", description.warnings}};
  if (description.window)
    json["window"] = {description.window->minimum, description.window->maximum};
  return json;
}

std::optional<ValueRange> window_from(const Json& description) {
  if (!description.contains("window")) return std::nullopt;
  const Json& window = description.at("window");
  const ValueRange range{finite_number(window.at(0)), finite_number(window.at(1))};
  if (!(range.maximum > range.minimum)) refuse_report("window");
  return range;
}

VolumeDescription description_from(const Json& json) {
  return {json.at("id"),     json.at("title"),
          json.at("format"), json.at("modality"),
          json.at("units"),  json.at("warnings").get<std::vector<std::string>>(),
          window_from(json)};
}

Json to_json(const VolumeGeometry& geometry) {
  const glm::ivec3 size = geometry.size_voxels;
  return {{"size", {size.x, size.y, size.z}},
          {"spacing", numbers(geometry.spacing_mm)},
          {"origin", numbers(geometry.origin_patient_mm)},
          {"axes",
           {numbers(geometry.direction_patient[0]), numbers(geometry.direction_patient[1]),
            numbers(geometry.direction_patient[2])}}};
}

VolumeGeometry geometry_from(const Json& json) {
  VolumeGeometry geometry;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    geometry.size_voxels[axis] = json.at("size").at(i);
    geometry.direction_patient[axis] = vector_from(json.at("axes").at(i));
    if (geometry.size_voxels[axis] < 1 || geometry.size_voxels[axis] > 32768) refuse_report("size");
  }
  geometry.spacing_mm = vector_from(json.at("spacing"));
  geometry.origin_patient_mm = vector_from(json.at("origin"));
  if (glm::any(glm::lessThanEqual(geometry.spacing_mm, glm::dvec3(0.0)))) refuse_report("spacing");
  if (!is_within_reach(geometry)) refuse_report("origin");
  return geometry;
}

}  // namespace

NLOHMANN_JSON_SERIALIZE_ENUM(ScanTask, {{ScanTask::list, "list"},
                                        {ScanTask::list_opened, "list_opened"},
                                        {ScanTask::try_out, "try_out"}})

Json to_json(const ScanJob& job) {
  Json json = {{"scan", job.path.string()}, {"root", job.root.string()},
               {"task", job.task},          {"volume_bytes", job.volume_bytes},
               {"given_up", Json::array()}, {"opened", Json::array()}};
  for (const auto& [file, reason] : job.given_up) {
    json["given_up"].push_back({file.string(), reason});
  }
  for (const auto& file : job.opened) json["opened"].push_back(file.string());
  if (job.dicom_refused) json["dicom_refused"] = *job.dicom_refused;
  return json;
}

ScanJob scan_job_from(const Json& json) {
  ScanJob job;
  job.path = json.at("scan").get<std::string>();
  job.root = json.at("root").get<std::string>();
  job.volume_bytes = json.at("volume_bytes");
  job.task = json.at("task");
  for (const auto& file : json.at("given_up")) {
    job.given_up.emplace(file.at(0).get<std::string>(), file.at(1));
  }
  for (auto& file : paths_from(json.at("opened"))) job.opened.insert(std::move(file));
  if (json.contains("dicom_refused")) job.dicom_refused = json.at("dicom_refused");
  return job;
}

Json to_json(const VolumeSource& source) {
  Json files = Json::array();
  for (const auto& file : source.files) files.push_back(file.string());
  return {{"description", to_json(source.description)},
          {"geometry", to_json(source.geometry)},
          {"files", files},
          {"part", source.part},
          {"decode_bytes", source.decode_bytes}};
}

VolumeSource source_from(const Json& json) {
  return {description_from(json.at("description")), geometry_from(json.at("geometry")),
          paths_from(json.at("files")), json.at("part"), json.at("decode_bytes")};
}

Json to_json(const Listing& listing) {
  Json json = {{"volumes", Json::array()}, {"refused", Json::array()}};
  for (const auto& source : listing.volumes) json["volumes"].push_back(to_json(source));
  for (const auto& [path, reason] : listing.refused)
    json["refused"].push_back({path.string(), reason});
  return json;
}

Listing listing_from(const Json& json) {
  Listing listing;
  for (const auto& source : json.at("volumes")) {
    listing.volumes.push_back(source_from(source));
    if (listing.volumes.back().files.empty()) refuse_report("files");
  }
  for (const auto& refused : json.at("refused")) {
    listing.refused.push_back(
        {refused.at(0).get<std::string>(), quoted_briefly(refused.at(1), kLongestReason)});
  }
  return listing;
}

Json to_json(const Error& error) {
  const Error::Detail& detail = error.detail();
  return {std::string(code_word(detail.code)), detail.message, detail.field, detail.expected,
          detail.received};
}

Error error_from(const Json& json) {
  const auto code = error_code_from(json.at(0).get_ref<const std::string&>());
  if (!code) refuse_report("code");
  return Error({*code, json.at(1), json.at(2), json.at(3), json.at(4)});
}

Json to_json(const VolumeHead& head) {
  const Volume& volume = head.volume;
  Json json = {{"description", to_json(volume.description)},
               {"geometry", to_json(volume.geometry)},
               {"float", head.is_float},
               {"scale", volume.value_scale},
               {"offset", volume.value_offset},
               {"range", {volume.value_range.minimum, volume.value_range.maximum}}};
  if (volume.nothing_value) json["nothing"] = *volume.nothing_value;
  return json;
}

VolumeHead volume_head_from(const Json& json) {
  VolumeHead head;
  head.volume.description = description_from(json.at("description"));
  head.volume.geometry = geometry_from(json.at("geometry"));
  head.is_float = json.at("float");
  head.volume.value_scale = finite_number(json.at("scale"));
  head.volume.value_offset = finite_number(json.at("offset"));
  head.volume.value_range = {finite_number(json.at("range").at(0)),
                             finite_number(json.at("range").at(1))};
  if (json.contains("nothing")) head.volume.nothing_value = finite_number(json.at("nothing"));
  if (head.volume.value_scale <= 0) refuse_report("scale");
  return head;
}

Json progress_report(LoadStage stage, double fraction) { return {name_of(stage), fraction}; }

std::pair<LoadStage, double> progress_from(const Json& json) {
  for (std::size_t stage = 0; stage < kLoadStageNames.size(); ++stage) {
    if (json.at(0) != kLoadStageNames.at(stage)) continue;
    return {static_cast<LoadStage>(stage), finite_number(json.at(1))};
  }
  refuse_report("stage");
}

std::vector<std::filesystem::path> paths_from(const Json& json) {
  std::vector<std::filesystem::path> paths;
  for (const auto& path : json) paths.emplace_back(path.get<std::string>());
  return paths;
}

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace cutaway::reading
