#pragma once
#include <QHash>
#include <QString>
#include <QStringList>

#include "records/sherd.h"

namespace ostraka::ui {

/// What was typed and could not be saved yet: it stays at its sherd, whatever is shown meanwhile.
class UnsavedValues {
 public:
  using Typed = QHash<QString, QString>;  ///< name of a field -> what was typed

  void keep(store::SherdRow sherd, const QString& field, const QString& value) {
    typed_[sherd.value].insert(field, value);
  }
  bool forget(store::SherdRow sherd, const QString& field);  ///< false: there was nothing
  void clear() { typed_.clear(); }
  Typed of(store::SherdRow sherd) const { return typed_.value(sherd.value); }
  QStringList labels() const;  ///< of the fields of all sherds

 private:
  QHash<qint64, Typed> typed_;
};

QStringList labelsOf(const UnsavedValues::Typed& typed);

}  // namespace ostraka::ui
