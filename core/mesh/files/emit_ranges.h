#pragma once

#include <functional>
#include <string>

#include "core/base/byte_sink.h"

namespace kerf {

// Hands the bytes of many items to a sink in order. encode(first, end, part) appends those of a range of
// items; several ranges are encoded at a time, on several threads, and only so many are held. Returns false
// if the sink did.
bool emit_ranges(size_t items, const ByteSink& sink,
                 const std::function<void(size_t first, size_t end, std::string& part)>& encode);

}  // namespace kerf
