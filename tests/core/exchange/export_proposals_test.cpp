#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "closed_shell.h"
#include "cloud/glb.h"
#include "colour/munsell_proposals.h"
#include "exchange/export_folder.h"
#include "exported_project.h"
#include "files/json.h"
#include "images/jpeg_image.h"
#include "texture/texture.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

class ExportOfProposals : public ExportedProject {
 protected:
  // A sherd's model with other bytes, as if they had been entered.
  void giveModel(store::SherdRow sherd, const char* ending, const std::string& bytes) {
    const auto files = *catalogue::Files(catalogue()).of(sherd);
    for (records::FileRecord file : files) {
      if (!file.path.ends_with(ending)) continue;
      put(project_->folder() / file.path, bytes);
      file.sha256 = sha256(bytes);
      file.bytes = static_cast<std::int64_t>(bytes.size());
      EXPECT_TRUE(catalogue::Files(catalogue()).save(file, anna));
    }
  }
};

TEST_F(ExportOfProposals, NamesThemApartFromWhatWasEnteredAndInNoTable) {
  const TriangleMesh shell = closedShell();
  GlbTexture photographs;  // seen from above, through to the other side
  for (const Eigen::Vector3f& v : shell.vertices)
    photographs.uv.emplace_back(0.5f + v.x() / 80, 0.5f - v.y() / 80);
  photographs.jpeg = images::encodedJpeg(cv::Mat3b(400, 400, cv::Vec3b(30, 60, 200)));
  colour::MunsellProposals proposals;
  proposals.out = colour::proposedFor({150, 110, 80});
  GlbExtras extras;
  extras.munsell = colour::toJson(proposals).dump();
  extras.texture = "albedo";
  giveModel(rows[0], "model.ply", formatPly(shell, "a"));
  giveModel(rows[0], "model.glb", *formatGlb(shell, photographs, extras));
  for (const std::size_t most : {0, 60'000}) {  // half of what the shell takes
    ExportOptions options;
    options.target = folder_.path() / (most > 0 ? "light" : "whole");
    options.forms = {Form::Glb, Form::Json, Form::Csv};
    options.most_model_bytes = most;
    const std::vector<store::SherdRow> one = {rows[0]};
    const auto done = exportFolder(catalogue(), project_->folder(), one, options, quiet, {});
    ASSERT_TRUE(done) << done.error().sentence();
    const fs::path data = options.target / "data", glb = data / "models/ARM1-T3-0012-0001.glb";
    EXPECT_EQ(readFile(glb)->find("normalTexture") != std::string::npos, most > 0)
        << "the lighter one has the relief that it lost";
    EXPECT_EQ(extrasInGlb(glb).texture, "albedo");
    EXPECT_EQ(extrasInGlb(glb).munsell, nlohmann::json::parse(extras.munsell).dump());
    const nlohmann::json record = *readJson(data / "sherds/ARM1-T3-0012-0001.json");
    EXPECT_EQ(record.at("processing").at("texture"), "albedo");
    EXPECT_EQ(record.at("proposals").at("munsell"), nlohmann::json::parse(extras.munsell));
    EXPECT_FALSE(record.at("description").contains("munsell"));
    const std::string chip = proposals.out->match.notation;
    EXPECT_EQ(readFile(data / "sherds.csv")->find(chip), std::string::npos) << chip;
  }
}

}  // namespace
}  // namespace ostraka::exchange
