#include "batch/photographs.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <system_error>

#include "base/message.h"
#include "base/text.h"
#include "batch/exif.h"
#include "batch/photograph.h"
#include "files/files.h"
#include "images/image_header.h"
#include "images/raw_image.h"

namespace ostraka::batch {
namespace fs = std::filesystem;
namespace {

constexpr std::pair<const char*, Side> kSideFolders[] = {{"front", Side::Front},
                                                         {"back", Side::Back},
                                                         {"top_images", Side::Front},
                                                         {"bottom_images", Side::Back}};

// Photographs, or imported scans.
std::vector<fs::path> photographsOrScansIn(const fs::path& folder) {
  std::vector<fs::path> files = photographsIn(folder);
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const fs::path& file = it->path();
    if (lowerCase(file.extension().string()) == ".ply" &&
        !file.filename().string().starts_with('.'))
      files.push_back(file);
  }
  return files;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// Takes a run of digits from the front, without its leading zeros.
std::string_view takeNumber(std::string_view& name) {
  std::size_t digits = 0;
  while (digits < name.size() && isDigit(name[digits])) ++digits;
  std::string_view number = name.substr(0, digits);
  name.remove_prefix(digits);
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

std::string stemOf(const fs::path& file) {
  return lowerCase(file.stem().string());
}

double pixels(int width, int height) {
  return static_cast<double>(width) * height;
}

// names: of one photograph or more.
Message leftOutAsSmall(const std::vector<std::string>& names, double least_megapixels) {
  constexpr std::size_t kNamed = 3;
  const std::size_t named = std::min(names.size(), kNamed);
  const std::string some = joined(std::span(names).first(named), ", ");
  if (names.size() > named)
    return message(
        "Photographs of less than %1 megapixels are left out (%2 and %3 more); copy the originals "
        "from the camera instead of thumbnails.",
        decimal(least_megapixels, 2), some, names.size() - named);
  return message(
      "Photographs of less than %1 megapixels are left out (%2); copy the originals from the "
      "camera instead of thumbnails.",
      decimal(least_megapixels, 2), some);
}

void warn(Progress& progress, const fs::path& where, const Message& what) {
  progress.note(NoteLevel::Warning, about(where, what));
}

// Adds those that are not to left_out.
std::vector<Shot> readable(const FreeSide& side, const ReadBatchOptions& options, LeftOut& left_out,
                           Progress& progress) {
  std::vector<Shot> shots;
  std::set<std::string> stems;
  std::vector<std::string> small;
  for (const fs::path& file : side.files) {
    const Result<images::ImageSize> size = images::readImageSize(file);
    if (!size) {
      left_out.add(size.error().sentence());
      progress.note(NoteLevel::Warning,
                    inOne(size.error().sentence(), message("This photograph is left out.")));
      continue;
    }
    if (pixels(size->width, size->height) < 1e6 * options.least_free_megapixels) {
      small.push_back(file.filename().string());
      continue;
    }
    // Results carry the stem, and a camera may write a picture in two formats.
    if (!stems.insert(stemOf(file)).second) {
      const Message why = message("Another photograph has the same name; this one is left out.");
      left_out.add(about(file, why));
      warn(progress, file, why);
      continue;
    }
    Shot shot;
    shot.side = side.side;
    shot.file = file;
    shot.width = size->width;
    shot.height = size->height;
    shots.push_back(std::move(shot));
  }
  if (small.empty()) return shots;
  const Message why = leftOutAsSmall(small, options.least_free_megapixels);
  for (std::size_t i = 0; i < small.size(); ++i) left_out.add(why);
  warn(progress, side.folder, why);
  return shots;
}

// Bytes that the camera's compression needed for a pixel: of neighbours, which show the same scene,
// a blurred one needs fewer.
double detailOf(const Shot& shot) {
  std::error_code failed;
  const std::uintmax_t bytes = fs::file_size(shot.file, failed);
  return failed ? 0 : static_cast<double>(bytes) / pixels(shot.width, shot.height);
}

// As they were taken, where each says when; else as they come.
void sortByTime(std::vector<Shot>& shots) {
  std::vector<std::pair<std::int64_t, std::size_t>> taken;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const std::optional<std::int64_t> ms = readExif(shots[i].file).takenMs();
    if (!ms) return;
    taken.emplace_back(*ms, i);
  }
  std::sort(taken.begin(), taken.end());
  std::vector<Shot> sorted;
  for (const auto& [ms, i] : taken) sorted.push_back(std::move(shots[i]));
  shots = std::move(sorted);
}

// The most detailed photograph of each of `most` stretches of the series.
std::vector<Shot> thinned(std::vector<Shot> shots, std::size_t most) {
  sortByTime(shots);
  std::vector<Shot> chosen;
  for (std::size_t k = 0; k < most; ++k) {
    const std::size_t from = k * shots.size() / most, to = (k + 1) * shots.size() / most;
    std::size_t best = from;
    for (std::size_t i = from + 1; i < to; ++i)
      if (detailOf(shots[i]) > detailOf(shots[best])) best = i;
    chosen.push_back(std::move(shots[best]));
  }
  std::ranges::sort(chosen, inOrderOfNames, &Shot::file);
  return chosen;
}

fs::path wholePath(const fs::path& folder) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

bool isFolder(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_directory(folder, ignored);
}

FreeSide plainSide(Side side, const fs::path& folder, bool alone) {
  FreeSide plain{side, photographsIn(folder), folder, {}};
  std::vector<fs::path> masks{folder / "masks",
                              folder.parent_path() / (folder.filename().string() + "_masks")};
  if (alone) masks.push_back(folder.parent_path() / "masks");
  const auto found = std::find_if(masks.begin(), masks.end(), isFolder);
  if (found != masks.end() && *found != folder) plain.mask_folder = *found;
  return plain;
}

Result<void> areTwoFolders(const fs::path& front, const std::optional<fs::path>& back) {
  for (const fs::path& folder : {front, back.value_or(front)})
    if (!isFolder(folder))
      return Error::unusable(
          message("There is no such folder; choose one with the photographs of one side."), folder);
  std::error_code ignored;
  if (back && fs::equivalent(front, *back, ignored))
    return Error::unusable(
        message(
            "The same folder is given for the front and the back; choose the folder of each side."),
        front);
  return {};
}

}  // namespace

bool inNaturalOrder(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (isDigit(a[0]) && isDigit(b[0])) {
      const std::string_view m = takeNumber(a), n = takeNumber(b);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      continue;
    }
    const auto lower = [](char c) {
      return static_cast<unsigned char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    };
    if (lower(a[0]) != lower(b[0])) return lower(a[0]) < lower(b[0]);
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.empty() != b.empty() ? a.empty() : whole_a < whole_b;
}

bool inOrderOfNames(const fs::path& a, const fs::path& b) {
  return inNaturalOrder(a.filename().string(), b.filename().string());
}

std::vector<fs::path> photographsIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
    if ((hasPhotographEnding(it->path()) || images::hasRawEnding(it->path())) &&
        !it->path().filename().string().starts_with("."))
      files.push_back(it->path());
  std::set<std::string> developed;
  for (const fs::path& file : files)
    if (!images::hasRawEnding(file)) developed.insert(stemOf(file));
  std::erase_if(files, [&developed](const fs::path& file) {
    return images::hasRawEnding(file) && developed.contains(stemOf(file));
  });
  std::ranges::sort(files, inOrderOfNames);
  return files;
}

