#include "ui/main/run_window.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTranslator>
#include <cstdio>

#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/main/main_window.h"
#include "ui/settings/window_settings.h"
#include "ui/viewport/sherd_view.h"
#include "ui/widgets/input_guard.h"

namespace ostraka::ui {
namespace {

bool hasDisplay() {
  return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
}

// The window's texts and numbers in one language, as long as this is there.
class Texts {
 public:
  explicit Texts(const QLocale& locale) {
    QLocale::setDefault(locale);
    // English forms of one and many are under every language: a text that none has is still right.
    if (plurals_.load(QStringLiteral(":/i18n/ostraka_en")))
      QApplication::installTranslator(&plurals_);
    if (qts_.load(locale, QStringLiteral("qtbase"), QStringLiteral("_"),
                  QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
      QApplication::installTranslator(&qts_);
    if (ours_.load(locale, QStringLiteral("ostraka"), QStringLiteral("_"),
                   QStringLiteral(":/i18n")))
      QApplication::installTranslator(&ours_);
  }

 private:
  QTranslator plurals_, qts_, ours_;
};

}  // namespace

int runWindow(int argc, char** argv, const std::optional<std::filesystem::path>& project) {
  if (!hasDisplay() && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    std::fputs(
        "There is no display to open the window on. Start it from a desktop, or use the commands: "
        "ostraka --help.\n",
        stderr);
    return 2;
  }
  prepareOpenGl();
  QApplication application(argc, argv);
  QApplication::setApplicationName(QStringLiteral("ostraka"));
  QApplication::setApplicationDisplayName(QStringLiteral("Ostraka"));
  QApplication::setApplicationVersion(QStringLiteral(OSTRAKA_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("ostraka"));
  QApplication::setWindowIcon(icon(QStringLiteral("sherd")));
  application.installEventFilter(new InputGuard(&application));
  ThreadedJobRunner runner;
  std::optional<QString> folder =
      project ? QString::fromStdString(std::filesystem::absolute(*project).string()) : QString();
  int status = 0;
  while (folder) {  // a restart opens the next window, in the language that was chosen
    const WindowSettings settings = readSettings();
    const Texts texts(localeOf(settings));
    applyLook(application, settings.theme, settings.text_percent);
    MainWindow window(runner);
    window.show();
    if (!folder->isEmpty()) window.openProject(*folder);
    status = QApplication::exec();
    folder = window.restarted();
  }
  return status;
}

std::string openGlOfThisComputer(std::optional<bool>& works) {
  works.reset();
  if (!hasDisplay()) return "not looked at: there is no display";
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
