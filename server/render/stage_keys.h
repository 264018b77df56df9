// What of a scene the stages read: the keys by which they know that nothing has changed.
#pragma once

#include <array>
#include <optional>

#include "render/composite_pass.h"
#include "render/gpu_volume.h"
#include "render/light_pass.h"
#include "render/normals_pass.h"
#include "render/ray_cast_pass.h"
#include "render/render_settings.h"
#include "scene/scene.h"

namespace cutaway {

/// Without the entry's version.
RayCastKey ray_cast_key(const Scene& scene, const GpuVolume& volume,
                        const RenderSettings& settings);

std::array<LitShading, kBranches> lit_shadings(const Scene& scene);

/// Nothing where neighbouring voxels are all that is asked for.
std::optional<NormalsKey> normals_key(const Scene& scene, BranchIndex index, const RayCastKey& rays,
                                      std::uint64_t surface_version, const GpuVolume& volume);

/// Asks for nothing where the branch is drawn without it.
LightKey light_key(const Scene& scene, BranchIndex index, const ViewRays& rays,
                   std::uint64_t surface_version, const GpuVolume& volume, LightQuality quality);

Relief relief_of(const Scene& scene, BranchIndex index, std::uint64_t reach_version);

/// Nothing where the wall is drawn like the rest of the context.
std::optional<CavityWall> cavity_wall(const Scene& scene);

/// Nothing where the lens is another one.
std::optional<MagicLens> magic_lens(const Scene& scene, const ViewRays& rays);

/// What the steps of the scene's filters hand on in.
WorkNeeds work_needs(const Scene& scene, double resolution_scale);

/// Of the buffers in which such a picture of the scene is drawn.
BufferNeeds needs_of(const Scene& scene, const RenderSettings& settings);

/// By how much a tile must be larger on each side for what its filters read beside it: what lies
/// further in is as in the whole picture.
int tile_margin_px(const Scene& scene);

}  // namespace cutaway
