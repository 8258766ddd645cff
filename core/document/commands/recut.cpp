#include "core/document/commands/recut.h"

#include "core/base/length_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/settings_fields.h"

namespace kerf {

namespace {

std::string fineness(const Resolution& r) {
  switch (r.rule) {
    case Resolution::Rule::kTargetEdge:
      return "edges of " + length_text(r.target_edge);
    case Resolution::Rule::kTolerance:
      return "within " + length_text(r.tolerance);
    case Resolution::Rule::kDepth:
      return std::to_string(r.depth) + (r.depth == 1 ? " level" : " levels");
  }
  return "";
}

}  // namespace

std::string Recut::words() const { return "Cut the stroke again, " + fineness(settings.resolution); }

void describe(Fields& f, Recut& c) { f.object("settings", c.settings); }

}  // namespace kerf
