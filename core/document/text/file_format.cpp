#include "core/document/text/file_format.h"

#include "core/base/version.h"
#include "core/document/text/fields.h"

namespace kerf {

void format_fields(Fields& f, uint64_t newest) {
  f.check(f.present("format", true), nullptr,
          "the file was made before Kerf 0.2, in a format that is no longer read: open it with the version "
          "that made it");
  uint64_t format = newest;
  f.version("format", format, newest);
  std::string program = kVersion;
  f.text("program", program);
}

}  // namespace kerf
