#include "gl/gpu_timer.h"

namespace cutaway::gl {

namespace {

QueryHandle create_timestamp() {
  GLuint name = 0;
  glCreateQueries(GL_TIMESTAMP, 1, &name);
  return QueryHandle(name);
}

std::uint64_t result(const QueryHandle& query) {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &nanoseconds);
  return nanoseconds;
}

}  // namespace

GpuTimer::GpuTimer() : begin_(create_timestamp()), end_(create_timestamp()) {}

void GpuTimer::begin() const { glQueryCounter(begin_.name(), GL_TIMESTAMP); }
void GpuTimer::end() const { glQueryCounter(end_.name(), GL_TIMESTAMP); }
std::uint64_t GpuTimer::elapsed_ns() const { return result(end_) - result(begin_); }

}  // namespace cutaway::gl
