// An OpenGL 4.5 core context without any display.
#pragma once

#include <epoxy/egl.h>

#include <memory>
#include <string>

namespace cutaway::gl {

struct ContextOptions {
  bool require_gpu = false;   ///< refuse software renderers
  bool debug_output = false;  ///< GL's own errors become check failures
};

/// Robust (a lost device is told, not undefined), surfaceless, current on the thread that made it
/// and used there only. Devices are tried in EGL's order, hardware before software; Mesa's
/// surfaceless platform comes last.
class Context {
 public:
  /// Throws StartUpError (renderer_unavailable) saying what each device answered.
  static std::unique_ptr<Context> create(const ContextOptions& options);

  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  const std::string& renderer() const { return renderer_; }  ///< GL_RENDERER
  const std::string& version() const { return version_; }    ///< GL_VERSION
  bool is_software() const { return software_; }
  int max_3d_texture_size() const { return max_3d_texture_size_; }
  /// Of a picture's texture, and of what is drawn into it.
  int max_texture_size() const { return max_texture_size_; }

  /// True once the device was lost; nothing made in this context works any more.
  bool is_lost() const;

 private:
  Context(EGLDisplay display, EGLContext context);
  EGLDisplay display_;
  EGLContext context_;
  std::string renderer_;
  std::string version_;
  bool software_ = false;
  int max_3d_texture_size_ = 0;
  int max_texture_size_ = 0;
};

}  // namespace cutaway::gl
