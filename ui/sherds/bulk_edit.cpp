#include "ui/sherds/bulk_edit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCompleter>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "catalogue/label_codes.h"
#include "intake/sherd_moves.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kReasons = 3;          // of refusals, above that list
constexpr std::size_t kShown = 200;  // the preview's list; all are counted

bool isPlace(const std::string& field) {
  const records::SherdField* known = sherds::sherdField(field);
  return known != nullptr && known->kind == records::FieldKind::Place;
}

QString shownValue(const records::ChangePreview& change, const std::string& value,
                   const TermWords& words) {
  const std::string& field = change.change.field;
  return isNumber(field) ? typedText(*sherds::sherdField(field), value) : words.shown(field, value);
}

// Whole, since the table has no room for them; mostly it is one for all sherds.
QStringList reasonsOf(const std::vector<records::ChangePreview>& shown) {
  QStringList reasons;
  std::set<std::string> said;
  for (const records::ChangePreview& change : shown) {
    if (change.refusal.empty() || !said.insert(change.refusal.english()).second) continue;
    if (reasons.size() == kReasons) return reasons << QStringLiteral("…");
    reasons << wordsOf(change.refusal);
  }
  return reasons;
}

}  // namespace

struct BulkEdit::Preview {
  intake::Move move;  ///< where sherds get another context
  std::vector<records::ChangePreview> shown;
  std::vector<records::SherdRecord> records;  ///< of the first kShown
};

BulkEdit::BulkEdit(QWidget* parent) : QWidget(parent) {
  buildLayout();
}

