#include "base/memory.h"

#include <sys/resource.h>

#include <fstream>
#include <string>

namespace ostraka {

double peakMemoryMb() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double freeMemoryMb() {
  std::ifstream info("/proc/meminfo");
  for (std::string key, rest; info >> key; std::getline(info, rest)) {
    double kilobytes = 0;
    if (key == "MemAvailable:" && info >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

}  // namespace ostraka
