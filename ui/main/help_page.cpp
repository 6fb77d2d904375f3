#include "ui/main/help_page.h"

#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrlQuery>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/look.h"
#include "ui/widgets/page_acts.h"
#include "ui/widgets/parts.h"

// A static library's resources are linked in only when somebody asks for them.
static void initialiseManual() {
  Q_INIT_RESOURCE(manual);
}

namespace ostraka::ui {
namespace {

constexpr int kPictureWide = 800;  // as the pages ask for

// A picture is made as small as it is shown with care; the browser itself would drop pixels, and
// with them strokes of the letters in it.
class ManualText final : public QTextBrowser {
 public:
  using QTextBrowser::QTextBrowser;

 protected:
  QVariant loadResource(int type, const QUrl& name) override {
    const QVariant found = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return found;
    QImage image = QImage::fromData(found.toByteArray());
    if (image.isNull()) return found;
    const int wide = qRound(kPictureWide * devicePixelRatioF());
    if (image.width() > wide) image = image.scaledToWidth(wide, Qt::SmoothTransformation);
    image.setDevicePixelRatio(static_cast<double>(image.width()) / kPictureWide);
    return image;
  }
};

// A page within a screen has a list of its own.
bool isOfAnInnerScreen(const QAction& action,
                       const std::vector<std::pair<QString, const QWidget*>>& screens,
                       const QWidget* screen) {
  return std::any_of(screens.begin(), screens.end(), [&](const auto& other) {
    const QWidget* inner = other.second;
    if (inner == screen || !screen->isAncestorOf(inner)) return false;
    const auto* owner = qobject_cast<const QWidget*>(action.parent());
    return owner == inner || inner->isAncestorOf(owner);
  });
}

}  // namespace

HelpPage::HelpPage(QWidget* parent)
    : QWidget(parent),
      text_(new ManualText(this)),
      search_(named<QLineEdit>({QStringLiteral("helpSearch"), tr("Search the manual")}, this)),
      note_(wrappedLabel(this, QStringLiteral("helpNote"))) {
  initialiseManual();
  setObjectName(QStringLiteral("help"));
  text_->setObjectName(QStringLiteral("helpText"));
  text_->setAccessibleName(tr("Manual"));
  text_->setSearchPaths({QStringLiteral(":/manual")});
  text_->setOpenExternalLinks(true);
  auto* bar = new QHBoxLayout;
  const auto add = [this, bar](const QString& text, const QString& object) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(object);
    bar->addWidget(button);
    return button;
  };
  connect(add(tr("&Contents"), QStringLiteral("helpContents")), &QPushButton::clicked, this,
          [this] { showManual(QStringLiteral("index")); });
  connect(add(tr("All &keys"), QStringLiteral("helpKeys")), &QPushButton::clicked, this,
          &HelpPage::shortcutsWanted);
  connect(add(tr("&About"), QStringLiteral("helpAbout")), &QPushButton::clicked, this,
          &HelpPage::showAbout);
  search_->setPlaceholderText(tr("Search the manual"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::returnPressed, this, &HelpPage::showFound);
  connect(text_, &QTextBrowser::sourceChanged, this, &HelpPage::showHit);
  bar->addWidget(search_, 1);
  auto* close = add(tr("Back to work (Esc)"), QStringLiteral("helpClose"));
  close->setShortcut(QKeySequence(Qt::Key_Escape));
  connect(close, &QPushButton::clicked, this, &HelpPage::closed);
  auto* column = new QVBoxLayout(this);
  column->addLayout(bar);
  column->addWidget(note_);
  column->addWidget(text_, 1);
  // In English, that is untranslated, it goes without saying.
  constexpr const char* kNote = QT_TR_NOOP("The manual is in English.");
  if (const QString words = tr(kNote); words != QLatin1String(kNote)) note_->setText(words);
  note_->hide();
}

void HelpPage::showManual(const QString& page) {
  note_->setVisible(!note_->text().isEmpty());
  text_->setSource(QUrl(QStringLiteral("qrc:/manual/%1.html").arg(page)));
  text_->setFocus();
}

// Each line that has all the words; it leads to the first of them there.
void HelpPage::showFound() {
  const QStringList words =
      search_->text().simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (words.isEmpty()) return;
  note_->setVisible(!note_->text().isEmpty());
  QString rows;
  for (const QString& name :
       QDir(QStringLiteral(":/manual")).entryList({QStringLiteral("*.html")})) {
    QFile file(QStringLiteral(":/manual/") + name);
    if (!file.open(QIODevice::ReadOnly)) continue;
    QTextDocument page;
    page.setHtml(QString::fromUtf8(file.readAll()));
    qsizetype hits = 0;
    for (QTextBlock line = page.begin(); line.isValid(); line = line.next()) {
      const QString text = line.text();
      const bool has = std::all_of(words.begin(), words.end(), [&](const QString& word) {
        return text.contains(word, Qt::CaseInsensitive);
      });
      if (has)
        rows += QStringLiteral("<p><a href=\"qrc:/manual/%1?hit=%2\">%3</a><br>%4</p>")
                    .arg(name, QString::number(hits),
                         tr("%1, line %2")
                             .arg(page.metaInformation(QTextDocument::DocumentTitle))
                             .arg(line.blockNumber() + 1)
                             .toHtmlEscaped(),
                         text.toHtmlEscaped());
      hits += text.count(words.front(), Qt::CaseInsensitive);
    }
  }
  if (rows.isEmpty())
    rows = QStringLiteral("<p>%1</p>")
               .arg(tr("The manual does not mention '%1'.")
                        .arg(words.join(QLatin1Char(' ')))
                        .toHtmlEscaped());
  text_->setHtml(rows);
}

void HelpPage::showHit(const QUrl& page) {
  const QString hit = QUrlQuery(page).queryItemValue(QStringLiteral("hit"));
  const QString word = search_->text().simplified().section(QLatin1Char(' '), 0, 0);
  if (hit.isEmpty() || word.isEmpty()) return;
  for (int i = 0; i <= hit.toInt() && text_->find(word);) ++i;
}

void HelpPage::showShortcuts(const std::vector<std::pair<QString, const QWidget*>>& screens) {
  note_->hide();
  QString html = QStringLiteral("<h1>%1</h1>").arg(tr("All keys").toHtmlEscaped());
  QSet<const QAction*> listed;
  for (const auto& [title, screen] : screens) {
    QString rows;
    for (const QAction* action : screen->findChildren<QAction*>()) {
      if (action->shortcut().isEmpty() || action->text().isEmpty() || listed.contains(action) ||
          isOfAnInnerScreen(*action, screens, screen))
        continue;
      listed.insert(action);
      rows += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                  .arg(keyText(action->shortcut()).toHtmlEscaped(),
                       action->text().remove(QLatin1Char('&')).toHtmlEscaped());
    }
    if (!rows.isEmpty())
      html += QStringLiteral("<h2>%1</h2><table cellpadding=4>%2</table>")
                  .arg(title.toHtmlEscaped(), rows);
  }
  text_->setHtml(html);
  text_->setFocus();
}

void HelpPage::showAbout() {
  note_->hide();
  text_->setHtml(
      QStringLiteral("<h1>Ostraka %1</h1><p>%2</p><p>%3</p><p>%4</p>")
          .arg(QCoreApplication::applicationVersion().toHtmlEscaped(),
               tr("Complete, measured 3D models of potsherds from photographs of both their sides.")
                   .toHtmlEscaped(),
               tr("Apache License 2.0. It uses Qt (LGPL 3), VTK and OpenCV among others; the file "
                  "LICENSE and the README name them all.")
                   .toHtmlEscaped(),
               tr("Nothing leaves this computer: the program uses no network.").toHtmlEscaped()));
  text_->setFocus();
}

}  // namespace ostraka::ui
