#include "ui/export/export_screen.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/sherds/surface_choice.h"
#include "ui/widgets/big_button.h"
#include "ui/widgets/flow_row.h"
#include "ui/widgets/open_outside.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/page_area.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/side_by_side.h"

namespace ostraka::ui {

ExportScreen::ExportScreen(QWidget* parent)
    : Screen(tr("Export"), QStringLiteral("export"), parent), model_(this) {
  buildLayout();
  connect(&model_, &ExportModel::changed, this, &ExportScreen::refresh);
  connect(&model_, &ExportModel::finished, this, [this] {
    if (model_.state() == ExportModel::State::Done)
      emit said(tr("Exported: %1").arg(model_.closingLine()));
  });
  closeProject();
}

QWidget* ExportScreen::buildWhat() {
  auto* box = new QGroupBox(tr("What"), this);
  all_ = named<QRadioButton>("all", tr("All sherds"), box);
  filtered_ = named<QRadioButton>("filtered", tr("Matching the filter"), box);
  chosen_ = named<QRadioButton>("chosen", box);
  archive_ = named<QRadioButton>("archive", tr("The whole project, as an archive"), box);
  filter_ = named<QLineEdit>({"exportFilter", tr("Filter of what is exported")}, box);
  filter_->setPlaceholderText(tr("context:0012"));
  auto* column = new QVBoxLayout(box);
  for (QWidget* widget :
       std::initializer_list<QWidget*>{all_, filtered_, filter_, chosen_, archive_}) {
    widget->setMinimumHeight(controlHeight(*this));
    column->addWidget(widget);
  }
  connect(all_, &QRadioButton::clicked, this, [this] { choose(What::All); });
  connect(filtered_, &QRadioButton::clicked, this,
          [this] { choose(What::Filtered, filter_->text()); });
  connect(chosen_, &QRadioButton::clicked, this, [this] { choose(What::Chosen); });
  connect(archive_, &QRadioButton::clicked, this, [this] { choose(What::Project); });
  connect(filter_, &QLineEdit::editingFinished, this, [this] {
    if (filter_->text() != model_.selection().filter) choose(What::Filtered, filter_->text());
  });
  column->addStretch();
  return box;
}

QWidget* ExportScreen::buildForms() {
  auto* box = new QGroupBox(tr("Formats"), this);
  box->setObjectName("formats");
  auto* column = new QVBoxLayout(box);
  column->setSpacing(2);  // the rows' own height keeps them apart
  const std::pair<exchange::Form, QString> all[] = {
      {exchange::Form::Csv, tr("Tables (CSV): English headings, decimal points")},
      {exchange::Form::Ods, tr("Tables (ODS): LibreOffice, Excel")},
      {exchange::Form::Json, tr("Records (JSON), re-importable")},
      {exchange::Form::Pictures, tr("A picture of each model (PNG)")},
      {exchange::Form::Ply, tr("Models as PLY, in mm")},
      {exchange::Form::Glb, tr("Models as GLB, for the web and for slides")},
      {exchange::Form::Obj, tr("Models as OBJ, in mm")},
      {exchange::Form::Drawings, tr("Drawings for print (SVG and PDF)")},
      {exchange::Form::Photographs, tr("The photographs, unchanged")},
      {exchange::Form::Views, tr("Pictures, masks, poses for COLMAP and OpenMVS")}};
  for (const auto& [form, text] : all) {
    auto* check = named<QCheckBox>("form" + QString::number(static_cast<int>(form)), text, box);
    check->setMinimumHeight(controlHeight(*this));  // the row between them counts, too
    connect(check, &QCheckBox::clicked, this, [this, kind = form](bool wanted) {
      exchange::ExportOptions options = model_.options();
      if (wanted)
        options.forms.insert(kind);
      else
        options.forms.erase(kind);
      model_.setOptions(std::move(options));
    });
    forms_.emplace_back(check, form);
    if (form != exchange::Form::Drawings && form != exchange::Form::Ply) {
      column->addWidget(check);
      continue;
    }
    auto* row = new FlowRow;  // long words of some languages go on below
    row->addWidget(check);
    if (form == exchange::Form::Ply) {
      row->addWidget(buildDetail(box));
    } else {
      row->addWidget(buildScale(box));
      row->addWidget(buildSurface(box));
    }
    column->addLayout(row);
  }
  return box;
}

QWidget* ExportScreen::buildScale(QWidget* box) {
  auto* scale = named<QComboBox>({"exportScale", tr("Scale of the drawings")}, box);
  scale->addItem(tr("1 : 1"), 1.0);
  scale->addItem(tr("1 : 2"), 0.5);
  scale->addItem(tr("fit to A4"), QVariant());
  connect(scale, &QComboBox::activated, this, [this, scale](int at) {
    const QVariant chosen = scale->itemData(at);
    exchange::ExportOptions options = model_.options();
    options.drawing_scale = chosen.isValid() ? std::optional(chosen.toDouble()) : std::nullopt;
    model_.setOptions(std::move(options));
  });
  return scale_ = scale;
}

QWidget* ExportScreen::buildSurface(QWidget* box) {
  surface_ = named<SurfaceChoice>({"exportSurface", tr("Surfaces in the drawings")}, box);
  connect(surface_, &QComboBox::activated, this, [this] {
    exchange::ExportOptions options = model_.options();
    options.drawing_surface = surface_->surface();
    options.drawing_dpi = surface_->dpi();
    model_.setOptions(std::move(options));
  });
  return surface_;
}

QWidget* ExportScreen::buildDetail(QWidget* box) {
  auto* detail = named<QComboBox>({"exportDetail", tr("Detail of the models")}, box);
  detail->setToolTip(
      tr("How large a GLB may be. PLY and OBJ get the same surface. Larger models get fewer "
         "triangles and smaller photographs; how far they are off is measured and stated in each "
         "file."));
  const auto add = [detail](const QString& text, std::size_t most_bytes) {
    detail->addItem(text, static_cast<qulonglong>(most_bytes));
  };
  add(tr("Full detail"), 0);
  add(tr("for the web, up to 5 MB"), exchange::kWebBytes);
  add(tr("for a phone, up to 1 MB"), exchange::kPhoneBytes);
  connect(detail, &QComboBox::activated, this, [this, detail](int at) {
    exchange::ExportOptions options = model_.options();
    options.most_model_bytes = detail->itemData(at).toULongLong();
    model_.setOptions(std::move(options));
  });
  return detail_ = detail;
}

QWidget* ExportScreen::buildWhere() {
  auto* box = new QGroupBox(tr("Where"), this);
  target_ = named<QLineEdit>({"target", tr("New folder for the export")}, box);
  QPushButton* choose =
      iconButton(box, "browse", "folder", tr("Choose…"), this, &ExportScreen::browse);
  filled(new QHBoxLayout(box), {{target_, 1}, choose});
  connect(target_, &QLineEdit::textEdited, &model_, &ExportModel::setTarget);
  return box;
}

void ExportScreen::buildLayout() {
  size_ = wrappedLabel(this, "size");
  size_->setFont(scaledFont(*this, Look::kSection, true));
  problem_ = wrappedLabel(this, "problem");
  closing_ = wrappedLabel(this, "closing");
  closing_->setFont(scaledFont(*this, Look::kSection, true));
  bar_ = new QProgressBar(this);
  bar_->setRange(0, 1000);
  bar_->setAccessibleName(tr("Progress of the export"));
  start_ = new BigButton("start", tr("Export"), this);
  cancel_ = iconButton(this, "cancel", "cancel", tr("Cancel"), &model_, &ExportModel::cancel);
  open_ = new BigButton("open", tr("Open folder"), this);
  connect(start_, &QPushButton::clicked, &model_, &ExportModel::start);
  stop_ = addPageAct(this, "exportStop", "cancel", tr("Stop the export"), Qt::Key_Escape, &model_,
                     &ExportModel::cancel);
  connect(open_, &QPushButton::clicked, this, [this] { emit said(openOutside(model_.target())); });
  auto* choices = new QWidget(this);
  auto* upper = new SideBySide(choices);
  upper->add(buildWhat(), 1);
  upper->add(buildForms(), 1);
  filled(bareLayout<QVBoxLayout>(choices), {upper, buildWhere(), problem_, Part::room()});
  auto* foot =
      filled(new QHBoxLayout, {{size_, 1}, {closing_, 1}, {bar_, 1}, open_, cancel_, start_});
  filled(pageColumn(this), {{new PageArea(choices, this), 1}, foot});
}

QAbstractButton* ExportScreen::primary() const {
  return model_.state() == ExportModel::State::Done ? open_ : start_;
}

void ExportScreen::openProject(ProjectSession& session) {
  closeProject();
  model_.openProject(&session);
  setEnabled(true);
}

QString ExportScreen::losesByClosing() const {
  return model_.state() == ExportModel::State::Running
             ? tr("The export is not finished, and nothing of it would be kept. Close once more to "
                  "stop it.")
             : QString();
}

void ExportScreen::closeProject() {
  setEnabled(false);  // before, so that no line keeps what is typed in it
  model_.openProject(nullptr);
}

void ExportScreen::showEvent(QShowEvent* event) {
  Screen::showEvent(event);
  model_.setWatched(true);
}

void ExportScreen::hideEvent(QHideEvent* event) {
  Screen::hideEvent(event);
  model_.setWatched(false);
}

void ExportScreen::choose(What what, const QString& filter) {
  ExportSelection selection = model_.selection();
  selection.what = what;
  if (what == What::Filtered) selection.filter = filter;
  model_.choose(std::move(selection));
}

void ExportScreen::showItem(const QString& what) {
  if (what.startsWith("rows:")) {
    ExportSelection selection{What::Chosen, model_.selection().filter, {}};
    for (const QString& row : what.mid(5).split(',', Qt::SkipEmptyParts))
      selection.chosen.push_back({row.toLongLong()});
    model_.choose(std::move(selection));
  } else if (what.startsWith("filter:") && what.size() > 7) {
    choose(What::Filtered, what.mid(7));
  } else {
    choose(What::All);
  }
}

void ExportScreen::takeChosen(const QString& what) {
  if (what.isEmpty() || model_.state() == ExportModel::State::Running) return;
  if (what.startsWith(kPlate)) return;  // what one looks at is not what one gives away
  showItem(what);
}

void ExportScreen::browse() {
  const QString parent = QFileDialog::getExistingDirectory(this, tr("Folder for the export"));
  if (parent.isEmpty()) return;
  const QString name = model_.target().section('/', -1);
  model_.setTarget(parent + "/" + (name.isEmpty() ? "export" : name));
}

void ExportScreen::refresh() {
  const bool running = model_.state() == ExportModel::State::Running;
  const QSignalBlocker quiet(filter_);
  const ExportSelection& selection = model_.selection();
  const exchange::ExportOptions& options = model_.options();
  all_->setChecked(selection.what == What::All);
  filtered_->setChecked(selection.what == What::Filtered);
  chosen_->setChecked(selection.what == What::Chosen);
  archive_->setChecked(model_.isArchive());
  chosen_->setText(selection.chosen.empty() ? tr("Selected sherds")
                                            : tr("%n selected sherd(s)", nullptr,
                                                 static_cast<int>(selection.chosen.size())));
  chosen_->setEnabled(!selection.chosen.empty());
  if (!filter_->hasFocus()) filter_->setText(selection.filter);
  for (const auto& [check, form] : forms_) check->setChecked(options.forms.contains(form));
  scale_->setCurrentIndex(options.drawing_scale ? scale_->findData(*options.drawing_scale)
                                                : scale_->count() - 1);
  surface_->choose(options.drawing_surface, options.drawing_dpi);
  detail_->setCurrentIndex(
      std::max(0, detail_->findData(static_cast<qulonglong>(options.most_model_bytes))));
  if (!target_->hasFocus()) target_->setText(model_.target());
  size_->setText(model_.sizeText());
  const bool done = model_.state() == ExportModel::State::Done;
  size_->setVisible(!running && !done);
  QString problem = model_.problem();
  const QStringList warnings = model_.warnings();
  if (!warnings.isEmpty()) problem += (problem.isEmpty() ? "" : "\n") + warnings.join('\n');
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  closing_->setText(model_.closingLine());
  closing_->setVisible(done);
  bar_->setVisible(running);
  bar_->setValue(qRound(1000 * model_.fraction()));
  bar_->setFormat(model_.progressText());
  start_->setEnabled(model_.canStart());
  stop_->setEnabled(running);
  const bool begun = running && cancel_->isHidden();
  if (begun) cancel_->show();
  if (begun && isVisible()) cancel_->setFocus();  // else Esc would find nobody
  emit working(running ? tr("Export: %1").arg(model_.progressText()) : QString(),
               running ? model_.fraction() : -1);
  open_->setVisible(done);
  start_->setVisible(!done);
  for (QWidget* box : findChildren<QGroupBox*>())
    box->setEnabled(!running && !(box->objectName() == "formats" && model_.isArchive()));
  if (running) return;
  // Else the focus would go to a button of the window's foot.
  if (cancel_->hasFocus())
    (primary()->isEnabled() ? static_cast<QWidget*>(primary()) : target_)->setFocus();
  cancel_->hide();
}

}  // namespace ostraka::ui
