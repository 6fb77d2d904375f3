#include <algorithm>
#include <optional>

#include "catalogue/settings.h"
#include "cloud/ply.h"
#include "exchange/drawn_sherds.h"
#include "exchange/export_plan.h"
#include "exchange/lighter_model.h"
#include "exchange/views_out.h"
#include "images/png_image.h"
#include "metadata/metadata.h"
#include "metadata/sherd_json.h"
#include "records/sherd.h"
#include "store/database.h"
#include "texture/relief.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;
using namespace catalogue;
using store::valueOrThrow;

constexpr std::size_t kRecordsRead = 16;
constexpr std::size_t kChecksum = 64;  // letters of one

std::int64_t bytesOf(const fs::path& file) {
  std::error_code code;
  const std::uintmax_t bytes = fs::file_size(file, code);
  return code ? 0 : static_cast<std::int64_t>(bytes);
}

// The middle one, by what `size` says.
template <class List, class Size>
const auto* middleOf(const List& list, Size size) {
  std::vector<const typename List::value_type*> order;
  for (const auto& one : list) order.push_back(&one);
  if (order.empty()) return static_cast<const typename List::value_type*>(nullptr);
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  std::nth_element(order.begin(), middle, order.end(),
                   [&](const auto* a, const auto* b) { return size(*a) < size(*b); });
  return *middle;
}

class Sizing {
 public:
  Sizing(const Catalogue& catalogue, const ExportPlan& plan, const ExportOptions& options,
         const std::vector<records::SherdRecord>& sherds, std::stop_token stop)
      : catalogue_(catalogue),
        plan_(plan),
        options_(options),
        sherds_(sherds),
        stop_(std::move(stop)) {}

  /// Throws Refused.
  ExportSize run() {
    size_.sherds = static_cast<int>(sherds_.size());
    for (const auto step :
         {&Sizing::copies, &Sizing::drawings, &Sizing::records, &Sizing::metadata}) {
      stopIfAsked();
      (this->*step)();
    }
    size_.files += static_cast<int>(files_.size()) + kFilesOfTheBag;
    return size_;
  }

 private:
  void stopIfAsked() const {
    if (stop_.stop_requested()) throw store::Refused(Error::cancelled());
  }

  void add(const std::string& to, std::int64_t bytes, store::SherdRow sherd = {},
           const std::string& role = {}) {
    files_.push_back({"data/" + to, std::string(kChecksum, '0'), bytes});
    size_.bytes += bytes;
    if (sherd) of_sherds_[sherd].push_back({role, to, files_.back().sha256, bytes});
  }

  // Copies that stay as they are; models that are made anew are measured on one of them.
  void copies() {
    const auto made = [](const PlannedFile& file) {
      return isModel(file.form) && file.from.extension() == ".ply";
    };
    std::vector<PlannedFile> models;
    std::set<store::SherdRow> lightened, with_model;
    for (const PlannedFile& file : plan_.files()) {
      stopIfAsked();
      if (!plan_.open(file)) continue;  // is left out
      if (made(file))
        models.push_back(file);
      else
        add(file.to, bytesOf(file.from), file.sherd, file.role);
      if (isModel(file.form)) with_model.insert(file.sherd);
      if (isMadeAnew(file, options_)) lightened.insert(file.sherd);
    }
    size_.lightened = static_cast<int>(lightened.size());
    size_.without_model = plan_.withoutModel(sherds_, with_model);
    const auto* middle =
        middleOf(models, [](const PlannedFile& file) { return bytesOf(file.from); });
    const Shares shares = middle == nullptr ? Shares() : sharesOf(*middle);
    std::set<store::SherdRow> pictured;
    for (const PlannedFile& file : models) {
      // What is made smaller comes to about the same, whatever it was.
      const auto bytes =
          static_cast<double>(bytesOf(isMadeAnew(file, options_) ? middle->from : file.from));
      const auto addAs = [&](const char* ending, double share) {
        add(fs::path(file.to).replace_extension(ending).string(),
            static_cast<std::int64_t>(bytes * share), file.sherd, file.role);
      };
      const std::string ending = fs::path(file.to).extension().string();
      const auto share = shares.find(ending);
      addAs(ending.c_str(), share == shares.end() ? 1 : share->second);
      const auto addBeside = [&](const char* beside) {
        if (const auto of = shares.find(beside); of != shares.end()) addAs(beside, of->second);
      };
      if (file.form == Form::Obj) addBeside(".mtl");
      if (file.form != Form::Glb && pictured.insert(file.sherd).second) addBeside(".png");
    }
    for (const auto& [batch, number] : plan_.viewed()) {
      stopIfAsked();
      const Result<ViewsSize> views = sizeOfViews(plan_.project(), number);
      if (!views) continue;  // as the export will say
      size_.files += views->files;
      size_.bytes += views->bytes;
    }
  }

