// The client's wish for a lossless picture of its scene, of a size of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "session/ends.h"
#include "session/frame_flow.h"

namespace cutaway {

/// One still at a time, in a view of its own, beside the live frames and their credits. Lives on
/// the session's strand.
class StillSaver {
 public:
  struct Wish {
    std::uint32_t request = 0;
    Viewport size;
  };

  /// `failed` hears of a still that could not be rendered, with its request.
  StillSaver(std::shared_ptr<Strand> strand, FrameSource& source, ClientSink& sink,
             std::uint64_t view, std::function<void(std::uint32_t, const Error&)> failed);
  ~StillSaver();
  StillSaver(const StillSaver&) = delete;
  StillSaver& operator=(const StillSaver&) = delete;

  /// Throws Error while another is under way.
  void save(const Wish& wish, const SceneSnapshot& snapshot, const FrameQuality& quality);

 private:
  void came_back(std::uint32_t request, const SceneSnapshot& shown, FrameOutcome outcome);

  FrameSource& source_;
  ClientSink& sink_;
  std::uint64_t view_;
  std::function<void(std::uint32_t, const Error&)> failed_;
  bool busy_ = false;
  Tether tether_;
};

}  // namespace cutaway
