#include "ui/pairs/review_work.h"

#include <nlohmann/json.hpp>

#include "cloud/ply.h"
#include "files/json.h"
#include "intake/review_decisions.h"
#include "review/more_candidates.h"

namespace ostraka::ui {
namespace {

constexpr std::size_t kShownPoints = 60000;  // of a face; fractures come on top
constexpr double kThumbnailPixel_mm = 0.5;

}  // namespace

QImage imageOf(const review::Picture& picture) {
  if (picture.rgba.empty()) return {};
  return QImage(picture.rgba.data(), picture.width, picture.height, 4 * picture.width,
                QImage::Format_RGBA8888)
      .copy();
}

Result<OpenedBatch> openBatch(const std::filesystem::path& output,
                              const std::filesystem::path& rows) {
  if (const Result<void> whole = review::computedToItsEnd(output); !whole) return whole.error();
  Result<decisions::Decisions> decisions = decisions::readDecisions(output);
  if (!decisions) return decisions.error();
  const auto live = review::LivePairs::open(output);
  if (!live) return live.error();
  decisions::Decisions followed = decisions::followed(*decisions, output);
  OpenedBatch opened{*live, std::move(*decisions), std::move(followed)};
  if (!rows.empty()) opened.caught_up = intake::catchUp(rows, output.filename().string(), output);
  return opened;
}

Result<std::shared_ptr<const PairScene>> pairScene(const LivePairsPtr& live, int front, int back,
                                                   const Eigen::Isometry3d& pose, Clouds clouds) {
  auto scene = std::make_shared<PairScene>();
  scene->front = front;
  scene->back = back;
  Result<review::PairView> view = live->view(front, back, pose);
  if (!view) return view.error();
  scene->view = std::move(*view);
  scene->front_picture = imageOf(scene->view.front);
  scene->back_picture = imageOf(scene->view.back);
  scene->fit.front_from_back = pose;
  // Scans without a usable fracture still have outlines and photographs.
  if (const Result<review::LiveFit> fit = live->measured(front, back, pose)) scene->fit = *fit;
  if (clouds == Clouds::Fetch) {
    Result<review::ScanCloud> f = live->cloud(batch::Side::Front, front, kShownPoints);
    Result<review::ScanCloud> b = live->cloud(batch::Side::Back, back, kShownPoints);
    if (!f) return f.error();
    if (!b) return b.error();
    scene->front_cloud = std::move(*f);
    scene->back_cloud = std::move(*b);
  }
  return std::shared_ptr<const PairScene>(std::move(scene));
}

Result<std::shared_ptr<const PairScene>> loneScene(const LivePairsPtr& live, batch::Side side,
                                                   int scan) {
  auto scene = std::make_shared<PairScene>();
  const bool front = side == batch::Side::Front;
  (front ? scene->front : scene->back) = scan;
  const double pixel_mm = live->pixelOf_mm(side, scan);
  scene->view.frame = live->frameOf(side, scan, pixel_mm);
  if (const Result<review::Picture> picture = live->picture(side, scan, pixel_mm))
    (front ? scene->front_picture : scene->back_picture) = imageOf(*picture);
  Result<review::ScanCloud> cloud = live->cloud(side, scan, kShownPoints);
  if (!cloud) return cloud.error();
  scene->front_cloud.emplace();
  scene->back_cloud.emplace();
  (front ? *scene->front_cloud : *scene->back_cloud) = std::move(*cloud);
  return std::shared_ptr<const PairScene>(std::move(scene));
}

// The report tells whose models lie there: a number is a front's, whatever back it was given, and
// until a batch is computed to the end there is none.
Result<MeshPtr> closedModel(const LivePairsPtr& live, int front, int back) {
  const std::filesystem::path file_of_report = live->output() / "report.json";
  const Result<nlohmann::json> report = readJson(file_of_report);
  if (!report) return report.error();
  const std::string& front_id = live->table().fronts.at(static_cast<std::size_t>(front)).id;
  const std::string& back_id = live->table().backs.at(static_cast<std::size_t>(back)).id;
  std::string number;
  for (const nlohmann::json& sherd : report->value("sherds", nlohmann::json::array()))
    if (sherd.value("front", "") == front_id && sherd.value("back", "") == back_id)
      number = sherd.value("number", "");
  if (number.empty())
    return Error{ErrorCode::Missing, "There is no model of these two sides.",
                 file_of_report.string()};
  Result<PlyContents> file = readPly(live->output() / "sherds" / number / "model.ply");
  if (!file) return file.error();
  return MeshPtr(std::make_shared<TriangleMesh>(std::move(file->mesh)));
}

Result<ScanPictures> scanPictures(const LivePairsPtr& live, std::stop_token stop) {
  ScanPictures pictures;
  for (const batch::Side side : {batch::Side::Front, batch::Side::Back}) {
    const auto& scans = side == batch::Side::Front ? live->table().fronts : live->table().backs;
    for (int i = 0; i < static_cast<int>(scans.size()); ++i) {
      if (stop.stop_requested()) return Error::cancelled();
      const Result<review::Picture> picture = live->picture(side, i, kThumbnailPixel_mm);
      if (!picture) return picture.error();
      pictures[{side, i}] = imageOf(*picture);
    }
  }
  return pictures;
}

Result<std::optional<review::ReviewCandidate>> anotherCandidate(const LivePairsPtr& live, int front,
                                                                const std::vector<int>& known,
                                                                Progress& progress,
                                                                std::stop_token stop) {
  const auto found = review::nextCandidate(*live, front, known, progress, stop);
  if (!found) return found.error();
  if (!*found) return std::optional<review::ReviewCandidate>();
  return std::optional(review::candidateOf(**found));
}

Result<review::ReviewCandidate> oneCandidate(const LivePairsPtr& live, int front, int back,
                                             std::stop_token stop) {
  const Result<decisions::RegisteredCandidate> candidate = live->compared(front, back, stop);
  if (!candidate) return candidate.error();
  return review::candidateOf(*candidate);
}

}  // namespace ostraka::ui
