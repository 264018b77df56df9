// The pipeline: from a scene to pixels, stage by stage, each run only when what it reads has
// changed.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "render/composite_pass.h"
#include "render/convert_pass.h"
#include "render/entry_pass.h"
#include "render/filters/filter_pass.h"
#include "render/frame_plan.h"
#include "render/gpu_volume.h"
#include "render/light_pass.h"
#include "render/normals_pass.h"
#include "render/ray_cast_pass.h"
#include "render/render_settings.h"
#include "render/resolve_pass.h"
#include "render/shade_pass.h"
#include "render/slice_pass.h"
#include "render/stage.h"
#include "render/view_regions.h"

namespace cutaway {

/// Name of the pass that costs most.
inline constexpr const char* kRayCast = "ray cast";

/// How often each stage has run for a view: proof of what a change costs.
struct StageCounts {
  std::uint64_t entry = 0;
  std::uint64_t ray_cast = 0;
  std::array<std::uint64_t, kBranches> normals{};  ///< at a scale
  std::array<std::uint64_t, kBranches> light{};
  std::array<std::uint64_t, kBranches> shade{};
  std::array<std::uint64_t, kBranches> filters{};
  std::uint64_t composite = 0;
  std::uint64_t slice = 0;  ///< instead of all those before
  std::uint64_t convert = 0;
  bool operator==(const StageCounts&) const = default;
};

/// One view's buffers and what they show. Render thread only.
class ViewState {
 public:
  StageCounts counts() const;
  /// What its buffers take on the device.
  std::uint64_t bytes() const { return buffers_ ? buffers_->bytes() : 0; }

 private:
  friend class FramePipeline;
  struct Branch {
    Stage<NormalsKey> normals;
    Stage<LightKey> light;
    Stage<ShadeKey> shade;
    std::deque<Stage<FilterKey>> filters;  ///< stay where they are while a plan refers to them
  };
  std::optional<ViewBuffers> buffers_;
  ViewKind kind_ = ViewKind::volume;  ///< stages of another kind draw into the same picture
  Stage<EntryKey> entry_;
  Stage<RayCastKey> ray_cast_;
  std::array<Branch, kBranches> branches_;
  Stage<CompositeKey> composite_;
  Stage<SliceKey> slice_;
  Stage<ConvertKey> convert_;
};

/// Owns the programs. Render thread only.
class FramePipeline {
 public:
  FramePipeline();

  /// What has to be drawn for the scene to stand in the view's buffers, converted to the settings'
  /// layout. View and volume must outlive the plan, and there is one plan of a view at a time.
  FramePlan plan(ViewState& view, const Scene& scene, GpuVolume& volume,
                 const RenderSettings& settings);

  /// The same, drawn at once.
  void render(ViewState& view, const Scene& scene, GpuVolume& volume,
              const RenderSettings& settings) {
    plan(view, scene, volume, settings).finish();
  }

  /// Starts the transfer of what render drew.
  static void start_readback(const ViewState& view, PixelLayout layout,
                             gl::PixelReadback& readback);

  /// The surface buffers as they are, for tests: RGBA32F, rows top first, `surface_size_px` of
  /// supersampled rays.
  static std::vector<glm::vec4> read_surface(const ViewState& view, BranchIndex branch);
  static glm::ivec2 surface_size_px(const ViewState& view);
  /// The same with normals at a scale, where the branch asked for them.
  static std::vector<glm::vec4> read_calmed(const ViewState& view, BranchIndex branch);
  /// How much light comes to each pixel of a branch: x ambient, y direct. Of the picture's size.
  static std::vector<glm::vec4> read_reach(const ViewState& view, BranchIndex branch);
  /// A branch's colour before its filters: display-encoded, coverage. Of the picture's size.
  static std::vector<glm::vec4> read_shaded(const ViewState& view, BranchIndex branch);
  /// The same for the layers of translucent material: premultiplied colour and opacity.
  static std::vector<glm::vec4> read_layers(const ViewState& view, BranchIndex branch);

  void observe(PassObserver observer) { observer_ = std::move(observer); }

 private:
  /// What the parts of a plan have in common.
  struct Draft {
    ViewState& view;
    ViewBuffers& buffers;
    const RenderSettings& settings;
    ViewRegions regions;
    int viewport_height_px;
    ViewRays rays;
    FramePlan& plan;
  };
  /// A branch's last picture and how to know that it changed.
  struct BranchPicture {
    const gl::Texture2D* texture;
    std::uint64_t version;
  };
  std::uint64_t find_entries(const Draft& draft, const RayCastKey& rays, GpuVolume& volume);
  std::uint64_t cast_rays(const Draft& draft, const RayCastKey& key, GpuVolume& volume);
  /// A branch's surface and how to know that it changed.
  BranchPicture calm_normals(const Draft& draft, BranchIndex index, const NormalsKey& key,
                             const GpuVolume& volume);
  std::uint64_t reach_of_light(const Draft& draft, BranchIndex index, const LightKey& key,
                               const gl::Texture2D& surface, const GpuVolume& volume);
  BranchPicture shade_surface(const Draft& draft, BranchIndex index, const Scene& scene,
                              BranchPicture surface, const ViewRays& rays, const GpuVolume& volume);
  BranchPicture shade(const Draft& draft, BranchIndex index, const ShadeKey& key,
                      const gl::Texture2D& surface, const GpuVolume& volume);
  BranchPicture resolve(const Draft& draft, BranchIndex index, std::uint64_t layers_version);
  BranchPicture filter(const Draft& draft, BranchIndex index, const std::vector<Module>& filters,
                       BranchPicture picture, const gl::Texture2D& surface);
  std::vector<Pass> filter_steps(const Draft& draft, BranchIndex index, const FilterKey& key,
                                 const gl::Texture2D& input, const gl::Texture2D& surface,
                                 const ColourTarget& target);
  std::uint64_t composite(const Draft& draft, const CompositeKey& key);
  std::uint64_t picture_of_volume(ViewState& view, const Scene& scene, GpuVolume& volume,
                                  const RenderSettings& settings, FramePlan& plan);
  std::uint64_t picture_of_slice(ViewState& view, const Scene& scene, const GpuVolume& volume,
                                 const RenderSettings& settings, FramePlan& plan);
  void convert(ViewState& view, const ConvertKey& key, FramePlan& plan);

  gl::FullscreenTriangle triangle_;
  gl::ShaderLibrary shaders_;
  EntryPass entry_pass_;
  RayCastPass ray_cast_pass_;
  NormalsPass normals_pass_;
  LightPass light_pass_;
  ShadePass shade_pass_;
  ResolvePass resolve_pass_;
  FilterPass filter_pass_;
  CompositePass composite_pass_;
  SlicePass slice_pass_;
  ConvertPass convert_pass_;
  PassObserver observer_;
};

}  // namespace cutaway
