// The whole chain on a small batch of the virtual rig: 2 sherds, 800 pixels wide.
#include "pipeline/process_batch.h"
#include "review/review.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "batch/moved_batch.h"
#include "batch/photograph.h"
#include "cloud/glb.h"
#include "cloud/ply.h"
#include "decisions/candidate_table.h"
#include "decisions/mask_strokes.h"
#include "files/files.h"
#include "files/json.h"
#include "paper/report_page.h"
#include "rig/camera.h"
#include "small_batch.h"
#include "watched_progress.h"

namespace ostraka::pipeline {
namespace {

TEST_F(ProcessBatch, TurnsPhotographsIntoWholeSherdsWithTheirReports) {
  NeverBack progress;
  const Result<ProcessSummary> summary = process(folder_ / "out", 0, progress);
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->sherds.size(), 2u);
  EXPECT_TRUE(summary->whole());
  EXPECT_NEAR(progress.shares, 1, 0.01) << "the time left is what is missing to 1";
  for (const char* name : {"front.ply", "back.ply", "model.ply", "model.glb", "preview.png"})
    for (const char* number : {"01", "02"})
      EXPECT_TRUE(fs::exists(folder_ / "out" / "sherds" / number / name)) << number << ' ' << name;
  const Result<std::string> html = readFile(folder_ / "out" / "report.html");
  ASSERT_TRUE(html.has_value());
  EXPECT_TRUE(isSafeReport(*html));
  EXPECT_EQ(html->find("http", kReportHead.size()), std::string::npos) << "needs no network";
  const Result<nlohmann::json> report = readJson(folder_ / "out" / "report.json");
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->at("sherds").size(), 2u);
  const nlohmann::json record = *readJson(folder_ / "out" / "work" / "reports.json");
  for (const char* name : {"pairs.json", "report.html", "report.json"})
    EXPECT_EQ(record.at("files").at(name), sha256(*readFile(folder_ / "out" / name))) << name;
  // Sherds of the virtual rig have walls of 3 to 10 mm.
  for (const nlohmann::json& sherd : report->at("sherds")) {
    const double wall = sherd.at("figures").at("measures").at("thickness_mean_mm").get<double>();
    EXPECT_GT(wall, 2.5);
    EXPECT_LT(wall, 11.0);
    EXPECT_GT(sherd.at("figures").at("texture_seen_share").get<double>(), 0.95);  // of six stops
    const nlohmann::json& munsell = sherd.at("figures").at("munsell");
    EXPECT_EQ(sherd.at("figures").at("texture"), "photo");
    EXPECT_TRUE(munsell.at("chart").is_null());
    for (const char* part : {"out", "in", "core"})  // clay lies among the chips
      EXPECT_LT(munsell.at(part).at("ciede2000").get<double>(), 6) << munsell;
    EXPECT_TRUE(colour::parseMunsellProposals(munsell.dump())) << munsell;
    EXPECT_NE(munsell.at("out").at("side"), munsell.at("in").at("side"));
    EXPECT_EQ(nlohmann::json::parse(extrasInGlb(folder_ / "out" / "sherds" /
                                                sherd.at("number").get<std::string>() / "model.glb")
                                        .munsell),
              munsell);
  }
  EXPECT_NE(html->find("Rough: there is no usable colour chart"), std::string::npos);
  for (const char* number : {"01", "02"}) {
    const Result<std::string> glb = readFile(folder_ / "out" / "sherds" / number / "model.glb");
    EXPECT_NE(glb->find("baseColorTexture"), std::string::npos);
    EXPECT_NE(glb->find(R"("texture":"photo")"), std::string::npos);
  }
}

TEST_F(ProcessBatch, StoppedAndStartedAgainWithOtherThreadsLeavesTheSameBytes) {
  QuietProgress quiet;
  ASSERT_TRUE(process(folder_ / "out", 0, quiet).has_value());
  for (const char* stage : {"stereo of the back side", "models"}) {
    std::stop_source stop;
    StopsAt stopping(stage, stop);
    const auto stopped = process(folder_ / "again", 3, stopping, stop.get_token());
    ASSERT_FALSE(stopped.has_value());
    EXPECT_EQ(stopped.error().code, ErrorCode::Cancelled);
    EXPECT_FALSE(fs::exists(folder_ / "again" / "report.json"))
        << "half a result must not look whole";
  }
  ASSERT_TRUE(process(folder_ / "again", 1, quiet).has_value());
  EXPECT_EQ(results(folder_ / "again"), results(folder_ / "out"));
}

