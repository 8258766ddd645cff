#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

#include "core/base/records.h"

namespace kerf {

// The state of a value before a command; after exchange(), the state after it. The general version keeps a
// copy and suits values that are cheap to copy and to compare. For a class with a nested type `Change`, that
// type is used instead; it has the same functions.
//
// The order of calls is begin, the edits of the command, end, and then any number of exchange and restore.
// Precondition of both: the value is in the state that the change was recorded for, i.e. later changes were
// undone before.
template <typename T>
class ChangeOf {
 public:
  // Starts to record the edits of `value`.
  void begin(T& value) { other_ = value; }
  void end(T& value) { differs_ = !(other_ == value); }
  // Whether the command changed anything.
  bool any() const { return differs_; }
  // Swaps the state of `value` with the recorded one, exactly to the bit.
  void exchange(T& value) { std::swap(value, other_); }
  // Sets `value` to the recorded state, as an edit that another open change records.
  void restore(T& value) const { value = other_; }
  // Memory allocated by the change, in bytes.
  size_t bytes() const { return 0; }

 private:
  T other_{};
  bool differs_ = false;
};

template <typename T>
class ChangeOf<Records<T>> {
 public:
  void begin(Records<T>& records) { records.begin_change(); }
  void end(Records<T>& records) { change_ = records.end_change(); }
  bool any() const { return change_.any(); }
  void exchange(Records<T>& records) { records.exchange(change_); }
  void restore(Records<T>& records) const { records.restore(change_); }
  size_t bytes() const { return change_.bytes(); }
  const typename Records<T>::Change& records() const { return change_; }

 private:
  typename Records<T>::Change change_;
};

template <typename T>
requires requires { typename T::Change; }
class ChangeOf<T> : public T::Change {};

// The change of an owner that lists the members that a command may change once, as
//
//   template <typename Self>
//   static auto parts(Self& self) { return std::tie(self.links_, self.positions_); }
//
// where Self is the owner or the owner as const. Every function goes through the members in that order.
template <typename Owner>
class ChangeOfParts {
 public:
  void begin(Owner& owner) {
    for_each_part(owner, changes_, [](auto& part, auto& change) { change.begin(part); });
  }
  void end(Owner& owner) {
    for_each_part(owner, changes_, [](auto& part, auto& change) { change.end(part); });
  }
  bool any() const {
    return std::apply([](const auto&... change) { return (change.any() || ...); }, changes_);
  }
  void exchange(Owner& owner) {
    for_each_part(owner, changes_, [](auto& part, auto& change) { change.exchange(part); });
  }
  void restore(Owner& owner) const {
    for_each_part(owner, changes_, [](auto& part, const auto& change) { change.restore(part); });
  }
  size_t bytes() const {
    return std::apply([](const auto&... change) { return (change.bytes() + ...); }, changes_);
  }

  // The change of the only member of this type, or of the member with this index.
  template <typename Part>
  const ChangeOf<Part>& part() const {
    return std::get<ChangeOf<Part>>(changes_);
  }
  template <size_t index>
  const auto& part_at() const {
    return std::get<index>(changes_);
  }

  // Memory allocated by the members of the owner, in bytes.
  static size_t bytes_of(const Owner& owner) {
    return std::apply([](const auto&... part) { return (bytes_of_part(part) + ...); }, Owner::parts(owner));
  }

 private:
  template <typename... Part>
  static std::tuple<ChangeOf<Part>...> changes_of(std::tuple<Part&...>);
  using Changes = decltype(changes_of(Owner::parts(std::declval<Owner&>())));

  template <typename SomeChanges, typename Visit>
  static void for_each_part(Owner& owner, SomeChanges& changes, Visit visit) {
    const auto parts = Owner::parts(owner);
    [&]<size_t... i>(std::index_sequence<i...>) { (visit(std::get<i>(parts), std::get<i>(changes)), ...); }
    (std::make_index_sequence<std::tuple_size_v<Changes>>());
  }

  template <typename Part>
  static size_t bytes_of_part(const Part& part) {
    if constexpr (requires { part.bytes(); }) {
      return part.bytes();
    } else {
      return 0;
    }
  }

  Changes changes_;
};

}  // namespace kerf
