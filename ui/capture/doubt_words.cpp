#include "ui/capture/doubt_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace ostraka::ui {
namespace {

struct Doubts {
  Q_DECLARE_TR_FUNCTIONS(ostraka::ui::Doubts)

 public:
  static QString of(capture::ShotProblem problem) {
    using capture::ShotProblem;
    switch (problem) {
      case ShotProblem::Unreadable:
        return tr("the file is cut off or no picture");
      case ShotProblem::WrongStop:
        return tr("the markers show another angle than this stop's");
      case ShotProblem::OtherSize:
        return tr("the picture has another size than the camera's others");
      case ShotProblem::Unplaced:
        return tr(
            "too few markers are seen to tell the stop: is something before them, is it blurred?");
      case ShotProblem::Repeated:
        return tr("the camera handed over an earlier photograph once more");
      case ShotProblem::FewMarkers:
        return tr("too few markers of the plate are seen: is something before them?");
      case ShotProblem::Blurred:
        return tr("it is blurred: did the table still move, did the focus change?");
      case ShotProblem::TooDark:
        return tr("the sherds are too dark: give more light or expose longer");
      case ShotProblem::TooBright:
        return tr("the sherds are burnt out: expose shorter");
      case ShotProblem::CutOff:
        return tr("a sherd is cut off by the picture's edge: move it or the camera");
      case ShotProblem::OtherSettings:
        break;
    }
    return tr("the camera's settings are others than they were: set them back");
  }
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
  for (const capture::ShotProblem problem : check.problems)
    if (problem != capture::ShotProblem::OtherSettings || check.other_settings.empty())
      all << Doubts::of(problem);
  for (const std::string& setting : check.other_settings)
    all << Doubts::tr("%1: set it back").arg(QString::fromStdString(setting));
  return all;
}

QStringList doubtsOf(const capture::SideCheck& check) {
  QStringList all;
  if (!check.counted)
    all << Doubts::tr("The sherds could not be counted: too few of the plate's markers are seen.");
  if (check.counted && check.sherds == 0) all << Doubts::tr("No sherd is seen on the plate.");
  if (!check.touching_mm.empty())
    all << Doubts::tr(
               "Sherds touch or nearly touch at %1 from the plate's middle: move them apart and "
               "shoot again.")
               .arg(Doubts::places(check.touching_mm));
  if (!check.doubtful_mm.empty())
    all << Doubts::tr(
               "What lies at %1 from the plate's middle was counted as one but may be two sherds "
               "that touch: look there; if so, move them apart and shoot again.")
               .arg(Doubts::places(check.doubtful_mm));
  return all;
}

QStringList doubtsBetween(const capture::SideCheck& front, const capture::SideCheck& back) {
  QStringList all;
  if (capture::sameSide(front, back))
    all << Doubts::tr(
        "The back looks like the front: turn the sherds over and photograph them again.");
  if (!front.counted || !back.counted)
    return all << (front.counted
                       ? Doubts::tr("The sherds of the back could not be counted: compare the "
                                    "pictures yourself before you clear the plate.")
                       : Doubts::tr("The sherds of the front could not be counted: compare the "
                                    "pictures yourself before you clear the plate."));
  if (front.sherds > back.sherds)
    all << Doubts::tr(
               "The front showed %1 sherds, the back %2: look for the missing one before you clear "
               "the plate.")
               .arg(front.sherds)
               .arg(back.sherds);
  if (front.sherds < back.sherds)
    all << Doubts::tr("The front showed %1 sherds, the back %2: was one added, or did one break?")
               .arg(front.sherds)
               .arg(back.sherds);
  return all;
}

}  // namespace ostraka::ui
