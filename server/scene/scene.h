// What a frame shows, as checked values. The schema protocol/schema/scene.schema.json is the one
// place that says ranges, units and defaults; these types hold what has passed it and been resolved
// for a volume. What they begin with is nothing, and no default.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/value_band.h"
#include "scene/json.h"

namespace cutaway {

/// One entry of a registry (a shading model, a filter, a lens shape) with its parameters: every
/// parameter of its schema entry is present and in range, so whoever reads them needs no default.
struct Module {
  std::string name;
  Json parameters;  ///< object without "name"
  bool operator==(const Module&) const = default;
};

enum class Projection { perspective, orthographic };

/// Patient space, mm. The picture's right is direction x up.
struct Camera {
  Projection projection = Projection::perspective;
  glm::dvec3 eye_mm{0.0};
  glm::dvec3 target_mm{0.0};
  glm::dvec3 up{0.0};
  double vertical_fov_degrees = 0.0;  ///< perspective
  double view_height_mm = 0.0;        ///< orthographic: what the viewport's height spans
  bool operator==(const Camera&) const = default;
};

enum class ViewKind { volume, axial, coronal, sagittal };

struct Viewport {
  int width_px = 0;
  int height_px = 0;
  ViewKind kind = ViewKind::volume;
  bool operator==(const Viewport&) const = default;
};

/// The material that a branch draws.
struct Surface {
  ValueBand band;        ///< physical values
  double opacity = 0.0;  ///< of one millimetre; 1: opaque from its surface on
  bool operator==(const Surface&) const = default;
};

enum class NormalScale { fixed, automatic };
enum class Reconstruction { linear, cubic };

/// Where a surface's normals come from.
struct Normals {
  NormalScale scale = NormalScale::fixed;
  double scale_mm = 0.0;  ///< standard deviation of the Gaussian; 0: neighbouring voxels
  Reconstruction reconstruction = Reconstruction::linear;
  bool operator==(const Normals&) const = default;
};

/// Ambient light that is kept away.
struct Occlusion {
  double strength = 0.0;
  std::optional<double> range_mm;  ///< else what follows from the lens and the volume
  double near_share = 0.0;         ///< of a quarter of the range
  glm::dvec3 colour{0.0};
  bool operator==(const Occlusion&) const = default;
};

struct Shadow {
  double strength = 0.0;
  double softness_degrees = 0.0;
  bool operator==(const Shadow&) const = default;
};

/// What the volume goes through before it is drawn.
struct Preparation {
  bool hide_couch = false;
  bool fill_context = false;
  double focus_islands_ml = 0.0;
  double context_islands_ml = 0.0;
  bool operator==(const Preparation&) const = default;
};

/// One of the two ways in which a point of the volume can be drawn.
struct Branch {
  Surface surface;
  Module shading;
  Normals normals;
  Occlusion occlusion;
  Shadow shadow;
  std::vector<Module> filters;  ///< in the order they run
  bool operator==(const Branch&) const = default;
};

enum class LensMode { none, cutaway, magic };
/// Whether the cutaway goes on towards the eye.
enum class LensOpening { closed, funnel };
enum class LensCap { flat, gradient, open, section };

/// Of the cavity that the cutaway's lens makes.
struct Wall {
  double strength = 0.0;
  glm::dvec3 colour{0.0};
  double deepening = 0.0;
  double edge_mm = 0.0;
  glm::dvec3 edge_colour{0.0};
  bool operator==(const Wall&) const = default;
};

struct Lens {
  LensMode mode = LensMode::none;
  Module shape;
  glm::dvec3 centre_mm{0.0};
  double radius_mm = 0.0;
  LensOpening opening = LensOpening::closed;
  double funnel_degrees = 0.0;  ///< by how much its side leans away from the axis
  LensCap cap = LensCap::flat;
  Wall wall;
  double strength = 0.0;  ///< magic: the focus' share in the middle, 0..1
  double softness = 0.0;  ///< magic: share of the radius over which it fades out, 0..1
  bool strict = false;    ///< magic: the context fades where the focus is empty, too
  bool operator==(const Lens&) const = default;
};

enum class LightFrame { camera, patient };

struct Light {
  LightFrame frame = LightFrame::camera;
  glm::dvec3 direction{0.0};  ///< towards the light; camera frame: x right, y up, z to the viewer
  bool operator==(const Light&) const = default;
};

struct Background {
  glm::dvec3 colour{0.0};  ///< display-encoded sRGB, 0..1
  bool operator==(const Background&) const = default;
};

enum class SliceConvention { radiological, neurological };

/// Which physical values are drawn from black to white.
struct Window {
  double centre = 0.0;
  double width = 0.0;
  bool operator==(const Window&) const = default;
};

/// Which part of its plane a slice's viewport shows.
struct SliceView {
  glm::dvec3 centre_mm{0.0};
  std::optional<double> view_height_mm;  ///< else what shows the whole volume
  bool operator==(const SliceView&) const = default;
};

/// Three planes through one point, square to each other; patient space, mm.
struct Slices {
  glm::dvec3 crosshair_mm{0.0};
  glm::dvec3 superior{0.0};  ///< unit; normal of the axial plane
  glm::dvec3 anterior{0.0};  ///< unit, square to superior; normal of the coronal plane
  SliceConvention convention = SliceConvention::radiological;
  Window window;
  SliceView axial;
  SliceView coronal;
  SliceView sagittal;
  bool operator==(const Slices&) const = default;
};

/// Immutable once made; shared between threads as shared_ptr<const Scene>.
struct Scene {
  std::string volume;
  Viewport viewport;
  Camera camera;
  Preparation preparation;
  Branch focus;
  Branch context;
  Lens lens;
  Light light;
  Background background;
  Slices slices;
  bool operator==(const Scene&) const = default;
};

}  // namespace cutaway
