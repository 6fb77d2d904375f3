#include "ui/wizard/sherd_numbers.h"

#include <algorithm>

#include "catalogue/batches.h"
#include "sherds/numbers.h"
#include "sherds/sherds.h"
#include "store/names.h"
#include "ui/frame/project_session.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kLongestNumber = 40;  // a label has room for no more

// What nobody writes on a sherd, or in a list that it comes from.
bool isPlausible(const QString& typed) {
  const auto isNone = [](QChar c) { return c.isSpace() || !c.isPrint(); };
  return typed.size() <= kLongestNumber &&
         std::any_of(typed.begin(), typed.end(), [](QChar c) { return c.isDigit(); }) &&
         std::none_of(typed.begin(), typed.end(), isNone);
}

}  // namespace

void SherdNumbers::follow(ProjectSession* session, const QString& batch,
                          const capture::PlateInspection* inspection) {
  std::vector<Eigen::Vector2d> places;
  if (session != nullptr && inspection != nullptr && inspection->pixel_from_plate)
    for (const capture::SeenSherd& sherd : inspection->sherds) places.push_back(sherd.centre_mm);
  if (session == session_ && batch == batch_ && places == places_mm_) return;
  session_ = session;
  batch_ = batch;
  places_mm_ = std::move(places);
  typed_.clear();
  row_ = {};
  if (!places_mm_.empty()) {
    catalogue::Catalogue& rows = session_->project().catalogue();
    if (const auto record = catalogue::Batches(rows).byNumber(batch_.toStdString()))
      row_ = record->row;
    if (row_)
      if (auto typed = sherds::typedNumbers(rows, row_)) typed_ = std::move(*typed);
  }
  assign();
}

void SherdNumbers::assign() {
  numbers_ = QStringList(count());
  const std::vector<int> place = sherds::placesOf(typed_, places_mm_);
  for (std::size_t i = 0; i < typed_.size(); ++i)
    if (place[i] >= 0) numbers_[place[i]] = QString::fromStdString(typed_[i].number);
  emit changed();
}

QString SherdNumbers::give(int sherd, const QString& typed) {
  if (session_ == nullptr || !row_ || sherd < 0 || sherd >= count()) return {};
  catalogue::Catalogue& rows = session_->project().catalogue();
  const QString plain = typed.trimmed();
  if (!plain.isEmpty() && !plain.startsWith(QLatin1String("OST1:"), Qt::CaseInsensitive) &&
      !isPlausible(plain))
    return tr("%1 is no sherd's number: it has a digit, no space and at most %2 characters.")
        .arg(plain)
        .arg(kLongestNumber);
  const auto number = sherds::wholeNumber(rows, row_, typed.toStdString());
  if (!number) return sentenceOf(number.error());
  std::vector<sherds::TypedNumber> all;
  const std::vector<int> place = sherds::placesOf(typed_, places_mm_);
  for (std::size_t i = 0; i < typed_.size(); ++i) {
    const bool same = store::uniqueKey(typed_[i].number) == store::uniqueKey(*number);
    if (same && place[i] >= 0 && place[i] != sherd)
      return tr("Sherd %1 of this plate has the number %2: take it from that one first, or type "
                "another.")
          .arg(place[i] + 1)
          .arg(QString::fromStdString(*number));
    // Of a place where none lies now it comes along.
    if (place[i] != sherd && !same) all.push_back(typed_[i]);
  }
  if (!number->empty()) all.push_back({places_mm_[static_cast<std::size_t>(sherd)], *number});
  if (const auto kept = sherds::setTypedNumbers(rows, row_, all, session_->provenance()); !kept) {
    if (const auto other = sherds::Sherds(rows).byNumber(*number); other && *other)
      if (const auto holder = sherds::Sherds(rows).get(*other);
          holder && !holder->batch_number.empty())
        return tr("A sherd of %1 has the number %2 already; type another.")
            .arg(QString::fromStdString(holder->batch_number), QString::fromStdString(*number));
    return wordsOf(kept.error().what);
  }
  typed_ = std::move(all);
  assign();
  return {};
}

QString SherdNumbers::doubtOf(int sherd) const {
  const QString number = of(sherd);
  if (session_ == nullptr || !row_ || number.isEmpty()) return {};
  const catalogue::Catalogue& rows = session_->project().catalogue();
  if (const auto doubt = sherds::Numbers(rows).doubt({}, number.toStdString());
      doubt && !doubt->empty())
    return wordsOf(*doubt);
  const auto fits = sherds::fitsTheBatch(rows, row_, number.toStdString());
  const auto example = sherds::wholeNumber(rows, row_, "1");
  if (!fits || *fits || !example) return {};
  return tr("Sherd %1: %2 is not as this bag's sherds are numbered (%3). If that is no slip, go "
            "on.")
      .arg(sherd + 1)
      .arg(number, QString::fromStdString(*example));
}

}  // namespace ostraka::ui