// Photographs with twice the pixels each way but nothing more to see: averaged down, they give what
// the small ones gave.
TEST_F(ProcessBatch, AveragesLargePhotographsDownForAllButTheCameras) {
  QuietProgress quiet;
  ASSERT_TRUE(process(folder_ / "out", 0, quiet).has_value());
  const fs::path large = folder_ / "large";
  fs::copy(folder_ / "batch", large, fs::copy_options::recursive);
  fs::remove_all(large / "truth");
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(large)) {
    if (!batch::hasPhotographEnding(entry.path())) continue;
    const cv::Mat small = *batch::readPhotograph(entry.path());
    cv::Mat twice;
    cv::resize(small, twice, {}, 2, 2, cv::INTER_CUBIC);
    ASSERT_TRUE(cv::imwrite(entry.path().string(), twice, {cv::IMWRITE_JPEG_QUALITY, 97}));
  }
  ProcessOptions options;
  options.batch = large;
  options.output = folder_ / "large_out";
  options.megapixels = 0.48;  // 800 x 600
  const Result<ProcessSummary> summary = processBatch(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->sherds.size(), 2u);
  EXPECT_TRUE(summary->whole());
  EXPECT_TRUE(summary->draft) << "averaged down, and to less than kDraftMegapixels";
  EXPECT_EQ(readJson(options.output / "report.json")->at("draft"), true);
  EXPECT_EQ(readJson(folder_ / "out" / "report.json")->at("draft"), false)
      << "small photographs, but all of their pixels";
  const cv::Mat mask = *batch::readMask(options.output / "work" / "masks_front" / "cam0_pos00.png");
  EXPECT_EQ(mask.size(), cv::Size(1600, 1200)) << "a mask is laid upon its photograph";
  const auto sizes = [](const fs::path& output) {
    std::vector<std::array<double, 3>> all;
    for (const nlohmann::json& sherd : readJson(output / "report.json")->at("sherds")) {
      const nlohmann::json& of = sherd.at("figures").at("measures");
      all.push_back({of.at("length_mm"), of.at("width_mm"), of.at("thickness_mean_mm")});
    }
    return all;
  };
  const auto expected = sizes(folder_ / "out"), found = sizes(options.output);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(found[i][k], expected[i][k], 0.5) << i << k;
}

TEST_F(ProcessBatch, WhatIsWrongWithOnePhotographOrMaskCostsThatPhotographAndIsNamed) {
  QuietProgress quiet;
  copyOfWhole("whole");
  const fs::path batch = folder_ / "damaged", masks = folder_ / "whole" / "work";
  fs::copy(folder_ / "batch", batch, fs::copy_options::recursive);
  for (const char* side : {"front", "back"})
    fs::copy(masks / (std::string("masks_") + side), batch / (std::string(side) + "_masks"));
  fs::remove(batch / "front" / "cam0_pos01.jpg");  // nobody took it
  cv::imwrite((batch / "front" / "cam1_pos03.jpg").string(), cv::Mat3b(300, 400));
  fs::remove(batch / "front_masks" / "cam1_pos05.png");
  cv::imwrite((batch / "front_masks" / "cam2_pos04.png").string(), cv::Mat1b(600, 800, uchar{0}));
  std::stop_source stop;
  StopsAt back("masks of the back side", stop);
  ProcessOptions options;
  options.batch = batch;
  options.output = folder_ / "damaged_out";
  options.masks = "given";
  const Result<ProcessSummary> stopped = processBatch(options, back, stop.get_token());
  ASSERT_FALSE(stopped.has_value());
  ASSERT_EQ(stopped.error().code, ErrorCode::Cancelled) << stopped.error().sentence();
  const Result<std::string> log = readFile(options.output / "log.txt");
  ASSERT_TRUE(log.has_value());
  for (const char* words :
       {"missing: cam0_pos01", "cam1_pos03.jpg: The image has 400 x 300",
        "cam1_pos05.jpg: This photograph has no mask", "cam2_pos04.jpg: The mask marks no sherd"})
    EXPECT_NE(log->find(words), std::string::npos) << words << " in " << *log;
  const auto points = [](const fs::path& output) {
    return readJson(output / "work" / "dense_front" / "stage.json")
        ->at("figures")
        .at("points")
        .get<double>();
  };
  // Four of 18 photographs see little that the others do not.
  EXPECT_GT(points(options.output), 0.75 * points(folder_ / "whole"));
}

