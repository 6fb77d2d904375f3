#include "ui/catalogue/drawing_page.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPrintDialog>
#include <QPrinter>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "catalogue/settings.h"
#include "drawing/drawing_files.h"
#include "files/output_place.h"
#include "store/names.h"
#include "store/values.h"
#include "ui/catalogue/sheet_view.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/when_done.h"
#include "ui/look/look.h"
#include "ui/sherds/surface_choice.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"
#include "ui/words/print_wording.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr double kShownDpi = 200;  // three pixels for the thinnest line, when looked at closely
constexpr std::size_t kNamed = 5;  // of the sherds that were left out
constexpr const char* kRimsKey = "drawing.rims";
using drawing::RimChoice;
using Rims = std::map<store::SherdRow, RimChoice>;
// The proposed ending gives way to that of the chosen kind, which a desktop's dialog leaves as it
// was; one that was typed stays.
QString fileOfKind(const QString& file, const QString& kind) {
  const QString proposed = QStringLiteral(".pdf");
  const QString ending =
      kind.isEmpty() ? proposed : kind.section(QStringLiteral("(*"), -1).chopped(1);
  if (file.endsWith(proposed, Qt::CaseInsensitive)) return file.chopped(proposed.size()) + ending;
  const QStringList ours{"svg", "png", "tif", "tiff"};
  return ours.contains(QFileInfo(file).suffix().toLower()) ? file : file + ending;
}

Result<void> onlyWhether(const Result<std::vector<std::filesystem::path>>& written) {
  return written ? Result<void>() : written.error();
}

// Propose is said of none: it is what holds where nothing is said.
Rims readRims(const ProjectSession& session) {
  Rims rims;
  const QJsonObject kept = QJsonDocument::fromJson(session.setting(kRimsKey).toUtf8()).object();
  for (auto at = kept.begin(); at != kept.end(); ++at)
    rims[{at.key().toLongLong()}] = at->toBool() ? RimChoice::Yes : RimChoice::No;
  return rims;
}

void keepRims(ProjectSession& session, const Rims& rims) {
  QJsonObject kept;
  for (const auto& [sherd, rim] : rims)
    kept.insert(QString::number(sherd.value), rim == RimChoice::Yes);
  session.keepSetting(kRimsKey, QJsonDocument(kept).toJson(QJsonDocument::Compact));
}

QString cm(double mm) {
  return QLocale().toString(mm / 10, 'f', 1);
}

}  // namespace

DrawingPage::DrawingPage(QWidget* parent) : QWidget(parent) {
  buildLayout();
  refresh();
}

QLayout* DrawingPage::buildChoices() {
  // Long words of some languages do not widen the window.
  const auto narrow = [](auto* box) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(8);
    box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return box;
  };
  scale_ = narrow(named<QComboBox>({"drawingScale", tr("Scale of the drawing")}, this));
  scale_->addItem(tr("1 : 1"), 1.0);
  scale_->addItem(tr("1 : 2"), 0.5);
  surface_ = narrow(named<SurfaceChoice>({"drawingSurface", tr("How surfaces are drawn")}, this));
  rim_ = narrow(named<QComboBox>({"drawingRim", tr("Whether it is a rim")}, this));
  rim_->addItem(tr("Automatic"), static_cast<int>(RimChoice::Propose));
  rim_->addItem(tr("Rim sherd"), static_cast<int>(RimChoice::Yes));
  rim_->addItem(tr("No rim"), static_cast<int>(RimChoice::No));
  rim_->setPlaceholderText(tr("Different"));  // of sherds that differ
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
  for (const auto& [text, box] :
       {std::pair(tr("Scale"), scale_), std::pair(tr("Surface"), static_cast<QComboBox*>(surface_)),
        std::pair(tr("Rim"), rim_)}) {
    form->addRow(text, box);
    connect(box, &QComboBox::activated, this,
            box == rim_ ? &DrawingPage::rimChosen : &DrawingPage::choicesChanged);
  }
  alignForm(*form);
  for (int row = 0; row < form->rowCount(); ++row)  // the pane is narrower than a page
    form->itemAt(row, QFormLayout::LabelRole)->widget()->setMinimumWidth(0);
  return form;
}

QLayout* DrawingPage::buildActs() {
  enter_ =
      iconButton(this, "enterRim", "check", tr("Enter the diameter"), this, &DrawingPage::enterRim);
  save_ = iconButton(this, "saveDrawing", "export", tr("Save…"), this, &DrawingPage::save);
  print_ = iconButton(this, "printDrawing", "print", tr("Print…"), this, &DrawingPage::print);
  addPageAct(this, {}, {}, tr("Print the drawing"), QKeySequence::Print, this, &DrawingPage::print)
      ->setAutoRepeat(false);
  auto* row = filled(new QHBoxLayout, {{save_, 1}, {print_, 1}});
  return filled(new QVBoxLayout, {enter_, row});
}

