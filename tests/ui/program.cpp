#include "tests/ui/program.h"

#include <QApplication>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>

namespace ostraka::ui {
namespace {

std::map<std::string, UiTest>& uiTests() {
  static std::map<std::string, UiTest> tests;
  return tests;
}

}  // namespace

bool addUiTest(const UiTest& test) {
  return uiTests().emplace(std::filesystem::path(test.source).stem().string(), test).second;
}

}  // namespace ostraka::ui

int main(int argc, char** argv) {
  const auto& tests = ostraka::ui::uiTests();
  const auto found = argc < 2 ? tests.end() : tests.find(argv[1]);
  if (found == tests.end()) {
    std::fprintf(stderr, "Usage: %s TEST [ARGUMENTS OF QTEST]\n", argv[0]);
    for (const auto& [name, test] : tests) std::fprintf(stderr, "  %s\n", name.c_str());
    return 2;
  }
  argv[1] = argv[0];  // Qt sees a program of this test alone
  ++argv;
  --argc;
  // From here on as QTEST_MAIN does it.
  found->second.prepare();
  QApplication application(argc, argv);
  QApplication::setAttribute(Qt::AA_Use96Dpi);
  QTEST_DISABLE_KEYPAD_NAVIGATION
  const std::unique_ptr<QObject> test = found->second.make();
  QTest::setMainSourcePath(found->second.source);
  return QTest::qExec(test.get(), argc, argv);
}
