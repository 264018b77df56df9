#include "volume/phantoms.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "volume/parallel.h"
#include "volume/phantom/voxelise.h"

namespace cutaway {

namespace {

constexpr std::string_view kPrefix = "phantom:";
constexpr int kSmallest = 32;
constexpr int kLargest = 512;
constexpr int kDefault = PhantomRequest{}.size_voxels;

struct Kind {
  PhantomKind kind;
  std::string_view name;
  std::string_view title;
  double edge_mm;  ///< of the cube that the voxels fill
  phantom::Layers (*layers)();
};

constexpr std::array kKinds = {
    Kind{PhantomKind::head, "head", "Head phantom", 280.0, phantom::head_layers},
    Kind{PhantomKind::abdomen, "abdomen", "Abdomen phantom", 400.0, phantom::abdomen_layers},
    Kind{PhantomKind::knees, "knees", "Knees phantom", 280.0, phantom::knees_layers},
};

const Kind& kind_of(const PhantomRequest& request) { return kKinds[std::size_t(request.kind)]; }

PhantomKind parse_kind(std::string_view id, std::string_view name) {
  const auto kind = std::find_if(kKinds.begin(), kKinds.end(),
                                 [name](const Kind& candidate) { return candidate.name == name; });
  if (kind != kKinds.end()) return kind->kind;
  throw Error({.code = ErrorCode::unknown_volume,
               .message = "there is no such phantom",
               .expected = "phantom:head, phantom:abdomen or phantom:knees",
               .received = std::string(id)});
}

[[noreturn]] void refuse_size(std::string_view received) {
  throw Error({.code = ErrorCode::out_of_range,
               .message = "a phantom of this size cannot be made",
               .expected = std::to_string(kSmallest) + " to " + std::to_string(kLargest) +
                           " voxels an edge",
               .received = std::string(received)});
}

int parse_size(std::string_view text) {
  int size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  if (!is_number || size < kSmallest || size > kLargest) refuse_size(text);
  return size;
}

void require_size(const PhantomRequest& request) {
  const int size = request.size_voxels;
  if (size < kSmallest || size > kLargest) refuse_size(std::to_string(size));
}

}  // namespace

std::optional<PhantomRequest> parse_phantom_id(std::string_view id) {
  if (!id.starts_with(kPrefix)) return std::nullopt;
  const std::string_view rest = id.substr(kPrefix.size());
  const std::size_t at = rest.find('@');
  PhantomRequest request{.kind = parse_kind(id, rest.substr(0, at))};
  if (at != std::string_view::npos) request.size_voxels = parse_size(rest.substr(at + 1));
  return request;
}

std::string phantom_id(const PhantomRequest& request) {
  std::string id = std::string(kPrefix) + std::string(kind_of(request).name);
  if (request.size_voxels == kDefault) return id;
  return id + "@" + std::to_string(request.size_voxels);
}

VolumeDescription describe_phantom(const PhantomRequest& request) {
  return {.id = phantom_id(request),
          .title = std::string(kind_of(request).title),
          .format = "phantom",
          .modality = "CT",
          .units = "HU",
          .warnings = {}};
}

VolumeGeometry phantom_geometry(const PhantomRequest& request) {
  require_size(request);
  const double spacing_mm = kind_of(request).edge_mm / request.size_voxels;
  return {.size_voxels = glm::ivec3(request.size_voxels),
          .spacing_mm = glm::dvec3(spacing_mm),
          .origin_patient_mm = glm::dvec3(-0.5 * spacing_mm * (request.size_voxels - 1)),
          .direction_patient = glm::dmat3(1.0)};
}

Volume make_phantom(const PhantomRequest& request, const ProgressSink& progress,
                    const std::stop_token& stop) {
  return make_phantom(request, progress, stop, default_thread_count());
}

Volume make_phantom(const PhantomRequest& request, const ProgressSink& progress,
                    const std::stop_token& stop, int threads) {
  Volume volume;
  volume.description = describe_phantom(request);
  volume.geometry = phantom_geometry(request);
  const auto report = [&](double fraction) {
    if (progress) progress(LoadStage::decode, fraction);
  };
  std::vector<std::uint16_t> stored = phantom::voxelise(
      kind_of(request).layers(),
      {.geometry = volume.geometry, .threads = threads, .progress = report}, stop);
  const auto [smallest, largest] = std::minmax_element(stored.begin(), stored.end());
  volume.value_offset = -phantom::kStoredOffsetHu;
  volume.value_range = {*smallest + volume.value_offset, *largest + volume.value_offset};
  volume.voxels = std::move(stored);
  return volume;
}

}  // namespace cutaway
