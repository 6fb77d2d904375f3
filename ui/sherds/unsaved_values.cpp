#include "ui/sherds/unsaved_values.h"

#include "ui/sherds/field_words.h"

namespace ostraka::ui {

bool UnsavedValues::forget(store::SherdRow sherd, const QString& field) {
  const auto typed = typed_.find(sherd.value);
  if (typed == typed_.end() || !typed->remove(field)) return false;
  if (typed->isEmpty()) typed_.erase(typed);
  return true;
}

QStringList UnsavedValues::labels() const {
  QStringList labels;
  for (const Typed& typed : typed_) labels += labelsOf(typed);
  labels.removeDuplicates();
  return labels;
}

QStringList labelsOf(const UnsavedValues::Typed& typed) {
  QStringList labels;
  for (const QString& field : typed.keys()) labels << fieldLabel(field.toStdString());
  labels.sort();
  return labels;
}

}  // namespace ostraka::ui
