#include "exchange/drawn_sherds.h"

#include <algorithm>

#include "base/message.h"
#include "catalogue/files.h"
#include "cloud/ply.h"
#include "drawing/drawing_files.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "records/sherd.h"
#include "sherds/measurements.h"
#include "sherds/pair_decisions.h"
#include "sherds/sherds.h"

namespace ostraka::exchange {

using drawing::RimChoice;
using records::SherdRecord;

drawing::RimChoice rimChoiceOf(const SherdRecord& sherd) {
  const auto names = [&](const char* part) {
    return std::find(sherd.part.begin(), sherd.part.end(), part) != sherd.part.end();
  };
  if (names("rim") || names("profile") || names("whole")) return RimChoice::Yes;
  return sherd.part.empty() || names("lid") ? RimChoice::Propose : RimChoice::No;
}

namespace {

// Before it has a number it is known by its place in its batch, as on the plate's map.
Message nameOf(const SherdRecord& sherd) {
  if (!sherd.number.empty()) return sherd.number;
  if (sherd.batch_number.empty() || sherd.piece == 0) return message("draft %1", sherd.id);
  return message("sherd %1 of %2", sherd.piece, sherd.batch_number);
}

Result<void> takeHandMeasures(const catalogue::Catalogue& catalogue, store::SherdRow sherd,
                              drawing::HandMeasures& by_hand) {
  const auto measured = sherds::Measurements(catalogue).byHand({&sherd, 1});
  if (!measured) return measured.error();
  for (const records::Measurement& m : *measured) {
    by_hand[m.kind] = {m.value, {}};
    if (m.uncertainty && *m.uncertainty < m.value)
      by_hand[m.kind].interval = {m.value - *m.uncertainty, m.value + *m.uncertainty};
  }
  return {};
}

}  // namespace

Result<PlyContents> modelOf(const SherdRecord& sherd, const std::filesystem::path& project) {
  return readPlyWithin(project, sherd.model_path);
}

Result<std::optional<texture::TexturedMesh>> texturedModelOf(const catalogue::Catalogue& catalogue,
                                                             const SherdRecord& sherd,
                                                             const std::filesystem::path& project) {
  using Textured = std::optional<texture::TexturedMesh>;
  const Result<std::vector<records::FileRecord>> files = catalogue::Files(catalogue).of(sherd.row);
  if (!files) return files.error();
  const std::string path =
      std::filesystem::path(sherd.model_path).replace_extension(".glb").generic_string();
  const auto glb = std::ranges::find(*files, path, &records::FileRecord::path);
  if (glb == files->end()) return Textured();
  Result<OpenFile> open = OpenFile::within(project, glb->path);
  if (!open) return open.error();
  const Result<std::string> bytes = open->readAll();
  if (!bytes) return bytes.error();
  if (sha256(*bytes) != glb->sha256)
    return Error::unusable(differsFromEntered(sherd), open->name());
  return texture::openedGlb(*bytes, open->name());
}

namespace {

// Where they are to be seen; that they cannot be read is a remark.
std::optional<texture::TexturedMesh> takePhotographs(const catalogue::Catalogue& catalogue,
                                                     const SherdRecord& sherd,
                                                     const std::filesystem::path& project,
                                                     drawing::DrawingOptions& how) {
  if (how.surface == drawing::Surface::Relief) return std::nullopt;
  Result<std::optional<texture::TexturedMesh>> read = texturedModelOf(catalogue, sherd, project);
  if (read) return std::move(*read);
  how.remarks.push_back(message("Drawn without its photographs: %1", read.error().what));
  return std::nullopt;
}

}  // namespace

Message differsFromEntered(const SherdRecord& sherd) {
  return message(
      "This model or picture of the sherd %1 differs from the recorded one; reprocess its batch "
      "%2.",
      (sherd.number.empty() ? sherd.id : sherd.number), sherd.batch_number);
}

Message leftOutAsVoid(const SherdRecord& sherd) {
  return message("%1 is void and was left out.", nameOf(sherd));
}

Result<drawing::SherdDrawing> drawSherd(const catalogue::Catalogue& catalogue,
                                        const SherdRecord& sherd,
                                        const std::filesystem::path& project,
                                        const DrawSherdsOptions& options) {
  const Message id = nameOf(sherd);
  if (sherd.model_path.empty())
    return Error::unusable(
        message("This sherd has no model yet, so it cannot be drawn; process its batch first."),
        id.english());
  const Result<PlyContents> model = modelOf(sherd, project);
  if (!model) return model.error();
  drawing::DrawingOptions how = options.drawing;
  if (Result<void> read = takeHandMeasures(catalogue, sherd.row, how.by_hand); !read)
    return read.error();
  const std::optional<texture::TexturedMesh> photographs =
      takePhotographs(catalogue, sherd, project, how);
  if (photographs) how.photographs = &*photographs;
  if (options.rim_from_catalogue) how.rim = rimChoiceOf(sherd);
  if (const auto said = options.rims.find(sherd.row); said != options.rims.end())
    how.rim = said->second;
  if (sherd.state == records::SherdState::Void)
    how.remarks.push_back(
        sherd.void_reason.empty()
            ? message("This sherd is void.")
            : message("This sherd is void; reason: %1", sherds::voidReason(sherd.void_reason)));
  if (sherd.scale_doubtful)
    how.remarks.push_back(
        message("The measurements of its batch are in doubt, and so is the size of this drawing."));
  Result<drawing::SherdDrawing> drawn = drawing::drawSherd(model->mesh, id, how);
  if (drawn || how.rim != RimChoice::Yes) return drawn;
  // No stretch of the edge can be a lip, or the model itself is at fault: then this fails, too.
  how.rim = RimChoice::No;
  how.remarks.push_back(message(
      "The sherd is recorded as a rim, but no part of its edge can be one; it is drawn without a "
      "rim."));
  return drawing::drawSherd(model->mesh, id, how);
}

Result<DrawnSherds> drawSherds(const catalogue::Catalogue& catalogue,
                               const std::filesystem::path& project,
                               std::span<const store::SherdRow> rows,
                               const DrawSherdsOptions& options, Progress& progress,
                               std::stop_token stop) {
  if (const Result<void> good = options.drawing.check(); !good) return good.error();
  const Result<std::vector<SherdRecord>> sherds = sherds::Sherds(catalogue).of(rows);
  if (!sherds) return sherds.error();
  DrawnSherds all;
  std::int64_t done = 0;
  for (const SherdRecord& sherd : *sherds) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(done++, static_cast<std::int64_t>(sherds->size()));
    if (sherd.state == records::SherdState::Void && rows.size() > 1) {
      all.left_out.push_back({sherd.row, nameOf(sherd).english(), leftOutAsVoid(sherd)});
      continue;
    }
    Result<drawing::SherdDrawing> drawn = drawSherd(catalogue, sherd, project, options);
    if (!drawn) {
      all.left_out.push_back({sherd.row, nameOf(sherd).english(), drawn.error().sentence()});
      continue;
    }
    all.drawings.push_back(std::move(*drawn));
    all.rows.push_back(sherd.row);
  }
  progress.report(done, done);
  return all;
}

