#include "ui/editor/shared/command_labels.h"

#include <gtest/gtest.h>

namespace kerf {
namespace {

TEST(CommandLabels, name_the_beam_and_the_piece) {
  CutSettings settings;
  settings.laser.radius = 0.004;
  EXPECT_EQ(command_label(BeginStroke{settings, {}}, FileUnit::kMetre), "Stroke, radius 4 mm");
  EXPECT_EQ(command_label(HidePiece{{{0, 0}, 2}, true}, FileUnit::kMetre), "Hide piece 2 of body 1");
  EXPECT_EQ(command_label(DuplicatePiece{{{1, 0}, 0}, {}}, FileUnit::kMetre), "Duplicate body 2");
}

TEST(CommandLabels, show_lengths_in_the_unit_of_the_document) {
  CutSettings settings;
  settings.laser.radius = 0.01;
  settings.resolution.rule = Resolution::Rule::kTargetEdge;
  settings.resolution.target_edge = 0.5;
  EXPECT_EQ(command_label(BeginStroke{settings, {}}, FileUnit::kMillimetre), "Stroke, radius 10 \xc2\xb5m");
  EXPECT_EQ(command_label(BeginStroke{settings, {}}, FileUnit::kInch), "Stroke, radius 0.01 in");
  EXPECT_EQ(command_label(Recut{settings}, FileUnit::kMillimetre),
            "Recut the stroke, edges of 500 \xc2\xb5m");
}

TEST(StageLabels, use_singular_plural_and_none_for_face_counts) {
  StageRecord record;
  record.kind = StageRecord::Kind::kRemove;
  EXPECT_EQ(stage_label(record, FileUnit::kMetre), "Remove: no face was removed.");
  record.done.delta.removed_faces = 1;
  record.left = 1;
  EXPECT_EQ(stage_label(record, FileUnit::kMetre),
            "Remove: 1 face was removed. 1 face is left for this stage.");
  record.kind = StageRecord::Kind::kCloseRim;
  record.done.delta.removed_faces = 0;
  EXPECT_EQ(stage_label(record, FileUnit::kMetre),
            "Close the rim: no face was left inside the boundary of the stroke.");
  record.done.delta.removed_faces = 1;
  EXPECT_EQ(stage_label(record, FileUnit::kMetre),
            "Close the rim: 1 face inside the boundary of the stroke was removed.");
  record.done.delta.removed_faces = 31'841;
  EXPECT_EQ(stage_label(record, FileUnit::kMetre),
            "Close the rim: 31 841 faces inside the boundary of the stroke were removed.");
}

TEST(CommandLabels, name_a_piece_by_its_name_or_number) {
  EXPECT_EQ(command_label(SetSolid{{{0, 0}, 0}, true}, FileUnit::kMetre, "box"), "Make box a solid");
  EXPECT_EQ(command_label(SetSolid{{{0, 0}, 0}, false}, FileUnit::kMetre, "box"), "Make box a sheet");
}

}  // namespace
}  // namespace kerf