TEST_F(ProcessBatch, DoesWhatAPersonDecidedAndOnlyWhatFollowsFromIt) {
  QuietProgress quiet;
  copyOfWhole("decided");
  const auto before = results(folder_ / "decided");
  const Result<decisions::CandidateTable> table =
      decisions::readCandidates(folder_ / "decided" / "work" / "pairs" / "candidates.json");
  ASSERT_TRUE(table.has_value()) << table.error().sentence();
  decisions::PairDecision swapped;
  swapped.kind = decisions::DecisionKind::Pair;
  swapped.by = "AP";
  const Result<nlohmann::json> pairs = readJson(folder_ / "decided" / "pairs.json");
  const bool straight = pairs->at("pairs").at(0).at("back") == table->backs[0].id;
  swapped.scans = {table->fronts[0], table->backs[straight ? 1 : 0]};
  const auto written = decisions::appendDecision(folder_ / "decided", swapped);
  ASSERT_TRUE(written.has_value()) << written.error().sentence();

  const Result<ProcessSummary> summary = process(folder_ / "decided", 1, quiet);
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_FALSE(summary->sherds.empty());
  EXPECT_EQ(summary->sherds[0].back, swapped.scans[1].id) << "a person's word, however it fits";
  EXPECT_EQ(summary->sherds[0].decided_by, "AP");
  EXPECT_FALSE(summary->sherds[0].ambiguous);
  for (const char* stage : {"rig", "dense_front", "dense_back", "scans_front", "pairs"})
    EXPECT_TRUE(fs::exists(folder_ / "decided" / "work" / stage / "stage.json")) << stage;
  const Result<std::string> log = readFile(folder_ / "decided" / "log.txt");
  EXPECT_NE(log->find("pairs: reused from an earlier run"), std::string::npos);

  decisions::PairDecision undo;
  undo.kind = decisions::DecisionKind::Withdraw;
  undo.by = "AP";
  undo.replaces = {written->id};
  ASSERT_TRUE(decisions::appendDecision(folder_ / "decided", undo).has_value());
  ASSERT_TRUE(process(folder_ / "decided", 1, quiet).has_value());
  EXPECT_EQ(results(folder_ / "decided"), before) << "withdrawn, all is as it was";
}

