#pragma once

#include <functional>
#include <string_view>

namespace kerf {

// Takes the next bytes of a file or stream, which are valid during the call only. Returns false when no more
// are wanted, because writing failed.
using ByteSink = std::function<bool(std::string_view)>;

}  // namespace kerf
