// What comes from elsewhere: tables, exports, whole projects; and places that are called otherwise.
#include "tables/import_table.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/catalogue/places_dialog.h"
#include "ui/frame/project_session.h"
#include "ui/merge/merge_dialog.h"
#include "ui/merge/merge_model.h"
#include "ui/tables/import_dialog.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

void CatalogueScreen::openImport() {
  if (!session_) return;
  if (!import_dialog_) {
    import_->openProject(session_);
    import_dialog_ = new ImportDialog(*import_, this);
    import_dialog_->setAttribute(Qt::WA_DeleteOnClose);
    connect(import_dialog_, &ImportDialog::mergeWanted, this, &CatalogueScreen::openMerge);
  }
  import_dialog_->show();
  import_dialog_->activateWindow();
}

void CatalogueScreen::openMerge() {
  if (!session_) return;
  if (import_dialog_) import_dialog_->close();
  if (!merge_dialog_) {
    merge_->openProject(session_);
    merge_dialog_ = new MergeDialog(*merge_, this);
    merge_dialog_->setAttribute(Qt::WA_DeleteOnClose);
  }
  merge_dialog_->show();
  merge_dialog_->activateWindow();
}

void CatalogueScreen::renamePlaces() {
  if (!session_) return;
  if (!places_dialog_) {
    places_dialog_ = new PlacesDialog(*session_, this);
    places_dialog_->setAttribute(Qt::WA_DeleteOnClose);
  }
  if (const std::vector<store::SherdRow> sherds = selected(); !sherds.empty())
    places_dialog_->showPlaceOf(sherds.front());
  places_dialog_->show();
  places_dialog_->activateWindow();
}

// Every screen shows what came; what was changed before it cannot be taken back any more.
void CatalogueScreen::tookProject(const QString& sentence) {
  session_->undo().clear();
  session_->tellVocabulariesChanged();
  session_->tellSherdsChanged();
  session_->tellBatchChanged({});
  reload();
  emit said(sentence);
}

void CatalogueScreen::tellOfImports() {
  QStringList lines;
  for (const auto& left : tables::unfinishedImports(session_->project().catalogue()))
    lines << tr("The import of %1 broke off after %2 of %3 rows; these are whole. Import it again "
                "for the rest.")
                 .arg(QString::fromStdString(left.source))
                 .arg(left.entered)
                 .arg(left.of)
                 .toHtmlEscaped();
  if (lines.isEmpty()) return;
  lines << QStringLiteral("<a href=\"forget\">%1</a>").arg(tr("Dismiss"));
  complain(lines.join(QStringLiteral("<br>")));
}

void CatalogueScreen::forgetImports() {
  const auto done = tables::forgetUnfinishedImports(session_->project().catalogue());
  complain(done ? QString() : sentenceOf(done.error()));
}

}  // namespace ostraka::ui
