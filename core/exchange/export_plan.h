#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/message.h"
#include "catalogue/catalogue.h"
#include "exchange/export_folder.h"
#include "exchange/model_files.h"
#include "files/open_folder.h"
#include "paper/sheet.h"
#include "records/sherd.h"
#include "texture/texture.h"

namespace ostraka::exchange {

bool isModel(Form form);

/// The scales that drawings are made at where the sheet decides.
inline constexpr double kDrawingScales[] = {1, 1 / 2.0, 1 / 3.0, 1 / 4.0, 1 / 5.0};

/// Of what a GLB may take: all but its label, and its surface without the photographs.
constexpr std::size_t unlabelledBytes(const ExportOptions& options) {
  return options.most_model_bytes / 20 * 19;
}
constexpr std::size_t surfaceBytes(const ExportOptions& options) {
  return options.most_model_bytes / 5 * 2;
}

/// One file to be copied, and what for.
struct PlannedFile {
  store::SherdRow sherd;  ///< none: of a batch
  std::string role, to;
  std::filesystem::path from;
  std::string sha256;  ///< as entered; empty when not known
  Form form = Form::Ply;
  std::string inside = {};  ///< `from` as the catalogue has it; empty for what a person named
};
/// A model that is made anew, so that it takes no more than it may.
bool isMadeAnew(const PlannedFile& file, const ExportOptions& options);

/// What sherds are called in an export: by their numbers, or, while they are drafts, by the batch
/// with the place on its map, B0004-03, and the beginning of the id where another has that name on
/// some system.
std::map<store::SherdRow, std::string> namesOf(std::span<const records::SherdRecord> sherds);

/// Everything that an export copies and makes, in a fixed order.
class ExportPlan {
 public:
  ExportPlan(const catalogue::Catalogue& catalogue, const std::filesystem::path& project,
             const ExportOptions& options)
      : catalogue_(catalogue), project_(project), options_(options) {}

  /// Once. They outlive the plan. Throws Refused.
  void add(std::span<const records::SherdRecord> sherds, const std::stop_token& stop);
  /// Of one that was added (namesOf).
  const std::string& nameOf(const records::SherdRecord& sherd) const {
    return names_.at(sherd.row);
  }
  /// Names of those that have no model in an export that is to have models.
  std::vector<std::string> withoutModel(std::span<const records::SherdRecord> sherds,
                                        const std::set<store::SherdRow>& with_model) const;
  /// Those whose pictures, masks and poses are wanted.
  std::map<store::BatchRow, std::string> viewed() const;
  const std::vector<std::filesystem::path>& viewedPhotographs() const {
    return viewed_photographs_;
  }
  const std::vector<PlannedFile>& files() const { return files_; }
  const std::filesystem::path& project() const { return project_; }
  /// What the catalogue names is read within the project only, and through no link: anybody may
  /// have written it, and an export is handed on.
  Result<OpenFile> open(const PlannedFile& file) const;
  /// To be drawn.
  const std::vector<const records::SherdRecord*>& drawn() const { return drawn_; }
  /// Not drawn, and why.
  const std::vector<Message>& notDrawn() const { return not_drawn_; }

 private:
  void addFiles(const records::SherdRecord& sherd);
  void want(Form form, const records::SherdRecord& sherd, const char* role, const std::string& to,
            const std::string& from);
  void addDrawing(const records::SherdRecord& sherd, const std::string& name);
  void photographs(store::BatchRow batch, const std::string& number);

  const catalogue::Catalogue& catalogue_;
  const std::filesystem::path& project_;
  const ExportOptions& options_;
  std::vector<PlannedFile> files_;
  std::vector<const records::SherdRecord*> drawn_;
  std::vector<Message> not_drawn_;
  std::vector<std::filesystem::path> viewed_photographs_;
  std::map<store::SherdRow, std::string> names_;
  std::map<store::BatchRow, std::string> batches_;
  std::map<std::string, std::string> hashes_;
};

/// The records of these sherds; the plan refers to them. Throws Refused.
std::vector<records::SherdRecord> readAll(const catalogue::Catalogue& catalogue,
                                          std::span<const store::SherdRow> rows, ExportPlan& plan,
                                          const std::stop_token& stop);

/// A sherd's drawing on its sheets.
struct DrawnSheets {
  std::vector<Page> pages;
  std::vector<Message> remarks;  ///< of the drawing
};
/// Errors: those of drawSherd.
Result<DrawnSheets> sheetsOf(const catalogue::Catalogue& catalogue,
                             const records::SherdRecord& sherd,
                             const std::filesystem::path& project, const ExportOptions& options,
                             const std::string& title);
/// A model as GLB.
Result<std::string> glbOf(const TriangleMesh& mesh, const records::SherdRecord& sherd);
Result<std::string> glbOf(const texture::TexturedMesh& model, const records::SherdRecord& sherd,
                          const GlbExtras& processed);
/// What `process` left in the GLB beside a sherd's model: its texture's kind and, where they are
/// such, proposals for Munsell colours; empty where there is none.
GlbExtras processedExtras(const std::filesystem::path& project, const records::SherdRecord& sherd);
/// A model in one of its forms, labelled. bytes: a GLB for that form, a PLY for the others.
Result<std::string> labelled(Form form, const std::string& bytes, const ModelLabel& label,
                             const std::string& where);

}  // namespace ostraka::exchange
