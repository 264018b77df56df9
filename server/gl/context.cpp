#include "gl/context.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <thread>

#include "core/log.h"
#include "core/start_up_error.h"
#include "core/threads.h"
#include "gl/context_display.h"
#include "gl/debug_output.h"
#include "gl/driver_faults.h"

namespace cutaway::gl {

namespace {

EGLConfig choose_config(EGLDisplay display) {
  // Without EGL_PBUFFER_BIT the default asks for windows, which a display-less machine has none of.
  const std::array attributes{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                              EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  const bool found =
      eglChooseConfig(display, attributes.data(), &config, 1, &count) == EGL_TRUE && count > 0;
  return found ? config : nullptr;
}

EGLContext create_egl_context(EGLDisplay display, bool debug) {
  const EGLConfig config = choose_config(display);
  if (config == nullptr || eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return EGL_NO_CONTEXT;
  const std::array attributes{EGL_CONTEXT_MAJOR_VERSION,
                              4,
                              EGL_CONTEXT_MINOR_VERSION,
                              5,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_CONTEXT_OPENGL_DEBUG,
                              debug ? EGL_TRUE : EGL_FALSE,
                              EGL_CONTEXT_OPENGL_ROBUST_ACCESS,
                              EGL_TRUE,
                              EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                              EGL_LOSE_CONTEXT_ON_RESET,
                              EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

bool names_software(const std::string& renderer) {
  for (const char* word : {"llvmpipe", "softpipe", "swrast", "SwiftShader", "Software"}) {
    if (renderer.find(word) != std::string::npos) return true;
  }
  return false;
}

/// Mesa's software renderer has two pools, of a thread a core each up to 32, and some more threads
/// for its cache of programs.
int most_driver_threads() {
  constexpr int kLargestPool = 32;
  constexpr int kOthers = 4;
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  return 2 * std::clamp(cores, 1, kLargestPool) + kOthers;
}

std::string gl_string(GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); }

}  // namespace

Context::Context(EGLDisplay display, EGLContext context) : display_(display), context_(context) {
  renderer_ = gl_string(GL_RENDERER);
  version_ = gl_string(GL_VERSION);
  software_ = names_software(renderer_);
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &max_3d_texture_size_);
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max_texture_size_);
  std::array<GLint, 2> viewport{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  max_texture_size_ = std::min({max_texture_size_, viewport[0], viewport[1]});
}

Context::~Context() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

bool Context::is_lost() const { return glGetGraphicsResetStatus() != GL_NO_ERROR; }

std::unique_ptr<Context> Context::create(const ContextOptions& options) {
  require_threads(most_driver_threads());
  work_around_driver_faults();
  std::string tried;
  for (const DisplayCandidate& candidate : find_display_candidates()) {
    if (eglInitialize(candidate.display, nullptr, nullptr) != EGL_TRUE) {
      tried += " " + candidate.name + ": cannot be initialised.";
      continue;
    }
    const EGLContext egl = create_egl_context(candidate.display, options.debug_output);
    if (egl == EGL_NO_CONTEXT ||
        eglMakeCurrent(candidate.display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl) != EGL_TRUE) {
      tried += " " + candidate.name + ": no OpenGL 4.5 core context.";
      continue;
    }
    std::unique_ptr<Context> context(new Context(candidate.display, egl));
    if (options.require_gpu && context->is_software()) {
      tried += " " + candidate.name + ": " + context->renderer() + " is software.";
      continue;
    }
    if (options.debug_output) install_debug_output();
    log().debug("OpenGL on EGL {}: {}, {}", candidate.name, context->renderer(),
                context->version());
    return context;
  }
  const std::string what =
      options.require_gpu ? "no GPU renders OpenGL here" : "nothing renders OpenGL here";
  throw StartUpError(StartUpError::Fault::renderer_unavailable,
                     what + "; expected an EGL device with OpenGL 4.5 core; got " +
                         (tried.empty() ? "no EGL device" : tried.substr(1)));
}

}  // namespace cutaway::gl
