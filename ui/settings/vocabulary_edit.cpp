#include "ui/settings/vocabulary_edit.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "catalogue/settings.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_value.h"
#include "ui/frame/term_words.h"
#include "ui/look/look.h"
#include "ui/widgets/form_rows.h"
#include "ui/widgets/parts.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kLines = 7;

QString linesOf(const std::vector<records::Term>& terms) {
  QStringList lines;
  for (const records::Term& term : terms) lines << termLabel(term);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

VocabularyEdit::VocabularyEdit(QWidget* parent)
    : QWidget(parent),
      which_(named<QComboBox>("vocabularyWhich", this)),
      terms_(named<QPlainTextEdit>({"vocabularyTerms", tr("Terms, one per line")}, this)),
      told_(wrappedLabel(this, QStringLiteral("vocabularyTold"))),
      save_(named<QPushButton>("vocabularySave", tr("&Save vocabulary"), this)) {
  setObjectName(QStringLiteral("vocabulary"));
  for (const auto& [words, name] :
       {std::pair(tr("part"), "part"), std::pair(tr("surface"), "surface"),
        std::pair(tr("decoration"), "decoration"), std::pair(tr("manufacture"), "manufacture"),
        std::pair(tr("firing"), "firing"), std::pair(tr("condition"), "condition")})
    which_->addItem(words, QString::fromLatin1(name));
  terms_->setTabChangesFocus(true);
  buildLayout();
  connect(which_, &QComboBox::currentIndexChanged, this, [this] {
    keepDraft();
    showTerms();
  });
  connect(save_, &QPushButton::clicked, this, &VocabularyEdit::save);
  setVisible(false);
}

void VocabularyEdit::buildLayout() {
  QFormLayout* form = titledForm(this, tr("Project vocabulary"));
  form->addRow(tr("&Words for"), which_);
  form->addRow(tr("&One per line"), terms_);
  form->addRow(QString(), told_);
  form->addRow(QString(), save_);
  terms_->setFixedHeight(fontMetrics().lineSpacing() * kLines);
  alignForm(*form);
}

void VocabularyEdit::setSession(ProjectSession* session) {
  session_ = session;
  drafts_.clear();
  setVisible(session != nullptr);
  showTerms();
}

void VocabularyEdit::keepDraft() {
  const QString typed = terms_->toPlainText();
  if (typed == linesOf(held_))
    drafts_.remove(shown_);
  else
    drafts_.insert(shown_, typed);
}

void VocabularyEdit::showTerms() {
  held_.clear();
  shown_ = which_->currentData().toString();
  if (session_)
    if (auto terms =
            catalogue::Settings(session_->project().catalogue()).vocabulary(shown_.toStdString()))
      held_ = std::move(*terms);
  terms_->setPlainText(drafts_.value(shown_, linesOf(held_)));
  told_->setText(drafts_.contains(shown_)
                     ? tr("These terms are not saved yet.")
                     : tr("A word that sherds use already stays; change those first."));
}

// A word that was there before keeps what it is called in other languages.
std::vector<records::Term> VocabularyEdit::written() const {
  std::vector<records::Term> terms;
  for (const QString& line : terms_->toPlainText().split(QLatin1Char('\n'))) {
    const std::string word = line.simplified().toStdString();
    if (word.empty()) continue;
    const auto known = std::find_if(held_.begin(), held_.end(), [&](const records::Term& term) {
      return term.term == word || termLabel(term).toStdString() == word;
    });
    terms.push_back(known == held_.end() ? records::Term{word, {}, {}} : *known);
  }
  return terms;
}

void VocabularyEdit::save() {
  if (!session_) return;
  const QString vocabulary = which_->currentData().toString();
  const std::vector<records::Term> after = written();
  const bool same = std::equal(held_.begin(), held_.end(), after.begin(), after.end(),
                               [](const auto& a, const auto& b) { return a.term == b.term; });
  if (same) return;
  const std::string name = vocabulary.toStdString();
  const auto shown = [this, vocabulary] {
    session_->tellVocabulariesChanged();
    keepDraft();
    drafts_.remove(vocabulary);
    showTerms();
  };
  const SavedValue<std::vector<records::Term>> terms = {
      name,
      [&session = *session_, name] {
        return catalogue::Settings(session.project().catalogue()).vocabulary(name);
      },
      [&session = *session_, name](const std::vector<records::Term>& wanted,
                                   const records::Provenance& by) {
        return catalogue::Settings(session.project().catalogue()).setVocabulary(name, wanted, by);
      },
      shown};
  const Result<void> done = saveValue(*session_, tr("change the vocabulary"), terms, after);
  told_->setText(done ? tr("Saved.") : sentenceOf(done.error()));
}

}  // namespace ostraka::ui
