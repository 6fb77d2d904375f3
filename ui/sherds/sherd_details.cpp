#include "ui/sherds/sherd_details.h"

#include <QAction>
#include <QComboBox>
#include <QCompleter>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStringListModel>
#include <QVBoxLayout>
#include <algorithm>
#include <set>
#include <utility>

#include "catalogue/places.h"
#include "cloud/glb.h"
#include "sherds/numbers.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "ui/jobs/job.h"
#include "ui/look/look.h"
#include "ui/sherds/field_words.h"
#include "ui/sherds/munsell_line.h"
#include "ui/widgets/elided_button.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

constexpr int kSmallPicture = 64;

void setPicture(QLabel* label, const QString& path, int size) {
  const QPixmap pixmap(path);
  label->setPixmap(pixmap.isNull()
                       ? icon("sherd").pixmap(size, size)
                       : pixmap.scaled(size, size, Qt::KeepAspectRatio, Qt::SmoothTransformation));
}

QString unsavedWords(const QStringList& fields) {
  return SherdDetails::tr("Not saved yet: %1. Enter in the field saves it.")
      .arg(fields.join(QStringLiteral(", ")));
}

}  // namespace

SherdDetails::SherdDetails(QWidget* parent) : QScrollArea(parent) {
  buildLayout();
  clear();
}

void SherdDetails::buildLayout() {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setAccessibleName(tr("Details of the sherd"));
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  number_ = new QLabel(page);
  number_->setFont(scaledFont(*this, Look::kSection, true));
  number_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  number_->setWordWrap(true);
  number_->setAccessibleName(tr("Number of the sherd"));
  QWidget* acts = buildNumberActs();
  form_ = new QFormLayout;
  form_->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  const auto addField = [&](const records::SherdField& field) {
    form_->addRow(fieldLabel(field.name), editorFor(field.name, field.kind));
    if (field.kind == records::FieldKind::Munsell) addProposal(field.name);
  };
  // A context is chosen with its trench and site; what voids a sherd comes last, for Tab too.
  const std::set<std::string> elsewhere = {"site", "trench", "context", "void_reason"};
  for (const records::SherdField& field : sherds::sherdFields()) {
    if (field.name == std::string("site")) addPlace();
    if (field.editable && !elsewhere.contains(field.name)) addField(field);
  }
  for (const records::SherdField& field : sherds::sherdFields())
    if (field.name == std::string("void_reason")) addField(field);
  filled(column, {number_, acts, form_});
  addTables(*column);
  column->addStretch();
  buildRefusal();
  setWidget(page);
}

// What a draft offers takes no other place than it has in a sherd with a number, so that from one
// to the next the fields stay where they are.
QWidget* SherdDetails::buildNumberActs() {
  number_acts_ = named<QStackedWidget>("numberActs", this);
  number_acts_->addWidget(new QWidget(number_acts_));
  give_number_ = named<ElidedButton>("giveNumber", icon("label"),
                                     tr("Assign number %1").arg(QString()), number_acts_);
  connect(give_number_, &QPushButton::clicked, this, &SherdDetails::numberWanted);
  number_acts_->addWidget(give_number_);
  auto* none = new QWidget(number_acts_);
  why_no_number_ = named<ElidedLabel>("whyNoNumber", none);
  why_no_number_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* numbering = named<ElidedButton>("openNumbering", icon("settings"), tr("Numbering…"), none);
  connect(numbering, &QPushButton::clicked, this, &SherdDetails::numberingWanted);
  filled(bareLayout<QHBoxLayout>(none), {{why_no_number_, 1}, numbering});
  number_acts_->addWidget(none);
  number_acts_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return number_acts_;
}

void SherdDetails::showNumberActs(const catalogue::Catalogue& catalogue,
                                  const records::SherdRecord& sherd) {
  number_acts_->setCurrentIndex(0);
  if (!sherd.number.empty()) return;
  const auto proposed = sherds::Numbers(catalogue).propose(std::span(&sherd.row, 1));
  if (proposed)
    give_number_->setText(tr("Assign number %1").arg(QString::fromStdString(proposed->front())));
  else
    why_no_number_->setText(wordsOf(proposed.error().what));
  number_acts_->setCurrentIndex(proposed ? 1 : 2);
}

