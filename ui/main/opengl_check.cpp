#include "ui/main/opengl_check.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

#include "ui/viewport/sherd_view.h"

namespace ostraka::ui {

std::string openGlOfThisComputer(std::optional<bool>& works) {
  works.reset();
  if (qEnvironmentVariableIsEmpty("DISPLAY") && qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
    return "not looked at: there is no display";
  works = false;
  prepareOpenGl();
  int argc = 1;
  char name[] = "ostraka";
  char* argv[] = {name, nullptr};
  QGuiApplication application(argc, argv);
  QOpenGLContext context;
  QOffscreenSurface surface;
  surface.create();
  if (!context.create() || !context.makeCurrent(&surface))
    return "none; install libgl1-mesa-dri for drawing without a graphics card";
  const auto text = [&](GLenum what) {
    const auto* words = context.functions()->glGetString(what);
    return words == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(words));
  };
  const std::string renderer = text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
  const auto version = std::pair(context.format().majorVersion(), context.format().minorVersion());
  context.doneCurrent();
  if (version < std::pair(3, 2)) return renderer + "; 3.2 or newer is needed";
  works = true;
  return renderer;
}

}  // namespace ostraka::ui
