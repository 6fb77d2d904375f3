#pragma once
#include "catalogue/files.h"
#include "cloud/glb.h"
#include "exchange/export_folder.h"
#include "exchange/read_back.h"
#include "files/files.h"
#include "intake/enter_results.h"
#include "records/sherd.h"
#include "result_folder.h"
#include "sherds/numbers.h"
#include "sherds/sherds.h"
#include "small_project.h"

namespace ostraka::exchange {

/// A small project with one batch of three sherds, numbered and described, with models.
class ExportedProject : public catalogue::SmallProject {
 protected:
  ExportedProject() : batch(newBatch({bag4})), out(project_->resultsFolder("B0001"), 3) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (const char* number : {"01", "02", "03"}) {
      const auto folder = project_->resultsFolder("B0001") / "sherds" / number;
      put(folder / "model.ply", formatPly(mesh, "plate_front"));
      put(folder / "model.glb", *formatGlb(mesh, {}));
      catalogue::ResultFolder::noteModel(project_->resultsFolder("B0001"), number);
    }
    const std::string photograph = "batches/B0001/front/cam0_pos00.jpg";
    put(project_->folder() / photograph, "JPEG");
    catalogue::ResultFolder::noteInputs(project_->resultsFolder("B0001"),
                                        project_->batchFolder("B0001"));
    records::FileRecord f;
    f.path = photograph;
    f.sha256 = sha256("JPEG");
    f.bytes = 4;
    f.media_type = "image/jpeg";
    f.role = "photo";
    f.batch = batch;
    EXPECT_TRUE(catalogue::Files(catalogue()).save(f, anna));
    EXPECT_TRUE(intake::enterResults(catalogue(), project_->folder(), batch,
                                     project_->resultsFolder("B0001"), {}, quiet, {}));
    rows = *sherds::Sherds(catalogue()).rows(batch);
    EXPECT_TRUE(sherds::Numbers(catalogue()).assign(rows, anna));
    EXPECT_TRUE(set(rows[0], "part", "rim; neck"));
    EXPECT_TRUE(set(rows[0], "weight_g", "23.4"));
    EXPECT_TRUE(set(rows[0], "note", "=SUM(A1), \"quoted\"; Գառնի\nsecond line"));
    EXPECT_TRUE(set(rows[0], "extra.drawer", "7"));
    EXPECT_TRUE(set(rows[1], "joins", "ARM1-T3-0012-0001"));
    EXPECT_TRUE(set(rows[1], "date_edtf", "-1149/-0799~"));
    EXPECT_TRUE(set(rows[2], "length_mm", "52"));
  }
  static void put(const std::filesystem::path& path, const std::string& bytes) {
    EXPECT_TRUE(writeFileAtomically(path, bytes));
  }
  /// Of the i-th sherd.
  std::string modelOf(int i) { return fileOf(i, &records::SherdRecord::model_path); }
  std::string pictureOf(int i) { return fileOf(i, &records::SherdRecord::preview_path); }
  std::string fileOf(int i, std::string records::SherdRecord::*path) {
    const auto sherd = sherds::Sherds(catalogue()).get(rows[static_cast<std::size_t>(i)]);
    return (project_->folder() / ((*sherd).*path)).string();
  }
  Result<Exported> exportTo(const std::string& name, std::set<Form> forms) {
    ExportOptions options;
    options.target = folder_.path() / name;
    options.forms = std::move(forms);
    options.program = "ostraka 1.0.0";
    return exportFolder(catalogue(), project_->folder(), rows, options, quiet, {});
  }
  const std::set<Form> all = {Form::Csv, Form::Json,     Form::Ply,         Form::Glb,
                              Form::Obj, Form::Pictures, Form::Photographs, Form::Drawings};
  store::BatchRow batch;
  catalogue::ResultFolder out;
  QuietProgress quiet;
  std::vector<store::SherdRow> rows;
};

}  // namespace ostraka::exchange