void SherdDetails::buildRefusal() {
  refusal_ = named<QWidget>("refusal", this);
  refusal_->setAutoFillBackground(true);
  auto* column = new QVBoxLayout(refusal_);
  told_ = new QScrollArea(refusal_);
  told_->setFrameShape(QFrame::NoFrame);
  told_->setWidgetResizable(true);
  told_->setFocusPolicy(Qt::NoFocus);
  auto* told = new QWidget(told_);
  auto* row = bareLayout<QHBoxLayout>(told);
  refusal_picture_ = new QLabel(told);
  refusal_picture_->setAccessibleName(tr("Picture of the sherd in the way"));
  refusal_text_ = wrappedLabel(told, "refusalText");
  filled(row, {refusal_picture_, {refusal_text_, 1}});
  confirm_ = named<ElidedButton>("confirmChange", icon("check"), tr("Confirm"), refusal_);
  confirm_->setFocusPolicy(Qt::TabFocus);  // a press that took the focus would move it away
  confirm_->setMinimumHeight(targetSize(*this));
  told_->setWidget(told);
  filled(column, {told_, confirm_});
  connect(confirm_, &QPushButton::clicked, this, [this] {
    editors_.value(asked_field_)->setFocus();
    if (sherd_) emit confirmed(asked_field_, unsaved_.of(sherd_).value(asked_field_));
  });
}

void SherdDetails::addPlace() {
  place_ = named<QComboBox>({"field_place", tr("Context")}, this);
  place_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(place_, &QComboBox::activated, this, [this](int index) {
    const QString place = place_->itemData(index).toString();
    if (sherd_ && index >= 0 && place != shown_.value("place")) emit edited("place", place);
  });
  form_->addRow(tr("context"), place_);
}

void SherdDetails::addProposal(const std::string& field) {
  const QString name = QString::fromStdString(field);
  auto* line = new MunsellLine(field, this);
  connect(line, &MunsellLine::takenOver, this, [this, name](const QString& notation) {
    if (sherd_) emit edited(name, notation);
  });
  form_->addRow(line);
  form_->setRowVisible(line, false);
  proposals_.insert(name, line);
}

void SherdDetails::offerProposals(const colour::MunsellProposals& proposals,
                                  const records::SherdRecord& sherd) {
  for (MunsellLine* line : std::as_const(proposals_))
    form_->setRowVisible(line, line->offer(proposals, sherd));
}

// A slow disk must not keep the window waiting for them.
void SherdDetails::readProposals(const std::filesystem::path& project,
                                 const records::SherdRecord& sherd, JobRunner& jobs) {
  if (reading_) reading_->drop();
  reading_ = nullptr;
  if (sherd.model_path.empty()) return offerProposals({}, sherd);
  const auto file = (project / sherd.model_path).replace_extension(".glb");
  reading_ = jobs.start(makeJob([file](Progress&, std::stop_token) {
                          return Result<colour::MunsellProposals>(
                              colour::parseMunsellProposals(extrasInGlb(file).munsell)
                                  .value_or(colour::MunsellProposals()));
                        }),
                        this);
  connect(reading_, &JobHandle::finished, this, [this, sherd](const JobOutcome& outcome) {
    if (const auto read = outcomeAs<colour::MunsellProposals>(outcome))
      offerProposals(*read, sherd);
  });
}

// Custom fields stand above what voids a sherd, for Tab too.
void SherdDetails::setCustomFields(const std::vector<std::string>& fields) {
  if (!sherd_) {  // they may be another project's, and nobody types in them
    for (const std::string& field : custom_fields_)
      form_->removeRow(editors_.take(QString::fromStdString(field)));
    custom_fields_.clear();
  }
  QWidget* last = editors_.value("void_reason");
  for (const std::string& field : fields) {
    if (editors_.contains(QString::fromStdString(field))) continue;
    QWidget* before =
        editors_.value(custom_fields_.empty() ? QStringLiteral("note")
                                              : QString::fromStdString(custom_fields_.back()));
    int row = 0;
    QFormLayout::ItemRole role = QFormLayout::FieldRole;
    form_->getWidgetPosition(last, &row, &role);
    form_->insertRow(row, fieldLabel(field), editorFor(field, records::FieldKind::Text));
    QWidget::setTabOrder(before, editors_.value(QString::fromStdString(field)));
    custom_fields_.push_back(field);
  }
}

