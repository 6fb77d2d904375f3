#include "ui/wizard/batch_description.h"

#include <utility>

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

// Counts how long no label was in sight.
std::vector<PlaceText> BatchDescription::bagsIn(const QStringList& codes) {
  std::vector<PlaceText> bags = bagsOn(codes, [this](const QString& code) {
    return findPlaceText(session_->project().catalogue(), code);
  });
  looks_without_label_ = bags.empty() ? looks_without_label_ + 1 : 0;
  return bags;
}

// What was typed stays until another bag's label comes into sight, or this one once more. Of two
// bags nobody knows whose sherds lie there.
void BatchDescription::readLabels(const QStringList& codes) {
  const std::vector<PlaceText> bags = bagsIn(codes);
  if (looks_without_label_ == kLooksUntilGone) labels_.clear();
  QStringList seen;
  for (const PlaceText& bag : bags) seen << bag.words();
  if (seen.isEmpty() || seen == labels_) return;
  labels_ = seen;
  if (bags.size() > 1)
    return emit said(CaptureWizard::tr("Labels of several bags are in sight: %1. Leave the one of "
                                       "these sherds.")
                         .arg(wordsOf(bags)));
  setPlace(bags.front());
  emit placeRead();
  emit said(CaptureWizard::tr("Read from the label: %1").arg(seen.front()));
}

// A batch whose bag nobody gave takes it from the label also now.
void BatchDescription::compareLabels(const QStringList& codes) {
  if (place_.isEmpty()) return readLabels(codes);
  std::vector<PlaceText> bags = bagsIn(codes);
  if (bags.empty() && looks_without_label_ < kLooksUntilGone) return;
  const QString before = otherBag();
  of_backs_ = std::move(bags);
  if (otherBag() != before) emit changed();
}

QString BatchDescription::otherBag() const {
  for (const PlaceText& bag : of_backs_)
    if (!bag.differsFrom(place_)) return {};
  return wordsOf(of_backs_);
}

}  // namespace ostraka::ui
