#include <gtest/gtest.h>

#include "exchange/export_folder.h"
#include "exported_project.h"

namespace ostraka::exchange {
namespace {

namespace fs = std::filesystem;

using ExportedSize = ExportedProject;

constexpr std::size_t kLightModels = 60'000;  // half of what a shell takes

TEST_F(ExportedSize, IsCountedUntilSomebodyStopsIt) {
  std::stop_source stop;
  stop.request_stop();
  const Result<ExportSize> size =
      sizeOfExport(catalogue(), project_->folder(), rows, {}, stop.get_token());
  ASSERT_FALSE(size);
  EXPECT_EQ(size.error().code, ErrorCode::Cancelled);
}

// A person decides by it which stick to take, and how long to wait.
TEST_F(ExportedSize, TellsTheNumberOfFilesAndTheirBytesWithinATenth) {
  const std::vector<std::set<Form>> choices = {ExportOptions().forms,
                                               {Form::Csv, Form::Ods},
                                               {Form::Json},
                                               {Form::Ply, Form::Photographs},
                                               {Form::Obj, Form::Glb, Form::Pictures},
                                               {Form::Drawings, Form::Csv}};
  for (const std::size_t most : {std::size_t{0}, kLightModels})
    for (std::size_t i = 0; i < choices.size(); ++i) {
      ExportOptions options;
      options.target = folder_.path() / ("out" + std::to_string(i) + (most > 0 ? "l" : ""));
      options.forms = choices[i];
      options.most_model_bytes = most;
      const Result<ExportSize> size =
          sizeOfExport(catalogue(), project_->folder(), rows, options, {});
      ASSERT_TRUE(size) << size.error().sentence();
      const Result<Exported> done =
          exportFolder(catalogue(), project_->folder(), rows, options, quiet, {});
      ASSERT_TRUE(done) << done.error().sentence();
      EXPECT_EQ(size->sherds, 3);
      EXPECT_TRUE(size->without_model.empty());
      EXPECT_EQ(size->files, done->files) << i;
      int lie_there = 0;
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(options.target))
        lie_there += entry.is_regular_file() ? 1 : 0;
      EXPECT_EQ(done->files, lie_there) << i;
      // README.txt lists what is there, and nothing else.
      const std::string read_me = *readFile(options.target / "data/README.txt");
      for (const auto& [form, part] : {std::pair(Form::Ply, "models/*.ply"),
                                       {Form::Glb, "models/*.glb"},
                                       {Form::Obj, "models/*.obj"}})
        EXPECT_EQ(read_me.find(part) != std::string::npos, choices[i].contains(form))
            << i << ": " << part;
      for (const char* part : {"sherds.csv", "sherds.ods", "sherds/", "models/", "images/",
                               "photographs/", "drawings/", "views/"})
        EXPECT_EQ(read_me.find("\n" + std::string(part)) != std::string::npos,
                  fs::exists(options.target / "data" / part))
            << i << ": " << part;
      const auto said = static_cast<double>(size->bytes), is = static_cast<double>(done->bytes);
      EXPECT_NEAR(said / is, 1, 0.1) << "choice " << i << ": " << said << " said, " << is;
    }
}

}  // namespace
}  // namespace ostraka::exchange
