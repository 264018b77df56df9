// The figures as a table while they come, and as JSON at the end.
#pragma once

#include <cstdio>
#include <string>

#include "benchmark/frame_timing.h"
#include "benchmark/jpeg_timing.h"
#include "benchmark/machine.h"
#include "scene/json.h"

namespace cutaway::benchmark {

class Report {
 public:
  explicit Report(const Machine& machine);

  /// Prints what every row that follows belongs to.
  void begin_volume(const std::string& name, const Volume& volume);
  void begin_size(Viewport size);
  void add(const std::string& case_name, const FrameTime& time);
  void add_jpeg(const Picture& picture, int quality, const std::vector<JpegRate>& rates);

  const Json& json() const { return json_; }

 private:
  Json json_;
  std::string volume_;
  glm::ivec3 size_voxels_{0};
  Viewport size_;
};

}  // namespace cutaway::benchmark
