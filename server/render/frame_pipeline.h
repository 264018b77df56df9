// The pipeline: from a scene to pixels, stage by stage, each run only when what it reads has
// changed.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "render/composite_pass.h"
#include "render/convert_pass.h"
#include "render/filters/filter_pass.h"
#include "render/gpu_volume.h"
#include "render/ray_cast_pass.h"
#include "render/render_settings.h"
#include "render/resolve_pass.h"
#include "render/shade_pass.h"
#include "render/stage.h"
#include "render/view_regions.h"

namespace cutaway {

/// How often each stage has run for a view: proof of what a change costs.
struct StageCounts {
  std::uint64_t ray_cast = 0;
  std::array<std::uint64_t, kBranches> shade{};
  std::array<std::uint64_t, kBranches> filters{};
  std::uint64_t composite = 0;
  bool operator==(const StageCounts&) const = default;
};

/// One view's buffers and what they show. Render thread only.
class ViewState {
 public:
  StageCounts counts() const;

 private:
  friend class FramePipeline;
  struct Branch {
    Stage<ShadeKey> shade;
    std::vector<Stage<FilterKey>> filters;
  };
  /// A branch's last picture and how to know that it changed.
  struct BranchPicture {
    const gl::Texture2D* texture;
    std::uint64_t version;
  };
  std::optional<ViewBuffers> buffers_;
  Stage<RayCastKey> ray_cast_;
  std::array<Branch, kBranches> branches_;
  Stage<CompositeKey> composite_;
};

/// Called after each stage that ran, with its name; measuring only.
using StageObserver = std::function<void(const char* stage)>;

/// Owns the programs. Render thread only.
class FramePipeline {
 public:
  FramePipeline();

  /// Draws the scene into the view's buffers and converts it to the settings' layout.
  void render(ViewState& view, const Scene& scene, GpuVolume& volume,
              const RenderSettings& settings);

  /// Starts the transfer of what render drew.
  static void start_readback(const ViewState& view, PixelLayout layout,
                             gl::PixelReadback& readback);

  /// The surface buffers as they are, for tests: RGBA32F, rows top first, `surface_size_px` of
  /// supersampled rays.
  static std::vector<glm::vec4> read_surface(const ViewState& view, BranchIndex branch);
  static glm::ivec2 surface_size_px(const ViewState& view);
  /// The same for the layers of translucent material: premultiplied colour and opacity.
  static std::vector<glm::vec4> read_layers(const ViewState& view, BranchIndex branch);

  void observe(StageObserver observer) { observer_ = std::move(observer); }

 private:
  /// Where a branch's stages draw, and how.
  struct Target {
    gl::PixelRect region;
    const RenderSettings& settings;
  };
  std::uint64_t cast_rays(ViewState& view, const RayCastKey& key, GpuVolume& volume,
                          const gl::PixelRect& region);
  ViewState::BranchPicture shade(ViewState& view, BranchIndex index, const ShadeKey& key,
                                 const Target& target);
  ViewState::BranchPicture resolve(ViewState& view, BranchIndex index, std::uint64_t layers_version,
                                   const Target& target);
  ViewState::BranchPicture filter(ViewState& view, BranchIndex index,
                                  const std::vector<Module>& filters,
                                  ViewState::BranchPicture picture, const Target& target);
  void composite(ViewState& view, const CompositeKey& key);
  void convert(ViewState& view, PixelLayout layout);
  void ran(const char* stage) const;

  gl::FullscreenTriangle triangle_;
  gl::ShaderLibrary shaders_;
  RayCastPass ray_cast_pass_;
  ShadePass shade_pass_;
  ResolvePass resolve_pass_;
  FilterPass filter_pass_;
  CompositePass composite_pass_;
  ConvertPass convert_pass_;
  StageObserver observer_;
};

}  // namespace cutaway
