#include <cmath>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cloud/ply.h"
#include "command.h"
#include "drawing/drawing.h"
#include "drawing/drawing_files.h"
#include "options.h"
#include "shown.h"
#include "texture/texture.h"

namespace ostraka::app {
namespace {

namespace fs = std::filesystem;
using namespace ostraka::drawing;
using nlohmann::ordered_json;

struct DrawArguments {
  std::vector<fs::path> models;
  std::vector<std::string> ids;
  fs::path output;
  DrawingOptions drawing;
  SheetOptions sheets;
};

// OUT/sherds/07/model.ply is sherd 07; other files are named after themselves.
std::string idOf(const fs::path& model) {
  return model.stem() == "model" && model.has_parent_path()
             ? fs::absolute(model).parent_path().filename().string()
             : model.stem().string();
}

ordered_json asJson(const SherdDrawing& drawing) {
  ordered_json rim;
  if (drawing.rim) {
    const RimEstimate& r = *drawing.rim;
    const auto where_known = [&r](double x) {
      return r.saysDiameter() ? ordered_json(x) : ordered_json();
    };
    rim = {{"probability", r.probability},
           {"diameter_mm", where_known(r.diameter_mm)},
           {"low_mm", r.low_mm},
           {"high_mm", std::isfinite(r.high_mm) ? ordered_json(r.high_mm) : ordered_json()},
           {"kept_pct", where_known(100 * r.kept)},
           {"kept_low_pct", where_known(100 * r.kept_low)},
           {"kept_high_pct", where_known(100 * r.kept_high)}};
  }
  return {{"id", drawing.id},
          {"drawn_as_rim", drawing.drawn_as_rim},
          {"rim", rim},
          {"remarks", drawing.remarks},
          {"hints", drawing.hints}};
}

void print(const SherdDrawing& drawing) {
  if (drawing.drawn_as_rim && drawing.mouth)
    show(stdout, "%s: rim diameter %.1f mm (95 %%: %.1f to %.1f), %.0f %% of the rim preserved.\n",
         drawing.id.english().c_str(), drawing.rim->diameter_mm, drawing.rim->low_mm,
         drawing.rim->high_mm, 100 * drawing.rim->kept);
  for (const auto* sentences : {&drawing.remarks, &drawing.hints})
    for (const Message& sentence : *sentences)
      show(stdout, "%s: %s\n", drawing.id.english().c_str(), sentence.english().c_str());
}

int runDraw(const DrawArguments& arguments, Session& session) {
  if (!arguments.ids.empty() && arguments.ids.size() != arguments.models.size())
    return fail(session, {ErrorCode::UnusableInput,
                          "Give one --id for each model, in the same order, or none.",
                          {}});
  const Result<DrawnAs> as = drawnAs(arguments.output, arguments.models);
  if (!as) return fail(session, as.error());
  if (*as == DrawnAs::Pictures && arguments.sheets.layout == SheetOptions::Layout::Plates)
    return fail(session,
                {ErrorCode::UnusableInput, "Plates are sheets; write them to FILE.pdf or FILE.svg.",
                 arguments.output.string()});
  std::vector<SherdDrawing> drawings;
  std::vector<std::string> pictures;
  ordered_json list = ordered_json::array();
  session.progress.begin("drawings", 1.0);
  for (std::size_t i = 0; i < arguments.models.size(); ++i) {
    if (session.stop.stop_requested()) return fail(session, Error::cancelled());
    session.progress.report(static_cast<std::int64_t>(i),
                            static_cast<std::int64_t>(arguments.models.size()));
    const Result<PlyContents> model = readPly(arguments.models[i]);
    if (!model) return fail(session, model.error());
    const std::string id = arguments.ids.empty() ? idOf(arguments.models[i]) : arguments.ids[i];
    drawing::DrawingOptions how = arguments.drawing;
    const auto photographs = how.surface == Surface::Relief
                                 ? std::optional<texture::TexturedMesh>()
                                 : texture::openedBeside(arguments.models[i], model->mesh);
    if (!photographs)
      how.remarks.push_back(
          Message("Drawn without its photographs: %1", {photographs.error().what}));
    else if (*photographs)
      how.photographs = &**photographs;
    Result<SherdDrawing> drawing = drawSherd(model->mesh, id, how);
    if (!drawing) return fail(session, drawing.error());
    if (*as == DrawnAs::Pictures)
      pictures.push_back(formatPicture(pictureOf(model->mesh, *drawing, how), arguments.output));
    list.push_back(asJson(*drawing));
    drawings.push_back(std::move(*drawing));
  }
  const Result<std::vector<fs::path>> files =
      *as == DrawnAs::Pictures
          ? writePictures(arguments.output, pictures)
          : writeSheets(arguments.output,
                        layOut(drawings, arguments.drawing.scale, arguments.sheets));
  if (!files) return fail(session, files.error());
  ordered_json names = ordered_json::array();
  for (const fs::path& file : *files) names.push_back(file.string());
  return finish(session, Whole, {{"files", names}, {"sherds", list}}, [&] {
    for (const SherdDrawing& drawing : drawings) print(drawing);
    for (const fs::path& file : *files) show(stdout, "Drawn: %s\n", file.c_str());
  });
}

}  // namespace

void addSurface(CLI::App& command, Surface& surface, Dpi& dpi) {
  addChoice(command, "--surface", surface,
            {{"shaded", Surface::Relief},
             {"paint", Surface::Painted},
             {"orthophoto", Surface::Orthophoto}},
            "shaded",
            "Views in drawings: the relief shaded; with paint and slip by their "
            "brightness; or an orthophoto, the photographs in parallel projection");
  addChoice(command, "--dpi", dpi, {{"300", Dpi::Usual}, {"600", Dpi::Fine}}, "300",
            "Resolution of these views on paper: 300 or 600");
}

void addDraw(CLI::App& root, Command& chosen) {
  CLI::App* command = root.add_subcommand(
      "draw", "Archaeological drawings of models: section, views, scale, rim diameter");
  auto a = std::make_shared<DrawArguments>();
  command->add_option("MODEL.ply", a->models, "Closed models, as OUT/sherds/01/model.ply")
      ->required();
  command
      ->add_option(
          "--output,-o", a->output,
          "FILE.pdf (all sheets), FILE.svg (a file each), FILE.png or FILE.tif (the views alone, a "
          "file for each sherd, with its resolution)")
      ->required();
  addChoice(*command, "--scale", a->drawing.scale,
            {{"1:1", 1.0}, {"1:2", 0.5}, {"1:3", 1.0 / 3}, {"2:1", 2.0}}, "1:1",
            "Size on paper to that of the sherd");
  command->add_flag_callback(
      "--rim", [a] { a->drawing.rim = RimChoice::Yes; }, "These are rim sherds, I am sure");
  command->add_flag_callback(
      "--no-rim", [a] { a->drawing.rim = RimChoice::No; }, "These are no rim sherds, I am sure");
  addSurface(*command, a->drawing.surface, a->drawing.dpi);
  command->add_flag_callback(
      "--plates", [a] { a->sheets.layout = SheetOptions::Layout::Plates; },
      "Many sherds on a sheet instead of one each");
  addChoice(*command, "--paper", a->sheets.paper, {{"a4", Paper::A4}, {"a3", Paper::A3}}, "a4",
            "a4 or a3; what is larger gets what it needs");
  command->add_option("--id", a->ids, "Name of each sherd, in the order of the models");
  command->add_option("--title", a->sheets.title, "At the foot of each sheet");
  workOf(*command, chosen, runDraw, a);
}

}  // namespace ostraka::app
