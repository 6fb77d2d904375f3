#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "command.h"
#include "files/output_place.h"
#include "options.h"
#include "rig/plate_print.h"
#include "rig/printed_sheet.h"
#include "shown.h"

namespace ostraka::app {
namespace {

using rig::PlatePrint;
using rig::PlatePrintOptions;

enum class PaperChoice { A4, A3, Whole };

int runPlate(PlatePrintOptions options, PaperChoice paper, const std::filesystem::path& output,
             const Session& session) {
  if (const Result<void> good = checkOutputFile(output, {".pdf"}); !good)
    return fail(session, good.error());
  options.paper.reset();
  if (paper != PaperChoice::Whole) options.paper = paper == PaperChoice::A4 ? Paper::A4 : Paper::A3;
  const Result<PlatePrint> print = rig::writePlatePrint(output, options);
  if (!print) return fail(session, print.error());
  nlohmann::ordered_json json = {{"output", output.string()},
                                 {"markers", print->plate.markers.size()},
                                 {"sheets", print->centres.size()},
                                 {"markers_on_seams", print->markers_cut},
                                 {"ruler_mm", print->ruler_mm}};
  return finish(session, Whole, std::move(json), [&] {
    show(stdout, "%s: the plate on %zu sheet%s, the board on the last page.\n", output.c_str(),
         print->centres.size(), print->centres.size() == 1 ? "" : "s");
    show(stdout, "plate.json and board.json beside it describe them%s.\n",
         options.ruler_measured_mm == 0 ? " as drawn" : " as measured");
    if (print->markers_cut > 0)
      show(stdout,
           print->markers_cut == 1 ? "%d marker is on a seam; glue it with care.\n"
                                   : "%d markers are on a seam; glue those with care.\n",
           print->markers_cut);
    if (options.ruler_measured_mm == 0)
      show(stdout,
           "Print at 100 %% (not 'fit to page'), glue the sheets, and measure both rulers: %.0f "
           "mm.\n"
           "If they measure otherwise, run this again with --ruler-measured and the length.\n",
           print->ruler_mm);
  });
}

int runSheet(const rig::SheetPrintOptions& options, const std::filesystem::path& output,
             const Session& session) {
  if (const Result<void> good = checkOutputFile(output, {".pdf"}); !good)
    return fail(session, good.error());
  const Result<rig::SheetPrint> print = rig::writeSheetPrint(output, options);
  if (!print) return fail(session, print.error());
  nlohmann::ordered_json json = {{"output", output.string()},
                                 {"markers", print->plate.markers.size()},
                                 {"sheets", 1},
                                 {"markers_on_seams", 0},
                                 {"ruler_mm", print->bar_mm}};
  return finish(session, Whole, std::move(json), [&] {
    show(stdout, "%s: the sheet, and a bar of %.0f mm on its second page.\n", output.c_str(),
         print->bar_mm);
    show(stdout, "plate.json beside it describes the sheet%s.\n",
         options.bar_measured_mm == 0 ? " as drawn" : " as measured");
    if (options.bar_measured_mm == 0)
      show(stdout,
           "Print at 100 %% (not 'fit to page') and measure the bar. If it measures otherwise, run "
           "this again with --ruler-measured and the length.\n");
  });
}

int runChosen(const PlatePrintOptions& options, PaperChoice paper,
              const std::optional<rig::SheetSize>& sheet, const std::filesystem::path& output,
              const Session& session) {
  return sheet ? runSheet({*sheet, options.ruler_measured_mm}, output, session)
               : runPlate(options, paper, output, session);
}

}  // namespace

void addPlate(CLI::App& root, Command& chosen) {
  CLI::App* command = root.add_subcommand("plate",
                                          "Marker plate with calibration board, or sheet for "
                                          "photographs by hand, to be printed in true "
                                          "scale (PDF)");
  auto options = std::make_shared<PlatePrintOptions>();
  auto paper = std::make_shared<PaperChoice>(PaperChoice::A3);
  auto sheet = std::make_shared<std::optional<rig::SheetSize>>();
  auto output = std::make_shared<std::filesystem::path>();
  command
      ->add_option("--output,-o", *output,
                   "PDF to write; plate.json and board.json are written beside it")
      ->required();
  CLI::Option* by_hand = addChoice(
      *command, "--sheet", *sheet,
      {{"a4", rig::SheetSize::A4}, {"a3", rig::SheetSize::A3}, {"letter", rig::SheetSize::Letter}},
      "",
      "a4, a3 or letter: the sheet under sherds that are photographed by hand, in "
      "place of a turntable's plate");
  command->add_option("--diameter", options->diameter_mm, "Of the turntable's plate, mm")
      ->capture_default_str();
  addChoice(*command, "--paper", *paper,
            {{"a4", PaperChoice::A4}, {"a3", PaperChoice::A3}, {"whole", PaperChoice::Whole}}, "a3",
            "a4 or a3: sheets that are glued together; whole: one page for a plotter");
  command->add_option("--marker", options->marker_mm, "Side of the markers, mm")
      ->capture_default_str();
  command->add_option("--dictionary", options->dictionary, "Of the plate's markers, OpenCV's name")
      ->capture_default_str();
  addChoice(*command, "--ground", options->ground,
            {{"white", rig::Ground::White}, {"black", rig::Ground::Black}}, "white",
            "Between the markers: white, or black where no cloth is laid");
  command->add_option("--margin", options->printer_margin_mm, "What the printer leaves white, mm")
      ->capture_default_str();
  command->add_option("--ruler-measured", options->ruler_measured_mm,
                      "What the ruler or bar measures on paper, mm: the files follow it");
  for (const char* name :
       {"--diameter", "--paper", "--marker", "--dictionary", "--ground", "--margin"})
    by_hand->excludes(command->get_option(name));
  workOf(*command, chosen, runChosen, options, paper, sheet, output);
}

}  // namespace ostraka::app
