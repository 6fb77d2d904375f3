#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pipeline/chain.h"

namespace ostraka::pipeline {

/// A stage's name and what it left behind.
struct ReportStage {
  std::string name;
  stages::StageRecord record;
};

/// One sherd of the report: its pair and what the model stage found.
struct ReportSherd {
  std::string number;
  const DecidedPair* pair = nullptr;
  const scan::Scan* front = nullptr;
  const scan::Scan* back = nullptr;
  nlohmann::ordered_json figures;  ///< of the model stage; "model": false when there is none
  std::filesystem::path preview;   ///< preview.png; may be absent
};

/// Everything that the two reports are written from.
struct ReportInput {
  std::string batch_name;
  batch::Way way = batch::Way::Rig;
  Message one_side;  ///< a sentence where the other side was not photographed
  std::vector<ReportStage> stages;
  std::vector<ReportSherd> sherds;
  std::vector<std::string> unpaired_front, unpaired_back, set_aside, reshoot;
  std::vector<Message> warnings;
  Message scale;                       ///< what makes it: checks::scaleSource
  std::vector<Message> scale_doubts;   ///< while there is one a person must decide
  bool draft = false;                  ///< ProcessSummary::draft
  std::vector<std::string> decisions;  ///< ids of those that were followed
  const Poses* poses = nullptr;
  const Masks* front_masks = nullptr;
  const Masks* back_masks = nullptr;
};

/// report.json: figures per stage and sherd. Seconds and memory are the only values that differ
/// between two runs on the same input.
nlohmann::ordered_json reportJson(const ReportInput& input);

/// report.html: one file, readable without a network: pictures with numbered outlines, contours
/// laid over each other, descriptor plots, the pair table with reasons, coverage, warnings in
/// words.
std::string reportHtml(const ReportInput& input);

}  // namespace ostraka::pipeline
