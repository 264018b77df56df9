#include "render/empty_space.h"

#include <algorithm>
#include <span>

#include "volume/brick_faces.h"

namespace cutaway {

namespace {

constexpr std::size_t kKeptMaps = 16;

gl::Texture3D distance_texture(glm::ivec3 size, const std::vector<std::uint8_t>& context,
                               const std::vector<std::uint8_t>& focus) {
  std::vector<std::uint8_t> both(context.size() * 2);
  for (std::size_t i = 0; i < context.size(); ++i) {
    both[2 * i] = context[i];
    both[2 * i + 1] = focus[i];
  }
  gl::Texture3D texture(GL_RG8UI, size, gl::Filtering::nearest);
  texture.upload_slices(0, size.z, std::as_bytes(std::span(both)));
  return texture;
}

BlockGrid filled_blocks(glm::ivec3 size, const std::vector<std::uint8_t>& context,
                        const std::vector<std::uint8_t>& focus) {
  std::vector<bool> filled(context.size());
  for (std::size_t i = 0; i < filled.size(); ++i) filled[i] = context[i] == 0 || focus[i] == 0;
  return block_grid(size, filled);
}

void upload_faces(const std::vector<BlockCorner>& corners, EmptySpaceMaps& maps) {
  GLuint buffer = 0;
  GLuint array = 0;
  glCreateBuffers(1, &buffer);
  maps.corners = gl::BufferHandle(buffer);
  glCreateVertexArrays(1, &array);
  maps.faces = gl::VertexArrayHandle(array);
  maps.corner_count = static_cast<int>(corners.size());
  if (corners.empty()) return;
  glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(corners.size() * sizeof(BlockCorner)),
                       corners.data(), 0);
  glVertexArrayVertexBuffer(array, 0, buffer, 0, sizeof(BlockCorner));
  glVertexArrayAttribIFormat(array, 0, 4, GL_UNSIGNED_BYTE, 0);
  glVertexArrayAttribBinding(array, 0, 0);
  glEnableVertexArrayAttrib(array, 0);
}

EmptySpaceMaps make_maps(const MinMaxGrid& grid, glm::ivec3 size_voxels, const ValueBand& context,
                         const ValueBand& focus) {
  const auto of_context = chebyshev_distance_map(grid, context);
  const auto of_focus = chebyshev_distance_map(grid, focus);
  EmptySpaceMaps maps{.context = context, .focus = focus};
  maps.distances = distance_texture(grid.size_bricks, of_context, of_focus);
  maps.occupied = box_of_bricks(
      grid, size_voxels, [&](std::size_t at) { return of_context[at] == 0 || of_focus[at] == 0; });
  const BlockGrid blocks = filled_blocks(grid.size_bricks, of_context, of_focus);
  maps.block_cells = blocks.block_bricks * grid.brick_size;
  upload_faces(block_faces(blocks), maps);
  return maps;
}

}  // namespace

const EmptySpaceMaps& EmptySpace::maps(const MinMaxGrid& grid, glm::ivec3 size_voxels,
                                       const ValueBand& context, const ValueBand& focus) {
  const auto known = std::ranges::find_if(kept_, [&](const EmptySpaceMaps& maps) {
    return maps.context == context && maps.focus == focus;
  });
  if (known != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, known);
    return kept_.front();
  }
  kept_.push_front(make_maps(grid, size_voxels, context, focus));
  if (kept_.size() > kKeptMaps) kept_.pop_back();
  return kept_.front();
}

}  // namespace cutaway