void DrawingPage::buildLayout() {
  draw_ = iconButton(this, "drawMany", "edit", {}, this, &DrawingPage::draw);
  bar_ = named<QProgressBar>({"drawingProgress", tr("Progress of the drawing")}, this);
  bar_->setRange(0, 1000);
  stop_ = iconButton(this, "stopDrawing", "cancel", tr("Stop"), this, &DrawingPage::stop);
  auto* working = filled(new QHBoxLayout, {{bar_, 1}, stop_});
  view_ = new SheetView(this);
  view_->setMinimumHeight(fontMetrics().height() * 8);
  const auto turn = [this](const char* picture, const QString& text, int by) {
    auto* made = new QToolButton(this);
    made->setIcon(icon(picture));
    made->setAccessibleName(text);
    made->setToolTip(text);
    connect(made, &QToolButton::clicked, this, [this, by] { showPage(page_ + by); });
    return made;
  };
  previous_ = turn("previous", tr("Previous sheet"), -1);
  next_ = turn("next", tr("Next sheet"), 1);
  next_->setObjectName("nextSheet");
  where_ = named<QLabel>("whichSheet", this);
  auto* pages = filled(new QHBoxLayout, {previous_, where_, next_, Part::room()});
  words_ = wrappedLabel(this, "drawingWords");
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->setAccessibleName(tr("What the drawing says"));
  filled(new QVBoxLayout(this),
         {buildChoices(), draw_, working, {view_, 1}, pages, words_, buildActs()});
}

exchange::DrawSherdsOptions DrawingPage::options() const {
  exchange::DrawSherdsOptions how;
  how.drawing.wording = printWording();
  how.drawing.scale = scale_->currentData().toDouble();
  how.drawing.surface = surface_->surface();
  how.drawing.dpi = surface_->dpi();
  how.rims = rims_;
  return how;
}

const std::vector<Page>& DrawingPage::pages() const {
  static const std::vector<Page> none;
  return drawn_ ? drawn_->pages : none;
}

void DrawingPage::setSherds(ProjectSession* session, std::vector<store::SherdRow> sherds) {
  if (session != session_) rims_ = session ? readRims(*session) : Rims();
  session_ = session;
  sherds_ = std::move(sherds);
  showRim();
  choicesChanged();
}

// What is said of all that are shown.
void DrawingPage::showRim() {
  const auto said = [this](store::SherdRow sherd) {
    const auto found = rims_.find(sherd);
    return found == rims_.end() ? RimChoice::Propose : found->second;
  };
  const RimChoice first = sherds_.empty() ? RimChoice::Propose : said(sherds_.front());
  const bool alike = std::all_of(sherds_.begin(), sherds_.end(),
                                 [&](store::SherdRow sherd) { return said(sherd) == first; });
  rim_->setCurrentIndex(alike ? rim_->findData(static_cast<int>(first)) : -1);
}

void DrawingPage::rimChosen() {
  const auto rim = static_cast<RimChoice>(rim_->currentData().toInt());
  for (const store::SherdRow sherd : sherds_)
    if (rim == RimChoice::Propose)
      rims_.erase(sherd);
    else
      rims_[sherd] = rim;
  if (session_) keepRims(*session_, rims_);
  choicesChanged();
}

void DrawingPage::forget() {
  delete drawing_.data();
  delete painting_.data();
  drawn_.reset();
  problem_.clear();
  view_->showSheet({});
  page_ = 0;
}

void DrawingPage::choicesChanged() {
  forget();
  if (isVisible() && sherds_.size() == 1)
    draw();
  else
    refresh();
}

void DrawingPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!drawn_ && !drawing_ && problem_.isEmpty() && sherds_.size() == 1) draw();
}

