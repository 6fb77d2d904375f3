#include "ui/import/import_chooser.h"

#include <QFileDialog>
#include <QWidget>

#include "capture/label_code.h"
#include "ui/frame/project_session.h"
#include "ui/import/import_ask.h"
#include "ui/import/path_drop.h"
#include "ui/import/print_sheet_button.h"
#include "ui/import/sides_view.h"
#include "ui/jobs/when_done.h"
#include "ui/widgets/page_acts.h"

namespace ostraka::ui {
namespace {

constexpr const char* kSheetKey = "import.sheet";
constexpr QLatin1String kNoSheet("none");  // a person cleared it, or typed a marker's size
constexpr const char* kMarkerKey = "import.marker_mm";
constexpr std::size_t kLookedAtForLabels = 5;  // of a side: a second or less each

}  // namespace

ImportChooser::ImportChooser(QWidget* screen, ImportAsk* ask)
    : QObject(screen), screen_(screen), ask_(ask) {
  connect(new PathDrop(screen_), &PathDrop::dropped, this, &ImportChooser::take);
  connect(ask_->sides(), &SidesView::sheetChosen, this, [this](const QString& file) {
    if (session_ != nullptr) session_->keepSetting(kSheetKey, file.isEmpty() ? kNoSheet : file);
  });
  connect(ask_->sides(), &SidesView::sheetPrinted, this, [this] {
    if (session_ != nullptr) session_->keepSetting(kSheetKey, {});  // the printed one is proposed
  });
  connect(ask_->sides(), &SidesView::backWanted, this, &ImportChooser::chooseBack);
  connect(ask_->sides(), &SidesView::markerChosen, this, [this](double side_mm) {
    if (session_ == nullptr) return;
    session_->keepSetting(kMarkerKey, QString::number(side_mm));
    session_->keepSetting(kSheetKey, kNoSheet);
  });
}

void ImportChooser::setSession(ProjectSession* session) {
  dropJob(job_);
  dropJob(labels_job_);
  session_ = session;
  screen_->setAcceptDrops(session != nullptr);
}

std::filesystem::path ImportChooser::lastSheet() const {
  const QString kept = session_->setting(kSheetKey);
  return kept.isEmpty() ? printedSheet() : std::filesystem::path(kept.toStdString());
}

std::optional<double> ImportChooser::lastMarker() const {
  const double side_mm = session_->setting(kMarkerKey).toDouble();
  return side_mm > 0 ? std::optional(side_mm) : std::nullopt;
}

void ImportChooser::choose(ImportKind kind) {
  QFileDialog* dialog =
      askForFile(screen_,
                 kind == ImportKind::Scans ? tr("Folder with front/ and back/ scans")
                                           : tr("Folder of a batch, or with photographs"),
                 {}, {});
  connect(dialog, &QFileDialog::fileSelected, this, [this, kind](const QString& folder) {
    if (kind == ImportKind::Scans)
      ask_->ask(folder, kind);
    else
      take({folder});
  });
}

void ImportChooser::chooseBack() {
  QFileDialog* dialog = askForFile(screen_, tr("Folder of the back photographs"), {}, {});
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    if (!ask_->isAsking()) return;
    const Result<SidesPlan> both = withBack(ask_->sides()->plan(), folder);
    if (!both) return emit failed(both.error());
    ask_->sides()->setPlan(*both);
    ask_->askAgain();
    readLabels();
  });
}

// Who has confirmed the import meanwhile is not disturbed any more.
void ImportChooser::readLabels() {
  dropJob(labels_job_);
  const ImportSides sides = ask_->sides()->plan().sides();
  const auto read = [sides](Progress&, std::stop_token stop) {
    auto seen = capture::codesInSome(sides.front, kLookedAtForLabels, stop);
    const auto backs = capture::codesInSome(sides.back, kLookedAtForLabels, stop);
    if (seen && backs) seen->insert(seen->end(), backs->begin(), backs->end());
    return seen;
  };
  labels_job_ = session_->jobs().start(makeJob(read, JobPriority::Background), this);
  whenDone<std::vector<capture::PhotographCodes>>(labels_job_, this, [this](const auto& seen) {
    if (seen && ask_->isAsking()) ask_->takeCodes(*seen);
  });
}

void ImportChooser::take(const QStringList& paths) {
  if (session_ == nullptr || paths.isEmpty()) return;
  dropJob(job_);
  dropJob(labels_job_);
  job_ = session_->jobs().start(makeJob([paths, last = lastSheet()](Progress&, std::stop_token) {
                                  return planSides(paths, last);
                                }),
                                this);
  whenDone<std::optional<SidesPlan>>(job_, this, [this, paths](auto plan) {
    if (!plan) return emit failed(plan.error());
    if (*plan) {
      (*plan)->marker_mm = lastMarker();
      (*plan)->marker_proposed = (*plan)->marker_mm.has_value();
      ask_->askSides(**plan);
      readLabels();
    } else
      ask_->ask(paths.front(), ImportKind::Photographs);
  });
}

}  // namespace ostraka::ui