QWidget* SherdDetails::editorFor(const std::string& field, records::FieldKind kind) {
  const QString name = QString::fromStdString(field);
  QWidget* editor = nullptr;
  const auto told = [this, name](const QString& value) {
    if (!sherd_) return;
    // Asked about already: a press of the answer takes the focus away, and must not ask anew.
    const bool asked = confirm_->isVisible() && asked_field_ == name;
    if (asked && unsaved_.of(sherd_).value(name) == value) return;
    // What could not be saved is tried again, or given up by what was there before.
    if (value != shown_.value(name) || unsaved_.of(sherd_).contains(name)) emit edited(name, value);
  };
  if (kind == records::FieldKind::Term) {
    auto* box = new QComboBox(this);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(box, &QComboBox::activated, this, [box, told](int) { told(box->currentText()); });
    editor = box;
  } else {
    auto* line = new QLineEdit(this);
    if (name == QLatin1String("number"))
      line->setToolTip(
          tr("7 is the running number in the sherd's context; =7 is the number 7 "
             "itself."));
    if (kind == records::FieldKind::Edtf)
      line->setPlaceholderText(tr("-0599/-0549: 600 to 550 BC"));
    if (kind == records::FieldKind::Terms) {
      auto* completer = new QCompleter(new QStringListModel(line), line);
      completer->setCaseSensitivity(Qt::CaseInsensitive);
      line->setCompleter(completer);
    }
    connect(line, &QLineEdit::editingFinished, this, [this, name, line, told] {
      put_[name] = line->text();
      told(line->text());
    });
    line->installEventFilter(this);
    editor = line;
  }
  editor->setObjectName("field_" + name);
  editor->setAccessibleName(fieldLabel(field));
  editors_.insert(name, editor);
  return editor;
}

void SherdDetails::setVocabularies(const catalogue::Catalogue& catalogue) {
  words_.read(catalogue);
  if (const auto own = sherds::Sherds(catalogue).customFields()) setCustomFields(*own);
  for (const records::SherdField& field : sherds::sherdFields()) {
    if (std::string_view(field.vocabulary).empty()) continue;
    const QStringList terms = words_.of(field);
    QWidget* editor = editors_.value(field.name);
    if (auto* box = qobject_cast<QComboBox*>(editor)) {
      box->clear();
      box->addItem({});
      box->addItems(terms);
    } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
      qobject_cast<QStringListModel*>(line->completer()->model())->setStringList(terms);
      line->setPlaceholderText(terms.mid(0, 4).join("; ") + "; …");
    }
  }
}

void SherdDetails::setText(const std::string& field, const QString& text) {
  const QString name = QString::fromStdString(field);
  shown_.insert(name, text);
  QWidget* editor = editors_.value(name);
  if (auto* box = qobject_cast<QComboBox*>(editor)) {
    if (box->findText(text) < 0) box->addItem(text);
    box->setCurrentText(text);
  } else if (auto* line = qobject_cast<QLineEdit*>(editor); line && !isTyping(name)) {
    if (line->text() == text && !line->isUndoAvailable()) return;  // what is marked stays marked
    put(name, text);
    line->setCursorPosition(0);
  }
}

void SherdDetails::put(const QString& field, const QString& text) {
  auto* line = qobject_cast<QLineEdit*>(editors_.value(field));
  line->setText(text);
  put_[field] = line->text();
}

bool SherdDetails::isTyping(const QString& field) const {
  const auto* line = qobject_cast<QLineEdit*>(editors_.value(field));
  return sherd_ && line != nullptr && line->text() != put_.value(field);
}

