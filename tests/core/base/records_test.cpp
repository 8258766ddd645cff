#include "core/base/records.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace kerf::test {
namespace {

struct Record {
  uint32_t a = 0, b = 0;
  friend bool operator==(const Record&, const Record&) = default;
};

std::vector<Record> content(const Records<Record>& records) {
  std::vector<Record> all;
  for (uint32_t i = 0; i < records.size(); ++i) all.push_back(records[i]);
  return all;
}

// Edits, additions and growth as in a command.
void change_at_random(Records<Record>& records, Random& random) {
  const size_t edits = random.below(200);
  for (size_t i = 0; i < edits; ++i) {
    const Record record{static_cast<uint32_t>(random.below(1000)), static_cast<uint32_t>(i)};
    const size_t what = records.empty() ? 0 : random.below(4);
    if (what == 0) records.push_back(record);
    if (what == 1) records.grow_to(records.size() + static_cast<uint32_t>(random.below(50)));
    if (what >= 2) records.edit(static_cast<uint32_t>(random.below(records.size()))) = record;
  }
}

TEST(Records, keep_addresses_stable_when_large_storage_grows) {
  Records<Record> records;
  records.grow_to(Records<Record>::kSmall + 1);
  const Record* first = &records[0];
  records.grow_to(3 * Records<Record>::kChunk);
  EXPECT_EQ(first, &records[0]);
  EXPECT_EQ(records[3 * Records<Record>::kChunk - 1], Record());
}

TEST(Records, undo_and_redo_random_changes_exactly) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Records<Record> records;
    records.grow_to(static_cast<uint32_t>(random.below(3 * Records<Record>::kSmall)));
    std::vector<std::vector<Record>> states{content(records)};
    std::vector<Records<Record>::Change> changes;
    size_t at = 0;
    for (int step = 0; step < 60; ++step) {
      const size_t what = random.below(3);
      if (what == 0) {
        changes.resize(at);
        states.resize(at + 1);
        records.begin_change();
        change_at_random(records, random);
        changes.push_back(records.end_change());
        states.push_back(content(records));
        ++at;
      } else if (what == 1 && at > 0) {
        records.exchange(changes[--at]);
      } else if (what == 2 && at < changes.size()) {
        records.exchange(changes[at++]);
      }
      ASSERT_EQ(content(records), states[at]) << "step " << step;
    }
  }
}

TEST(Records, restore_an_older_state_as_an_undoable_edit) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Records<Record> records;
    records.grow_to(static_cast<uint32_t>(random.below(2 * Records<Record>::kSmall)));
    const auto before = content(records);
    records.begin_change();
    change_at_random(records, random);
    records.grow_to(records.size() + static_cast<uint32_t>(random.below(2 * Records<Record>::kSmall)));
    change_at_random(records, random);
    auto first = records.end_change();
    const auto between = content(records);

    records.begin_change();
    records.restore(first);
    ASSERT_EQ(content(records), before);
    change_at_random(records, random);
    auto second = records.end_change();
    const auto after = content(records);

    records.begin_change();
    change_at_random(records, random);
    auto third = records.end_change();
    records.exchange(third);
    ASSERT_EQ(content(records), after);

    Records<Record> copy = records, other = records;
    other.restore(second);
    ASSERT_EQ(content(other), between);
    other.restore(first);
    ASSERT_EQ(content(other), before);
    records.exchange(second);
    ASSERT_EQ(content(records), between);
    records.exchange(second);
    ASSERT_EQ(content(records), after);
    ASSERT_EQ(content(copy), after);
    records.exchange(second);
    records.exchange(first);
    ASSERT_EQ(content(records), before);
  }
}

TEST(Records, store_only_changed_records_per_change) {
  Records<Record> records;
  records.grow_to(1'000'000);
  records.begin_change();
  for (uint32_t i = 500'000; i < 500'100; ++i) records.edit(i).a = i;
  EXPECT_LT(records.end_change().bytes(), 3000u);
}

}  // namespace
}  // namespace kerf::test
