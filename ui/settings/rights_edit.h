#pragma once
#include <QPointer>
#include <QWidget>

#include "base/result.h"

class QLabel;
class QLineEdit;

namespace ostraka::records {
struct Provenance;
}  // namespace ostraka::records

namespace ostraka::ui {

class ProjectSession;

/// Part of the settings: whose the open project's finds are, and under which licence exports are
/// handed on. Nothing is claimed until somebody says it.
class RightsEdit final : public QWidget {
  Q_OBJECT

 public:
  explicit RightsEdit(QWidget* parent = nullptr);
  /// Hidden without a project.
  void setSession(ProjectSession* session);

 private:
  struct Rights {
    QString licence, holder;
    bool operator==(const Rights&) const = default;
  };
  void save();
  void showRights();
  static Result<Rights> rightsIn(ProjectSession& session);
  static Result<void> setRights(ProjectSession& session, const Rights& rights,
                                const records::Provenance& provenance);

  QPointer<ProjectSession> session_;
  Rights held_;  ///< in the catalogue
  QLineEdit* licence_;
  QLineEdit* holder_;
  QLabel* told_;
};

}  // namespace ostraka::ui
