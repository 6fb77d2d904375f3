#pragma once
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>

#include "base/result.h"

namespace ostraka::upkeep {
class Project;
}

namespace ostraka::ui {

/// A project that is about to be made: name, code of the site, folder, numbering, with the live
/// example of the next number. No widget.
class NewProject final : public QObject {
  Q_OBJECT

 public:
  explicit NewProject(QObject* parent = nullptr);

  const QString& name() const { return name_; }
  const QString& siteCode() const { return site_; }
  const QString& folder() const { return folder_; }
  const QString& numbering() const { return numbering_; }
  /// "ARM1-T3-0012-0007" for the numbering as it stands; empty when it cannot be.
  QString example() const { return example_; }
  /// Why it cannot be made, in a sentence; empty when it can.
  QString refusal() const;
  bool canBeMade() const { return refusal().isEmpty(); }

  /// Makes the project's folder and its catalogue with the site.
  Result<std::shared_ptr<upkeep::Project>> make() const;

 public slots:
  void clear();  ///< as it was at first
  /// Name, code and folder that nobody typed, after the folder of these photographs; what was
  /// proposed for others before is forgotten.
  void proposeFor(const QStringList& photographs);
  void setName(const QString& name);  ///< the folder follows until it was typed
  void setSiteCode(const QString& code);
  void setFolder(const QString& folder);
  void setNumbering(const QString& numbering);

 signals:
  void changed();

 private:
  void follow();

  QString place() const { return folder_.trimmed(); }

  QString name_, site_, folder_, numbering_, example_, numbering_refusal_;
  struct Proposal {
    QString name, site, folder;
  } proposed_;
  bool folder_typed_ = false;
};

/// A folder of this name where projects go, or with a number behind it when there is one.
QString freshFolder(const QString& name);

/// Where projects go when nobody says otherwise: ~/Ostraka.
QString projectsFolder();

/// A new project 'Virtual rig' with a rig of that kind and a bag that is filled in already.
Result<std::shared_ptr<upkeep::Project>> makeVirtualProject(const QString& folder);

}  // namespace ostraka::ui
