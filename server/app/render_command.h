// `cutaway render`: one picture, without a network.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace cutaway {

struct RenderCommand {
  std::string scene_path;  ///< a scene or style document
  std::string output_path;
  std::optional<std::string> volume;  ///< a phantom, file or folder; else what the document names
  std::optional<Viewport> size;       ///< else the document's
  int supersampling = 2;              ///< rays a pixel each way
  bool require_gpu = false;
};

/// Throws Error; writes the PNG only when all went well.
void run_render(const RenderCommand& command);

}  // namespace cutaway
