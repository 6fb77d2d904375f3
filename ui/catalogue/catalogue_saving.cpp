// What a person enters about a sherd is looked at, and saved or refused in place.
#include <QPrinter>
#include <algorithm>

#include "intake/sherd_moves.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/sherd_changes.h"
#include "sherds/sherds.h"
#include "sherds/typed_numbers.h"
#include "ui/catalogue/catalogue_screen.h"
#include "ui/frame/project_session.h"
#include "ui/map/asked_print.h"
#include "ui/map/catalogue_labels.h"
#include "ui/map/map_screen.h"
#include "ui/sherds/bulk_edit.h"
#include "ui/sherds/field_words.h"
#include "ui/sherds/sherd_details.h"
#include "ui/sherds/sherd_edits.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {

// Of those chosen, as the map prints them; the others have no number that could stand on one.
void CatalogueScreen::printLabels() {
  const std::vector<store::SherdRow> sherds = selected();
  if (!session_ || sherds.empty()) return;
  const QVector<SherdLabel> labels = sherdLabels(session_->project().catalogue(), sherds);
  if (labels.isEmpty())
    return complain(tr("Only sherds with a number get a label: assign the numbers first."));
  askToPrint(
      this, tr("sherd labels"),
      MapScreen::tr("%n label(s) are sent to the printer.", nullptr,
                    static_cast<int>(labels.size())),
      [labels](QPrinter& printer, QString* why) {
        return ostraka::ui::printLabels(printer, labels, why);
      },
      [this](const QString& sentence) { emit said(sentence); });
}

void CatalogueScreen::saveField(const QString& field, const QString& value) {
  if (!edits_) return;
  if (field == "place") return move(value.split('\n'));
  const catalogue::Catalogue& catalogue = session_->project().catalogue();
  const auto refuse = [&](const QString& why, const QString& other, const QString& picture) {
    details_->keepUnsaved(field, value);
    details_->showRefusal(field.toStdString(), why, other, picture);
  };
  records::FieldChange change{details_->sherd(), field.toStdString(), value.toStdString()};
  const QString two_ways = inTwoWays(change.field, value);
  if (!two_ways.isEmpty()) return refuse(two_ways, {}, {});
  if (change.field == "number") {
    const auto whole = sherds::wholeNumber(catalogue, change.sherd, change.value);
    if (!whole) return refuse(wordsOf(whole.error().what), {}, {});
    change.value = *whole;
  }
  const auto previews = sherds::SherdChanges(catalogue).preview(std::span(&change, 1));
  const auto shown = previews ? previews->front() : records::ChangePreview{change, {}, {}, {}, {}};
  if (!shown.refusal.empty()) {
    QString number, picture;
    if (const auto other = sherds::Sherds(catalogue).get(shown.in_the_way);
        shown.in_the_way && other) {
      number = QString::fromStdString(other->number);
      picture = QString::fromStdString((session_->folder() / other->preview_path).string());
    }
    return refuse(wordsOf(shown.refusal), number, picture);
  }
  if (shown.asks())
    return details_->ask(field, value, questionWords(shown.findings), confirmWords(shown.findings));
  if (change.field == "number" && shown.old_value != shown.new_value)
    if (const auto doubt = sherds::Numbers(catalogue).doubt(change.sherd, change.value);
        doubt && !doubt->empty())
      return details_->ask(field, QString::fromStdString(change.value), wordsOf(*doubt),
                           confirmWords({}));
  const bool voids =
      change.field == "void_reason" && !shown.new_value.empty() && shown.old_value.empty();
  if (voids) {
    const auto sherd = sherds::Sherds(catalogue).get(change.sherd);
    details_->ask(field, value,
                  tr("A void sherd gets no label, drawing or place on a plate, and its number is "
                     "never given again. Is %1 void: \u201c%2\u201d?")
                      .arg(sherd ? sherdName(*sherd) : QString(), value),
                  tr("Void sherd"));
  } else {
    keepField(field, QString::fromStdString(change.value));
  }
  if (previews && shown.old_value == shown.new_value) showSelection();  // 7 was 0012-0007 already
}

QString CatalogueScreen::losesByClosing() const {
  const QStringList fields = details_->unsaved().labels();
  return fields.isEmpty()
             ? QString()
             : tr("Not saved yet: %1. Enter in the field saves it; closing again discards it.")
                   .arg(fields.join(QStringLiteral(", ")));
}

void CatalogueScreen::keepField(const QString& field, const QString& value,
                                records::Confirmation confirmation) {
  if (!edits_) return;
  const records::FieldChange change{details_->sherd(), field.toStdString(), value.toStdString(),
                                    confirmation};
  details_->forgetUnsaved(field);
  const QString why = edits_->change(tr("change %1").arg(fieldLabel(change.field)), {change});
  complain(why);
  if (!why.isEmpty()) details_->keepUnsaved(field, value);
}

void CatalogueScreen::move(const QStringList& place) {
  const store::SherdRow sherd = details_->sherd();
  std::vector<records::FieldChange> wanted;
  const char* fields[] = {"site", "trench", "context"};
  for (int i = 0; i < 3 && i < place.size(); ++i)
    wanted.push_back({sherd, fields[i], place[i].toStdString()});
  const auto move = intake::moveOf(session_->project().catalogue(), wanted);
  if (!move) return complain(sentenceOf(move.error()));
  const QString why =
      edits_->change(tr("move to another context"), move->changes, leftBehindWords(*move));
  if (!why.isEmpty()) complain(why);
}

void CatalogueScreen::changeAll(const std::vector<records::FieldChange>& changes) {
  if (changes.empty() || !edits_) return;
  const std::string& field = changes.front().field;  // others come along with it
  const auto sherds = std::count_if(changes.begin(), changes.end(),
                                    [&](const auto& change) { return change.field == field; });
  const QString why = edits_->change(
      tr("change %1 of %n sherd(s)", nullptr, static_cast<int>(sherds)).arg(fieldLabel(field)),
      changes, bulk_->note());
  if (!why.isEmpty()) complain(why);
}

void CatalogueScreen::giveNumbers() {
  if (!edits_) return;
  const std::vector<store::SherdRow> sherds = selected();
  complain(sherds.empty() ? tr("Choose the sherds that are to get numbers.")
                          : edits_->assignNumbers(sherds));
}

}  // namespace ostraka::ui
