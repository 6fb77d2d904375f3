#include "ui/wizard/batch_description.h"

#include <map>

#include "ui/frame/project_session.h"
#include "ui/wizard/batch_in_hand.h"
#include "ui/wizard/capture_wizard.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kLooksUntilGone = 5;  // a hand may hide a label for a moment

}  // namespace

BatchDescription::BatchDescription(BatchInHand* batch, QObject* parent)
    : QObject(parent), batch_(batch) {}

void BatchDescription::setSession(ProjectSession* session) {
  session_ = session;
  labels_.clear();
}

void BatchDescription::setPlace(const PlaceText& place) {
  if (place == place_) return;
  place_ = place;
  emit changed();
}

// What was typed last may be the bag of another batch.
void BatchDescription::takePlaceOfBatch() {
  if (!batch_->isThere() || batch_->place() == place_) return;
  setPlace(batch_->place());
  emit placeRead();
}

void BatchDescription::setCounted(int sherds) {
  if (sherds == batch_->counted() || sherds < 0) return;
  batch_->setCounted(sherds);
  emit countChanged();
}

void BatchDescription::takeNumbersAsRight() {
  batch_->takeNumbersAsRight();
  emit changed();
}

// What was typed stays until another bag's label comes into sight, or this one once more. Of two
// bags nobody knows whose sherds lie there.
void BatchDescription::readLabels(const QStringList& codes) {
  std::map<QString, PlaceText> bags;
  for (const QString& code : codes)
    if (code.startsWith(QLatin1String("OST1:")))
      if (const auto place = findPlaceText(session_->project().catalogue(), code))
        bags.emplace(place->words(), *place);
  QStringList seen;
  for (const auto& [words, place] : bags) seen << words;
  looks_without_label_ = seen.isEmpty() ? looks_without_label_ + 1 : 0;
  if (looks_without_label_ == kLooksUntilGone) labels_.clear();
  if (seen.isEmpty() || seen == labels_) return;
  labels_ = seen;
  if (bags.size() > 1)
    return emit said(CaptureWizard::tr("Labels of several bags are in sight: %1. Leave the one of "
                                       "these sherds.")
                         .arg(seen.join(QStringLiteral(", "))));
  setPlace(bags.begin()->second);
  emit placeRead();
  emit said(CaptureWizard::tr("Read from the label: %1").arg(seen.front()));
}

}  // namespace ostraka::ui
