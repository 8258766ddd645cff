#include "core/document/commands/command_words.h"

namespace kerf {

std::string words(const Command& command) {
  return std::visit([](const auto& c) { return c.words(); }, command);
}

size_t weight(const Command& command) {
  return sizeof(Command) + std::visit([](const auto& c) { return c.weight(); }, command);
}

}  // namespace kerf
