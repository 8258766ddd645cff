#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

using Notes = std::vector<std::string>;

TEST(LoadNotes, are_empty_for_a_valid_file) {
  MeshReport report;
  report.faces = report.faces_in_file = report.triangles_in_file = 12;
  report.boundary_edges = 4;
  report.repairs.welded_vertices = 28;
  report.repairs.duplicated_vertices = 3;
  EXPECT_TRUE(load_notes(report).empty());
}

TEST(LoadNotes, use_singular_and_plural) {
  MeshReport report;
  report.repairs.zero_area_faces = 1;
  EXPECT_EQ(load_notes(report), Notes{"1 face has no area and was kept, because it connects others."});
  report.repairs.zero_area_faces = 3;
  EXPECT_EQ(load_notes(report), Notes{"3 faces have no area and were kept, because they connect others."});
}

TEST(LoadNotes, list_dropped_elements_first_and_reader_warnings_last) {
  MeshReport report;
  report.repairs.reoriented_faces = 12;
  report.repairs.invalid_faces_dropped = 2;
  report.non_manifold_edges = 1;
  report.warnings = {"7 bytes after the last triangle were ignored."};
  const Notes notes = load_notes(report);
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_EQ(notes[0], "2 triangles refer to missing vertices and were dropped.");
  EXPECT_EQ(notes[1], "12 faces were flipped, so that neighbours agree and closed parts face outward.");
  EXPECT_EQ(notes[3], report.warnings[0]);
}

TEST(LoadNotes, list_exactly_the_dropped_elements_as_dropped) {
  Repairs repairs;
  repairs.zero_area_faces = repairs.reoriented_faces = repairs.isolated_vertices_dropped = 5;
  EXPECT_TRUE(dropped_notes(repairs).empty());
  repairs.degenerate_faces_dropped = repairs.non_finite_faces_dropped = repairs.invalid_faces_dropped = 1;
  Notes notes = dropped_notes(repairs);
  ASSERT_EQ(notes.size(), 3u);
  for (const std::string& note : notes)
    EXPECT_TRUE(note.starts_with("1 triangle ") && note.ends_with("dropped.")) << note;
  repairs.incomplete_faces_dropped = 2;
  notes = dropped_notes(repairs);
  ASSERT_EQ(notes.size(), 4u);
  EXPECT_EQ(notes[3], "2 faces have fewer than three corners and were dropped.");
}

}  // namespace
}  // namespace kerf
