#include "core/mesh/files/mesh_format.h"

#include <gtest/gtest.h>

#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

TEST(MeshFormat, is_found_by_extension_in_any_case) {
  EXPECT_EQ(mesh_format("obj"), MeshFormat::kObj);
  EXPECT_EQ(mesh_format(".PLY"), MeshFormat::kPly);
  EXPECT_EQ(mesh_format("Stl"), MeshFormat::kStl);
  EXPECT_FALSE(mesh_format("objx"));
  EXPECT_FALSE(mesh_format(""));
  EXPECT_FALSE(mesh_format("..obj"));
  for (const MeshFormatRow& row : kMeshFormats) {
    EXPECT_EQ(mesh_format(row.ending), row.format);
    EXPECT_EQ(format_row(row.format).ending, row.ending);
  }
}

TEST(MeshFormat, of_a_file_is_detected_by_content_not_name) {
  for (const test::Sample& sample : test::sample_files())
    for (const char* ending : {"obj", "ply", "stl", "off", "txt", ""})
      EXPECT_EQ(recognise_format(sample.bytes, ending), sample.format) << sample.name << " as ." << ending;
}

TEST(MeshFormat, of_an_archive_is_3mf_if_it_has_a_model_of_any_name) {
  const std::string zip = "PK\x03\x04";
  EXPECT_EQ(recognise_format(zip + "3D/3dmodel.model", ""), MeshFormat::k3mf);
  EXPECT_EQ(recognise_format(zip + "[Content_Types].xml _rels/.rels 3D/part.model", ""), MeshFormat::k3mf);
  EXPECT_FALSE(recognise_format(zip + "[Content_Types].xml _rels/.rels word/document.xml", ""));
  EXPECT_FALSE(recognise_format(zip + "part.model", ""));
}

TEST(MeshFormat, of_damaged_content_falls_back_to_the_name) {
  EXPECT_EQ(recognise_format("\x01\x02\x03", "off"), MeshFormat::kOff);
  EXPECT_FALSE(recognise_format("\x01\x02\x03", "txt"));
  EXPECT_EQ(recognise_format("", "ply"), MeshFormat::kPly);
  EXPECT_EQ(recognise_format("# a comment\n\n  v 0 0 0\n", "stl"), MeshFormat::kObj)
      << "after comments and blanks";
}

}  // namespace
}  // namespace kerf
