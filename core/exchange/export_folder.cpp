#include "exchange/export_folder.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>

#include "archive/bagit.h"
#include "base/message.h"
#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "cloud/ply.h"
#include "exchange/drawn_sherds.h"
#include "exchange/export_plan.h"
#include "exchange/lighter_model.h"
#include "exchange/model_files.h"
#include "exchange/views_out.h"
#include "files/files.h"
#include "files/open_folder.h"
#include "images/png_image.h"
#include "metadata/metadata.h"
#include "metadata/sherd_json.h"
#include "model/volume_moment.h"
#include "records/records.h"
#include "records/sherd.h"
#include "records/words.h"
#include "store/database.h"
#include "store/values.h"
#include "texture/relief.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;
using store::valueOrThrow;

constexpr int kDrawingAsCopies = 20;  // for the progress: a drawing takes its time
constexpr int kViewAsCopies = 5;      // likewise a photograph without its lens
constexpr int kRowsAsCopy = 10;       // of a table: they take less than a file

// Rounded up: what is said holds.
double saidOf(double off_mm) {
  return std::ceil(1000 * off_mm) / 1000;
}

// What is left of the work, counted as part of the whole.
class Rest final : public Progress {
 public:
  Rest(Progress& whole, std::int64_t done, std::int64_t total)
      : whole_(whole), done_(done), total_(total) {}
  void report(std::int64_t done, std::int64_t total) override {
    whole_.report(done_ + (total_ - done_) * done / std::max<std::int64_t>(1, total), total_);
  }
  void note(NoteLevel level, const Message& text) override { whole_.note(level, text); }

 private:
  Progress& whole_;
  std::int64_t done_, total_;
};

class Exporting {
 public:
  Exporting(const Catalogue& catalogue, const fs::path& project, const ExportOptions& options,
            archive::BagWriter& bag, Progress& progress, std::stop_token stop)
      : catalogue_(catalogue),
        project_(project),
        options_(options),
        bag_(bag),
        progress_(progress),
        stop_(std::move(stop)) {}

  /// Within a snapshot: throws Refused.
  Exported run(const std::vector<records::SherdRecord>& sherds, const ExportPlan& plan,
               std::span<const store::SherdRow> rows) {
    const records::ProjectRecord project = valueOrThrow(Settings(catalogue_).project());
    total_ = workOf(plan, sherds.size());
    copy(sherds, plan, project.licence);
    draw(plan, project.title);
    views(plan);
    centres(sherds, plan.project());
    records(sherds, plan, rows);
    exported_.without_model = plan.withoutModel(sherds, with_model_);
    for (const metadata::MetadataFile& file :
         valueOrThrow(metadata::metadataOf(catalogue_, sherds, project, options_.program,
                                           {bag_.files(), exported_.without_model})))
      valueOrThrow(bag_.add(file.path, file.text));
    const auto read_again = [this](const fs::path& written) -> Result<void> {
      Rest rest(progress_, done_, total_);
      const auto whole = archive::checkBag(written, rest, stop_);
      return whole ? Result<void>() : whole.error();
    };
    valueOrThrow(
        bag_.finish(valueOrThrow(archive::bagInfo(catalogue_, options_.program)), read_again));
    exported_.sherds = static_cast<int>(sherds.size());
    exported_.files = static_cast<int>(bag_.files().size()) + kFilesOfTheBag;
    exported_.bytes = bag_.bytes();
    std::set_difference(options_.forms.begin(), options_.forms.end(), written_.begin(),
                        written_.end(),
                        std::inserter(exported_.without_file, exported_.without_file.end()));
    return exported_;
  }

 private:
  // As so many copies. All that is written is read again.
  std::int64_t workOf(const ExportPlan& plan, std::size_t sherds) const {
    const std::size_t drawn = plan.drawn().size(), viewed = plan.viewedPhotographs().size(),
                      described = options_.forms.contains(Form::Json) ? sherds : 0,
                      copies = plan.files().size() + described, read = copies + 2 * drawn + viewed;
    std::size_t work = copies + kDrawingAsCopies * drawn + kViewAsCopies * viewed + read;
    for (const Form table : {Form::Csv, Form::Ods})
      if (options_.forms.contains(table)) work += 1 + sherds / kRowsAsCopy;
    return static_cast<std::int64_t>(work);
  }

  void stopIfAsked() const {
    if (stop_.stop_requested()) throw store::Refused(Error::cancelled());
  }

