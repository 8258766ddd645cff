#pragma once

#include <cstdint>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/world/contact_memory.h"

namespace kerf {

// The contacts of two bodies in a tick, and what is known of them.
struct TouchingPair {
  static constexpr uint32_t kGround = 0xffffffffu;
  uint32_t first = 0, second = 0;  // indices of moving bodies, first < second; the second may be kGround
  std::vector<Contact> contacts;
  PairMemory memory;
};

}  // namespace kerf
