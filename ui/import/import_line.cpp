#include "ui/import/import_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/import/batch_importer.h"
#include "ui/look/look.h"
#include "ui/widgets/parts.h"

namespace ostraka::ui {

ImportLine::ImportLine(BatchImporter* importer, QWidget* parent)
    : QWidget(parent),
      words_(new QLabel(this)),
      bar_(named<QProgressBar>({"importProgress", tr("How far the import is")}, this)) {
  bar_->setRange(0, 100);
  auto* stop = named<QPushButton>("importStop", tr("Stop the import"), this);
  stop->setMinimumHeight(targetSize(*this));
  stop->setFocusPolicy(Qt::TabFocus);  // Space stays the next thing
  filled(bareLayout<QHBoxLayout>(this), {words_, {bar_, 1}, stop});
  connect(stop, &QPushButton::clicked, importer, &BatchImporter::cancel);
  connect(importer, &BatchImporter::started, this, [this](const QString& title) {
    words_->setText(title);
    showProgress(0);
    show();
  });
  connect(importer, &BatchImporter::progressed, this, &ImportLine::showProgress);
  connect(importer, &BatchImporter::ended, this, &QWidget::hide);
  hide();
}

void ImportLine::showProgress(double fraction) {
  bar_->setValue(qRound(100 * fraction));
}

}  // namespace ostraka::ui
