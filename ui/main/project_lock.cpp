#include "ui/main/project_lock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QSet>

namespace ostraka::ui {
namespace {

// One folder has one lock, by whatever link it was opened.
QString fileOf(const QString& folder) {
  const QString real = QDir(folder).canonicalPath();
  return QDir(real.isEmpty() ? folder : real).absoluteFilePath(QStringLiteral(".ostraka.lock"));
}

// By the windows of this process, where they took them.
QSet<QString>& heldHere() {
  static QSet<QString> files;
  return files;
}

}  // namespace

ProjectLock::ProjectLock(const QString& file) : lock_(file) {
  lock_.setStaleLockTime(0);
}

ProjectLock::~ProjectLock() {
  heldHere().remove(lock_.fileName());
}

bool ProjectLock::isOf(const QString& folder) const {
  return lock_.fileName() == fileOf(folder);
}

std::unique_ptr<ProjectLock> ProjectLock::take(const QString& folder) {
  const QString file = fileOf(folder);
  if (heldHere().contains(file)) return nullptr;
  std::unique_ptr<ProjectLock> taken(new ProjectLock(file));
  // Ours, and nobody holds it there: its folder was moved while it was open.
  qint64 holder = 0;
  if (taken->lock_.getLockInfo(&holder, nullptr, nullptr) &&
      holder == QCoreApplication::applicationPid())
    QFile::remove(file);
  if (!taken->lock_.tryLock() && taken->lock_.error() == QLockFile::LockFailedError) return nullptr;
  heldHere().insert(file);
  return taken;
}

}  // namespace ostraka::ui
