#pragma once
#include <QLockFile>
#include <memory>

namespace ostraka::ui {

/// A project that a window has open: two would compute the same batch twice. A window that died
/// leaves no lock behind, its process is gone; nor does one whose folder was moved under it.
class ProjectLock {
 public:
  /// Null: another window, or another program, has it open. A folder that cannot be written is
  /// open to all.
  static std::unique_ptr<ProjectLock> take(const QString& folder);
  ~ProjectLock();
  bool isOf(const QString& folder) const;

 private:
  explicit ProjectLock(const QString& file);
  QLockFile lock_;
};

}  // namespace ostraka::ui