Result<std::vector<std::string>> picturesOf(const catalogue::Catalogue& catalogue,
                                            const std::filesystem::path& project,
                                            const DrawnSherds& drawn,
                                            const DrawSherdsOptions& options,
                                            const std::filesystem::path& file, Progress& progress,
                                            std::stop_token stop) {
  const Result<std::vector<SherdRecord>> sherds = sherds::Sherds(catalogue).of(drawn.rows);
  if (!sherds) return sherds.error();
  std::vector<std::string> files;
  for (std::size_t i = 0; i < sherds->size(); ++i) {
    if (stop.stop_requested()) return Error::cancelled();
    progress.report(static_cast<std::int64_t>(i), static_cast<std::int64_t>(sherds->size()));
    const SherdRecord& sherd = (*sherds)[i];
    const Result<PlyContents> model = modelOf(sherd, project);
    if (!model) return model.error();
    drawing::DrawingOptions how = options.drawing;
    const std::optional<texture::TexturedMesh> photographs =
        takePhotographs(catalogue, sherd, project, how);
    if (photographs) how.photographs = &*photographs;
    files.push_back(
        drawing::formatPicture(drawing::pictureOf(model->mesh, drawn.drawings[i], how), file));
  }
  return files;
}

}  // namespace ostraka::exchange
