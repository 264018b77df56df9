// Normals under a Gaussian and of the cubic reconstruction for the reference renderer: from what
// they are, not from where the renderer samples them.
#pragma once

#include "scene/scene.h"
#include "scene/view_geometry.h"
#include "support/reference_ray.h"
#include "volume/volume.h"

namespace cutaway::reference {

/// Standard deviation of the Gaussian that a branch asks for, mm; 0: none.
double gaussian_mm(const Normals& normals, BranchName branch, const VolumeGeometry& geometry);

/// Whether a branch's hits are not what the ray cast leaves.
bool asks_for_other_normals(const Normals& normals);

/// The hit with the place and the normal that the branch asks for; a cut's face keeps its own.
SurfaceHit calmed(const SurfaceHit& hit, const Branch& branch, BranchName name,
                  const Volume& volume, const ViewRay& ray);

}  // namespace cutaway::reference