TEST_F(ProcessBatch, ComputesOnlyWhatFollowsFromAMendedMask) {
  QuietProgress quiet;
  copyOfWhole("painted");
  const fs::path out = folder_ / "painted";
  const auto before = results(out);
  const auto table = decisions::readCandidates(out / "work" / "pairs" / "candidates.json");
  ASSERT_TRUE(table.has_value()) << table.error().sentence();
  EXPECT_TRUE(table->supports[0] && table->supports[1]) << "a plate lay below both sides";
  const decisions::ScanRef& first = table->fronts.at(0);
  const auto images = rig::readCameras(out / "work" / "rig" / "cameras.json");
  ASSERT_TRUE(images.has_value()) << images.error().sentence();
  std::vector<decisions::MaskStroke> strokes;  // the middle of the first sherd is said to be plate
  for (const rig::PosedImage& image : *images) {
    if (image.side != batch::Side::Front) continue;
    decisions::MaskStroke stroke;
    stroke.camera = image.camera;
    stroke.stop = image.stop;
    stroke.paint = decisions::MaskPaint::Plate;
    stroke.radius_px = 14;
    stroke.path_px = {image.project({first.place_mm.x(), first.place_mm.y(), 5.0})};
    stroke.photograph = decisions::photographHash(batch::photographNow(image.file, out));
    strokes.push_back(stroke);
  }
  ASSERT_TRUE(decisions::writeMaskStrokes(out, strokes).has_value());
  EXPECT_EQ(decisions::maskFolder(out, batch::Side::Front), "masks_front")
      << "nothing is edited yet";
  EXPECT_TRUE(decisions::masksWantComputing(out));
  EXPECT_TRUE(review::wantsComputing(out));
  const auto points = [&](const std::string& number) {
    const auto scan = readPlyCloud(out / "sherds" / number / "front.ply");
    return scan ? static_cast<double>(scan->size()) : 0.0;
  };
  const double first_before = points("01"), second_before = points("02");
  ASSERT_TRUE(process(out, 1, quiet).has_value());
  EXPECT_FALSE(decisions::masksWantComputing(out));
  EXPECT_EQ(decisions::maskFolder(out, batch::Side::Front), "edited_front");
  EXPECT_EQ(decisions::maskFolder(out, batch::Side::Back), "masks_back");
  const std::string log = *readFile(out / "log.txt");
  const std::string last = log.substr(log.rfind("rig: reused from an earlier run"));
  for (const char* kept : {"masks_front", "masks_back", "dense_back", "scans_back"})
    EXPECT_NE(last.find(std::string(kept) + ": reused from an earlier run"), std::string::npos)
        << kept;
  EXPECT_EQ(last.find("dense_front: reused from an earlier run"), std::string::npos);
  // 14 pixels around its middle are gone from the first sherd; the second loses nothing.
  EXPECT_LT(points("01"), 0.95 * first_before);
  EXPECT_GT(points("02"), 0.98 * second_before);
  const auto masked = decisions::maskedPhotographs(out);
  ASSERT_TRUE(masked.has_value() && fs::exists(masked->front().photograph));
  EXPECT_EQ(masked->size(), images->size());

  for (decisions::MaskStroke& stroke : strokes) stroke.photograph = "of the one before";
  ASSERT_TRUE(decisions::writeMaskStrokes(out, strokes).has_value());
  ASSERT_TRUE(process(out, 1, quiet).has_value());
  EXPECT_EQ(points("01"), first_before) << "other sherds may lie there now";
  ASSERT_TRUE(decisions::writeMaskStrokes(out, {}).has_value());
  EXPECT_TRUE(decisions::masksWantComputing(out)) << "what is taken back is to be computed, too";
  ASSERT_TRUE(process(out, 1, quiet).has_value());
  EXPECT_EQ(results(out), before) << "taken back, all is as it was";
}

TEST_F(ProcessBatch, GoesOnWhereABatchWasStoppedAndThenMoved) {
  QuietProgress quiet;
  copyOfWhole("stopped");
  const auto before = results(folder_ / "stopped");
  const fs::path stage = folder_ / "stopped" / "work" / "masks_front";
  fs::remove(stage / "stage.json");
  ASSERT_TRUE(writeJson(stage / "begun.json", {{"stage", "masks_front"}}).has_value());
  fs::copy(folder_ / "batch", folder_ / "elsewhere", fs::copy_options::recursive);
  ProcessOptions options;
  options.batch = folder_ / "elsewhere";
  options.output = folder_ / "stopped";
  const Result<ProcessSummary> summary = processBatch(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  EXPECT_EQ(results(folder_ / "stopped"), before);
  const std::string log = *readFile(folder_ / "stopped" / "log.txt");
  EXPECT_NE(log.rfind("rig: reused from an earlier run"), std::string::npos);
}

TEST_F(ProcessBatch, SetAsideASherdIsNeitherMadeNorMissed) {
  QuietProgress quiet;
  copyOfWhole("aside");
  const Result<decisions::CandidateTable> table =
      decisions::readCandidates(folder_ / "aside" / "work" / "pairs" / "candidates.json");
  const Result<nlohmann::json> pairs = readJson(folder_ / "aside" / "pairs.json");
  decisions::PairDecision aside;
  aside.kind = decisions::DecisionKind::Aside;
  aside.by = "AP";
  aside.scans = {table->fronts[0]};
  for (const decisions::ScanRef& back : table->backs)
    if (back.id == pairs->at("pairs").at(0).at("back")) aside.scans.push_back(back);
  ASSERT_TRUE(decisions::appendDecision(folder_ / "aside", aside).has_value());
  const Result<ProcessSummary> summary = process(folder_ / "aside", 1, quiet);
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->sherds.size(), 1u);
  EXPECT_EQ(summary->sherds[0].number, "02") << "the other keeps its number";
  EXPECT_EQ(summary->set_aside.size(), 2u);
  EXPECT_TRUE(summary->whole());
  EXPECT_FALSE(fs::exists(folder_ / "aside" / "sherds" / "01"));
  EXPECT_TRUE(fs::exists(folder_ / "aside" / "sherds" / "02" / "model.ply"));
}