Result<std::vector<Shot>> freeCameraShots(const FreeSide& side, const ReadBatchOptions& options,
                                          Progress& progress) {
  if (side.files.empty())
    return Error::unusable(
        message("This folder contains no photographs; put the photographs of one side into it."),
        side.folder);
  LeftOut left_out = side.left_out;
  std::vector<Shot> shots = readable(side, options, left_out, progress);
  const auto most = static_cast<std::size_t>(options.max_free_views);
  if (shots.size() > most) {
    warn(progress, side.folder,
         message("%1 of the %2 photographs are used: the most detailed ones, spread over the "
                 "series. More would take longer and add little.",
                 most, shots.size()));
    shots = thinned(std::move(shots), most);
  }
  if (static_cast<int>(shots.size()) < options.min_views_per_side)
    return tooFewOf(side.side, static_cast<std::ptrdiff_t>(shots.size()),
                    options.min_views_per_side, side.folder, left_out);
  const GivenMasks masks(side.mask_folder);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    shots[i].camera = static_cast<int>(i);
    masks.attachTo(shots[i], progress);
  }
  return shots;
}

bool isBatchFolder(const fs::path& folder) {
  for (const char* side : {"front", "back", "top_images", "bottom_images"})
    if (isFolder(folder / side)) return true;
  return false;
}