  // By a file's ending, of its PLY's bytes; nothing where it cannot be read, as the export will
  // say.
  using Shares = std::map<std::string, double>;
  Shares sharesOf(const PlannedFile& file) const {
    Result<OpenFile> open = plan_.open(file);
    if (!open) return {};
    const Result<std::string> bytes = open->readAll();
    if (!bytes) return {};
    const fs::path& ply = file.from;
    const Result<PlyContents> read = parsePly(*bytes, ply.string());
    if (!read) return {};
    const auto of = static_cast<double>(std::max<std::size_t>(1, bytes->size()));
    std::optional<LighterModel> lighter;
    if (isMadeAnew(file, options_))
      if (Result<LighterModel> made = lighterModel(read->mesh, surfaceBytes(options_)))
        lighter = std::move(*made);
    const std::string plain = lighter ? formatPly(lighter->mesh, "plate_front") : *bytes;
    const std::optional<texture::TexturedMesh> textured =
        texturedOf(file.sherd, lighter ? &lighter->mesh : nullptr, read->mesh);
    Shares shares{{".ply", static_cast<double>(plain.size()) / of}};
    const auto share = [&](const char* ending, std::size_t size) {
      shares[ending] = static_cast<double>(size) / of;
    };
    // As long as a real one.
    ModelLabel label{std::string(36, '0'), std::string(16, '0'), {}, options_.program, {}};
    if (lighter) label.deviation_mm = label.farthest_mm = lighter->deviation_mm;
    const bool with_ply = options_.forms.contains(Form::Ply),
               with_obj = options_.forms.contains(Form::Obj);
    if (textured && (with_ply || with_obj))
      share(".png", images::encodedPng(textured->texture.picture).size());
    if (textured && with_ply)
      if (const auto made = labelledTexturedPly(lighter ? lighter->mesh : read->mesh, *textured,
                                                label, "model.png"))
        share(".ply", made->size());
    if (with_obj && textured) {
      if (const auto made = labelledTexturedObj(*textured, label, "model")) {
        share(".obj", made->obj.size());
        share(".mtl", made->mtl.size());
      }
    } else if (with_obj) {
      if (const auto obj = labelled(Form::Obj, plain, {}, ply.string())) share(".obj", obj->size());
    }
    if (options_.forms.contains(Form::Glb))
      if (const auto glb = lighter && textured ? glbOf(*textured, {}, {})
                                               : glbOf(lighter ? lighter->mesh : read->mesh, {}))
        share(".glb", glb->size());
    return shares;
  }

  // On the mesh that will be exported; nothing where there are none.
  std::optional<texture::TexturedMesh> texturedOf(store::SherdRow row, const TriangleMesh* light,
                                                  const TriangleMesh& full) const {
    const auto sherd =
        std::ranges::find_if(sherds_, [&](const auto& record) { return record.row == row; });
    if (sherd == sherds_.end()) return std::nullopt;
    auto read = texturedModelOf(catalogue_, *sherd, plan_.project());
    if (!read || !*read || light == nullptr) return read ? std::move(*read) : std::nullopt;
    auto made = retextured(*light, **read);
    if (!made) return std::nullopt;
    if (options_.forms.contains(Form::Glb)) made->relief = texture::reliefOf(*made, full, 0);
    shrinkPhotographs(*made, unlabelledBytes(options_));
    return std::move(*made);
  }

  // Shaded views take most of a drawing, and their pixels grow with the sherd, as its model does: a
  // small, a middle and a large one tell for those of about their size.
  void drawings() {
    const auto& drawn = plan_.drawn();
    size_.drawings = static_cast<int>(drawn.size());
    const std::string title = valueOrThrow(Settings(catalogue_).project()).title;
    std::vector<std::pair<double, const records::SherdRecord*>> order;
    for (const records::SherdRecord* sherd : drawn)
      order.emplace_back(1 + static_cast<double>(bytesOf(plan_.project() / sherd->model_path)),
                         sherd);
    std::ranges::stable_sort(order, {}, [](const auto& one) { return one.first; });
    constexpr std::size_t kDrawn = 3;
    for (std::size_t k = 0; k < kDrawn; ++k) {
      const std::size_t from = order.size() * k / kDrawn, to = order.size() * (k + 1) / kDrawn;
      if (from == to) continue;
      stopIfAsked();
      std::size_t at = (from + to) / 2;
      auto sheets = sheetsOf(catalogue_, *order[at].second, plan_.project(), options_, title);
      if (!sheets) {  // its model is at fault, as the export will say
        at = from;
        sheets = sheetsOf(catalogue_, *order[at].second, plan_.project(), options_, title);
      }
      if (!sheets) continue;
      const auto& [size, middle] = order[at];
      const auto svg = static_cast<double>(formatSvg(sheets->pages.front(), middle->number).size());
      const auto pdf = static_cast<double>(formatPdf(sheets->pages, middle->number).size());
      for (std::size_t i = from; i < to; ++i) {
        const double share = order[i].first / size;
        const std::string name = "drawings/" + plan_.nameOf(*order[i].second);
        const store::SherdRow row = order[i].second->row;
        add(name + ".svg", static_cast<std::int64_t>(svg * share), row, "drawing");
        add(name + ".pdf", static_cast<std::int64_t>(pdf * share), row, "drawing");
      }
    }
  }

