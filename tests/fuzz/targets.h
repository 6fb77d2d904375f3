#pragma once
#include <span>
#include <string_view>

namespace ostraka::fuzz {

/// Hands foreign bytes to readers and aborts when one of their promises is broken. Its corpus is
/// the folder of its name in corpus/.
struct Target {
  std::string_view name;
  void (*run)(std::string_view bytes);
};

/// All targets, by name.
std::span<const Target> targets();

void ply(std::string_view bytes);
void json(std::string_view bytes);
void image(std::string_view bytes);
/// RIG.json: cameras, devices and the dialect of a turntable.
void rigFile(std::string_view bytes);
/// The fields of a network's file that decide how a photograph is fed to it.
void onnxHeader(std::string_view bytes);
/// GLB, PLY and OBJ models whose label is renewed for an export.
void modelLabel(std::string_view bytes);
/// Values of a table, separated by tabs and lines, written as a spreadsheet.
void spreadsheet(std::string_view bytes);
/// Texts of QR codes.
void labelCode(std::string_view bytes);
/// Replies of a turntable, to all drivers.
void deviceReplies(std::string_view bytes);
void table(std::string_view bytes);
void sherdJson(std::string_view bytes);
/// manifest.json of a batch folder.
void batchManifest(std::string_view bytes);
/// decisions.json, through to the pairs that follow from it.
void decisions(std::string_view bytes);
/// Candidates, mask strokes and reports of an output folder.
void outputFolder(std::string_view bytes);
/// A whole export, imported into a project; foreign_folder.h describes the bytes.
void exportFolder(std::string_view bytes);
/// An archive of a whole project, restored; foreign_folder.h describes the bytes.
void archive(std::string_view bytes);

}  // namespace ostraka::fuzz