  void copy(const std::vector<records::SherdRecord>& sherds, const ExportPlan& plan,
            const std::string& licence) {
    std::map<store::SherdRow, const records::SherdRecord*> by_row;
    std::map<store::BatchRow, std::string> scale_doubts;
    for (const records::SherdRecord& sherd : sherds) {
      by_row[sherd.row] = &sherd;
      if (!sherd.batch || scale_doubts.contains(sherd.batch)) continue;
      scale_doubts[sherd.batch] =
          linesOf(valueOrThrow(Batches(catalogue_).get(sherd.batch)).scale_doubts);
    }
    for (const PlannedFile& file : plan.files()) {
      stopIfAsked();
      progress_.report(done_++, total_);
      Result<OpenFile> open = plan.open(file);
      if (!open) {
        std::error_code code;
        const bool is_there =
            fs::symlink_status(file.from, code).type() != fs::file_type::not_found;
        exported_.warnings.push_back(
            is_there ? open.error().sentence()
                     : message("%1 is missing and was left out.", file.from.string()));
        continue;
      }
      const bool whole = file.form == Form::Photographs || file.form == Form::Drawings;
      const archive::BagFile added =
          whole ? valueOrThrow(bag_.addFile(file.to, std::move(*open), stop_))
                : addModel(file, std::move(*open), *by_row[file.sherd], licence,
                           scale_doubts[by_row[file.sherd]->batch]);
      written_.insert(file.form);
      if (isModel(file.form)) with_model_.insert(file.sherd);
      if (file.form == Form::Photographs && !file.sha256.empty() && added.sha256 != file.sha256)
        exported_.warnings.push_back(
            message("%1 differs from the recorded photograph; check it.", file.from.string()));
      if (file.sherd) name(file.sherd, file.role, file.to, added);
    }
  }

  archive::BagFile addModel(const PlannedFile& file, OpenFile open,
                            const records::SherdRecord& sherd, const std::string& licence,
                            const std::string& scale_doubts) {
    std::string bytes = valueOrThrow(open.readAll());
    if (!file.sha256.empty() && sha256(bytes) != file.sha256)
      store::refuse(differsFromEntered(sherd), file.from.string());
    ModelLabel label{sherd.id, sherd.number, licence, options_.program, scale_doubts};
    const TriangleMesh* light = nullptr;
    if (isMadeAnew(file, options_)) {
      const LighterModel& lighter = lightened(sherd, bytes, file.from.string());
      label.deviation_mm = saidOf(lighter.deviation_mm);
      label.farthest_mm = saidOf(lighter.farthest_mm);
      light = &lighter.mesh;
    }
    // A GLB that goes out as it is kept has its own.
    const texture::TexturedMesh* photographs =
        file.form != Form::Glb || light != nullptr ? photographsOf(sherd, light, file.to) : nullptr;
    if (photographs != nullptr && file.form == Form::Obj)
      return addTexturedObj(file, *photographs, label);
    if (photographs != nullptr && file.form == Form::Ply) {
      const TriangleMesh mesh =
          light != nullptr ? *light : valueOrThrow(parsePly(bytes, file.from.string())).mesh;
      const std::string picture = addPicture(file, *photographs);
      return valueOrThrow(
          bag_.add(file.to, valueOrThrow(labelledTexturedPly(mesh, *photographs, label, picture))));
    }
    if (file.form == Form::Glb && photographs != nullptr) {
      bytes = valueOrThrow(glbOf(*photographs, sherd, processedExtras(project_, sherd)));
    } else if (light != nullptr) {
      bytes = file.form == Form::Glb ? valueOrThrow(glbOf(*light, sherd))
                                     : formatPly(*light, "plate_front");
    } else if (file.form == Form::Glb && file.from.extension() == ".ply") {
      const PlyContents model = valueOrThrow(parsePly(bytes, file.from.string()));
      bytes = valueOrThrow(glbOf(model.mesh, sherd));
    }
    return valueOrThrow(
        bag_.add(file.to, valueOrThrow(labelled(file.form, bytes, label, file.from.string()))));
  }

  // On the mesh that is exported, once for all of the sherd's files; null where there are none.
  const texture::TexturedMesh* photographsOf(const records::SherdRecord& sherd,
                                             const TriangleMesh* light, const std::string& to) {
    if (photographs_of_ != sherd.row) {
      photographs_of_ = sherd.row;
      photographs_.reset();
      auto read = texturedModelOf(catalogue_, sherd, project_);
      std::optional<Error> why;
      if (!read) {
        why = read.error();
      } else if (*read && light == nullptr) {
        photographs_ = std::move(*read);
      } else if (*read) {
        auto made = retextured(*light, **read);
        if (made) {
          photographs_ = std::move(*made);
          if (options_.forms.contains(Form::Glb))
            photographs_->relief = texture::reliefOf(*photographs_, full_, 0);
          shrinkPhotographs(*photographs_, unlabelledBytes(options_));
        } else {
          why = made.error();
        }
      }
      if (why)
        exported_.warnings.push_back(
            message("%1 is exported without photographs: %2", to, why->sentence()));
    }
    return photographs_ ? &*photographs_ : nullptr;
  }

