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

/// Adults of average measures, contrast medium in the arteries (about 350 HU). Each says, besides
/// asymmetric anatomy, what tells left (+x) from right.
enum class PhantomKind {
  head,     ///< a metal earring in the left lobe, about (77, 10, -28) mm; larger left frontal sinus
  abdomen,  ///< liver on the right, spleen and stomach on the left; the right kidney lies lower
  knees  ///< a bone cyst in the left tibia only, about (85, 6, -34) mm; fibulae on the outer sides
};

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
                    const std::stop_token& stop);
Volume make_phantom(const PhantomRequest& request, const ProgressSink& progress,
                    const std::stop_token& stop, int threads);

}  // namespace cutaway
