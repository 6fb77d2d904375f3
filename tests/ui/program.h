#pragma once
#include <QTest>
#include <memory>

/// The tests of a folder are one program, which is compiled and linked once. Each source is a test
/// of its own, in a process of its own: `ui_main_test screens_test picturesOfAllScreens`.
namespace ostraka::ui {

struct UiTest {
  const char* source;  ///< its name without folder and ending is that of the test
  void (*prepare)();   ///< before there is an application: the class's `static void initMain()`
  std::unique_ptr<QObject> (*make)();
};

bool addUiTest(const UiTest& test);

template <class Test>
bool addUiTest(const char* source) {
  return addUiTest({source,
                    [] {
                      if constexpr (requires { Test::initMain(); }) Test::initMain();
                    },
                    []() -> std::unique_ptr<QObject> { return std::make_unique<Test>(); }});
}

}  // namespace ostraka::ui

/// In the namespace of the class.
#define OSTRAKA_UI_TEST(Class) \
  [[maybe_unused]] static const bool k##Class##Added = ostraka::ui::addUiTest<Class>(__FILE__);
