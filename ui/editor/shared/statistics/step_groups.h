#pragma once

#include <string>
#include <vector>

#include "core/document/history/document.h"

namespace kerf {

// Consecutive steps of the history that the user made at once, such as one for each piece that was hidden, so
// that one undo takes all of them back. The document knows nothing of groups: they last as long as the editor
// is open.
class StepGroups {
 public:
  struct Group {
    size_t from = 0, to = 0;  // positions of the history
    std::string name;
    bool is_one_row = false;  // in the list of the history
  };

  // Drops the groups that contain steps that are no longer in the history. To be called at least once in a
  // frame. Costs time in proportion to the new commands. Precondition: it is always the same document.
  void follow(const Document& document);
  // Makes the steps from a position up to that of the document a group, if there is more than one.
  void add(size_t from, const Document& document, std::string name, bool is_one_row = false);
  // Whether the list of the history has a row for a position: not within a group that is one row.
  bool has_row(size_t position) const;
  // The group that an undo (`back`) or a redo from the position of the document goes through, or null. Valid
  // until the next call.
  const Group* at(const Document& document, bool back) const;

 private:
  std::vector<Group> groups_;
  size_t position_ = 0, commands_ = 0;  // of the history and of the journal, as seen last
};

}  // namespace kerf
