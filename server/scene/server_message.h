// What the server sends as text: builders of the messages that protocol/README.md lists. Send them
// as json_text().
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "scene/client_message.h"
#include "scene/scene.h"

namespace cutaway {

inline constexpr const char* kSubprotocol = "cutaway.v1";

/// What a client is told not to go beyond.
struct WireLimits {
  std::int64_t message_bytes = 65536;
  std::int64_t viewport_pixels = 16777216;
  int viewport_side_px = 8192;
  int still_side_px = 8192;
  int frames_in_flight = 2;
};

struct ServerDescription {
  std::string server;    ///< name and version
  std::string renderer;  ///< for people
  bool software_renderer = false;
  WireLimits limits;
  std::string notice;
};

/// With the modules of the schemas and the styles that the program carries.
Json capabilities_message(const ServerDescription& description);

/// `place` 1 is the next to get a session.
Json queued_message(int place);

/// `listing` is {"volumes": [...], "refused": [...], "scanning": false}.
Json volumes_message(const Json& listing);

enum class LoadEnd { ready, cancelled, failed };
Json loading_message(const std::string& volume, LoadStage stage, double fraction);
Json loading_message(const std::string& volume, LoadEnd end);

/// `input`: of the newest message that the scene contains.
Json scene_message(std::uint32_t revision, std::uint32_t input, const Scene& scene);
/// After a volume was opened; `volume` is its summary.
Json scene_message(std::uint32_t revision, std::uint32_t input, const Scene& scene,
                   const Json& volume);

enum class PictureBranch { focus, context };
struct PickedPoint {
  glm::dvec3 position_mm{0.0};
  double value = 0.0;
  std::string units;
  std::optional<PictureBranch> branch;  ///< none on a slice
};
Json picked_message(std::uint32_t request, const std::optional<PickedPoint>& point);

enum class UnseenCode {
  volume_empty,
  above_all_values,
  below_all_values,
  fills_the_volume,
  transparent,
  lens_covered,
  lens_empty
};
/// Why a picture shows nothing where something is expected; fields as in the schema.
struct UnseenReason {
  UnseenCode code = UnseenCode::volume_empty;
  std::optional<PictureBranch> branch = {};
  std::optional<double> value = {};
  std::optional<double> limit = {};
  bool operator==(const UnseenReason&) const = default;
};
/// An empty list says that what was told before is over.
Json unseen_message(const std::vector<UnseenReason>& reasons);

Json error_message(const Error& error, const MessageEcho& echo = {});

}  // namespace cutaway