  // Comes back with the model when the export is read again.
  void addBeside(const PlannedFile& file, const char* ending, const std::string& bytes) {
    const std::string beside = fs::path(file.to).replace_extension(ending).string();
    const archive::BagFile added = valueOrThrow(bag_.add(beside, bytes));
    files_[file.sherd].push_back({file.role, beside, added.sha256, added.bytes});
  }

  // One for the sherd's PLY and OBJ; its name.
  std::string addPicture(const PlannedFile& file, const texture::TexturedMesh& model) {
    if (picture_of_ != file.sherd)
      addBeside(file, ".png", images::encodedPng(model.texture.picture));
    picture_of_ = file.sherd;
    return fs::path(file.to).stem().string() + ".png";
  }

  archive::BagFile addTexturedObj(const PlannedFile& file, const texture::TexturedMesh& model,
                                  const ModelLabel& label) {
    const TexturedObj made =
        valueOrThrow(labelledTexturedObj(model, label, fs::path(file.to).stem().string()));
    addBeside(file, ".mtl", made.mtl);
    addPicture(file, model);
    return valueOrThrow(bag_.add(file.to, made.obj));
  }

  // A sherd's files come one after the other: its lighter model is made once for all of them.
  const LighterModel& lightened(const records::SherdRecord& sherd, const std::string& ply,
                                const std::string& where) {
    if (lighter_of_ == sherd.row) return lighter_;
    lighter_of_ = sherd.row;
    full_ = valueOrThrow(parsePly(ply, where)).mesh;
    Result<LighterModel> made = lighterModel(full_, surfaceBytes(options_));
    if (made) return lighter_ = std::move(*made);
    exported_.warnings.push_back(
        message("%1 is exported in full detail: %2", where, made.error().sentence()));
    return lighter_ = LighterModel{full_};
  }

  void name(store::SherdRow sherd, const std::string& role, const std::string& to,
            const archive::BagFile& added) {
    files_[sherd].push_back({role, to, added.sha256, added.bytes});
    auto& named = named_[sherd];
    if (role == "model") named.try_emplace("model_file", to);
    if (role == "preview") named["image_file"] = to;
    if (role == "drawing") named["drawing_file"] = to;
  }

  void draw(const ExportPlan& plan, const std::string& title) {
    for (const Message& why : plan.notDrawn())
      exported_.warnings.push_back(message("Not drawn: %1", why));
    for (const records::SherdRecord* sherd : plan.drawn()) {
      stopIfAsked();
      progress_.report(done_, total_);
      done_ += kDrawingAsCopies;
      const Result<DrawnSheets> drawn =
          sheetsOf(catalogue_, *sherd, plan.project(), options_, title);
      if (!drawn) {
        exported_.warnings.push_back(message("Not drawn: %1", drawn.error().sentence()));
        continue;
      }
      for (const Message& remark : drawn->remarks)
        exported_.warnings.push_back(
            message("Check the drawing of %1: %2", plan.nameOf(*sherd), remark));
      const std::vector<Page>& pages = drawn->pages;
      const std::string to = "drawings/" + plan.nameOf(*sherd);
      for (const auto& [path, bytes] :
           {std::pair(to + ".svg", formatSvg(pages.front(), sherd->number)),
            std::pair(to + ".pdf", formatPdf(pages, sherd->number))}) {
        const archive::BagFile added = valueOrThrow(bag_.add(path, bytes));
        written_.insert(Form::Drawings);
        name(sherd->row, "drawing", path, added);
      }
    }
  }

  void views(const ExportPlan& plan) {
    const auto batches = plan.viewed();
    const fs::path scratch = archive::folderNamed(options_.target).string() + ".views";
    for (const auto& [row, number] : batches) {
      progress_.report(done_, total_);
      done_ += kViewAsCopies *
               static_cast<std::int64_t>(plan.viewedPhotographs().size() / batches.size());
      const Result<void> added = addViews(bag_, plan.project(), number, scratch, stop_);
      if (added) {
        written_.insert(Form::Views);
        continue;
      }
      if (added.error().code != ErrorCode::UnusableInput &&
          added.error().code != ErrorCode::NotEnough)
        throw store::Refused(added.error());
      exported_.warnings.push_back(
          message("No pictures with masks and poses of %1: %2", number, added.error().sentence()));
    }
  }