void DrawingPage::draw() {
  if (!session_ || sherds_.empty()) return;
  forget();
  drawing::SheetOptions sheets;
  sheets.wording = printWording();
  if (sherds_.size() > 1) sheets.layout = drawing::SheetOptions::Layout::Plates;
  const auto work = [folder = session_->folder(), sherds = sherds_, how = options(), sheets](
                        Progress& progress,
                        std::stop_token stop) -> Result<std::shared_ptr<const Drawn>> {
    const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
    if (!catalogue) return catalogue.error();
    const Result<records::ProjectRecord> project = catalogue::Settings(*catalogue).project();
    if (!project) return project.error();
    Result<exchange::DrawnSherds> drawn =
        exchange::drawSherds(*catalogue, folder, sherds, how, progress, stop);
    if (!drawn) return drawn.error();
    drawing::SheetOptions titled = sheets;
    titled.title = project->title;
    auto made = std::make_shared<Drawn>();
    made->pages = drawing::layOut(drawn->drawings, how.drawing.scale, titled);
    made->sherds = std::move(*drawn);
    made->how = how;
    return std::shared_ptr<const Drawn>(std::move(made));
  };
  const JobPriority priority = sherds_.size() > 1 ? JobPriority::Background : JobPriority::Quick;
  drawing_ = session_->jobs().start(makeJob(work, priority), this);
  connect(drawing_, &JobHandle::progressed, this, [this](const JobProgress& progress) {
    bar_->setValue(qRound(1000 * progress.fraction));
  });
  whenDone<std::shared_ptr<const Drawn>>(drawing_, this, [this](const auto& drawn) {
    if (drawn) return arrived(*drawn);
    problem_ = drawn.error().code == ErrorCode::Cancelled ? tr("Cancelled. Nothing was drawn.")
                                                          : sentenceOf(drawn.error());
    refresh();
  });
  bar_->setValue(0);
  refresh();
}

void DrawingPage::stop() {
  if (drawing_) drawing_->cancel();
}

void DrawingPage::arrived(const std::shared_ptr<const Drawn>& drawn) {
  drawn_ = drawn;
  showPage(0);
}

void DrawingPage::showPage(int page) {
  if (!drawn_ || page < 0 || page >= static_cast<int>(pages().size())) return refresh();
  page_ = page;
  refresh();
  delete painting_.data();
  const auto work = [drawn = drawn_, page](Progress&, std::stop_token) -> Result<QImage> {
    return paintedSheet(drawn->pages[static_cast<std::size_t>(page)], kShownDpi);
  };
  painting_ = session_->jobs().start(makeJob(work), this);
  whenDone<QImage>(painting_, this, [this](const auto& sheet) {
    if (sheet) view_->showSheet(*sheet);
  });
}

const drawing::Mouth* DrawingPage::mouth() const {
  if (!drawn_ || drawn_->sherds.drawings.size() != 1) return nullptr;
  const drawing::SherdDrawing& one = drawn_->sherds.drawings.front();
  return one.mouth && !one.mouth->by_hand ? &*one.mouth : nullptr;
}

QString DrawingPage::words() const {
  if (!problem_.isEmpty()) return problem_;
  if (drawing_) return tr("Drawing %n sherd(s)…", nullptr, static_cast<int>(sherds_.size()));
  if (sherds_.empty()) return tr("Choose a sherd.");
  if (!drawn_) return {};
  QStringList lines;
  const exchange::DrawnSherds& sherds = drawn_->sherds;
  if (const drawing::Mouth* shown = mouth())
    lines << tr("Mouth %1 cm across (95 %: %2 to %3), %4 % of the rim kept.")
                 .arg(cm(shown->diameter_mm.value), cm(shown->diameter_mm.interval->first),
                      cm(shown->diameter_mm.interval->second),
                      QLocale().toString(shown->kept_pct->value, 'f', 0));
  if (sherds_.size() == 1) {
    for (const drawing::SherdDrawing& one : sherds.drawings)
      lines << listOf(one.remarks) << listOf(one.hints);
    for (const exchange::SherdLeftOut& out : sherds.left_out) lines << wordsOf(out.why);
    return lines.join('\n');
  }
  lines << tr("%1 drawn, %2 left out.").arg(sherds.drawings.size()).arg(sherds.left_out.size());
  for (std::size_t i = 0; i < std::min(kNamed, sherds.left_out.size()); ++i)
    lines << wordsOf(sherds.left_out[i].why);
  return lines.join('\n');
}

void DrawingPage::refresh() {
  const int count = static_cast<int>(sherds_.size()), sheets = static_cast<int>(pages().size());
  draw_->setVisible(count > 1 && !drawing_ && !drawn_);
  draw_->setText(tr("Draw plates of %n sherd(s)", nullptr, count));
  bar_->setVisible(drawing_ != nullptr);
  stop_->setVisible(drawing_ != nullptr);
  for (QWidget* widget : std::initializer_list<QWidget*>{previous_, next_, where_})
    widget->setVisible(sheets > 1);
  previous_->setEnabled(page_ > 0);
  next_->setEnabled(page_ + 1 < sheets);
  where_->setText(tr("Sheet %1 of %2").arg(page_ + 1).arg(sheets));
  words_->setText(words());
  words_->setVisible(!words_->text().isEmpty());
  const bool ready = sheets > 0 && !writing_;
  save_->setEnabled(ready);
  print_->setEnabled(ready);
  enter_->setVisible(count == 1 && mouth());
}

