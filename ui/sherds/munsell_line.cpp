#include "ui/sherds/munsell_line.h"

#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "records/sherd.h"
#include "sherds/sherd_fields.h"
#include "ui/look/look.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {
namespace {

QString differenceText(double ciede2000) {
  return QLocale().toString(ciede2000, 'f', 1);
}

QString trustText(const colour::MunsellProposals& proposals) {
  if (!proposals.chart)
    return MunsellLine::tr("Rough: no usable colour chart in these photographs.");
  return MunsellLine::tr("Measured by the colour chart (Delta E 2000: median %1, 95 % %2).")
      .arg(differenceText(proposals.chart->median), differenceText(proposals.chart->within_95));
}

bool lacksProposals(const colour::MunsellProposals& proposals, const records::SherdRecord& sherd) {
  return !sherd.model_path.empty() && !proposals.out && !proposals.in && !proposals.core &&
         sherd.munsell_out.empty() && sherd.munsell_in.empty() && sherd.munsell_core.empty();
}

}  // namespace

MunsellLine::MunsellLine(const std::string& field, QWidget* parent)
    : QWidget(parent), field_(field) {
  const QString name = QString::fromStdString(field);
  text_ = wrappedLabel(this, "proposed_" + name);
  take_over_ = named<QPushButton>("takeOver_" + name, tr("Take over"), this);
  take_over_->setMinimumHeight(targetSize(*this));
  auto* column = filled(bareLayout<QVBoxLayout>(this), {text_, take_over_});
  column->setAlignment(take_over_, Qt::AlignLeading);
  connect(take_over_, &QPushButton::clicked, this, [this] { emit takenOver(notation_); });
}

bool MunsellLine::offer(const colour::MunsellProposals& proposals,
                        const records::SherdRecord& sherd) {
  const std::optional<colour::MunsellProposal>& own = field_ == "munsell_out"  ? proposals.out
                                                      : field_ == "munsell_in" ? proposals.in
                                                                               : proposals.core;
  clear();
  take_over_->setVisible(own.has_value());
  if (!own) {
    if (field_ == "munsell_core" && lacksProposals(proposals, sherd))
      text_->setText(tr(
          "No colours proposed: the model has no texture from photographs, or an earlier version "
          "of the program made it. Reprocess its batch to get proposals."));
    return !text_->text().isEmpty();
  }
  notation_ = QString::fromStdString(own->match.notation);
  text_->setText(tr("Proposed: %1 (Delta E 2000: %2), then %3 (%4). %5")
                     .arg(notation_, differenceText(own->match.difference),
                          QString::fromStdString(own->match.second),
                          differenceText(own->match.second_difference),
                          proposals.chart ? tr("Measured.") : tr("Rough estimate.")));
  take_over_->setAccessibleName(tr("Take over %1").arg(notation_));
  take_over_->setEnabled(own->match.notation != sherds::textOf(sherd, field_));
  QString trust = trustText(proposals);
  if (field_ != "munsell_core")
    trust += QLatin1Char(' ') + ((field_ == "munsell_out") == proposals.front_is_out
                                     ? tr("Of the side that was photographed first.")
                                     : tr("Of the side that was photographed second."));
  text_->setToolTip(trust);
  text_->setAccessibleDescription(trust);
  return true;
}

void MunsellLine::clear() {
  notation_.clear();
  text_->clear();
  text_->setToolTip({});
  text_->setAccessibleDescription({});
  take_over_->setEnabled(false);
}

}  // namespace ostraka::ui