Result<Batch> freeCameraBatch(const std::vector<FreeSide>& sides, const fs::path& folder,
                              const std::vector<fs::path>& plates, const ReadBatchOptions& options,
                              Progress& progress) {
  Batch batch;
  batch.way = Way::FreeCamera;
  batch.folder = folder;
  for (const FreeSide& side : sides) {
    Result<std::vector<Shot>> shots = freeCameraShots(side, options, progress);
    if (!shots) return shots.error();
    std::move(shots->begin(), shots->end(), std::back_inserter(batch.shots));
  }
  if (const Result<void> read = readDescriptions(plates, options, batch); !read)
    return read.error();
  return batch;
}

Result<Batch> readPhotographs(const fs::path& front, const std::optional<fs::path>& back,
                              const std::optional<fs::path>& sheet, const ReadBatchOptions& options,
                              Progress& progress) {
  ReadBatchOptions with_sheet = options;
  if (sheet) with_sheet.sheet = sheet;
  const fs::path folder[2] = {wholePath(front), back ? wholePath(*back) : fs::path()};
  if (!back && (isBatchFolder(folder[0]) || !isFolder(folder[0])))
    return readBatch(front, with_sheet, progress);
  if (!back && photographsIn(folder[0]).empty())
    return Error::unusable(message("This folder contains neither photographs nor the folders "
                                   "'front' and 'back' of a batch; "
                                   "choose a folder with photographs."),
                           folder[0]);
  if (const Result<void> two = areTwoFolders(front, back); !two) return two.error();
  const bool common = back && folder[0].parent_path() == folder[1].parent_path();
  std::vector<FreeSide> sides{plainSide(Side::Front, folder[0], !back)};
  std::vector<fs::path> plates{folder[0] / "plate.json"};
  if (back) {
    sides.push_back(plainSide(Side::Back, folder[1], false));
    plates.push_back(folder[1] / "plate.json");
  }
  if (common || !back) plates.push_back(folder[0].parent_path() / "plate.json");
  return freeCameraBatch(sides, common ? folder[0].parent_path() : folder[0], plates, with_sheet,
                         progress);
}

void LeftOut::add(const Message& why) {
  if (photographs++ == 0) first = why;
}

Error tooFewOf(Side side, std::ptrdiff_t photographs, int least, const fs::path& folder,
               const LeftOut& left_out) {
  if (left_out.photographs > 0)
    return {ErrorCode::NotEnough,
            message(side == Side::Front
                        ? translatable<4>("Usable photographs of the front side: %1; at least %2 "
                                          "are needed. Photographs left out: %3; the first: %4")
                        : translatable<4>("Usable photographs of the back side: %1; at least %2 "
                                          "are needed. Photographs left out: %3; the first: %4"),
                    photographs, least, left_out.photographs, left_out.first),
            folder.string()};
  return {ErrorCode::NotEnough,
          message(side == Side::Front
                      ? translatable<2>("Usable photographs of the front side: %1; at least %2 are "
                                        "needed. Take more from all directions.")
                      : translatable<2>("Usable photographs of the back side: %1; at least %2 are "
                                        "needed. Take more from all directions."),
                  photographs, least),
          folder.string()};
}

