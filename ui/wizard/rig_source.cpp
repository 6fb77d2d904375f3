#include "ui/wizard/rig_source.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include "cameras/desktop_hold.h"
#include "files/files.h"
#include "ui/jobs/job.h"
#include "virtualrig/virtual_camera.h"

namespace ostraka::ui {
namespace {

namespace fs = std::filesystem;

virtualrig::VirtualDevicesOptions virtualOptions(const RigChoice& choice, int batch) {
  virtualrig::VirtualDevicesOptions options;
  options.seed = choice.seed + static_cast<std::uint64_t>(batch);
  options.sherds = choice.sherds;
  options.width = choice.width_px;
  options.near_duplicates = choice.near_duplicates ? 1 : 0;
  return options;
}

// A person who waits is told for how many photographs.
class CountedProgress final : public Progress {
 public:
  explicit CountedProgress(Progress& inner) : inner_(inner) {}
  void report(std::int64_t done, std::int64_t total) override {
    inner_.report(done, total);
    tell(inner_, PreparedPhotographs{static_cast<int>(done), static_cast<int>(total)});
  }
  void note(NoteLevel level, const Message& text) override { inner_.note(level, text); }

 private:
  Progress& inner_;
};

Result<void> copyWhole(const fs::path& from, const fs::path& to) {
  const Result<std::string> bytes = readFile(from);
  if (!bytes) return bytes.error();
  return writeFileAtomically(to, *bytes);
}

QString ageWords(const fs::path& rig_file) {
  const QFileInfo file(QString::fromStdString(rig_file.string()));
  if (!file.exists()) return QCoreApplication::translate("Rig", "its file is missing");
  const auto days = static_cast<int>(file.lastModified().daysTo(QDateTime::currentDateTime()));
  return days <= 0 ? QCoreApplication::translate("Rig", "ready (calibrated today)")
                   : QCoreApplication::translate("Rig", "ready (%n day(s) old)", nullptr, days);
}

}  // namespace

QString RigChoice::toJson() const {
  QJsonObject object;
  object[QStringLiteral("kind")] = kind == Kind::Virtual ? QStringLiteral("virtual")
                                   : kind == Kind::File  ? QStringLiteral("file")
                                                         : QStringLiteral("none");
  object[QStringLiteral("file")] = QString::fromStdString(file.string());
  object[QStringLiteral("sherds")] = sherds;
  object[QStringLiteral("width_px")] = width_px;
  object[QStringLiteral("seed")] = QString::number(seed);
  object[QStringLiteral("near_duplicates")] = near_duplicates;
  return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

RigChoice RigChoice::fromJson(const QString& text) {
  const QJsonObject object = QJsonDocument::fromJson(text.toUtf8()).object();
  RigChoice choice;
  const QString kind = object[QStringLiteral("kind")].toString();
  if (kind == QLatin1String("virtual")) choice.kind = Kind::Virtual;
  if (kind == QLatin1String("file")) choice.kind = Kind::File;
  choice.file = object[QStringLiteral("file")].toString().toStdString();
  choice.sherds = qBound(1, object[QStringLiteral("sherds")].toInt(choice.sherds), 20);
  choice.width_px = qBound(400, object[QStringLiteral("width_px")].toInt(choice.width_px), 6000);
  choice.seed = object[QStringLiteral("seed")].toString(QStringLiteral("1")).toULongLong();
  choice.near_duplicates = object[QStringLiteral("near_duplicates")].toBool();
  return choice;
}

RigSource virtualRigSource(const RigChoice& choice) {
  RigSource source;
  source.anew_for_each_batch = true;
  source.turns_sherds = true;
  source.words = QCoreApplication::translate("Rig", "virtual");
  source.open = [choice](int batch, const devices::AskPerson&,
                         std::stop_token) -> Result<std::shared_ptr<capture::RigDevices>> {
    Result<capture::RigDevices> devices = virtualrig::openVirtualRig(virtualOptions(choice, batch));
    if (!devices) return devices.error();
    return std::make_shared<capture::RigDevices>(std::move(*devices));
  };
  source.prepare = [choice](const fs::path& folder, int batch, Progress& progress,
                            std::stop_token stop) {
    CountedProgress counted(progress);
    return virtualrig::writeVirtualCalibration(virtualOptions(choice, batch), folder, counted,
                                               stop);
  };
  return source;
}

RigSource fileRigSource(const fs::path& rig_file) {
  RigSource source;
  source.words = ageWords(rig_file);
  source.open = [rig_file](int, const devices::AskPerson& ask,
                           std::stop_token stop) -> Result<std::shared_ptr<capture::RigDevices>> {
    Result<capture::RigDevices> devices = capture::openRigDevices(rig_file, ask, stop);
    if (!devices) return devices.error();
    return std::make_shared<capture::RigDevices>(std::move(*devices));
  };
  source.prepare = [rig_file](const fs::path& folder, int, Progress&,
                              std::stop_token) -> Result<void> {
    const Result<capture::DevicesFile> devices = capture::readDevices(rig_file);
    if (!devices) return devices.error();
    if (const Result<void> done = copyWhole(devices->plate, folder / "plate.json"); !done)
      return done;
    return copyWhole(rig_file, folder / "rig.json");
  };
  source.holders = [] { return cameras::desktopHolders(devices::findDevices({})); };
  source.release = [](std::stop_token stop) {
    return cameras::releaseFromDesktop(devices::findDevices({}), cameras::programRunner(stop),
                                       [] { return devices::findDevices({}); });
  };
  return source;
}

}  // namespace ostraka::ui
