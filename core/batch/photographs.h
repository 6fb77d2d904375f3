#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "batch/batch.h"

namespace ostraka::batch {

/// Whether name a comes before b for people: numbers count by their value (IMG_2 before IMG_10),
/// capitals as small letters. Equal names in that sense are ordered by their bytes.
bool inNaturalOrder(std::string_view a, std::string_view b);

/// The same of files by their names, wherever they lie.
bool inOrderOfNames(const std::filesystem::path& a, const std::filesystem::path& b);

/// Files of the folder whose names end like a photograph's, in natural order; not hidden ones, not
/// RAW files beside a developed picture with the same stem, and not those in subfolders.
/// Empty where the folder cannot be read.
std::vector<std::filesystem::path> photographsIn(const std::filesystem::path& folder);

/// Photographs of a side that are not used.
struct LeftOut {
  std::ptrdiff_t photographs = 0;
  Message first;  ///< why the first one is not; it names the file
  void add(const Message& why);
};

/// A side photographed by hand (Way::FreeCamera).
struct FreeSide {
  Side side = Side::Front;
  std::vector<std::filesystem::path> files;
  std::filesystem::path folder;  ///< of the files, for sentences
  std::filesystem::path
      mask_folder;        ///< masks by the photographs' stems; empty when there are none
  LeftOut left_out = {};  ///< in the folder and not among the files
};

/// Shots in natural order of their names, each with its own camera; sizes may differ. Left out,
/// with a warning that names them: what is no image, thumbnails, a second photograph of the same
/// stem, and all beyond ReadBatchOptions::max_free_views: these are thinned to the most detailed
/// ones of equally long stretches of the series. Errors: UnusableInput (no photograph at all),
/// NotEnough.
Result<std::vector<Shot>> freeCameraShots(const FreeSide& side, const ReadBatchOptions& options,
                                          Progress& progress);

/// Sides photographed by hand over one sheet, each at most once. `folder` and `plates` as in
/// readDescriptions. Errors: UnusableInput, NotEnough.
Result<Batch> freeCameraBatch(const std::vector<FreeSide>& sides,
                              const std::filesystem::path& folder,
                              const std::vector<std::filesystem::path>& plates,
                              const ReadBatchOptions& options, Progress& progress);

/// Whether the folder is built like a batch, with a folder of a side in it.
bool isBatchFolder(const std::filesystem::path& folder);

/// What a person names on a command line: one or two folders with photographs under any names, each
/// a side photographed by hand over one sheet (Way::FreeCamera); or the folder of a batch, which is
/// read by `readBatch`. `front` alone is a side whose back was not photographed.
/// Batch::folder: the folder in which both lie, else the front's own. The sheet is read from
/// `sheet`, or else from plate.json beside the photographs or in the folder above (of two folders:
/// in the one above both); board.json and scale.json from Batch::folder. Masks are those in
/// FRONT/masks or FRONT_masks, or in ../masks of a single folder, where they have a photograph's
/// stem and size. Errors: UnusableInput, NotEnough.
Result<Batch> readPhotographs(const std::filesystem::path& front,
                              const std::optional<std::filesystem::path>& back,
                              const std::optional<std::filesystem::path>& sheet,
                              const ReadBatchOptions& options, Progress& progress);

/// NotEnough. folder: where more are to be put. Of those left out it says how many, and why the
/// first one: who silenced the warnings reads nothing else.
Error tooFewOf(Side side, std::ptrdiff_t photographs, int least,
               const std::filesystem::path& folder, const LeftOut& left_out = {});

/// The mask that came with a photograph, by its stem: sets Shot::mask_file when it has its size.
class GivenMasks {
 public:
  explicit GivenMasks(const std::filesystem::path& folder);  ///< need not be there
  void attachTo(Shot& shot, Progress& progress) const;

 private:
  std::vector<std::pair<std::string, std::filesystem::path>> by_stem_;  // sorted
};

/// Reads what the folder says about sizes into the batch: the plate from `options.sheet` or else
/// from the first file of `plates` that is there; board.json and scale.json from Batch::folder.
Result<void> readDescriptions(const std::vector<std::filesystem::path>& plates,
                              const ReadBatchOptions& options, Batch& batch);

/// SHA-256 by name, relative to the batch's folder.
using PhotographHashes = std::map<std::string, std::string>;

/// The side whose folder a file with this name relative to the batch's folder lies in; none for
/// what lies elsewhere, such as masks, the plate or the board, which may be those of many batches.
std::optional<Side> sideOf(const std::string& name);

/// The photographs (or imported scans) that lie in the folders of both sides now. Error: Cancelled.
Result<PhotographHashes> photographsNow(const std::filesystem::path& batch_folder,
                                        const std::stop_token& stop);

/// What tells one taking of the batch from another: one hash of the names and hashes of all these.
Result<std::string> takingNow(const std::filesystem::path& batch_folder,
                              const std::stop_token& stop);

/// A photograph (or imported scan) of a side, to be compared by content.
struct SideFile {
  std::filesystem::path file;
  std::uintmax_t bytes = 0;
  std::string sha256 = {};  ///< empty: `file` is read where another has its size
};
/// Those that lie in the folders of both sides.
std::vector<SideFile> sideFilesIn(const std::filesystem::path& batch_folder);
/// These files, as far as they are there.
std::vector<SideFile> sideFiles(const std::vector<std::filesystem::path>& files);

}  // namespace ostraka::batch
