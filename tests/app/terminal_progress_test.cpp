#include "app/terminal_progress.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace ostraka::app {
namespace {

// What a progress wrote, with a clock that only the test moves.
class Screen {
 public:
  Screen() : file_(std::tmpfile()) {}
  ~Screen() { std::fclose(file_); }
  std::FILE* file() { return file_; }
  std::function<TerminalProgress::Clock::time_point()> clock() {
    return [this] { return TerminalProgress::Clock::time_point(now_); };
  }
  void wait(double seconds) {
    now_ += std::chrono::duration_cast<TerminalProgress::Clock::duration>(
        std::chrono::duration<double>(seconds));
  }
  std::string text() {
    std::fflush(file_);
    std::string text(static_cast<std::size_t>(std::ftell(file_)), '\0');
    std::rewind(file_);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file_), text.size());
    return text;
  }

 private:
  std::FILE* file_;
  TerminalProgress::Clock::duration now_{0};
};

TEST(TerminalProgress, WritesPlainLinesIntoAPipeWithTheTimeLeft) {
  Screen screen;
  TerminalProgress progress(screen.file(), false, Loudness::Warnings, screen.clock());
  progress.begin("cameras", 0.25);
  screen.wait(30);
  progress.report(1, 1);
  progress.begin("stereo", 0.75);
  const std::string text = screen.text();
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_NE(text.find("0 %  cameras\n"), std::string::npos) << text;
  // A quarter took 30 s: three quarters take 90 s, rounded to 2 minutes.
  EXPECT_NE(text.find("25 %  stereo, about 2 min left\n"), std::string::npos) << text;
}

TEST(TerminalProgress, DoesNotCountStagesThatWereWholeAlready) {
  Screen screen;
  TerminalProgress progress(screen.file(), false, Loudness::Warnings, screen.clock());
  progress.begin("cameras", 0.5);
  screen.wait(0.1);
  progress.begin("stereo", 0.4);
  screen.wait(40);
  progress.report(1, 1);
  // 0.4 took 40 s, 0.1 is left: 10 s. The stage that took no time says nothing about the pace.
  EXPECT_NE(screen.text().find("90 %  stereo, about 10 s left\n"), std::string::npos)
      << screen.text();
}

TEST(TerminalProgress, DrawsOneLineAnewOnATerminalAndClearsIt) {
  Screen screen;
  {
    TerminalProgress progress(screen.file(), true, Loudness::Warnings, screen.clock());
    progress.begin("masks", 1);
    screen.wait(1);
    progress.report(1, 2);
    progress.note(NoteLevel::Warning, "Shot 3 is dark.");
    progress.note(NoteLevel::Info, "masks: 24 shots");
  }
  const std::string text = screen.text();
  EXPECT_NE(text.find("\r\033[K50 %  masks"), std::string::npos) << text;
  EXPECT_NE(text.find("Warning: Shot 3 is dark.\n"), std::string::npos);
  EXPECT_EQ(text.find("24 shots"), std::string::npos) << "lines of the log only with --verbose";
  EXPECT_TRUE(text.ends_with("\r\033[K"));
}

TEST(TerminalProgress, SaysNothingWhenQuiet) {
  Screen screen;
  TerminalProgress progress(screen.file(), true, Loudness::Quiet, screen.clock());
  progress.begin("masks", 1);
  progress.note(NoteLevel::Warning, "x");
  EXPECT_TRUE(screen.text().empty());
}

TEST(DurationWords, AreRoundedToWhatIsKnown) {
  EXPECT_EQ(durationWords(12), "about 10 s");
  EXPECT_EQ(durationWords(0), "about 1 s");
  EXPECT_EQ(durationWords(100), "about 2 min");
  EXPECT_EQ(durationWords(2 * 3600 + 600), "about 2 h 10 min");
}

}  // namespace
}  // namespace ostraka::app
