#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "catalogue/catalogue.h"
#include "cloud/ply.h"
#include "drawing/drawing.h"
#include "records/sherd.h"
#include "texture/texture.h"

namespace ostraka::exchange {

/// Yes where the parts name a rim, a whole profile or a whole vessel; No where they name others
/// only; Propose where nothing is said, or a lid.
drawing::RimChoice rimChoiceOf(const records::SherdRecord& sherd);

struct DrawSherdsOptions {
  drawing::DrawingOptions drawing;  ///< its rim counts only where the next line says so
  bool rim_from_catalogue = true;   ///< rimChoiceOf decides; what a person entered is trusted
  /// Of single sherds, what a person says for their drawings alone; it comes before all others.
  std::map<store::SherdRow, drawing::RimChoice> rims;
};

/// The model that the catalogue names, read within the project and through no link.
Result<PlyContents> modelOf(const records::SherdRecord& sherd,
                            const std::filesystem::path& project);

/// The model with its photographs from the GLB that the catalogue names beside it, read likewise;
/// nothing where there is none or it has no texture. Errors: a file that cannot be read or is
/// another one than was entered.
Result<std::optional<texture::TexturedMesh>> texturedModelOf(const catalogue::Catalogue& catalogue,
                                                             const records::SherdRecord& sherd,
                                                             const std::filesystem::path& project);

/// A drawing of the catalogue's model, named by the sherd's number. Where a person says rim and no
/// stretch of the edge can be one it is drawn without, and a remark says so; another one says that
/// a sherd is void. What persons measured is printed instead of the model's measures. Errors: no
/// model, a file that cannot be read, a model that is not closed.
Result<drawing::SherdDrawing> drawSherd(const catalogue::Catalogue& catalogue,
                                        const records::SherdRecord& sherd,
                                        const std::filesystem::path& project,
                                        const DrawSherdsOptions& options);

/// Of a file that is another one than was entered; a sentence.
Message differsFromEntered(const records::SherdRecord& sherd);
/// Why a void sherd is in no plate and in no export's drawings; a sentence with its name.
Message leftOutAsVoid(const records::SherdRecord& sherd);

struct SherdLeftOut {
  store::SherdRow sherd;
  std::string id;
  Message why;
};
struct DrawnSherds {
  std::vector<drawing::SherdDrawing> drawings;
  std::vector<store::SherdRow> rows;  ///< of the drawings, in the same order
  std::vector<SherdLeftOut> left_out;
};
/// In the order of the rows; what cannot be drawn is left out and named, and so is what is void,
/// unless it is the only one. Errors: Cancelled, the catalogue cannot be read.
Result<DrawnSherds> drawSherds(const catalogue::Catalogue& catalogue,
                               const std::filesystem::path& project,
                               std::span<const store::SherdRow> rows,
                               const DrawSherdsOptions& options, Progress& progress,
                               std::stop_token stop);

/// The views of drawings alone, as files whose ending `file` has (drawing::formatPicture), in the
/// drawings' order. options: those they were drawn with. Errors: a model that cannot be read.
Result<std::vector<std::string>> picturesOf(const catalogue::Catalogue& catalogue,
                                            const std::filesystem::path& project,
                                            const DrawnSherds& drawn,
                                            const DrawSherdsOptions& options,
                                            const std::filesystem::path& file, Progress& progress,
                                            std::stop_token stop);

}  // namespace ostraka::exchange
