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
#include <QRegularExpression>
#include <QSet>
#include <QTextBlock>
#include <QTextBrowser>
#include <QUrlQuery>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>

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

// How much a word counts in a title, a heading and the text below.
constexpr double kInTitle = 9, kInHeading = 3, kInText = 1;

std::vector<ManualLine> linesOfManual() {
  std::vector<ManualLine> lines;
  for (const QString& name :
       QDir(QStringLiteral(":/manual")).entryList({QStringLiteral("*.html")})) {
    QFile file(QStringLiteral(":/manual/") + name);
    if (!file.open(QIODevice::ReadOnly)) continue;
    QTextDocument page;
    page.setHtml(QString::fromUtf8(file.readAll()));
    const QString title = page.metaInformation(QTextDocument::DocumentTitle);
    QString heading;
    for (QTextBlock block = page.begin(); block.isValid(); block = block.next()) {
      const int level = block.blockFormat().headingLevel();
      if (level > 1) heading = block.text();
      const double weight = level == 1 ? kInTitle : level > 1 ? kInHeading : kInText;
      lines.push_back({name, title, heading, block.text(), block.blockNumber(), weight});
    }
  }
  return lines;
}

// A word is found by its beginning, one of a letter or two only as a whole.
QRegularExpression wholeOrBegun(const QString& word) {
  constexpr int kShort = 2;
  return QRegularExpression(
      QStringLiteral("(?<!\\w)") + QRegularExpression::escape(word) +
          (word.size() <= kShort ? QStringLiteral("(?!\\w)") : QString()),
      QRegularExpression::CaseInsensitiveOption | QRegularExpression::UseUnicodePropertiesOption);
}

// Of a page: by word, how much it counts where it counts most; and the line that has most of them.
struct FoundPage {
  std::vector<double> weights;
  const ManualLine* best = nullptr;
  double best_rarity = 0, score = 0;
  qsizetype words = 0;
};

std::vector<const ManualLine*> foundIn(const std::vector<ManualLine>& lines,
                                       const QStringList& words) {
  const auto count = static_cast<std::size_t>(words.size());
  std::map<QString, FoundPage> pages;
  std::vector<std::vector<std::size_t>> found(lines.size());  // by line: which of the words
  for (std::size_t w = 0; w < count; ++w) {
    const QRegularExpression word = wholeOrBegun(words[static_cast<qsizetype>(w)]);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      FoundPage& page = pages[lines[i].page];
      page.weights.resize(count);
      if (!word.match(lines[i].text).hasMatch()) continue;
      found[i].push_back(w);
      page.weights[w] = std::max(page.weights[w], lines[i].weight);
    }
  }
  std::vector<double> rarity(count);
  for (std::size_t w = 0; w < count; ++w) {
    const auto with = std::count_if(pages.begin(), pages.end(),
                                    [w](const auto& page) { return page.second.weights[w] > 0; });
    rarity[w] = std::log(static_cast<double>(pages.size() + 1) / static_cast<double>(with + 1));
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    FoundPage& page = pages[lines[i].page];
    double of_line = 0;
    for (const std::size_t w : found[i]) of_line += rarity[w];
    if (found[i].empty() || (page.best != nullptr && of_line <= page.best_rarity)) continue;
    page.best = &lines[i];
    page.best_rarity = of_line;
  }
  std::vector<const FoundPage*> ranked;
  for (auto& [name, page] : pages) {
    for (std::size_t w = 0; w < count; ++w) {
      page.score += rarity[w] * page.weights[w];
      if (page.weights[w] > 0) ++page.words;
    }
    if (page.best != nullptr) ranked.push_back(&page);
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const FoundPage* a, const FoundPage* b) {
    return std::pair(a->words, a->score) > std::pair(b->words, b->score);
  });
  std::vector<const ManualLine*> best;
  for (const FoundPage* page : ranked)
    if (page->words == ranked.front()->words) best.push_back(page->best);
  return best;
}

}  // namespace

