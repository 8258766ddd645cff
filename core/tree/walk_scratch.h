#pragma once

#include <span>
#include <vector>

#include "core/tree/walks.h"

namespace kerf {

// The lists of one walk, on the stack of its caller for as long as they are short.
class WalkScratch {
 public:
  WalkScratch() = default;
  WalkScratch(const WalkScratch&) = delete;
  WalkScratch& operator=(const WalkScratch&) = delete;

  const WalkLists& lists() const { return lists_; }
  std::span<const uintptr_t> faces() const { return {faces_.items, faces_.count}; }
  std::span<const uintptr_t> marks() const { return {marks_.items, marks_.count}; }

 private:
  static constexpr uint32_t kShort = 96;
  struct List : WordList {
    List() : WordList{nullptr, 0, kShort, lengthen} { items = few; }
    static void lengthen(WordList& list);
    uintptr_t few[kShort];
    std::vector<uintptr_t> many;
  };
  List nodes_, blocks_, faces_, marks_;
  WalkLists lists_{nodes_, blocks_, faces_, marks_};
};

}  // namespace kerf
