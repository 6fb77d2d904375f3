#include <gmock/gmock.h>

#include "files/files.h"
#include "store/database.h"
#include "tests/core/intake/entering.h"

namespace ostraka::intake {
namespace {

namespace fs = std::filesystem;

class DamagedResults : public Entering {};

// A disk that was full, a copy that broke off, a folder that somebody packed with links.
TEST_F(DamagedResults, AreNotEnteredWhereAFileIsCutEmptiedMissingOrALink) {
  out.photographs = "first";  // with a table of candidates, which names the scans
  out.write();
  const fs::path results = project_->resultsFolder("B0001");
  const auto refusal = [&] {
    const auto entered =
        enterResults(catalogue(), project_->folder(), batch, results, {}, quiet, {});
    EXPECT_FALSE(entered);
    return entered ? Error::unusable("entered") : entered.error();
  };
  for (const char* name :
       {"sherds/02/model.ply", "sherds/02/model.glb", "sherds/02/preview.png", "report.html",
        "work/model_02/stage.json", "work/scans_front/f001.ply"}) {
    SCOPED_TRACE(name);
    const fs::path file = results / name, aside = folder_.path() / "aside";
    const std::string whole = *readFile(file);
    ASSERT_TRUE(writeFileAtomically(file, ""));
    EXPECT_EQ(refusal().where, file);
    fs::rename(file, aside);
    EXPECT_EQ(refusal().where, file);
    ASSERT_TRUE(writeFileAtomically(aside, whole));
    fs::create_symlink(aside, file);
    EXPECT_EQ(refusal().where, file) << "a link, though to the same bytes";
    fs::remove(file);
    ASSERT_TRUE(writeFileAtomically(file, whole));
  }
  ASSERT_TRUE(writeFileAtomically(results / "sherds/03/model.glb", "model of f003b003model"));
  EXPECT_EQ(refusal().where, results / "sherds/03/model.glb") << "cut";
  EXPECT_TRUE(sherds().empty()) << "nothing is entered by halves";
  out.write();
  EXPECT_EQ(enter().models, 3);
}

}  // namespace
}  // namespace ostraka::intake
