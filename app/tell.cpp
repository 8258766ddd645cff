#include "app/tell.h"

#include <iostream>

#include "core/mesh/load_notes.h"

namespace kerf {

Status flush_output() {
  return std::cout.flush() ? Status(Done{}) : failed("standard output cannot be written");
}

void warn(const std::string& warning) { std::cerr << "kerf: warning: " << warning << '\n'; }

void tell(const MeshReport& report) {
  for (const std::string& warning : report.warnings) warn(warning);
  for (const std::string& note : dropped_notes(report.repairs)) std::cerr << "kerf: note: " << note << '\n';
}

}  // namespace kerf
