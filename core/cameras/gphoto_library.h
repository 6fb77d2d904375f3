#pragma once
#include <mutex>
#include <string>
#include <vector>

#include "base/result.h"

extern "C" {
typedef struct _GPContext GPContext;
}

/// What the drivers of system cameras share of libgphoto2.
namespace ostraka::cameras {

/// Round loading, opening and closing.
std::mutex& gphotoLock();

struct GphotoPort {
  std::string model, port;
};
/// The cameras at all ports. Under the lock.
std::vector<GphotoPort> detectGphoto(GPContext* context);

/// An error code of the library in words.
Error gphotoTrouble(int code, const std::string& where);

/// libgphoto2 2.5.30 closes descriptor 0 when it lets a PTP/IP camera go; while this lives, it is
/// put back. Without it the next file that is opened would be 0, and be closed with the next
/// camera.
class KeepDescriptorZero {
 public:
  KeepDescriptorZero();
  ~KeepDescriptorZero();
  KeepDescriptorZero(const KeepDescriptorZero&) = delete;
  KeepDescriptorZero& operator=(const KeepDescriptorZero&) = delete;

 private:
  int copy_;
};

}  // namespace ostraka::cameras
