#include "core/mesh/mesh_attributes.h"

#include <cassert>

#include "core/base/assert.h"

namespace kerf {

void FaceColumns::Column::set(FaceId f, uint64_t cell) {
  const uint64_t before = get(f);
  if (before == cell) return;
  cells.grow_to(f.index + 1);
  filled.grow_to(f.index / kBlock + 1);
  cells.edit(f.index) = cell;
  if (before == 0) ++filled.edit(f.index / kBlock);
  if (cell == 0) --filled.edit(f.index / kBlock);
}

void FaceColumns::Column::share_sum(FaceId a, FaceId b, double share) {
  if (get(a) == 0 && get(b) == 0) return;
  const double sum = from_cell<double>(get(a)) + from_cell<double>(get(b)), first = share * sum;
  set(a, to_cell(first));
  set(b, to_cell(sum - first));
}

uint32_t FaceColumns::attach(Rule rule) {
  columns_.push_back({rule, {}, {}});
  return static_cast<uint32_t>(columns_.size() - 1);
}

void FaceColumns::record_split(FaceId kept, FaceId added, double share) {
  for (Column& column : columns_) {
    if (column.rule == Rule::kCopy) {
      column.set(added, column.get(kept));
    } else {
      column.share_sum(kept, added, share);
    }
  }
}

void FaceColumns::record_flipped(FaceId a, FaceId b, double share) {
  for (Column& column : columns_) {
    if (column.rule == Rule::kShareByArea) column.share_sum(a, b, share);
  }
}

void FaceColumns::record_removed(FaceId f) {
  for (Column& column : columns_) column.set(f, 0);
}

FaceColumns FaceColumns::extract(std::span<const FaceId> faces) const {
  FaceColumns extracted;
  for (const Column& column : columns_) {
    Column& own = extracted.columns_.emplace_back(Column{column.rule, {}, {}});
    for (uint32_t f = 0; f < faces.size(); ++f) own.set(FaceId(f), column.get(faces[f]));
  }
  return extracted;
}

bool FaceColumns::blank() const {
  return std::all_of(columns_.begin(), columns_.end(), [](const Column& c) { return c.cells.empty(); });
}

size_t FaceColumns::bytes() const {
  size_t bytes = 0;
  for (const Column& column : columns_) bytes += ChangeOfParts<Column>::bytes_of(column);
  return bytes;
}

// Undo ------------------------------------------------------------------------------------------------------

void FaceColumns::Change::begin(FaceColumns& columns) {
  changes_.resize(columns.columns_.size());
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].begin(columns.columns_[i]);
}

void FaceColumns::Change::end(FaceColumns& columns) {
  KERF_ASSERT(changes_.size() == columns.columns_.size() && "a column was attached within a command");
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].end(columns.columns_[i]);
}

bool FaceColumns::Change::any() const {
  return std::any_of(changes_.begin(), changes_.end(), [](const auto& change) { return change.any(); });
}

void FaceColumns::Change::exchange(FaceColumns& columns) {
  KERF_ASSERT(changes_.size() == columns.columns_.size());
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].exchange(columns.columns_[i]);
}

void FaceColumns::Change::restore(FaceColumns& columns) const {
  KERF_ASSERT(changes_.size() == columns.columns_.size());
  for (size_t i = 0; i < changes_.size(); ++i) changes_[i].restore(columns.columns_[i]);
}

size_t FaceColumns::Change::bytes() const {
  size_t bytes = 0;
  for (const auto& change : changes_) bytes += change.bytes();
  return bytes;
}

void VertexColours::set(VertexId v, const VertexColour& colour) {
  assert(v.valid());
  while (cells_.size() <= v.index) cells_.push_back(VertexColour());
  cells_.edit(v.index) = colour;
}

}  // namespace kerf
