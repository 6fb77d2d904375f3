#include "ui/catalogue/places_dialog.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>
#include <map>
#include <memory>

#include "catalogue/places.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_command.h"
#include "ui/look/look.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/screen_room.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kKind = Qt::UserRole, kRow = Qt::UserRole + 1, kName = Qt::UserRole + 2;

// A place has another name, or is one with another: every screen may show it.
void tellRenamed(ProjectSession& session) {
  session.tellVocabulariesChanged();
  session.tellSherdsChanged();
  session.tellBatchChanged({});
}

}  // namespace

PlacesDialog::PlacesDialog(ProjectSession& session, QWidget* parent)
    : QDialog(parent), session_(session) {
  setObjectName("placesDialog");
  setWindowTitle(tr("Rename places"));
  buildLayout();
  resize(
      fittedToScreen(*this, {fontMetrics().averageCharWidth() * 92, fontMetrics().height() * 32}));
  for (const auto changed : {&ProjectSession::sherdsChanged, &ProjectSession::othersWrote})
    connect(&session_, changed, this, &PlacesDialog::fill);
  fill();
}

void PlacesDialog::buildLayout() {
  auto* intro = wrappedLabel(this, "placesIntro");
  intro->setText(
      tr("Choose the place that was typed wrongly and enter its right name. If that place exists "
         "already, both become one."));
  places_ = named<QTreeWidget>({"places", tr("Places of the project")}, this);
  places_->setHeaderLabels({tr("Place"), tr("Sherds")});
  places_->header()->setStretchLastSection(false);
  places_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  places_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  places_->setTabKeyNavigation(false);
  name_ = named<QLineEdit>({"placeName", tr("Right name of the place")}, this);
  told_ = wrappedLabel(this, "placeTold");
  told_->setMinimumHeight(6 * fontMetrics().lineSpacing());
  told_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  rename_ = new BigButton("placeRename", tr("Rename"), this);
  rename_->setDefault(true);
  QPushButton* close =
      iconButton(this, "placesClose", "cancel", tr("Close"), this, &QDialog::reject);
  close->setAutoDefault(false);
  auto* line = filled(new QHBoxLayout, {labelFor(name_, tr("Right &name:")), {name_, 1}});
  auto* acts = filled(new QHBoxLayout, {Part::room(1), close, rename_});
  filled(new QVBoxLayout(this), {intro, {places_, 1}, line, told_, acts});
  connect(places_, &QTreeWidget::currentItemChanged, this, &PlacesDialog::showChosen);
  connect(name_, &QLineEdit::textChanged, this, &PlacesDialog::preview);
  connect(rename_, &QPushButton::clicked, this, &PlacesDialog::apply);
}

// words: with %1 for the name.
QTreeWidgetItem* PlacesDialog::add(QTreeWidgetItem* in, const char* words, catalogue::PlaceId place,
                                   const std::string& name) {
  const QString called = QString::fromStdString(name);
  auto* item =
      new QTreeWidgetItem(in, {QCoreApplication::translate("PlaceText", words).arg(called)});
  item->setData(0, kKind, static_cast<int>(place.kind));
  item->setData(0, kRow, static_cast<qlonglong>(place.row));
  item->setData(0, kName, called);
  const auto content = renamingOf(session_.project().catalogue(), place, name);
  if (content) item->setText(1, QString::number(content->sherds));
  item->setTextAlignment(1, Qt::AlignRight);
  return item;
}

// What is chosen stays chosen.
void PlacesDialog::fill() {
  const auto before = chosen();
  const QSignalBlocker quiet(places_);
  places_->clear();
  const catalogue::Places all(session_.project().catalogue());
  const auto sites = all.sites();
  const auto trenches = all.trenches();
  const auto contexts = all.contexts();
  const auto bags = all.bags();
  if (!sites || !trenches || !contexts || !bags) return;
  using catalogue::PlaceKind;
  std::map<std::int64_t, QTreeWidgetItem*> of_site, of_trench, of_context;
  for (const records::SiteRecord& site : *sites) {
    auto* item = new QTreeWidgetItem(
        places_,
        {QCoreApplication::translate("PlaceText", QT_TRANSLATE_NOOP("PlaceText", "site %1"))
             .arg(QString::fromStdString(site.code))});
    item->setFlags(Qt::ItemIsEnabled);  // the settings rename it
    of_site[site.row.value] = item;
  }
  for (const records::TrenchRecord& trench : *trenches)
    of_trench[trench.row.value] =
        add(of_site[trench.site.value], QT_TRANSLATE_NOOP("PlaceText", "trench %1"),
            {PlaceKind::Trench, trench.row.value}, trench.code);
  for (const records::ContextRecord& context : *contexts)
    of_context[context.row.value] =
        add(context.trench ? of_trench[context.trench.value] : of_site[context.site.value],
            QT_TRANSLATE_NOOP("PlaceText", "context %1"), {PlaceKind::Context, context.row.value},
            context.number);
  for (const records::BagRecord& bag : *bags)
    add(of_context[bag.context.value], QT_TRANSLATE_NOOP("PlaceText", "bag %1"),
        {PlaceKind::Bag, bag.row.value}, bag.number);
  for (const auto& items : {of_site, of_trench})
    for (const auto& [row, item] : items) item->setExpanded(true);
  if (before) choose(*before);
  showChosen();
}

