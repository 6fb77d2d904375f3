#include "ui/settings/numbering_model.h"

#include <QDate>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "catalogue/places.h"
#include "catalogue/settings.h"
#include "records/numbering.h"
#include "sherds/numbers.h"
#include "ui/frame/project_session.h"
#include "ui/frame/saved_value.h"
#include "ui/jobs/when_done.h"
#include "ui/words/sentence.h"
#include "upkeep/project.h"

namespace ostraka::ui {
namespace {

constexpr int kRangesInALine = 12;
constexpr const char* kFirst = "numbering.first";
constexpr const char* kLast = "numbering.last";

using Tokens = std::map<std::string, std::string>;

Tokens exampleTokens(const std::string& site, const std::string& trench,
                     const std::string& context) {
  const std::string year = QString::number(QDate::currentDate().year()).toStdString();
  return {{"site", site},
          {"trench", trench},
          {"context", context},
          {"bag", "4"},
          {"batch", "B0031"},
          {"yyyy", year},
          {"yy", year.substr(year.size() - 2)}};
}

Tokens tokensOf(const catalogue::Places& places, const records::ContextRecord& context) {
  Tokens tokens = exampleTokens(context.site_code, context.trench_code, context.number);
  if (!context.trench_code.empty()) return tokens;
  if (const Result<bool> others = places.hasTrenches(context.site_code); !others || *others)
    tokens.erase("trench");  // it is not recorded
  return tokens;
}

int settingIn(const ProjectSession& session, const char* key, int otherwise) {
  bool good = false;
  const int value = session.setting(key).toInt(&good);
  return good ? value : otherwise;
}

QString placeWords(const records::ContextRecord& context) {
  QStringList parts;
  for (const std::string* part : {&context.site_code, &context.trench_code, &context.number})
    if (!part->empty()) parts << QString::fromStdString(*part);
  return parts.join(QLatin1Char(' '));
}

using Gaps = std::vector<std::pair<QString, std::vector<int>>>;

Result<Gaps> gapsIn(const std::filesystem::path& project, const std::stop_token& stop) {
  const Result<catalogue::Catalogue> rows = upkeep::Project::connect(project);
  if (!rows) return rows.error();
  const auto contexts = catalogue::Places(*rows).contexts();
  if (!contexts) return contexts.error();
  Gaps gaps;
  for (const records::ContextRecord& context : *contexts) {
    if (stop.stop_requested()) return Error::cancelled();
    Result<std::vector<int>> numbers = sherds::Numbers(*rows).gaps(context.row);
    if (!numbers) return numbers.error();
    if (!numbers->empty()) gaps.emplace_back(placeWords(context), std::move(*numbers));
  }
  return gaps;
}

}  // namespace

QString numberRanges(const std::vector<int>& numbers, int most) {
  QStringList ranges;
  for (std::size_t i = 0; i < numbers.size();) {
    if (ranges.size() == most) {
      ranges << QStringLiteral("…");
      break;
    }
    std::size_t end = i + 1;
    while (end < numbers.size() && numbers[end] == numbers[end - 1] + 1) ++end;
    QString range = QString::number(numbers[i]);
    if (end - i == 2)
      range += QStringLiteral(", %1").arg(numbers[end - 1]);
    else if (end - i > 2)
      range += QStringLiteral("–%1").arg(numbers[end - 1]);
    ranges << range;
    i = end;
  }
  return ranges.join(QStringLiteral(", "));
}

void NumberingModel::setSession(ProjectSession* session) {
  dropJob(looking_);
  session_ = session;
  gaps_.clear();
  read();
  emit gapsChanged();
  if (session_ != nullptr) lookForGaps();
}

void NumberingModel::read() {
  held_ = {};
  if (session_ != nullptr)
    if (const Result<Numbering> numbering = stored()) held_ = *numbering;
  wanted_ = held_;
  follow();
}

Result<NumberingModel::Numbering> NumberingModel::stored() const {
  const auto project = catalogue::Settings(session_->project().catalogue()).project();
  if (!project) return project.error();
  return Numbering{QString::fromStdString(project->numbering), settingIn(*session_, kFirst, 1),
                   settingIn(*session_, kLast, kLastNumber)};
}

void NumberingModel::setScheme(const QString& scheme) {
  wanted_.scheme = scheme.trimmed();
  follow();
}

void NumberingModel::setBlock(int first, int last) {
  wanted_.first = first;
  wanted_.last = last;
  follow();
}

void NumberingModel::follow() {
  example_.clear();
  refusal_.clear();
  warning_.clear();
  const auto scheme = records::Numbering::parse(wanted_.scheme.toStdString());
  if (session_ == nullptr) return emit changed();
  if (!scheme) {
    refusal_ = sentenceOf(scheme.error());
    return emit changed();
  }
  if (wanted_.first > wanted_.last)
    refusal_ = tr("The first number of a block is not above its last.");
  const catalogue::Places places(session_->project().catalogue());
  const auto contexts = places.contexts();
  const auto project = catalogue::Settings(session_->project().catalogue()).project();
  Tokens shown = exampleTokens(project ? project->code : "ARM1", "T3", "0012");
  store::ContextRow of;
  if (contexts)
    for (const records::ContextRecord& context : *contexts) {
      const Tokens tokens = tokensOf(places, context);
      if (!scheme->number(tokens, wanted_.first)) {
        warning_ = tr("Sherds of %1 get no number so: it lacks a part that the numbering names.")
                       .arg(placeWords(context));
        continue;
      }
      shown = tokens;
      of = context.row;
      if (warning_.isEmpty()) warning_ = wordsOf(scheme->warning(tokens));
    }
  int next = std::max(wanted_.first, 1);
  if (const auto free = sherds::Numbers(session_->project().catalogue())
                            .next(*scheme, shown, of, next, wanted_.last))
    next = *free;
  const auto number = scheme->number(shown, next);
  if (number)
    example_ = QString::fromStdString(*number);
  else if (refusal_.isEmpty())
    refusal_ = sentenceOf(number.error());
  emit changed();
}

Result<void> NumberingModel::store(const Numbering& numbering,
                                   const records::Provenance& provenance) {
  catalogue::Settings settings(session_->project().catalogue());
  Result<records::ProjectRecord> project = settings.project();
  if (!project) return project.error();
  project->numbering = numbering.scheme.toStdString();
  if (Result<void> set = settings.setProject(*project, provenance); !set) return set;
  for (const auto& [key, value] :
       {std::pair(kFirst, numbering.first), std::pair(kLast, numbering.last)})
    if (Result<void> set = settings.setValue(key, std::to_string(value), provenance); !set)
      return set;
  return {};
}

QString NumberingModel::apply() {
  if (!canApply()) return refusal_;
  const auto shown = [this] {
    read();
    session_->tellVocabulariesChanged();  // the next numbers are others now
  };
  const SavedValue<Numbering> numbering = {
      "numbering", [this] { return stored(); },
      [this](const Numbering& wanted, const records::Provenance& by) { return store(wanted, by); },
      shown};
  const Result<void> done =
      saveValue(*session_, tr("change the numbering"), numbering, Numbering(wanted_));
  return done ? QString() : sentenceOf(done.error());
}

void NumberingModel::lookAgain() {
  if (session_ == nullptr) return;
  follow();
  if (looking_ == nullptr) lookForGaps();
}

void NumberingModel::lookForGaps() {
  looking_ = session_->jobs().start(
      makeJob([folder = session_->folder()](Progress&, std::stop_token stop) {
        return gapsIn(folder, stop);
      }),
      this);
  whenDone<Gaps>(looking_, this, [this](const auto& gaps) {
    gaps_.clear();
    if (gaps)
      for (const auto& [place, numbers] : *gaps)
        gaps_ << tr("%1: %2").arg(place, numberRanges(numbers, kRangesInALine));
    emit gapsChanged();
  });
}

}  // namespace ostraka::ui
