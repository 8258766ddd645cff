#include "core/physics/machine_kind.h"

#include <gnu/libc-version.h>
#include <LinearMath/btScalar.h>
#include <sys/utsname.h>

namespace kerf {

namespace {

// The revision of how Kerf moves bodies. It increases when a change makes them move to other bits.
constexpr int kRevision = 3;

}  // namespace

std::string machine_kind() {
  utsname machine{};
  const std::string processor = uname(&machine) == 0 ? machine.machine : "unknown";
  const int version = btGetVersion();
  return processor + " glibc-" + gnu_get_libc_version() + " bullet-" + std::to_string(version / 100) + "." +
         std::to_string(version % 100) + " motion-" + std::to_string(kRevision);
}

}  // namespace kerf