QString DrawingPage::fileName() const {
  return sherds_.size() > 1 ? tr("plates")
                            : QString::fromStdString(store::slug(
                                  printWording().said(drawn_->sherds.drawings.front().id)));
}

// What is shown may become another drawing while somebody chooses where this one goes.
void DrawingPage::save() {
  const std::shared_ptr<const Drawn> drawn = drawn_;
  QString kind;
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the drawing"), QDir::home().filePath(fileName() + ".pdf"),
      tr("PDF, all sheets (*.pdf);;SVG, a file each sheet (*.svg);;PNG, the views of each sherd "
         "(*.png);;TIFF, the views of each sherd (*.tif)"),
      &kind);
  if (!file.isEmpty()) saveAs(fileOfKind(file, kind), drawn);
}

void DrawingPage::saveTo(const QString& file, const QString& kind) {
  saveAs(fileOfKind(file, kind), drawn_);
}

void DrawingPage::saveAs(const QString& file, const std::shared_ptr<const Drawn>& drawn) {
  if (!drawn || !session_) return;
  write(
      drawn,
      [drawn, folder = session_->folder(), path = std::filesystem::path(file.toStdString())](
          const std::vector<Page>& pages, Progress& progress,
          std::stop_token stop) -> Result<void> {
        const Result<drawing::DrawnAs> as = drawing::drawnAs(path);
        if (!as) return as.error();
        if (*as == drawing::DrawnAs::Sheets) return onlyWhether(drawing::writeSheets(path, pages));
        const Result<catalogue::Catalogue> catalogue = upkeep::Project::connect(folder);
        if (!catalogue) return catalogue.error();
        const auto pictures = exchange::picturesOf(*catalogue, folder, drawn->sherds, drawn->how,
                                                   path, progress, std::move(stop));
        if (!pictures) return pictures.error();
        return onlyWhether(drawing::writePictures(path, *pictures));
      },
      tr("Saved: %1").arg(file));
}

void DrawingPage::print() {
  if (!print_->isEnabled()) return;
  auto printer = std::make_shared<QPrinter>(QPrinter::HighResolution);
  printer->setFullPage(true);
  printer->setDocName(fileName() + QStringLiteral(".pdf"));  // a file is called like this
  auto* dialog = new QPrintDialog(printer.get(), this);      // knows printing into a PDF file, too
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, printer, drawn = drawn_] {
    const QString file = printer->outputFileName();
    write(
        drawn,
        [printer, file](const std::vector<Page>& pages, Progress&, const std::stop_token&) {
          const Result<void> good = checkOutputPlace(file.toStdString());  // a printer has no file
          return good ? printSheets(*printer, pages) : good;
        },
        file.isEmpty() ? tr("The drawing is sent to the printer; print it at 100 %.")
                       : tr("Saved: %1").arg(file));
  });
  dialog->open();
}

void DrawingPage::write(const std::shared_ptr<const Drawn>& drawn, Writing work,
                        const QString& done) {
  if (!drawn || !session_ || writing_) return;
  const auto job = [drawn, work = std::move(work)](Progress& progress, std::stop_token stop) {
    return work(drawn->pages, progress, std::move(stop));
  };
  writing_ = session_->jobs().start(makeJob(job), this);
  whenDone<void>(writing_, this, [this, done](const auto& written) {
    refresh();
    if (written) return emit said(done);
    words_->setText(sentenceOf(written.error()));
    words_->show();
  });
  refresh();
}

void DrawingPage::enterRim() {
  if (!mouth()) return;
  // With the larger half of the 95 % interval; a share by hand has perhaps none.
  const auto rounded = [](const drawing::Estimate& found) {
    const auto tenths = [](double x) { return store::numberText(std::round(x * 10) / 10); };
    if (!found.interval) return tenths(found.value);
    const auto& [low, high] = *found.interval;
    return tenths(found.value) + " ± " + tenths(std::max(high - found.value, found.value - low));
  };
  emit measuresWanted({{sherds_.front(), "rim_diameter_mm", rounded(mouth()->diameter_mm)},
                       {sherds_.front(), "rim_pct", rounded(*mouth()->kept_pct)}});
}

}  // namespace ostraka::ui
