#include "core/physics/contact/pair_contacts.h"

#include <optional>

#include "core/base/assert.h"
#include "core/physics/contact/chord_contacts.h"
#include "core/physics/contact/impulse_memory.h"
#include "core/physics/contact/point_contacts.h"
#include "core/physics/contact/push_out.h"
#include "core/physics/contact/reduce_contacts.h"

namespace kerf {

namespace {

void find_points_of_second(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                           PairMemory& memory, std::vector<Contact>& out) {
  const size_t before = out.size();
  find_point_contacts(second, first, lengths, memory.points_of_second, out);
  for (size_t i = before; i < out.size(); ++i) {
    Contact& c = out[i];
    c.at -= c.distance * c.normal;  // onto the first body
    c.normal = -c.normal;
    c.feature += kOnSecond;
  }
}

}  // namespace

std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory) {
  KERF_ASSERT(first.id < second.id);
  if (memory.crossed > 0) {
    memory.points_of_first.clear();
    memory.points_of_second.clear();
    const std::optional<Contact> push = push_out(first, second, memory);
    return push ? std::vector{*push} : std::vector<Contact>{};
  }
  std::vector<Contact> contacts;
  find_point_contacts(first, second, lengths, memory.points_of_first, contacts);
  find_points_of_second(first, second, lengths, memory, contacts);
  find_chord_contacts(first, second, lengths, contacts);
  reduce_contacts(contacts);
  take_impulses(memory, contacts);
  return contacts;
}

}  // namespace kerf