void BulkEdit::buildLayout() {
  heading_ = new QLabel(this);
  heading_->setFont(scaledFont(*this, Look::kSection, true));
  field_ = named<QComboBox>({"bulkField", tr("Field to change")}, this);
  for (const records::SherdField& field : sherds::sherdFields())
    if (field.editable && std::string_view(field.name) != "number")
      field_->addItem(fieldLabel(field.name), QString::fromLatin1(field.name));
  field_->setCurrentIndex(field_->findData("part"));
  value_ = named<QLineEdit>({"bulkValue", tr("New value for all")}, this);
  value_->setPlaceholderText(tr("new value; empty deletes"));
  summary_ = wrappedLabel(this, "bulkSummary");
  replace_ = named<QCheckBox>("bulkReplace", tr("Replace with measured value"), this);
  replace_->hide();
  make_bags_ =
      iconButton(this, "bulkMakeBags", "bag", tr("Make these bags"), this, &BulkEdit::makeBags);
  make_bags_->hide();
  connect(replace_, &QCheckBox::clicked, this, [this] { preview(); });
  table_ = new QTableWidget(0, 3, this);
  table_->setHorizontalHeaderLabels({tr("sherd"), tr("now"), tr("then")});
  table_->setAccessibleName(tr("What would change"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  table_->setWordWrap(true);
  apply_ =
      iconButton(this, "bulkApply", "check", tr("Change"), this, [this] { emit wanted(good_); });
  numbers_ = iconButton(this, "bulkNumbers", "label", tr("Assign numbers"), this,
                        &BulkEdit::numbersWanted);
  compare_ =
      iconButton(this, "bulkCompare", "compare", tr("Compare"), this, &BulkEdit::comparisonWanted);
  compare_->hide();
  bar_ = named<QProgressBar>({"bulkProgress", tr("Progress of the changes")}, this);
  bar_->setRange(0, 1000);
  stop_ =
      iconButton(this, "bulkStop", "cancel", tr("Cancel and undo"), this, &BulkEdit::stopWanted);
  filled(new QVBoxLayout(this), {heading_,
                                 compare_,
                                 labelFor(field_, tr("Field")),
                                 field_,
                                 labelFor(value_, tr("Value")),
                                 value_,
                                 summary_,
                                 replace_,
                                 make_bags_,
                                 {table_, 1},
                                 apply_,
                                 numbers_,
                                 bar_,
                                 stop_});
  showProgress(-1);
  connect(field_, &QComboBox::currentIndexChanged, this, [this] {
    offerTerms();
    replace_->setChecked(false);
    preview();
  });
  connect(value_, &QLineEdit::returnPressed, this, [this] {
    if (value_->isModified()) return;
    value_->setModified(true);
    preview();
  });
  connect(value_, &QLineEdit::textEdited, this, [this] {
    replace_->setChecked(false);  // it was said of another value
    preview();
  });
}

void BulkEdit::setSherds(ProjectSession* session, std::vector<store::SherdRow> sherds) {
  session_ = session;
  sherds_ = std::move(sherds);
  heading_->setText(tr("%n sherd(s) chosen", nullptr, static_cast<int>(sherds_.size())));
  compare_->setVisible(sherds_.size() == 2);
  value_->setText({});  // clear() would count as a person's act
  replace_->setChecked(false);
  offerTerms();
  preview();
}

void BulkEdit::showProgress(double fraction) {
  const bool busy = fraction >= 0;
  bar_->setVisible(busy);
  stop_->setVisible(busy);
  bar_->setValue(qRound(1000 * fraction));
  apply_->setVisible(!busy);
  numbers_->setVisible(!busy);
  field_->setEnabled(!busy);
  value_->setEnabled(!busy);
}

void BulkEdit::offerTerms() {
  const std::string field = field_->currentData().toString().toStdString();
  if (session_) words_.read(session_->project().catalogue());
  const records::SherdField* known = sherds::sherdField(field);
  auto* completer =
      new QCompleter(session_ && known != nullptr ? words_.of(*known) : QStringList(), value_);
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  delete value_->completer();
  value_->setCompleter(completer);
}

void BulkEdit::preview() {
  delete previewing_.data();  // what was typed before
  good_.clear();
  note_.clear();
  table_->setRowCount(0);
  lacking_.clear();
  make_bags_->hide();
  apply_->setEnabled(false);
  apply_->setText(tr("Change"));
  summary_->clear();
  if (!session_ || sherds_.empty()) return;
  if (!value_->isModified()) {
    replace_->hide();  // an empty line deletes only when a person says so
    summary_->setText(
        tr("Type a value to see what would change, or press Enter in the empty field to delete."));
    return;
  }
  const std::string field = field_->currentData().toString().toStdString();
  if (const QString two_ways = inTwoWays(field, value_->text()); !two_ways.isEmpty())
    return summary_->setText(two_ways);
  const auto work = [folder = session_->folder(), sherds = sherds_, field,
                     value = value_->text().toStdString(),
                     confirmation = replace_->isChecked() ? records::Confirmation::Given
                                                          : records::Confirmation::None](
                        Progress&, std::stop_token) -> Result<Preview> {
    const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
    if (!catalogue) return catalogue.error();
    std::vector<records::FieldChange> changes;
    for (const store::SherdRow& sherd : sherds)
      changes.push_back({sherd, field, value, confirmation});
    Result<intake::Move> move =
        isPlace(field) ? intake::moveOf(*catalogue, changes) : intake::Move{changes, 0, {}, {}};
    if (!move) return move.error();
    Result<std::vector<records::ChangePreview>> shown =
        sherds::SherdChanges(*catalogue).preview(move->changes);
    if (!shown) return shown.error();
    Result<std::vector<records::SherdRecord>> records =
        sherds::Sherds(*catalogue)
            .of(std::span(sherds).first(std::min<std::size_t>(sherds.size(), kShown)));
    if (!records) return records.error();
    return Preview{std::move(*move), std::move(*shown), std::move(*records)};
  };
  previewing_ = session_->jobs().start(makeJob(work), this);
  whenDone<Preview>(previewing_, this, [this](const auto& preview) {
    if (preview)
      showPreview(*preview);
    else
      summary_->setText(sentenceOf(preview.error()));
  });
}

// In the new contexts: the sherds come to them.
void BulkEdit::makeBags() {
  if (!session_) return;
  const records::Provenance provenance = session_->provenance();
  const Result<void> made = session_->project().catalogue().together([&]() -> Result<void> {
    for (const catalogue::BagPlace& bag : lacking_)
      if (const auto row = catalogue::bagAt(session_->project().catalogue(), bag, provenance); !row)
        return row.error();
    return {};
  });
  preview();
  if (!made) summary_->setText(sentenceOf(made.error()));
}

void BulkEdit::showPreview(const Preview& preview) {
  int changed = 0, same = 0, refused = 0, asked = 0;
  bool asks = false;
  std::size_t sherd = 0;
  for (const records::ChangePreview& change : preview.shown) {
    const bool is_same = change.refusal.empty() && change.old_value == change.new_value;
    asks = asks || !change.findings.empty();
    if (change.refusal.empty() && !is_same && !change.asks()) good_.push_back(change.change);
    if (change.change.field != preview.shown.front().change.field) continue;  // comes along
    const std::size_t i = sherd++;
    (is_same ? same : !change.refusal.empty() ? refused : change.asks() ? asked : changed) += 1;
    if (i >= preview.records.size() || is_same) continue;
    const int row = table_->rowCount();
    table_->insertRow(row);
    table_->setItem(row, 0, new QTableWidgetItem(sherdName(preview.records[i])));
    table_->setItem(row, 1, new QTableWidgetItem(shownValue(change, change.old_value, words_)));
    auto* then = new QTableWidgetItem(
        !change.refusal.empty() ? tr("rejected: %1").arg(wordsOf(change.refusal))
        : change.asks()         ? questionWords(change.findings)
                                : shownValue(change, change.new_value, words_));
    then->setToolTip(then->text());
    if (!change.refusal.empty()) then->setIcon(icon("error"));
    if (change.asks()) then->setIcon(icon("question"));
    table_->setItem(row, 2, then);
  }
  table_->resizeColumnsToContents();
  table_->resizeRowsToContents();
  const QString counts =
      tr("To change: %1. Unchanged: %2. Rejected: %3.").arg(changed).arg(same).arg(refused);
  note_ = leftBehindWords(preview.move);
  lacking_ = preview.move.lacking;
  make_bags_->setVisible(!lacking_.empty());
  QStringList lines = QStringList(counts) + reasonsOf(preview.shown);
  if (asked > 0) lines << tr("%n value(s) ask for a confirmation.", nullptr, asked);
  replace_->setVisible(asks);
  if (!note_.isEmpty()) lines << note_;
  summary_->setText(lines.join(QLatin1Char('\n')));
  apply_->setEnabled(!good_.empty());
  apply_->setText(tr("Change %n sherd(s)", nullptr, changed));
}

}  // namespace ostraka::ui