// A batch of four stops whose plate is said to be 1 % smaller, or as it is; and 160 mm of its true
// plate, each end marked to whole pixels on three photographs, as a person would.
void makeSaidSmaller(const fs::path& from, const fs::path& batch, double factor) {
  fs::copy(from, batch, fs::copy_options::recursive);
  for (const char* side : {"front", "back"})
    for (const char* camera : {"0", "1", "2"})
      for (const char* stop : {"1", "3", "5", "7"})
        fs::remove(batch / side / (std::string("cam") + camera + "_pos0" + stop + ".jpg"));
  nlohmann::ordered_json plate = *readJson(batch / "plate.json");
  for (auto& marker : plate.at("markers"))
    for (auto& corner : marker.at("corners"))
      for (auto& value : corner) value = factor * value.get<double>();
  ASSERT_TRUE(writeJson(batch / "plate.json", plate).has_value());
  const auto cameras = rig::readCameras(batch / "truth" / "cameras.json");
  ASSERT_TRUE(cameras.has_value()) << cameras.error().sentence();
  nlohmann::ordered_json ends = {nlohmann::ordered_json::array(), nlohmann::ordered_json::array()};
  for (const rig::PosedImage& image : *cameras) {
    if (image.side != batch::Side::Front || image.stop != 0) continue;
    for (const int e : {0, 1}) {
      const Eigen::Vector2d pixel = image.project({e == 0 ? -80.0 : 80.0, 0, 0});
      ends[e].push_back({{"file", fs::path(image.file).filename().string()},
                         {"pixel", {std::round(pixel.x()), std::round(pixel.y())}}});
    }
  }
  const nlohmann::ordered_json length = {{"side", "front"}, {"length", 160}, {"ends", ends}};
  const nlohmann::ordered_json scale = {{"unit", "mm"},
                                        {"lengths", nlohmann::ordered_json::array({length})}};
  ASSERT_TRUE(writeJson(batch / "scale.json", scale).has_value());
}

TEST_F(ProcessBatch, IsHeldWhenAMarkedLengthContradictsThePlate) {
  QuietProgress quiet;
  makeSaidSmaller(folder_ / "batch", folder_ / "smaller", 0.99);
  ProcessOptions options;
  options.batch = folder_ / "smaller";
  options.output = folder_ / "smaller_out";
  const Result<ProcessSummary> summary = processBatch(options, quiet, {});
  ASSERT_TRUE(summary.has_value()) << summary.error().sentence();
  ASSERT_EQ(summary->scale_doubts.size(), 1u);
  const std::string& doubt = summary->scale_doubts[0].english();
  EXPECT_NE(doubt.find("the length of 160.00 mm marked on the front side measures 158."),
            std::string::npos)
      << doubt;
  const Result<nlohmann::json> report = readJson(options.output / "report.json");
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->at("scale_doubts").at(0).at("text"), doubt);
  EXPECT_TRUE(report->at("scale").at("text").get<std::string>().ends_with("as in plate.json."))
      << report->at("scale");
  const nlohmann::json length = report->at("stages").at(0).at("figures").at("known_lengths").at(0);
  // 160 * 0.99 = 158.40; 0.48 mm a pixel, rounded, seen by three cameras: within 3 of its own sd.
  EXPECT_NEAR(length.at("found_mm").get<double>(), 158.4, 3 * length.at("sd_mm").get<double>());
  EXPECT_LT(length.at("sd_mm").get<double>(), 0.3);
  const std::string html = *readFile(options.output / "report.html");
  EXPECT_NE(html.find("Resolve this before you measure anything"), std::string::npos);
}

