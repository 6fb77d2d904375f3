#include <algorithm>

#include "base/message.h"
#include "files/output_place.h"
#include "pipeline/process_batch.h"

namespace ostraka::pipeline {

namespace fs = std::filesystem;

namespace {
constexpr double kLeastMemory_gb = 1;
}

Result<void> ProcessOptions::check() const {
  if (batch.empty()) return Error::unusable(message("No batch folder was given."));
  if (output.empty())
    return Error::unusable(message("No output folder was given; name one with --output OUT."));
  if (Result<void> good = checkOutputPlace(output, "results"); !good) return good;
  std::error_code failed;
  for (const fs::path& input : {batch, back.value_or(batch)}) {
    if (Result<void> good = checkNoLinkInProject(input); !good) return good;
    const fs::path folder = fs::weakly_canonical(input, failed);
    const fs::path beyond = fs::weakly_canonical(output, failed).lexically_relative(folder);
    if (!beyond.empty() && *beyond.begin() != "..")
      return Error::unusable(message("The output folder is inside the batch folder, to which "
                                     "Ostraka never writes; choose one next to it."),
                             output.string());
  }
  if (!(megapixels >= 0.3))
    return Error::unusable(message("Photographs cannot be reduced to less than 0.3 megapixels."));
  if (!(memory_gb >= kLeastMemory_gb))
    return Error::unusable(
        message("Processing needs at least %1 GB of memory.", decimal(kLeastMemory_gb, 0)));
  if (masks != "auto" && masks != "given" && !fs::is_regular_file(masks, failed))
    return Error::unusable(
        message("There is no such segmentation network; masks are 'auto', 'given' or an ONNX "
                "file."),
        masks);
  return {};
}

int ProcessSummary::ambiguous() const {
  return static_cast<int>(
      std::ranges::count_if(sherds, [](const SherdSummary& s) { return s.ambiguous; }));
}

bool ProcessSummary::whole() const {
  return !sherds.empty() && unpaired_front.empty() && unpaired_back.empty() && reshoot.empty() &&
         moved.empty() && left_out.empty() &&
         std::ranges::all_of(sherds, [](const SherdSummary& s) { return s.has_model; });
}

}  // namespace ostraka::pipeline