  // A few sherds tell how long the lines of all are.
  void records() {
    if (sherds_.empty()) return;
    const std::size_t step = std::max<std::size_t>(1, sherds_.size() / kRecordsRead);
    std::vector<store::SherdRow> some;
    std::int64_t record_bytes = 0;
    for (std::size_t i = 0; i < sherds_.size(); i += step) {
      const records::SherdRecord& sherd = sherds_[i];
      some.push_back(sherd.row);
      if (!options_.forms.contains(Form::Json)) continue;
      const std::string text = valueOrThrow(
          metadata::sherdJson(catalogue_, sherd, of_sherds_[sherd.row],
                              processedExtras(plan_.project(), sherd), options_.program));
      record_bytes += static_cast<std::int64_t>(text.size());
    }
    if (options_.forms.contains(Form::Json))
      for (const records::SherdRecord& sherd : sherds_)
        add("sherds/" + plan_.nameOf(sherd) + ".json",
            record_bytes / static_cast<std::int64_t>(some.size()));
    tables(some);
  }

  void tables(const std::vector<store::SherdRow>& some) {
    constexpr ByteOrderMark mark = ByteOrderMark::With;
    const auto bytes = [](const Result<std::string>& text) {
      return text ? static_cast<std::int64_t>(text->size()) : std::int64_t{0};
    };
    const auto all = [&](const Result<std::string>& with, const Result<std::string>& without) {
      return bytes(without) + (bytes(with) - bytes(without)) *
                                  static_cast<std::int64_t>(sherds_.size()) /
                                  static_cast<std::int64_t>(some.size());
    };
    FilesOfSherds named;
    for (const store::SherdRow row : some)
      for (const metadata::SherdFile& file : of_sherds_[row])
        named[row][file.role + "_file"] = file.path;
    const std::set<store::ContextRow> contexts = metadata::contextsOf(catalogue_, sherds_);
    const std::vector<store::ContextRow> places(contexts.begin(), contexts.end());
    if (options_.forms.contains(Form::Csv)) {
      add("sherds.csv",
          all(sherdsCsv(catalogue_, some, mark, named), sherdsCsv(catalogue_, {}, mark)));
      add("contexts.csv", bytes(contextsCsv(catalogue_, places, mark)));
      add("columns.csv", static_cast<std::int64_t>(columnsCsv(mark).size()));
    }
    if (options_.forms.contains(Form::Ods))
      add("sherds.ods", all(tablesOds(catalogue_, some, places, named, options_.words),
                            tablesOds(catalogue_, {}, places, {}, options_.words)));
  }

  void metadata() {
    const auto project = valueOrThrow(Settings(catalogue_).project());
    for (const metadata::MetadataFile& file : valueOrThrow(metadata::metadataOf(
             catalogue_, sherds_, project, options_.program, {files_, size_.without_model})))
      add(file.path, static_cast<std::int64_t>(file.text.size()));
  }

  const Catalogue& catalogue_;
  const ExportPlan& plan_;
  const ExportOptions& options_;
  const std::vector<records::SherdRecord>& sherds_;
  std::stop_token stop_;
  ExportSize size_;
  std::vector<archive::BagFile> files_;
  std::map<store::SherdRow, std::vector<metadata::SherdFile>> of_sherds_;
};

}  // namespace

Result<ExportSize> sizeOfExport(const Catalogue& catalogue, const fs::path& project,
                                std::span<const store::SherdRow> rows, const ExportOptions& options,
                                std::stop_token stop) {
  return catalogue.database().asResult([&] {
    ExportPlan plan(catalogue, project, options);
    const auto sherds = readAll(catalogue, rows, plan, stop);
    return Sizing(catalogue, plan, options, sherds, stop).run();
  });
}

}  // namespace ostraka::exchange