TEST_F(ProcessBatch, IsNotHeldByAMarkedLengthThatAgrees) {
  makeSaidSmaller(folder_ / "batch", folder_ / "true_plate", 1);
  std::stop_source stop;
  StopsAt front("masks of the front side", stop);
  ProcessOptions options;
  options.batch = folder_ / "true_plate";
  options.output = folder_ / "true_plate_out";
  ASSERT_FALSE(processBatch(options, front, stop.get_token()).has_value());
  const Result<nlohmann::json> cameras = readJson(options.output / "work" / "rig" / "stage.json");
  ASSERT_TRUE(cameras.has_value()) << cameras.error().sentence();
  EXPECT_TRUE(cameras->at("figures").at("scale_doubts").empty());
  EXPECT_EQ(cameras->at("figures").at("known_lengths").size(), 1u);
}

TEST_F(ProcessBatch, RefusesAFolderThatHoldsSomethingElse) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "mine" / "thesis.txt", "do not touch").has_value());
  QuietProgress quiet;
  const Result<ProcessSummary> refused = process(folder_ / "mine", 1, quiet);
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_EQ(*readFile(folder_ / "mine" / "thesis.txt"), "do not touch");
}

TEST_F(ProcessBatch, RefusesTheOutputOfAnotherBatch) {
  ASSERT_TRUE(writeFileAtomically(folder_ / "other" / "work" / "batch.json",
                                  R"({"front/cam0_pos00.jpg":"0"})")
                  .has_value());
  QuietProgress quiet;
  const Result<ProcessSummary> refused = process(folder_ / "other", 1, quiet);
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().what.english().find("another batch"), std::string::npos);
}

TEST_F(ProcessBatch, TheSamePlateAndCalibrationDoNotMakeItTheSameBatch) {
  // Four stops instead of eight: most of what is read is calibration.
  const fs::path batch = folder_ / "few_stops";
  fs::copy(folder_ / "batch", batch, fs::copy_options::recursive);
  nlohmann::ordered_json earlier;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(batch))
    if (entry.is_regular_file()) files.push_back(entry.path());
  for (const fs::path& file : files) {
    const std::string side = file.parent_path().filename(), stem = file.stem();
    const bool shot = side == "front" || side == "back";
    if (shot && stem.substr(stem.size() - 2) > "03")
      fs::remove(file);
    else
      earlier[fs::relative(file, batch).generic_string()] = shot ? "0" : sha256(*readFile(file));
  }
  ASSERT_TRUE(writeJson(folder_ / "same_rig" / "work" / "batch.json", earlier).has_value());
  ProcessOptions options;
  options.batch = batch;
  options.output = folder_ / "same_rig";
  QuietProgress quiet;
  const Result<ProcessSummary> refused = processBatch(options, quiet, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().what.english().find("another batch"), std::string::npos);
}

TEST_F(ProcessBatch, WritesNothingIntoTheBatchItself) {
  QuietProgress quiet;
  for (const fs::path& within : {folder_ / "batch", folder_ / "batch" / "front" / "out"}) {
    const Result<ProcessSummary> refused = process(within, 1, quiet);
    ASSERT_FALSE(refused.has_value());
    EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
    EXPECT_NE(refused.error().what.english().find("never writes"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(folder_ / "batch" / "front" / "out"));
}

TEST_F(ProcessBatch, NamesANetworkThatIsNotThereBeforeItBegins) {
  ProcessOptions options;
  options.batch = folder_ / "batch";
  options.output = folder_ / "no_network";
  options.masks = "absent.onnx";
  QuietProgress quiet;
  const Result<ProcessSummary> refused = processBatch(options, quiet, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_NE(refused.error().sentence().english().find("absent.onnx"), std::string::npos);
  EXPECT_FALSE(fs::exists(options.output));
}

TEST_F(ProcessBatch, NamesAMissingSide) {
  const fs::path half = folder_ / "half";
  fs::copy(folder_ / "batch", half, fs::copy_options::recursive);
  fs::remove_all(half / "back");
  ProcessOptions options;
  options.batch = half;
  options.output = folder_ / "half_out";
  QuietProgress quiet;
  const Result<ProcessSummary> refused = processBatch(options, quiet, {});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().code, ErrorCode::UnusableInput);
  EXPECT_NE(refused.error().sentence().english().find("back"), std::string::npos);
  EXPECT_FALSE(fs::exists(options.output)) << "an unusable batch leaves nothing behind";
}

}  // namespace
}  // namespace ostraka::pipeline
