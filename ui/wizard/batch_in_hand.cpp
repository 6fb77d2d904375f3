#include "ui/wizard/batch_in_hand.h"

#include <QDir>
#include <QRegularExpression>
#include <algorithm>

#include "catalogue/batches.h"
#include "catalogue/label_codes.h"
#include "records/sherd.h"
#include "sherds/photographed_again.h"
#include "sherds/typed_numbers.h"
#include "ui/frame/project_session.h"
#include "upkeep/project.h"

namespace ostraka::ui {

void BatchInHand::setSession(ProjectSession* session) {
  session_ = session;
  forget();
}

void BatchInHand::forget() {
  number_.clear();
  row_ = 0;
  counted_ = 0;
  of_another_bag_.clear();
}

void BatchInHand::resume() {
  number_.clear();
  row_ = 0;
  if (session_ == nullptr) return;
  const auto batches = catalogue::Batches(session_->project().catalogue()).all();
  if (!batches) return;
  const auto last = std::ranges::find_if(
      *batches, [](const auto& batch) { return batch.state <= records::BatchState::Back; });
  if (last == batches->end()) return;
  take(*last);
}

void BatchInHand::resume(const QString& number) {
  if (session_ == nullptr) return;
  const auto batch =
      catalogue::Batches(session_->project().catalogue()).byNumber(number.toStdString());
  if (batch && batch->state <= records::BatchState::Back) take(*batch);
}

void BatchInHand::take(const records::BatchRecord& batch) {
  number_ = QString::fromStdString(batch.number);
  row_ = batch.row.value;
  counted_ = batch.counted;
  of_another_bag_.clear();
}

int BatchInHand::index() const {
  QString number = number_;
  if (number.isEmpty() && session_ != nullptr)
    if (const auto next = catalogue::Batches(session_->project().catalogue()).nextNumber())
      number = QString::fromStdString(*next);
  number.remove(QLatin1Char('B'));
  return number.toInt();
}

std::filesystem::path BatchInHand::folder() const {
  return session_->project().batchFolder(number_.toStdString());
}

std::vector<TakenShot> BatchInHand::photographs(batch::Side side) const {
  static const QRegularExpression form(QStringLiteral("^cam(\\d)_pos(\\d+)\\.(jpg|png|tif)$"));
  std::vector<TakenShot> shots;
  const QDir place(QString::fromStdString((folder() / batch::name(side)).string()));
  for (const QString& file : place.entryList(QDir::Files, QDir::Name))
    if (const auto match = form.match(file); match.hasMatch())
      shots.push_back({match.captured(2).toInt(),
                       match.captured(1).toInt(),
                       0,
                       place.filePath(file),
                       {},
                       false});
  return shots;
}

std::vector<std::vector<std::filesystem::path>> BatchInHand::files(batch::Side side,
                                                                   int cameras) const {
  std::vector<std::vector<std::filesystem::path>> by_camera(static_cast<std::size_t>(cameras));
  for (const TakenShot& shot : photographs(side))
    if (shot.camera < cameras)
      by_camera[static_cast<std::size_t>(shot.camera)].emplace_back(shot.file.toStdString());
  return by_camera;
}

records::BatchState BatchInHand::state() const {
  if (session_ == nullptr || row_ == 0) return records::BatchState::Placed;
  const auto batch = catalogue::Batches(session_->project().catalogue()).get({row_});
  return batch ? batch->state : records::BatchState::Placed;
}

bool BatchInHand::isComputed() const {
  const records::BatchState now = state();
  return now == records::BatchState::Review || now == records::BatchState::Done;
}

PlaceText BatchInHand::place() const {
  if (session_ == nullptr || row_ == 0) return {};
  const catalogue::Catalogue& rows = session_->project().catalogue();
  const auto batch = catalogue::Batches(rows).get({row_});
  if (!batch || batch->bags.empty()) return {};
  const auto place = catalogue::placeOf(rows, batch->bags.front());
  if (!place || !*place) return {};
  return {QString::fromStdString((*place)->site), QString::fromStdString((*place)->trench),
          QString::fromStdString((*place)->context), QString::fromStdString((*place)->bag)};
}

QStringList BatchInHand::toPhotographAgain() const {
  QStringList sherds;
  if (session_ == nullptr) return sherds;
  if (const auto waiting = sherds::toPhotographAgain(session_->project().catalogue()))
    for (const records::SherdRecord& sherd : *waiting)
      sherds << QStringLiteral("%1 (%2)").arg(QString::fromStdString(sherd.number),
                                              QString::fromStdString(sherd.batch_number));
  return sherds;
}

// Without a bag nobody knows; what was doubted when it was typed is left out.
QStringList BatchInHand::numbersThatMayFit() const {
  QStringList numbers;
  if (session_ == nullptr || row_ == 0) return numbers;
  const catalogue::Catalogue& rows = session_->project().catalogue();
  if (const auto typed = sherds::typedNumbers(rows, {row_}))
    for (const sherds::TypedNumber& one : *typed) {
      const auto fits = sherds::fitsTheBatch(rows, {row_}, one.number);
      if (!fits || *fits) numbers << QString::fromStdString(one.number);
    }
  return numbers;
}

QStringList BatchInHand::numbersOfAnotherBag() const {
  QStringList numbers;
  if (of_another_bag_.isEmpty() || session_ == nullptr) return numbers;
  const QStringList fit = numbersThatMayFit();
  if (const auto typed = sherds::typedNumbers(session_->project().catalogue(), {row_}))
    for (const sherds::TypedNumber& one : *typed)
      if (const QString number = QString::fromStdString(one.number);
          of_another_bag_.contains(number) && !fit.contains(number))
        numbers << number;
  return numbers;
}

Result<void> BatchInHand::begin(const PlaceText& place) {
  catalogue::Catalogue& rows = session_->project().catalogue();
  const records::Provenance provenance = session_->provenance();
  if (row_ != 0) {  // begun before the person counted, or under another bag
    auto batch = catalogue::Batches(rows).get({row_});
    if (!batch) return batch.error();
    const bool moved = place != this->place();
    if (batch->counted == counted_ && !moved) return {};
    batch->counted = counted_;
    if (moved) {
      of_another_bag_ << numbersThatMayFit();
      const Result<std::int64_t> bag = bagRowOf(rows, place, provenance);
      if (!bag) return bag.error();
      batch->bags.clear();
      if (*bag != 0) batch->bags.push_back({*bag});
    }
    return catalogue::Batches(rows).save(*batch, provenance);
  }
  const Result<std::int64_t> bag = bagRowOf(rows, place, provenance);
  if (!bag) return bag.error();
  records::BatchRecord batch;
  if (*bag != 0) batch.bags.push_back({*bag});
  batch.operator_ = provenance.person;
  batch.counted = counted_;
  batch.started_ms = rows.now();
  const auto row = catalogue::Batches(rows).add(batch, provenance);
  if (!row) return row.error();
  const auto made = catalogue::Batches(rows).get(*row);
  if (!made) return made.error();
  row_ = row->value;
  number_ = QString::fromStdString(made->number);
  session_->tellBatchChanged(number_);
  return {};
}

Result<void> BatchInHand::setState(records::BatchState state) {
  Result<void> set = catalogue::Batches(session_->project().catalogue())
                         .setState({row_}, state, session_->provenance());
  session_->tellBatchChanged(number_);
  return set;
}

Result<void> BatchInHand::queue(int seen) {
  catalogue::Catalogue& rows = session_->project().catalogue();
  auto batch = catalogue::Batches(rows).get({row_});
  if (!batch) return batch.error();
  batch->ended_ms = rows.now();
  // What a person has counted is what the scans are compared with.
  if (counted_ > 0)
    batch->counted = counted_;
  else if (seen > 0)
    batch->counted = seen;
  if (Result<void> saved = catalogue::Batches(rows).save(*batch, session_->provenance()); !saved)
    return saved;
  return setState(records::BatchState::Queued);
}

}  // namespace ostraka::ui
