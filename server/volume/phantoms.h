// Procedural CT-like volumes in Hounsfield units: what runs without any file, and what tests run
// on.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "core/progress.h"
#include "volume/volume.h"

namespace cutaway {

enum class PhantomKind { head, abdomen, knees };

struct PhantomRequest {
  PhantomKind kind = PhantomKind::head;
  int size_voxels = 256;  ///< edge of the cubic grid, 32..512
};

/// "phantom:head", "phantom:head@128"; nothing where `id` does not begin with "phantom:". Throws
/// Error for an unknown name or a size outside 32..512.
std::optional<PhantomRequest> parse_phantom_id(std::string_view id);

std::string phantom_id(const PhantomRequest& request);

/// Title, modality, units and id, without computing a voxel.
VolumeDescription describe_phantom(const PhantomRequest& request);
VolumeGeometry phantom_geometry(const PhantomRequest& request);

/// Deterministic: the same request gives the same bytes on every machine and with any number of
/// threads (by default one per core). Progress is that of LoadStage::decode. Throws Error for a
/// size outside 32..512, Cancelled.
Volume make_phantom(const PhantomRequest& request, const ProgressSink& progress,
                    std::stop_token stop);
Volume make_phantom(const PhantomRequest& request, const ProgressSink& progress,
                    std::stop_token stop, int threads);

}  // namespace cutaway
