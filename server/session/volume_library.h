// Where a session's volumes come from.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "core/error.h"
#include "core/progress.h"
#include "scene/json.h"
#include "scene/scene.h"
#include "scene/volume_facts.h"

namespace cutaway {
/// A volume that is in memory, held for as long as the session shows it. Thread-safe.
class OpenVolume {
 public:
  virtual ~OpenVolume() = default;
  virtual const VolumeFacts& facts() const = 0;
  /// Of the volume as the scene has it prepared.
  virtual SurfaceProbe probe(const Scene& /*scene*/) const { return facts().first_surface_mm; }
  /// Of the physical values: "HU" or "none".
  virtual const std::string& units() const = 0;
  /// The `volume` part of the `scene` message: geometry, value range, histogram.
  virtual const Json& summary() const = 0;
  /// Physical value at a patient position (trilinear); nothing outside of the grid.
  virtual std::optional<double> value_at(glm::dvec3 position_mm) const = 0;
  /// The same to the faces of the outermost voxels, half a voxel farther, where their value is it.
  virtual std::optional<double> value_to_the_faces(glm::dvec3 position_mm) const = 0;
};

using OpenOutcome = std::variant<std::shared_ptr<const OpenVolume>, Error, Cancelled>;

/// Wanting a volume: destroying it withdraws the wish (and cancels the load when nobody else waits
/// for it).
class OpenTicket {
 public:
  virtual ~OpenTicket() = default;
};

/// Thread-safe. Callbacks come from any thread, never from inside open; none comes after the ticket
/// is destroyed.
class VolumeLibrary {
 public:
  virtual ~VolumeLibrary() = default;
  /// The `volumes` message's content: what can be opened and what was refused.
  virtual Json listing() const = 0;
  /// `changed` is called when the listing has changed (a scan found more). Ends with the ticket.
  virtual std::unique_ptr<OpenTicket> watch(std::function<void()> changed) = 0;
  virtual std::unique_ptr<OpenTicket> open(const std::string& id, ProgressSink progress,
                                           std::function<void(OpenOutcome)> done) = 0;
  /// The same for a small picture of it: behind what anyone wants to see.
  virtual std::unique_ptr<OpenTicket> open_for_preview(const std::string& id,
                                                       std::function<void(OpenOutcome)> done) = 0;
  /// Makes the volume of a scene as the scene has it prepared, where it is in memory and has not
  /// been made: `ready` is called once frames show it so. Null where there is nothing to wait for.
  virtual std::unique_ptr<OpenTicket> prepare(const Scene& scene, std::function<void()> ready) = 0;
};

}  // namespace cutaway
