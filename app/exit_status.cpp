#include "app/exit_status.h"

#include <iostream>

namespace kerf {

int report_error(const Error& error) {
  std::cerr << "kerf: " << error.message << '\n';
  return error.code == ErrorCode::kBadInput ? 2 : 1;
}

}  // namespace kerf
