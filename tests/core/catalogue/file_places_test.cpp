#include "catalogue/file_places.h"

#include <gtest/gtest.h>

namespace ostraka::catalogue {
namespace {

TEST(ImportPlaces, AreThoseOfPhotographsScansModelsAndDrawings) {
  for (const char* path :
       {"batches/B0001/front/cam0_pos00.jpg", "batches/B0001/back/cam1_pos03.TIF",
        "batches/B0001/plate.json", "batches/B0001/RIG.json",
        "batches/B0001/masks/front/cam0_pos00.png", "results/B0001/pairs.json",
        "results/B0001/scans/f001.ply", "models/B0001/0123456789abcdef/model.glb"})
    EXPECT_TRUE(importPlace(path, "B0001")) << path;
  for (const char* path : {"imported/out/models/A-1.ply", "imported/out/images/A-1.png",
                           "imported/out/drawings/A-1.svg", "imported/out/drawings/A-1.pdf"})
    EXPECT_TRUE(importPlace(path, {})) << path;
}

TEST(ImportPlaces, AreNoneThatSteerTheProgramOrBelongToOthers) {
  for (const char* path : {"backups/catalogue-99990101-000000-000.sqlite",
                           "catalogue.sqlite",
                           "catalogue.sqlite-journal",
                           "batches/B0001/catalogue.sqlite",
                           "results/B0001/decisions.json",
                           "results/B0001/mask_strokes.json",
                           "results/B0001/work/scans_front/f001.ply",
                           "results/B0001/work/stage.json",
                           "results/B0001/report.html",
                           "results/B0001/lock",
                           "results/B0001/log.txt",
                           "batches/B0001/manifest.json",
                           "batches/B0001/.hidden.jpg",
                           "batches/B0001/.git/x.jpg",
                           "batches/B0001/x.partial",
                           "batches/B0001/x.desktop",
                           "batches/B0001",
                           "batches/x.jpg",
                           "batches/B0002/front/x.jpg",
                           "results/B0002/pairs.json",
                           "models/B0002/a/model.ply",
                           "imported/out/x.ply",
                           "file-checks.txt",
                           "rigs/a/x.jpg",
                           "batches/B0001/../B0002/x.jpg",
                           "/batches/B0001/x.jpg",
                           "batches//B0001/x.jpg"})
    EXPECT_FALSE(importPlace(path, "B0001")) << path;
  for (const char* path :
       {"batches/B0001/front/x.jpg", "models/B0001/a/model.ply", "imported/out/x.sh",
        "imported/x.ply", "imported/out/.x.ply", "imported/../models/B0001/model.ply"})
    EXPECT_FALSE(importPlace(path, {})) << path;
}

TEST(RecordedPlaces, AreThoseOfTheFilesOwnBatch) {
  for (const char* path :
       {"batches/B0001/front/cam0_pos00.jpg", "batches/B0001/front/cam0_pos00.NEF",
        "batches/B0001/plate.json", "results/B0001/report.html", "results/B0001/report.json",
        "results/B0001/work/scans_front/f001.ply", "results/B0001/work/pieces_back/b001.ply",
        "models/B0001/0123456789abcdef/model.glb", "imported/out/models/A-1.ply"})
    EXPECT_TRUE(isRecordedPlace(path, "B0001")) << path;
  for (const char* path :
       {"results/B0005/decisions.json", "results/B0005/mask_strokes.json", "batches/B0005/rig.json",
        "batches/B0005/scale.json", "batches/B0005/front/x.jpg", "results/B0005/report.html",
        "results/B0005/work/scans_front/f001.ply", "results/B0001/decisions.json",
        "results/B0001/mask_strokes.json", "results/B0001/work/lock",
        "results/B0001/work/stage.json", "results/B0001/work/scans_front/.f.ply",
        "models/B0001/.hidden", "imported/a/b.desktop", "catalogue.sqlite", "backups/a/b.png"})
    EXPECT_FALSE(isRecordedPlace(path, "B0001")) << path;
  EXPECT_FALSE(isRecordedPlace("batches/B0001/front/x.jpg", {}));
  EXPECT_TRUE(isRecordedPlace("imported/out/models/A-1.ply", {}));
}

TEST(RecordedPaths, AreThoseOfAnyBatchAndNeverWhatSteersTheProgram) {
  for (const char* path :
       {"batches/B0001/front/cam0_pos00.jpg", "results/B0002/work/scans_front/f001.ply",
        "results/drawn/1.ply", "models/B0001/0123456789abcdef/preview.png", "imported/a/x.svg"}) {
    const Result<std::string> recorded = recordedPath(path);
    ASSERT_TRUE(recorded) << path;
    EXPECT_EQ(*recorded, path);
  }
  for (const char* path :
       {"catalogue.sqlite", "catalogue.sqlite-wal", "lock", "models/model.ply", "models//model.ply",
        "backups/B0001/catalogue.sqlite", "models/B0001/a/model.sqlite",
        "results/B0001/decisions.json", "results/B0001/work/rig/stage.json", "rigs/a/x.jpg", ""})
    EXPECT_FALSE(recordedPath(path)) << path;
}

TEST(PlacesOfFiles, AreAllInABatchsFolderButLocksAndWhatIsUnfinished) {
  for (const char* path : {"batches/B0001/notes.txt", "results/B0001/decisions.json",
                           "results/B0001/work/rig/rig.json", "models/B0001/a/model.ply",
                           "imported/out/models/A-1.ply"})
    EXPECT_TRUE(isPlaceOfFiles(path)) << path;
  for (const char* path :
       {"catalogue.sqlite", "backups/a/b.png", "batches/notes.txt", "results/B0001/work/lock",
        "batches/B0001/.hidden", "batches/.git/config", "results/B0001/x.partial/a.ply",
        "imported/out/x.desktop", "imported/x.ply", "batches/../backups/x.sqlite"})
    EXPECT_FALSE(isPlaceOfFiles(path)) << path;
}

}  // namespace
}  // namespace ostraka::catalogue
