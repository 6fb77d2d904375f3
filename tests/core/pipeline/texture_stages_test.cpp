// Textures that are made anew while everything before them is kept.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cloud/glb.h"
#include "files/files.h"
#include "files/json.h"
#include "small_batch.h"

namespace ostraka::pipeline {
namespace {

TEST_F(ProcessBatch, MakesOnlyTexturesAnewWithoutTheirLight) {
  QuietProgress quiet;
  copyOfWhole("albedo");
  const fs::path out = folder_ / "albedo";
  const auto before = results(out);
  ProcessOptions options;
  options.batch = folder_ / "batch";
  options.output = out;
  options.texture = TextureColours::Albedo;
  const Result<ProcessSummary> summary = processBatch(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  EXPECT_TRUE(summary->whole());
  const std::string log = *readFile(out / "log.txt");
  const std::string last = log.substr(log.rfind("rig: reused from an earlier run"));
  for (const char* kept :
       {"masks_front", "dense_back", "scans_back", "pairs", "model_01", "model_02"})
    EXPECT_NE(last.find(std::string(kept) + ": reused from an earlier run"), std::string::npos)
        << kept;
  // Of two sherds the light may be too little known; then they stay as photographed.
  const nlohmann::json light = *readJson(out / "work" / "light" / "stage.json");
  const bool is_known = light.at("figures").contains("light_uncertainty");
  EXPECT_EQ(light.at("warnings").empty(), is_known);
  auto after = results(out);
  for (const char* number : {"01", "02"}) {
    const std::string stage = std::string("texture_") + number,
                      folder = std::string("sherds/") + number + "/";
    EXPECT_EQ(last.find(stage + ": reused from an earlier run") == std::string::npos, is_known);
    for (const char* name : {"front.ply", "back.ply", "model.ply"})
      EXPECT_EQ(after.at(folder + name), before.at(folder + name)) << name;
    EXPECT_EQ(after.at(folder + "model.glb") != before.at(folder + "model.glb"), is_known);
    EXPECT_EQ(extrasInGlb(out / folder / "model.glb").texture, is_known ? "albedo" : "photo");
  }
  ASSERT_TRUE(process(out, 1, quiet).has_value());
  EXPECT_EQ(results(out), before) << "as photographed again";
}

}  // namespace
}  // namespace ostraka::pipeline