void PlacesDialog::choose(catalogue::PlaceId place) {
  for (QTreeWidgetItemIterator at(places_); *at != nullptr; ++at)
    if ((*at)->data(0, kRow).toLongLong() == place.row &&
        (*at)->data(0, kKind).toInt() == static_cast<int>(place.kind) &&
        (*at)->data(0, kName).isValid()) {
      places_->setCurrentItem(*at);
      places_->scrollToItem(*at);
    }
}

void PlacesDialog::showPlaceOf(store::SherdRow sherd) {
  const auto known = sherds::Sherds(session_.project().catalogue()).get(sherd);
  if (known && known->context)
    choose(known->bag ? catalogue::PlaceId{catalogue::PlaceKind::Bag, known->bag.value}
                      : catalogue::PlaceId{catalogue::PlaceKind::Context, known->context.value});
  // Mostly the context is wrong; the bag is shown below it.
  if (known && known->bag) choose({catalogue::PlaceKind::Context, known->context.value});
}

std::optional<catalogue::PlaceId> PlacesDialog::chosen() const {
  const QTreeWidgetItem* item = places_->currentItem();
  if (item == nullptr || !item->data(0, kName).isValid()) return {};
  return catalogue::PlaceId{static_cast<catalogue::PlaceKind>(item->data(0, kKind).toInt()),
                            item->data(0, kRow).toLongLong()};
}

void PlacesDialog::showChosen() {
  const auto place = chosen();
  name_->setEnabled(place.has_value());
  name_->setText(place ? places_->currentItem()->data(0, kName).toString() : QString());
  name_->selectAll();
  preview();
}

void PlacesDialog::preview() {
  rename_->setEnabled(false);
  rename_->setText(tr("Rename"));
  told_->clear();
  would_ = {};
  const auto place = chosen();
  if (!place && places_->currentItem() != nullptr)
    told_->setText(tr("A site gets another code in the settings, under Open project."));
  if (!place) return;
  const auto would =
      renamingOf(session_.project().catalogue(), *place, name_->text().toStdString());
  if (!would) return told_->setText(sentenceOf(would.error()));
  would_ = *would;
  QStringList parts;
  if (would_.contexts > 0) parts << tr("%n context(s)", nullptr, would_.contexts);
  if (would_.bags > 0) parts << tr("%n bag(s)", nullptr, would_.bags);
  if (would_.batches > 0) parts << tr("%n batch(es)", nullptr, would_.batches);
  if (would_.sherds > 0) parts << tr("%n sherd(s)", nullptr, would_.sherds);
  const QString content = parts.isEmpty() ? tr("nothing") : parts.join(QStringLiteral(", "));
  const QString from = QString::fromStdString(would_.before),
                to = QString::fromStdString(would_.after);
  QStringList said;
  if (would_.into != 0)
    said << tr("%1 exists already. Join with it? What is in %2 comes to %1: %3. %1 keeps its own "
               "description, and %2 is not listed any more.")
                .arg(to, from, content);
  else
    said << tr("In this place: %1.").arg(content);
  if (would_.numbered > 0)
    said << tr(
        "%n sherd(s) keep the number that is written on them; new numbers go on behind "
        "these.",
        nullptr, would_.numbered);
  told_->setText(said.join(QLatin1Char('\n')));
  rename_->setText(would_.into != 0 ? tr("Join places") : tr("Rename"));
  rename_->setEnabled(from != to && session_.whyReadOnly().isEmpty());
}

void PlacesDialog::apply() {
  const auto place = chosen();
  if (!place || would_.before == would_.after) return;
  using catalogue::Renamed;
  const bool joins = would_.into != 0;
  const auto change = [&session = session_, place = *place, name = would_.after,
                       joins]() -> Result<Renamed> {
    const records::Provenance provenance = session.provenance();
    Result<Renamed> done = catalogue::rename(
        session.project().catalogue(), place, name,
        joins ? catalogue::IfNameIsTaken::Join : catalogue::IfNameIsTaken::Refuse, provenance);
    if (done) tellRenamed(session);
    return done;
  };
  const auto from = QString::fromStdString(would_.before),
             to = QString::fromStdString(would_.after);
  const std::int64_t into = would_.into;
  const Result<Renamed> done = change();
  if (!done) return told_->setText(sentenceOf(done.error()));
  const auto held = std::make_shared<Renamed>(*done);
  const auto again = [change, held]() -> Result<void> {
    Result<Renamed> once_more = change();
    if (!once_more) return once_more.error();
    *held = std::move(*once_more);
    return {};
  };
  const auto back = [&session = session_, held]() -> Result<void> {
    const records::Provenance provenance = session.provenance();
    const Result<void> undone =
        catalogue::renameBack(session.project().catalogue(), *held, provenance);
    if (undone) tellRenamed(session);
    return undone;
  };
  session_.undo().push(
      new SavedCommand((joins ? tr("join %1 with %2") : tr("rename %1 to %2")).arg(from, to), again,
                       back, session_));
  choose({place->kind, joins ? into : place->row});
  told_->setText(
      (joins ? tr("Joined: %1 is %2 now.") : tr("Renamed: %1 is %2 now.")).arg(from, to));
}

}  // namespace ostraka::ui
