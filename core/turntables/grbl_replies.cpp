#include <cmath>

#include "base/text.h"
#include "turntables/grbl.h"

namespace ostraka::turntables {
namespace {

std::optional<double> firstNumber(std::string_view text) {
  const auto value = wholeText<double>(text.substr(0, text.find(',')));
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> codeAfter(std::string_view line, std::string_view start) {
  if (!line.starts_with(start)) return std::nullopt;
  return wholeText<int>(line.substr(start.size()));
}

Template<1> alarmWords(int code) {
  switch (code) {
    case 1:
    case 3:
      return translatable<1>(
          "The turntable was stopped while moving and lost its position: align the zero mark "
          "(ALARM:%1).");
    case 2:
      return translatable<1>(
          "The turntable's controller reports a turn beyond its travel: switch $20 off "
          "(ALARM:%1).");
    case 6:
    case 8:
    case 9:
      return translatable<1>("Homing failed: check the zero switch and its cable (ALARM:%1).");
    default:
      return translatable<1>("The turntable's controller raised an alarm (ALARM:%1).");
  }
}

Template<1> errorWords(int code) {
  switch (code) {
    case 1:
    case 2:
    case 3:
    case 20:
      return translatable<1>(
          "The controller does not understand the command: wrong controller type or bad cable "
          "(error:%1).");
    case 5:
      return translatable<1>("The turntable has no zero switch (error:%1).");
    case 8:
      return translatable<1>("The turntable is still moving (error:%1).");
    case 9:
      return translatable<1>("The turntable is locked: home it or unlock it (error:%1).");
    default:
      return translatable<1>("The turntable's controller rejected a command (error:%1).");
  }
}

}  // namespace

std::optional<GrblReport> parseGrblReport(std::string_view line) {
  if (line.size() < 3 || line.front() != '<' || line.back() != '>') return std::nullopt;
  line = line.substr(1, line.size() - 2);
  if (line.find_first_of("<>") != std::string_view::npos) return std::nullopt;
  GrblReport report;
  bool first = true;
  while (!line.empty() || first) {
    const std::size_t bar = line.find('|');
    const std::string_view field = line.substr(0, bar);
    line = bar == std::string_view::npos ? std::string_view() : line.substr(bar + 1);
    if (first) {
      report.state = field;
      first = false;
      continue;
    }
    std::optional<double>* place = field.starts_with("MPos:")   ? &report.machine
                                   : field.starts_with("WPos:") ? &report.work
                                   : field.starts_with("WCO:")  ? &report.offset
                                                                : nullptr;
    if (place == nullptr) continue;
    *place = firstNumber(field.substr(field.find(':') + 1));
    if (!*place) return std::nullopt;  // garbled
  }
  const std::string state = report.state.substr(0, report.state.find(':'));
  for (const char* known :
       {"Idle", "Run", "Hold", "Jog", "Alarm", "Door", "Check", "Home", "Sleep"})
    if (state == known) return report;
  return std::nullopt;
}

std::optional<Message> grblTrouble(std::string_view line) {
  if (const auto code = codeAfter(line, "ALARM:")) return message(alarmWords(*code), *code);
  if (const auto code = codeAfter(line, "error:")) return message(errorWords(*code), *code);
  return std::nullopt;
}

}  // namespace ostraka::turntables
