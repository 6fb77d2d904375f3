#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "files/output_place.h"
#include "options.h"
#include "rig/plate_print.h"
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

}  // namespace

void addPlate(CLI::App& root, Command& chosen) {
  CLI::App* command = root.add_subcommand(
      "plate", "Marker plate and calibration board to be printed in true scale (PDF)");
  auto options = std::make_shared<PlatePrintOptions>();
  auto paper = std::make_shared<PaperChoice>(PaperChoice::A3);
  auto output = std::make_shared<std::filesystem::path>();
  command
      ->add_option("--output,-o", *output,
                   "PDF to write; plate.json and board.json are written beside it")
      ->required();
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
                      "What the plate's ruler measures on paper, mm: the files follow it");
  workOf(*command, chosen, runPlate, options, paper, output);
}

}  // namespace ostraka::app
