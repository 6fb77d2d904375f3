#include "ui/main/catalogue_repair.h"

#include <QFileInfo>
#include <QStringList>

#include "files/files.h"
#include "ui/jobs/when_done.h"
#include "ui/main/project_lock.h"
#include "ui/words/sentence.h"
#include "upkeep/repair.h"

namespace ostraka::ui {
namespace {

using upkeep::RepairedRow;
using upkeep::RepairReport;

constexpr int kMostRows = 8;  // that a message shows; the others stand in the list

QString text(const std::string& value) {
  return QString::fromStdString(value);
}

QString wordsOf(const RepairReport& report) {
  if (report.damaged.empty()) return CatalogueRepair::tr("It is whole; nothing was changed.");
  const std::string backup = report.backup.filename().string();
  QStringList words;
  if (report.all_from_backup)
    words << CatalogueRepair::tr(
                 "Nothing in the damaged file could be read: it is that of %1 "
                 "again. Look what is missing since.")
                 .arg(text(backup));
  QStringList rows;
  for (const RepairedRow& row : report.rows) rows << ui::wordsOf(row.words(backup));
  if (report.interrupted)
    words << CatalogueRepair::tr(
        "An earlier repair was interrupted and is now finished. Check the catalogue for missing "
        "changes.");
  if (rows.isEmpty() && !report.all_from_backup && !report.interrupted)
    words << CatalogueRepair::tr("Everything in it is as it was.");
  if (!report.warning.empty()) words << ui::wordsOf(report.warning);
  words << rows.mid(0, kMostRows);
  const std::filesystem::path list = report.damaged.string() + ".txt";
  if (rows.size() > kMostRows &&
      writeFileAtomically(list, rows.join(QLatin1Char('\n')).toStdString() + "\n"))
    words << CatalogueRepair::tr("All %1 rows stand in %2.")
                 .arg(rows.size())
                 .arg(text(list.filename().string()));
  words << CatalogueRepair::tr("The damaged file is kept: %1")
               .arg(text(report.damaged.filename().string()));
  return words.join(QLatin1Char('\n'));
}

}  // namespace

CatalogueRepair::CatalogueRepair(JobRunner& runner, QObject* parent)
    : QObject(parent), runner_(runner) {}
CatalogueRepair::~CatalogueRepair() = default;

void CatalogueRepair::repair(const QString& folder) {
  if (job_ != nullptr) return;
  lock_ = ProjectLock::take(folder);
  if (lock_ == nullptr)
    return emit told(State::Failed, folder,
                     tr("Another window has this project open: close it there, then repair it."),
                     {});
  emit told(State::Busy, tr("The catalogue is being repaired …"), folder, {});
  const std::filesystem::path project = folder.toStdString();
  job_ = runner_.start(
      makeJob([project](Progress& progress, std::stop_token stop) -> Result<RepairReport> {
        return upkeep::repairCatalogue(project, progress, stop);
      }),
      this);
  whenDone<RepairReport>(job_, this, [this, folder](const auto& report) {
    lock_.reset();
    if (!report)
      return emit told(State::Failed, tr("The catalogue could not be repaired."),
                       sentenceOf(report.error()), {});
    emit told(State::Sure, tr("The catalogue is repaired."), wordsOf(*report), folder);
  });
}

}  // namespace ostraka::ui