// Something else than a person's leaving it takes the sherd away.
void SherdDetails::keepTyped() {
  for (auto at = editors_.begin(); at != editors_.end(); ++at) {
    if (!isTyping(at.key())) continue;
    put_[at.key()] = qobject_cast<QLineEdit*>(at.value())->text();
    unsaved_.keep(sherd_, at.key(), put_.value(at.key()));
  }
}

void SherdDetails::keepUnsaved(const QString& field, const QString& value) {
  unsaved_.keep(sherd_, field, value);
  showUnsaved();
}

// In a narrow pane labels stand above their fields, which would have no room beside them.
void SherdDetails::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  fitRefusal();
  const bool narrow = viewport()->width() < 2 * Look::kLabelColumn;
  form_->setRowWrapPolicy(narrow ? QFormLayout::WrapAllRows : QFormLayout::WrapLongRows);
}

// Esc gives up what was typed; Ctrl+Z in a field where nothing was typed is the catalogue's.
bool SherdDetails::eventFilter(QObject* watched, QEvent* event) {
  auto* line = qobject_cast<QLineEdit*>(watched);
  if (line != nullptr && event->type() == QEvent::ShortcutOverride && !line->isUndoAvailable() &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo)) {
    event->ignore();
    return true;
  }
  if (line == nullptr || event->type() != QEvent::KeyPress ||
      static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
    return QScrollArea::eventFilter(watched, event);
  const QString name = editors_.key(line), saved = shown_.value(name);
  if (line->text() == saved && !unsaved_.of(sherd_).contains(name)) return false;
  forgetUnsaved(name);
  put(name, saved);
  return true;
}

void SherdDetails::ask(const QString& field, const QString& value, const QString& question,
                       const QString& act) {
  keepUnsaved(field, value);
  showRefusal(field.toStdString(), question, {}, {});
  asked_field_ = field;
  confirm_->setText(act);
  confirm_->show();
  fitRefusal();
}

void SherdDetails::forgetUnsaved(const QString& field) {
  if (unsaved_.forget(sherd_, field)) hideRefusal();
}

void SherdDetails::showUnsaved() {
  const QHash<QString, QString> typed = unsaved_.of(sherd_);
  for (auto at = typed.begin(); at != typed.end(); ++at) {
    if (qobject_cast<QLineEdit*>(editors_.value(at.key())) && !isTyping(at.key()))
      put(at.key(), *at);
    if (auto* box = qobject_cast<QComboBox*>(editors_.value(at.key()))) box->setCurrentText(*at);
  }
  if (!typed.isEmpty())
    placeRefusal(typed.begin().key().toStdString(), unsavedWords(labelsOf(typed)), {}, {});
}

void SherdDetails::showSherd(const catalogue::Catalogue& catalogue,
                             const std::filesystem::path& project, store::SherdRow row,
                             JobRunner& jobs) {
  const Result<records::SherdRecord> sherd = sherds::Sherds(catalogue).get(row);
  if (!sherd) {
    clear();
    return;
  }
  if (row != sherd_) {
    keepTyped();
    for (MunsellLine* line : std::as_const(proposals_)) line->clear();
  }
  sherd_ = row;
  widget()->setEnabled(true);
  hideRefusal();
  number_->setText(sherdName(*sherd));
  showNumberActs(catalogue, *sherd);
  for (const records::SherdField& field : sherds::sherdFields())
    if (field.editable)
      setText(field.name,
              words_.shown(field, typedText(field, sherds::textOf(*sherd, field.name))));
  for (const std::string& field : custom_fields_)
    setText(field, QString::fromStdString(sherds::textOf(*sherd, field)));
  place_->clear();
  if (const auto contexts = catalogue::Places(catalogue).contexts())
    for (const records::ContextRecord& context : *contexts) {
      const QStringList codes = {QString::fromStdString(context.site_code),
                                 QString::fromStdString(context.trench_code),
                                 QString::fromStdString(context.number)};
      place_->addItem(codes.join(' ').simplified(), codes.join('\n'));
      if (context.row == sherd->context) place_->setCurrentIndex(place_->count() - 1);
    }
  if (!sherd->context) place_->setCurrentIndex(-1);
  shown_.insert("place", place_->currentData().toString());
  readProposals(project, *sherd, jobs);
  showUnsaved();
  showTables(catalogue, project, *sherd);
}

