#pragma once
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "catalogue/places.h"
#include "closed_shell.h"
#include "cloud/glb.h"
#include "cloud/ply.h"
#include "colour/munsell_proposals.h"
#include "files/files.h"
#include "records/records.h"
#include "records/sherd.h"
#include "sherds/numbers.h"
#include "sherds/sherd_fields.h"
#include "sherds/sherds.h"
#include "ui/frame/project_session.h"
#include "ui/jobs/job.h"
#include "upkeep/project.h"

namespace ostraka::ui {

/// A project with numbered, described sherds, pictures and all, in a folder that goes again.
class SampleProject {
 public:
  explicit SampleProject(int sherds, const char* name = "sample") {
    records::ProjectRecord record;
    record.code = "ARM";
    record.title = "Sample";
    auto made = upkeep::Project::create(std::filesystem::path(folder_.path().toStdString()) / name,
                                        record, [this] { return now_ms_ += 1000; });
    project_ = std::make_shared<upkeep::Project>(must(std::move(made)));
    session_ = std::make_unique<ProjectSession>(project_, project_->folder(), jobs_);
    session_->setInitials("AP");
    provenance_.person =
        must(catalogue::People(catalogue())
                 .save(records::PersonRecord{{}, {}, "Anna P.", "AP", {}}, provenance_));
    records::SiteRecord site;
    site.code = "ARM1";
    site.name = "Hill";
    records::TrenchRecord trench;
    trench.site = must(catalogue::Places(catalogue()).save(site, provenance_));
    trench.code = "T3";
    records::ContextRecord context;
    context.site = trench.site;
    context.trench = must(catalogue::Places(catalogue()).save(trench, provenance_));
    for (const char* number : {"0012", "0013"}) {
      context.number = number;
      contexts_.push_back(must(catalogue::Places(catalogue()).save(context, provenance_)));
    }
    must(catalogue().together([&]() -> Result<void> {
      for (int i = 0; i < sherds; ++i) add(i);
      return {};
    }));
  }

  catalogue::Catalogue& catalogue() { return project_->catalogue(); }
  ProjectSession& session() { return *session_; }
  const std::vector<store::SherdRow>& sherds() const { return sherds_; }
  QString folder() const { return folder_.path(); }
  QString value(int sherd, const std::string& field) {
    return QString::fromStdString(sherds::textOf(stored(sherd), field));
  }
  store::SherdRow row(int sherd) const { return sherds_[static_cast<std::size_t>(sherd)]; }
  records::SherdRecord stored(int i) { return must(sherds::Sherds(catalogue()).get(row(i))); }
  store::SherdRow addDraft(bool with_context = true) {
    records::SherdRecord s;
    if (with_context) s.context = contexts_[0];
    sherds_.push_back(must(sherds::Sherds(catalogue()).add(s, provenance_)));
    return sherds_.back();
  }

  /// A model worth drawing and turning.
  void giveModel(int sherd, const TriangleMesh& mesh = exchange::closedShell()) {
    const std::string path = "results/B0001/sherds/" + std::to_string(sherd) + "/model.ply";
    must(writeFileAtomically(project_->folder() / path, formatPly(mesh, "plate_front")));
    must(sherds::Sherds(catalogue()).setModel(row(sherd), path, stored(sherd).preview_path));
  }

  /// What its photographs propose, in a GLB beside a model of its own.
  void propose(int sherd, const colour::MunsellProposals& proposals) {
    giveModel(sherd);
    GlbExtras extras;
    extras.munsell = colour::toJson(proposals).dump();
    must(writeGlb((project_->folder() / stored(sherd).model_path).replace_extension(".glb"),
                  formatGlb(exchange::closedShell(), extras)));
  }

  template <class T>
  static T must(Result<T> result) {
    if (!result) throw std::runtime_error(result.error().sentence().english());
    return std::move(*result);
  }
  static void must(const Result<void>& result) {
    if (!result) throw std::runtime_error(result.error().sentence().english());
  }

 private:
  void add(int i) {
    records::SherdRecord s;
    s.context = contexts_[static_cast<std::size_t>(i % 2)];
    s.part = {i % 3 == 0 ? "rim" : "body"};
    s.ware = i % 2 == 0 ? "grey" : "red slipped";
    s.surface_out = i % 3 == 0 ? "burnished" : "plain";
    s.munsell_out = "10YR 3/1";
    s.measures = {{"length", 40.0 + i % 30},
                  {"width", 30.0 + i % 7},
                  {"thickness_mean", 4.0 + 0.5 * (i % 10)},
                  {"weight", 20.0 + i % 13}};
    const store::SherdRow row = must(sherds::Sherds(catalogue()).add(s, provenance_));
    sherds_.push_back(row);
    must(sherds::Numbers(catalogue()).assign(std::span(&row, 1), provenance_));
    if (i < 30) {
      const std::string path = "results/B0001/sherds/" + std::to_string(i) + "/preview.png";
      const std::filesystem::path file = project_->folder() / path;
      std::filesystem::create_directories(file.parent_path());
      picture(i).save(QString::fromStdString(file.string()));
      must(sherds::Sherds(catalogue()).setModel(row, "", path));
    }
  }
  static QImage picture(int i) {
    QImage image(240, 240, QImage::Format_RGB32);
    image.fill(QColor(40, 40, 44));
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QPolygonF outline;
    for (int k = 0; k < 9; ++k) {
      const double angle = 0.698 * k, radius = 60 + (i * 17 + k * 29) % 45;
      outline << QPointF(120 + radius * std::cos(angle), 120 + radius * std::sin(angle));
    }
    painter.setBrush(QColor(150 + i % 5 * 15, 105, 75));
    painter.drawPolygon(outline);
    return image;
  }

  QTemporaryDir folder_;
  std::int64_t now_ms_ = 1'790'000'000'000;
  ThreadedJobRunner jobs_;
  std::shared_ptr<upkeep::Project> project_;
  std::unique_ptr<ProjectSession> session_;
  records::Provenance provenance_;
  std::vector<store::ContextRow> contexts_;
  std::vector<store::SherdRow> sherds_;
};

}  // namespace ostraka::ui