  // Of the models that go along; to read all others for a table would take hours.
  void centres(const std::vector<records::SherdRecord>& sherds, const fs::path& project) {
    if (!options_.forms.contains(Form::Csv) && !options_.forms.contains(Form::Ods)) return;
    for (const records::SherdRecord& sherd : sherds) {
      if (!with_model_.contains(sherd.row)) continue;
      stopIfAsked();
      const Result<PlyContents> model = modelOf(sherd, project);
      if (!model) continue;  // a GLB alone
      const Eigen::Vector3d centre = model::volumeMoment(model->mesh).centre;
      for (int axis = 0; axis < 3; ++axis)
        named_[sherd.row][std::string("mass_centre_") + "xyz"[axis] + "_mm"] =
            store::numberText(std::round(100 * centre[axis]) / 100);
    }
  }

  void tables(const std::vector<records::SherdRecord>& sherds,
              std::span<const store::SherdRow> rows) {
    const std::set<store::ContextRow> contexts = metadata::contextsOf(catalogue_, sherds);
    const std::vector<store::ContextRow> list(contexts.begin(), contexts.end());
    const auto count = [&] {
      stopIfAsked();
      progress_.report(done_, total_);
      done_ += static_cast<std::int64_t>(1 + sherds.size() / kRowsAsCopy);
    };
    const auto put = [&](const char* name, Result<std::string> bytes) {
      valueOrThrow(bag_.add(name, valueOrThrow(std::move(bytes))));
    };
    if (options_.forms.contains(Form::Csv)) {
      count();
      constexpr ByteOrderMark with_mark = ByteOrderMark::With;
      put("sherds.csv", sherdsCsv(catalogue_, rows, with_mark, named_));
      put("contexts.csv", contextsCsv(catalogue_, list, with_mark));
      put("columns.csv", columnsCsv(with_mark));
    }
    if (options_.forms.contains(Form::Ods)) {
      count();
      put("sherds.ods", tablesOds(catalogue_, rows, list, named_, options_.words));
    }
  }

  void records(const std::vector<records::SherdRecord>& sherds, const ExportPlan& plan,
               std::span<const store::SherdRow> rows) {
    tables(sherds, rows);
    if (!options_.forms.contains(Form::Json)) return;
    for (const records::SherdRecord& sherd : sherds) {
      stopIfAsked();
      progress_.report(done_++, total_);
      const std::string text =
          valueOrThrow(metadata::sherdJson(catalogue_, sherd, files_[sherd.row],
                                           processedExtras(project_, sherd), options_.program));
      valueOrThrow(bag_.add("sherds/" + plan.nameOf(sherd) + ".json", text));
    }
  }

  const Catalogue& catalogue_;
  const fs::path& project_;
  const ExportOptions& options_;
  archive::BagWriter& bag_;
  Progress& progress_;
  std::stop_token stop_;
  Exported exported_;
  std::set<Form> written_ = {Form::Csv, Form::Json, Form::Ods};  ///< tables have all sherds
  std::set<store::SherdRow> with_model_;
  std::int64_t done_ = 0, total_ = 0;
  store::SherdRow lighter_of_, photographs_of_, picture_of_;
  std::optional<texture::TexturedMesh> photographs_;
  TriangleMesh full_;  // what lighter_ was made from
  LighterModel lighter_;
  std::map<store::SherdRow, std::vector<metadata::SherdFile>> files_;
  FilesOfSherds named_;
};

}  // namespace

Result<Exported> exportFolder(const Catalogue& catalogue, const fs::path& project,
                              std::span<const store::SherdRow> rows, const ExportOptions& options,
                              Progress& progress, std::stop_token stop) {
  if (rows.empty()) return Error::unusable(message("No sherds to export; select some first."));
  // Tables, records and names of files agree, whatever is edited meanwhile.
  return catalogue.database().inSnapshot([&] {
    ExportPlan plan(catalogue, project, options);
    const auto sherds = readAll(catalogue, rows, plan, stop);
    archive::BagWriter bag = valueOrThrow(archive::BagWriter::begin(options.target));
    return Exporting(catalogue, project, options, bag, progress, stop).run(sherds, plan, rows);
  });
}

}  // namespace ostraka::exchange