void SherdDetails::clear() {
  keepTyped();
  sherd_ = {};
  hideRefusal();
  number_acts_->setCurrentIndex(0);
  number_->setText(tr("Choose a sherd."));
  place_->clear();
  for (const records::SherdField& field : sherds::sherdFields())
    if (field.editable) setText(field.name, {});
  for (const std::string& field : custom_fields_) setText(field, {});
  if (reading_) reading_->drop();
  reading_ = nullptr;
  offerProposals({}, {});
  clearTables();
  widget()->setEnabled(false);
}

void SherdDetails::edit(const std::string& wanted) {
  QString name = QString::fromStdString(wanted);
  if (!editors_.contains(name)) name = "part";
  QWidget* editor = editors_.value(name);
  ensureWidgetVisible(editor);
  editor->setFocus(Qt::ShortcutFocusReason);
  if (auto* line = qobject_cast<QLineEdit*>(editor)) line->selectAll();
}

// The other fields that were refused before are named along.
void SherdDetails::showRefusal(const std::string& field, const QString& sentence,
                               const QString& other, const QString& picture) {
  QHash<QString, QString> before = unsaved_.of(sherd_);
  before.remove(QString::fromStdString(field));
  const QString whole = other.isEmpty() ? sentence : tr("%1 It is %2.").arg(sentence, other);
  const QString text =
      before.isEmpty() ? whole : whole + QLatin1Char('\n') + unsavedWords(labelsOf(before));
  placeRefusal(field, text, other, picture);
}

void SherdDetails::placeRefusal(const std::string& field, const QString& sentence,
                                const QString& other, const QString& picture) {
  const QString name = QString::fromStdString(field);
  refusal_text_->setText(sentence);
  refusal_picture_->setVisible(!other.isEmpty());
  confirm_->hide();
  if (!other.isEmpty()) setPicture(refusal_picture_, picture, kSmallPicture);
  QWidget* editor = name == QLatin1String("place") ? place_ : editors_.value(name);
  delete refused_.data();
  // A window that closes takes the focus from the field, and no button any more.
  if (auto* line = qobject_cast<QLineEdit*>(editor); line != nullptr && !window()->isHidden()) {
    line->setMinimumWidth(line->minimumSizeHint().width());  // else its row wraps for the mark
    refused_ = line->addAction(icon("error"), QLineEdit::TrailingPosition);
  }
  refusal_->show();
  fitRefusal();
  if (editor == nullptr) return;
  ensureWidgetVisible(editor);  // not behind what is said of it
  QWidget::setTabOrder(editor, confirm_);
}

// Below what scrolls, so that no field moves under the pointer.
void SherdDetails::fitRefusal() {
  if (refusal_->isHidden()) return setViewportMargins({});
  QRect room = contentsRect();
  if (verticalScrollBar()->isVisible()) room.setWidth(room.width() - verticalScrollBar()->width());
  const QLayout& outside = *refusal_->layout();
  const QMargins margins = outside.contentsMargins();
  const int rest = margins.top() + margins.bottom() +
                   (confirm_->isHidden()
                        ? 0
                        : std::max(outside.spacing(), 0) +
                              std::max(confirm_->sizeHint().height(), confirm_->minimumHeight()));
  QLayout& inside = *told_->widget()->layout();
  inside.activate();  // what was shown or said since counts
  const int wide = room.width() - margins.left() - margins.right();
  const int said = inside.hasHeightForWidth() ? inside.totalHeightForWidth(wide)
                                              : inside.totalSizeHint().height();
  // Half the room stays the fields'; a long sentence is scrolled.
  told_->setFixedHeight(std::min(said, std::max(room.height() / 2 - rest, fontMetrics().height())));
  const int high = told_->height() + rest;
  refusal_->setGeometry(room.left(), room.bottom() + 1 - high, room.width(), high);
  setViewportMargins(0, 0, 0, high);
}

void SherdDetails::hideRefusal() {
  delete refused_.data();
  refusal_->hide();
  fitRefusal();
}

}  // namespace ostraka::ui
