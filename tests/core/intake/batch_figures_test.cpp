// The figures of a batch are of its last computation; what became of its sherds since goes before.
#include "intake/batch_figures.h"

#include <gtest/gtest.h>

#include "catalogue/batches.h"
#include "catalogue/settings.h"
#include "sherds/sherds.h"
#include "tests/core/catalogue/small_project.h"

namespace ostraka::intake {
namespace {

class BatchFiguresOf : public catalogue::SmallProject {};

TEST_F(BatchFiguresOf, ABatchAreKeptAsTheyWere) {
  BatchFigures figures;
  figures.take({.sherds = 9, .sure = 5, .decided = 1, .ask = 3, .reshoot = 2});
  figures.uncertainty_mm = 0.07;
  figures.seconds = 61.5;
  figures.draft = true;
  figures.counted = 10;
  figures.moved = {{3, 4.5, 0.2, 0.01}};
  ASSERT_TRUE(keepFigures(catalogue(), "B0001", figures));
  const auto kept = keptFigures(catalogue(), "B0001");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->sherds, 9);
  EXPECT_EQ(kept->sure, 5);
  EXPECT_EQ(kept->decided, 1);
  EXPECT_EQ(kept->ask, 3);
  EXPECT_EQ(kept->reshoot, 2);
  EXPECT_EQ(kept->uncertainty_mm, 0.07);
  EXPECT_EQ(kept->seconds, 61.5);
  EXPECT_TRUE(kept->draft);
  EXPECT_EQ(kept->counted, 10);
  ASSERT_EQ(kept->moved.size(), 1u);
  EXPECT_EQ(kept->moved[0].camera, 3);
  EXPECT_EQ(kept->moved[0].moved_mm, 0.2);
}

TEST_F(BatchFiguresOf, ABatchWithoutAnyAreNone) {
  EXPECT_FALSE(keptFigures(catalogue(), "B0001"));
  for (const char* strange : {"{", "[1]", R"({"sherds": "nine"})", R"({"moved": [{}]})"}) {
    ASSERT_TRUE(catalogue::Settings(catalogue()).setValue("queue.figures.B0001", strange));
    EXPECT_FALSE(keptFigures(catalogue(), "B0001")) << strange;
  }
}

TEST_F(BatchFiguresOf, ABatchAreShownLessWhatBecameOfItsSherdsSince) {
  records::SherdRecord sherd;
  sherd.context = context12;
  std::string first;
  for (const char* number : {"A-1", "A-2"}) {
    sherd.number = number;
    sherd.batch = *catalogue::Batches(catalogue()).add({}, {});
    ASSERT_TRUE(sherds::Sherds(catalogue()).add(sherd, {}));
    if (first.empty()) first = catalogue::Batches(catalogue()).get(sherd.batch)->number;
  }
  BatchFigures figures;
  figures.numbers_left = {"A-1", "A-2", "A-3"};
  figures.unlike = {{"A-1", 47.7, 40.4}, {"A-2", 30, 40}};
  ASSERT_TRUE(keepFigures(catalogue(), first, figures));
  EXPECT_EQ(keptFigures(catalogue(), first)->numbers_left, figures.numbers_left);
  EXPECT_EQ(keptFigures(catalogue(), first)->unlike.size(), 2u);
  const auto shown = shownFigures(catalogue(), first);
  EXPECT_EQ(shown->numbers_left, (std::vector<std::string>{"A-2", "A-3"})) << "A-1 was given";
  ASSERT_EQ(shown->unlike.size(), 1u) << "A-2 lies elsewhere";
  EXPECT_EQ(shown->unlike[0].number, "A-1");
}

}  // namespace
}  // namespace ostraka::intake
