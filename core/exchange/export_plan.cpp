#include "exchange/export_plan.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/message.h"
#include "catalogue/files.h"
#include "cloud/glb.h"
#include "colour/munsell_proposals.h"
#include "exchange/drawn_sherds.h"
#include "exchange/model_files.h"
#include "records/sherd.h"
#include "sherds/sherds.h"
#include "store/database.h"
#include "store/names.h"

namespace ostraka::exchange {

namespace fs = std::filesystem;

using namespace catalogue;
using store::valueOrThrow;

namespace {

std::string draftName(const records::SherdRecord& sherd) {
  if (sherd.piece == 0 || sherd.batch_number.empty()) return store::slug("sherd-" + sherd.id);
  return store::slug(sherd.batch_number + (sherd.piece < 10 ? "-0" : "-") +
                     std::to_string(sherd.piece));
}

}  // namespace

// Numbers are unlike each other, but a person may give one that is a draft's name.
std::map<store::SherdRow, std::string> namesOf(std::span<const records::SherdRecord> sherds) {
  constexpr std::size_t kIdLetters = 8;
  std::map<store::SherdRow, std::string> names;
  std::set<std::string> taken;
  for (const records::SherdRecord& sherd : sherds)
    if (!sherd.number.empty())
      taken.insert(store::uniqueKey(names[sherd.row] = store::slug(sherd.number)));
  for (const records::SherdRecord& sherd : sherds) {
    if (!sherd.number.empty()) continue;
    std::string name = draftName(sherd);
    while (!taken.insert(store::uniqueKey(name)).second)
      name += "-" + sherd.id.substr(0, kIdLetters);
    names[sherd.row] = name;
  }
  return names;
}

bool isMadeAnew(const PlannedFile& file, const ExportOptions& options) {
  return isModel(file.form) && options.most_model_bytes > 0 && file.from.extension() == ".ply";
}

bool isModel(Form form) {
  return form == Form::Ply || form == Form::Glb || form == Form::Obj;
}

void ExportPlan::add(std::span<const records::SherdRecord> sherds, const std::stop_token& stop) {
  names_ = namesOf(sherds);
  for (const records::SherdRecord& sherd : sherds) {
    if (stop.stop_requested()) throw store::Refused(Error::cancelled());
    addFiles(sherd);
  }
}

void ExportPlan::addFiles(const records::SherdRecord& sherd) {
  const std::string& name = nameOf(sherd);
  std::string glb;  // that goes out as it is
  const auto most = static_cast<std::int64_t>(unlabelledBytes(options_));
  for (const records::FileRecord& file : valueOrThrow(Files(catalogue_).of(sherd.row))) {
    hashes_[file.path] = file.sha256;
    if (file.role == "model" && file.path.ends_with(".glb") && (most == 0 || file.bytes <= most))
      glb = file.path;
  }
  want(Form::Ply, sherd, "model", "models/" + name + ".ply", sherd.model_path);
  want(Form::Glb, sherd, "model", "models/" + name + ".glb", glb.empty() ? sherd.model_path : glb);
  want(Form::Obj, sherd, "model", "models/" + name + ".obj", sherd.model_path);
  want(Form::Pictures, sherd, "preview", "images/" + name + ".png", sherd.preview_path);
  if (options_.forms.contains(Form::Drawings)) addDrawing(sherd, name);
  if (sherd.batch && batches_.emplace(sherd.batch, sherd.batch_number).second)
    photographs(sherd.batch, sherd.batch_number);
}

std::map<store::BatchRow, std::string> ExportPlan::viewed() const {
  return options_.forms.contains(Form::Views) ? batches_ : std::map<store::BatchRow, std::string>();
}

void ExportPlan::want(Form form, const records::SherdRecord& sherd, const char* role,
                      const std::string& to, const std::string& from) {
  if (from.empty() || !options_.forms.contains(form)) return;
  files_.push_back({sherd.row, role, to, project_ / from, hashes_[from], form, from});
}

Result<OpenFile> ExportPlan::open(const PlannedFile& file) const {
  return file.inside.empty() ? OpenFile::open(file.from) : OpenFile::within(project_, file.inside);
}

// Drawings are for print; tables and records keep void sherds, with their state.
void ExportPlan::addDrawing(const records::SherdRecord& sherd, const std::string& name) {
  const auto made = options_.drawings.find(sherd.row);
  if (made == options_.drawings.end() && sherd.model_path.empty()) return;
  if (sherd.state == records::SherdState::Void) {
    not_drawn_.push_back(leftOutAsVoid(sherd));
  } else if (made != options_.drawings.end()) {
    for (const fs::path& file : made->second)
      files_.push_back(
          {sherd.row,
           "drawing",
           "drawings/" + name + store::slug(file.extension().string()).replace(0, 1, "."),
           file,
           {},
           Form::Drawings});
  } else {
    drawn_.push_back(&sherd);
  }
}

void ExportPlan::photographs(store::BatchRow batch, const std::string& number) {
  if (!options_.forms.contains(Form::Photographs) && !options_.forms.contains(Form::Views)) return;
  const std::string folder = "batches/" + number + "/";
  for (const records::FileRecord& file : valueOrThrow(Files(catalogue_).of(batch))) {
    if (file.role != "photo" && file.role != "scale") continue;
    if (file.role == "photo" && options_.forms.contains(Form::Views))
      viewed_photographs_.push_back(project_ / file.path);
    if (!options_.forms.contains(Form::Photographs)) continue;
    const std::string inside = file.path.starts_with(folder)
                                   ? file.path.substr(folder.size())
                                   : fs::path(file.path).filename().string();
    files_.push_back({{},
                      file.role,
                      "photographs/" + number + "/" + inside,
                      project_ / file.path,
                      file.sha256,
                      Form::Photographs,
                      file.path});
  }
}

std::vector<records::SherdRecord> readAll(const Catalogue& catalogue,
                                          std::span<const store::SherdRow> rows, ExportPlan& plan,
                                          const std::stop_token& stop) {
  std::vector<records::SherdRecord> sherds = valueOrThrow(sherds::Sherds(catalogue).of(rows));
  plan.add(sherds, stop);
  return sherds;
}

std::vector<std::string> ExportPlan::withoutModel(
    std::span<const records::SherdRecord> sherds,
    const std::set<store::SherdRow>& with_model) const {
  std::vector<std::string> names;
  if (std::any_of(options_.forms.begin(), options_.forms.end(), isModel))
    for (const records::SherdRecord& sherd : sherds)
      if (!with_model.contains(sherd.row)) names.push_back(nameOf(sherd));
  return names;
}

Result<DrawnSheets> sheetsOf(const Catalogue& catalogue, const records::SherdRecord& sherd,
                             const fs::path& project, const ExportOptions& options,
                             const std::string& title) {
  DrawSherdsOptions how;
  how.drawing.wording = options.wording;
  how.drawing.surface = options.drawing_surface;
  how.drawing.dpi = options.drawing_dpi;
  drawing::SheetOptions sheet;
  sheet.title = title;
  sheet.wording = options.wording;
  const std::vector<double> scales =
      options.drawing_scale
          ? std::vector{*options.drawing_scale}
          : std::vector<double>(std::begin(kDrawingScales), std::end(kDrawingScales));
  for (const double scale : scales) {
    how.drawing.scale = scale;
    Result<drawing::SherdDrawing> drawn = drawSherd(catalogue, sherd, project, how);
    if (!drawn) return drawn.error();
    std::vector<Message> remarks = drawn->remarks;
    std::vector<Page> pages = drawing::layOut({std::move(*drawn)}, scale, sheet);
    const Eigen::Vector2d wanted = paperSize(sheet.paper);
    const Eigen::Vector2d page(pages.front().width_mm, pages.front().height_mm);
    // However the sheet is turned.
    const bool fits =
        page.minCoeff() <= wanted.minCoeff() + 0.1 && page.maxCoeff() <= wanted.maxCoeff() + 0.1;
    if (fits || scale == scales.back()) return DrawnSheets{std::move(pages), std::move(remarks)};
  }
  return Error{ErrorCode::Failed, message("The drawing needs a scale."), sherd.number};
}

namespace {

GlbExtras extrasOf(const records::SherdRecord& sherd) {
  GlbExtras extras;
  if (sherd.measures.contains("filled_pct"))
    extras.filled_percent = sherd.measures.at("filled_pct");
  return extras;
}

}  // namespace

Result<std::string> glbOf(const TriangleMesh& mesh, const records::SherdRecord& sherd) {
  return formatGlb(mesh, extrasOf(sherd));
}

Result<std::string> glbOf(const texture::TexturedMesh& model, const records::SherdRecord& sherd,
                          const GlbExtras& processed) {
  GlbExtras extras = extrasOf(sherd);
  extras.munsell = processed.munsell;
  return texture::formatGlb(model, extras);
}

GlbExtras processedExtras(const fs::path& project, const records::SherdRecord& sherd) {
  if (sherd.model_path.empty()) return {};
  GlbExtras extras = extrasInGlb((project / sherd.model_path).replace_extension(".glb"));
  const auto proposals = colour::parseMunsellProposals(extras.munsell);
  extras.munsell = proposals ? colour::toJson(*proposals).dump() : std::string();
  return extras;
}

Result<std::string> labelled(Form form, const std::string& bytes, const ModelLabel& label,
                             const std::string& where) {
  return form == Form::Ply   ? labelledPly(bytes, label, where)
         : form == Form::Glb ? labelledGlb(bytes, label, where)
         : form == Form::Obj ? labelledObj(bytes, label, where)
                             : bytes;
}

}  // namespace ostraka::exchange
