#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "drawing/view.h"
#include "drawing/wording.h"
#include "store/row.h"

namespace ostraka::exchange {

enum class Form {
  Csv,
  Json,
  Ply,
  Glb,
  Obj,
  Pictures,
  Photographs,
  Drawings,
  Ods,
  Views  ///< pictures, masks and poses of the batches, for COLMAP and OpenMVS
};

/// What a model may take that a browser or a phone is to open.
inline constexpr std::size_t kWebBytes = 5'000'000, kPhoneBytes = 1'000'000;

/// What the reader calls a column of sherds.csv or contexts.csv. Any thread may call it.
using ColumnWords = std::function<std::string(const std::string& column)>;

struct ExportOptions {
  std::filesystem::path target;  ///< new folder
  std::set<Form> forms = {Form::Csv, Form::Json, Form::Ply, Form::Glb, Form::Pictures};
  /// Drawings made for sherds beforehand; each is copied to drawings/SLUG.ending. Sherds that have
  /// none here are drawn when drawings are wanted: SVG and PDF, a sheet each.
  std::map<store::SherdRow, std::vector<std::filesystem::path>> drawings;
  /// mm on paper per mm; nothing: for each sherd the largest of 1:1 to 1:5 that fits its sheet.
  std::optional<double> drawing_scale = 1;
  drawing::Surface drawing_surface = drawing::Surface::Relief;
  drawing::Dpi drawing_dpi = drawing::Dpi::Usual;
  drawing::Wording wording;         ///< of the drawings
  ColumnWords words;                ///< in the spreadsheet's headings; may be empty
  std::string program = "ostraka";  ///< with its version
  /// What a GLB may take, photographs and all. Larger ones get fewer triangles and texels, PLY and
  /// OBJ the same surface; how far it is off is stated in each file. 0: as computed, and the GLB as
  /// it is kept.
  std::size_t most_model_bytes = 0;
};

struct ExportSize {
  int sherds = 0, files = 0;
  std::int64_t bytes = 0;                  ///< of all of them, within a tenth; see sizeOfExport
  std::vector<std::string> without_model;  ///< as in Exported
  int drawings = 0;                        ///< sherds that will be drawn, two of the files each
  int lightened = 0;                       ///< sherds whose models will get fewer triangles
};
/// What the export will take, before it starts. Copies are counted; of what is made only for the
/// export (OBJ, lighter models, drawings, records) one to three sherds of middle size tell for all.
/// Views are a rough figure. Errors: those of the catalogue, Cancelled.
Result<ExportSize> sizeOfExport(const catalogue::Catalogue& catalogue,
                                const std::filesystem::path& project,
                                std::span<const store::SherdRow> sherds,
                                const ExportOptions& options, std::stop_token stop);

/// Beside the files that the manifest lists: itself, its own checksums and two with the bag's data.
inline constexpr int kFilesOfTheBag = 4;

struct Exported {
  int sherds = 0, files = 0;  ///< files: all that lie in the folder
  std::int64_t bytes = 0;
  std::vector<Message> warnings;  ///< models or photographs that are not there, sherds not drawn
  std::set<Form> without_file;    ///< forms that were asked for, and of which nothing is there
  /// Sherds, by the names of their files, of which no model is there; none where no models are
  /// asked for. README.txt lists them, too.
  std::vector<std::string> without_model;
};
/// A folder after BagIt with a checksum for every file; nothing half-written, ever: all is read
/// again before it gets its name. Errors: the target is there, a file changed since it was entered
/// or since it was written, a full disk, Cancelled.
Result<Exported> exportFolder(const catalogue::Catalogue& catalogue,
                              const std::filesystem::path& project,
                              std::span<const store::SherdRow> sherds, const ExportOptions& options,
                              Progress& progress, std::stop_token stop);

enum class ByteOrderMark { With, Without };  ///< Excel reads UTF-8 only with it
/// What a table says of a sherd besides its fields: model_file, image_file, drawing_file,
/// mass_centre_x_mm ...; may be empty.
using FilesOfSherds = std::map<store::SherdRow, std::map<std::string, std::string>>;
/// The table alone, for programs: in every language the same headings, decimal points, commas.
Result<std::string> sherdsCsv(const catalogue::Catalogue& catalogue,
                              std::span<const store::SherdRow> sherds, ByteOrderMark mark,
                              const FilesOfSherds& files = {});
Result<std::string> contextsCsv(const catalogue::Catalogue& catalogue,
                                std::span<const store::ContextRow> contexts, ByteOrderMark mark);
/// What the columns of both mean, and their units.
std::string columnsCsv(ByteOrderMark mark);
/// Sherds, contexts and the meanings of the columns as three sheets of an OpenDocument spreadsheet,
/// for people: numbers as their program shows them. The headings are the reader's words where the
/// import of a table knows them as the same field, else those of the CSV, so that a sheet that was
/// edited can be imported again.
Result<std::string> tablesOds(const catalogue::Catalogue& catalogue,
                              std::span<const store::SherdRow> sherds,
                              std::span<const store::ContextRow> contexts,
                              const FilesOfSherds& files, const ColumnWords& words);

}  // namespace ostraka::exchange
