// One bit after the other is turned in the catalogue and in the files that it knows. None may be
// accepted with another content. OSTRAKA_FLIPS=N turns N bits in each, OSTRAKA_SEED=N others.
#include "flipped_bits.h"

#include <cstdio>

#include "exported_project.h"
#include "program.h"
#include "upkeep/file_check.h"

namespace ostraka::test {
namespace {

namespace fs = std::filesystem;

int flips() {
  return numberFrom("OSTRAKA_FLIPS", 100);
}
unsigned seed() {
  return static_cast<unsigned>(numberFrom("OSTRAKA_SEED", 24));
}

using FlippedBits = exchange::ExportedProject;

TEST_F(FlippedBits, OfTheCatalogueAreFoundOrHarmless) {
  const fs::path folder = project_->folder();
  project_.reset();
  const catalogue::Flips result = catalogue::flipBits(folder, flips(), seed(), 1);
  std::printf("catalogue: %d bits: %d found, %d harmless, %d accepted; %d of %d repaired\n",
              flips(), result.found, result.harmless, result.accepted, result.restored,
              result.restored + result.not_restored);
  EXPECT_EQ(result.accepted, 0) << result.unlike;
  EXPECT_EQ(result.not_restored, 0) << result.unlike;
  EXPECT_GT(result.found, flips() * 9 / 10);
}

TEST_F(FlippedBits, OfPhotographsAndModelsAreAllFound) {
  const auto files = catalogue::valueIn(upkeep::knownFiles(catalogue()));
  ASSERT_GT(files.size(), 6u);
  std::mt19937_64 random(seed());
  int found = 0;
  for (int i = 0; i < flips(); ++i) {
    const upkeep::KnownFile& chosen = files[random() % files.size()];
    const fs::path file = project_->folder() / chosen.path;
    const std::string whole = catalogue::bytesOf(file);
    ASSERT_FALSE(whole.empty()) << file;
    std::string bytes = whole;
    bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
    catalogue::writeBytes(file, bytes);
    fs::remove(project_->folder() / "file-checks.txt");
    const auto checked = catalogue::valueIn(
        upkeep::checkFiles(catalogue(), project_->folder(), upkeep::CheckDepth::Hashes, quiet, {}));
    found += checked.damaged.size() == 1 && checked.damaged[0].file.path == chosen.path ? 1 : 0;
    catalogue::writeBytes(file, whole);
  }
  std::printf("photographs and models: %d bits: %d found\n", flips(), found);
  EXPECT_EQ(found, flips());
}

}  // namespace
}  // namespace ostraka::test
