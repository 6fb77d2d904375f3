#include "ui/wizard/doubt_words.h"

#include <QCoreApplication>
#include <QLocale>

#include "ui/wizard/capture_wizard.h"
#include "ui/words/sentence.h"

namespace ostraka::ui {
namespace {

struct Doubts {
  Q_DECLARE_TR_FUNCTIONS(ostraka::ui::Doubts)

 public:
  static QString places(const std::vector<Eigen::Vector2d>& list) {
    QStringList all;
    for (const Eigen::Vector2d& p : list)
      all << tr("(%1, %2) mm").arg(std::lround(p.x())).arg(std::lround(p.y()));
    return QLocale().createSeparatedList(all);
  }
};

}  // namespace

QStringList doubtsOf(const capture::ShotCheck& check) {
  QStringList all;
  for (const Message& sentence : check.sentences()) all << wordsOf(sentence);
  return all;
}

QStringList doubtsOf(const capture::SideCheck& check) {
  QStringList all;
  if (!check.counted)
    all << Doubts::tr(
        "The sherds could not be counted: too few of the plate's markers are visible.");
  if (check.counted && check.sherds == 0) all << Doubts::tr("No sherd is visible on the plate.");
  if (!check.touching_mm.empty())
    all << Doubts::tr(
               "Sherds touch or nearly touch at %1 from the plate's centre: move them apart and "
               "reshoot.")
               .arg(Doubts::places(check.touching_mm));
  if (!check.doubtful_mm.empty())
    all << Doubts::tr(
               "What lies at %1 from the plate's centre was counted as one but may be two touching "
               "sherds: check it; if so, move them apart and reshoot.")
               .arg(Doubts::places(check.doubtful_mm));
  return all;
}

// Hidden, touching another, in the hand still, broken, or a pebble: only a person knows.
QString countDoubt(const capture::SideCheck& check, int counted) {
  if (counted == 0 || !check.counted || check.sherds == counted) return {};
  const QString words =
      check.sherds < counted
          ? CaptureWizard::tr(
                "You counted %1 sherds, the photographs show %2: look for one that hides, touches "
                "another or was never laid down.")
          : CaptureWizard::tr(
                "You counted %1 sherds, the photographs show %2: look whether one lies there in "
                "parts, or a thing that is no sherd, or mend the count.");
  return words.arg(counted).arg(check.sherds);
}

QStringList doubtsBetween(const capture::SideCheck& front, const capture::SideCheck& back) {
  QStringList all;
  if (capture::sameSide(front, back))
    all << Doubts::tr("The back looks like the front: turn the sherds over and reshoot them.");
  if (!front.counted || !back.counted)
    return all << (front.counted ? Doubts::tr("The sherds of the back could not be counted: "
                                              "compare the pictures before you clear the plate.")
                                 : Doubts::tr("The sherds of the front could not be counted: "
                                              "compare the pictures before you clear the plate."));
  if (front.sherds > back.sherds)
    all << Doubts::tr(
               "The front showed %1 sherds, the back %2: find the missing one before you clear the "
               "plate.")
               .arg(front.sherds)
               .arg(back.sherds);
  if (front.sherds < back.sherds)
    all << Doubts::tr(
               "The front showed %1 sherds, the back %2: check whether one was added or broke.")
               .arg(front.sherds)
               .arg(back.sherds);
  return all;
}

}  // namespace ostraka::ui