GivenMasks::GivenMasks(const fs::path& folder) {
  if (folder.empty()) return;
  for (const fs::path& mask : photographsIn(folder)) by_stem_.emplace_back(stemOf(mask), mask);
  std::sort(by_stem_.begin(), by_stem_.end());
}

void GivenMasks::attachTo(Shot& shot, Progress& progress) const {
  const std::string stem = stemOf(shot.file);
  const auto found =
      std::lower_bound(by_stem_.begin(), by_stem_.end(), stem,
                       [](const auto& mask, const std::string& of) { return mask.first < of; });
  if (found == by_stem_.end() || found->first != stem) return;
  const Result<images::ImageSize> size = images::readImageSize(found->second);
  if (!size)
    progress.note(NoteLevel::Warning,
                  inOne(size.error().sentence(), message("This mask is not used.")));
  else if (*size != images::ImageSize{shot.width, shot.height})
    warn(progress, found->second,
         message("The mask and its photograph differ in size; the mask is not used."));
  else
    shot.mask_file = found->second;
}

Result<void> readDescriptions(const std::vector<fs::path>& plates, const ReadBatchOptions& options,
                              Batch& batch) {
  std::error_code ignored;
  const auto found = std::ranges::find_if(
      plates, [&ignored](const fs::path& file) { return fs::exists(file, ignored); });
  if (options.sheet || found != plates.end()) {
    batch.plate_file = options.sheet ? wholePath(*options.sheet) : *found;
    Result<Plate> plate = readPlate(batch.plate_file);
    if (!plate) return plate.error();
    batch.plate = batch.way == Way::FreeCamera ? asSheet(std::move(*plate)) : std::move(*plate);
  }
  if (const fs::path file = batch.folder / "board.json"; fs::exists(file, ignored)) {
    Result<Board> board = readBoard(file);
    if (!board) return board.error();
    batch.board = std::move(*board);
  }
  if (const fs::path file = batch.folder / "scale.json"; fs::exists(file, ignored)) {
    Result<std::vector<KnownLength>> lengths = readKnownLengths(file);
    if (!lengths) return lengths.error();
    batch.known_lengths = std::move(*lengths);
  }
  return {};
}

std::vector<SideFile> sideFiles(const std::vector<fs::path>& files) {
  std::vector<SideFile> sized;
  for (const fs::path& file : files) {
    std::error_code failed;
    const std::uintmax_t bytes = fs::file_size(file, failed);
    if (!failed) sized.push_back({file, bytes});
  }
  return sized;
}

std::vector<SideFile> sideFilesIn(const fs::path& batch_folder) {
  std::vector<fs::path> files;
  for (const auto& [folder, side] : kSideFolders)
    for (const fs::path& file : photographsOrScansIn(batch_folder / folder)) files.push_back(file);
  return sideFiles(files);
}

std::optional<Side> sideOf(const std::string& name) {
  for (const auto& [folder, side] : kSideFolders)
    if (fs::path(name).parent_path() == folder) return side;
  return std::nullopt;
}

Result<PhotographHashes> photographsNow(const fs::path& batch_folder, const std::stop_token& stop) {
  PhotographHashes hashes;
  for (const auto& [folder, side] : kSideFolders)
    for (const fs::path& file : photographsOrScansIn(batch_folder / folder)) {
      if (stop.stop_requested()) return Error::cancelled();
      const Result<std::string> bytes = readFile(file);
      hashes[std::string(folder) + "/" + file.filename().string()] =
          bytes ? sha256(*bytes) : "unreadable";
    }
  return hashes;
}

Result<std::string> takingNow(const fs::path& batch_folder, const std::stop_token& stop) {
  const Result<PhotographHashes> hashes = photographsNow(batch_folder, stop);
  if (!hashes) return hashes.error();
  std::string all;
  for (const auto& [name, hash] : *hashes) all += name + ":" + hash + "\n";
  return sha256(all);
}

}  // namespace ostraka::batch
