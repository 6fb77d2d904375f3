#include "targets.h"

namespace ostraka::fuzz {

std::span<const Target> targets() {
  static constexpr Target kAll[] = {{"archive", archive},
                                    {"batch_manifest", batchManifest},
                                    {"decisions", decisions},
                                    {"device_replies", deviceReplies},
                                    {"export_folder", exportFolder},
                                    {"image", image},
                                    {"json", json},
                                    {"label_code", labelCode},
                                    {"model_label", modelLabel},
                                    {"onnx_header", onnxHeader},
                                    {"output_folder", outputFolder},
                                    {"ply", ply},
                                    {"rig_file", rigFile},
                                    {"sherd_json", sherdJson},
                                    {"spreadsheet", spreadsheet},
                                    {"table", table}};
  return kAll;
}

}  // namespace ostraka::fuzz