HelpPage::HelpPage(QWidget* parent)
    : QWidget(parent),
      text_(named<ManualText>({"helpText", tr("Manual")}, this)),
      search_(named<QLineEdit>({QStringLiteral("helpSearch"), tr("Search the manual")}, this)),
      note_(wrappedLabel(this, QStringLiteral("helpNote"))) {
  initialiseManual();
  setObjectName(QStringLiteral("help"));
  text_->setSearchPaths({QStringLiteral(":/manual")});
  text_->setOpenExternalLinks(true);
  auto* bar = new QHBoxLayout;
  const auto add = [this, bar](const QString& text, const QString& object) {
    auto* button = named<QPushButton>(object, text, this);
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
  connect(search_, &QLineEdit::textEdited, this, &HelpPage::showFound);
  connect(search_, &QLineEdit::returnPressed, this, &HelpPage::showFound);
  connect(text_, &QTextBrowser::sourceChanged, this, &HelpPage::showHit);
  bar->addWidget(search_, 1);
  auto* close = add(tr("Back to work (Esc)"), QStringLiteral("helpClose"));
  close->setShortcut(QKeySequence(Qt::Key_Escape));
  connect(close, &QPushButton::clicked, this, &HelpPage::closed);
  filled(new QVBoxLayout(this), {bar, note_, {text_, 1}});
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

// The pages that have the most of the words, those first that name the rarest in titles and
// headings; each with the passage that has most of them.
void HelpPage::showFound() {
  const QStringList words =
      search_->text().simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts);
  if (words.isEmpty()) return;
  note_->setVisible(!note_->text().isEmpty());
  if (lines_.empty()) lines_ = linesOfManual();
  QString rows;
  for (const ManualLine* line : foundIn(lines_, words)) {
    QString where = line->title;
    if (!line->heading.isEmpty()) where += QStringLiteral(": ") + line->heading;
    rows += QStringLiteral("<p><a href=\"qrc:/manual/%1?block=%2\">%3</a><br>%4</p>")
                .arg(line->page, QString::number(line->block), where.toHtmlEscaped(),
                     line->text.toHtmlEscaped());
  }
  if (rows.isEmpty())
    rows = QStringLiteral("<p>%1</p>")
               .arg(tr("The manual does not mention '%1'.")
                        .arg(words.join(QLatin1Char(' ')))
                        .toHtmlEscaped());
  text_->setHtml(rows);
}

void HelpPage::showHit(const QUrl& page) {
  const QString block = QUrlQuery(page).queryItemValue(QStringLiteral("block"));
  if (block.isEmpty()) return;
  const QTextBlock found = text_->document()->findBlockByNumber(block.toInt());
  QTextCursor at(found);
  for (const QString& word : search_->text().simplified().split(QLatin1Char(' ')))
    if (const auto match = wholeOrBegun(word).match(found.text()); match.hasMatch()) {
      at.setPosition(found.position() + static_cast<int>(match.capturedStart()));
      at.setPosition(found.position() + static_cast<int>(match.capturedEnd()),
                     QTextCursor::KeepAnchor);
      break;
    }
  text_->setTextCursor(at);
  text_->ensureCursorVisible();
}

void HelpPage::showShortcuts(const std::vector<std::pair<QString, const QWidget*>>& screens) {
  note_->hide();
  QString html = QStringLiteral("<h1>%1</h1>").arg(tr("All keys").toHtmlEscaped());
  QSet<const QAction*> listed;
  for (const auto& [title, screen] : screens) {
    std::vector<std::pair<QString, QStringList>> keys;  // one key does one thing at a time
    for (const QAction* action : screen->findChildren<QAction*>()) {
      if (action->shortcut().isEmpty() || action->text().isEmpty() || listed.contains(action) ||
          isOfAnInnerScreen(*action, screens, screen))
        continue;
      listed.insert(action);
      const QString key = keyText(action->shortcut());
      auto at = std::find_if(keys.begin(), keys.end(),
                             [&key](const auto& other) { return other.first == key; });
      if (at == keys.end()) at = keys.insert(keys.end(), {key, {}});
      at->second << action->text().remove(QLatin1Char('&'));
    }
    QString rows;
    for (const auto& [key, texts] : keys)
      rows += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                  .arg(key.toHtmlEscaped(), texts.join(QStringLiteral(" / ")).toHtmlEscaped());
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
