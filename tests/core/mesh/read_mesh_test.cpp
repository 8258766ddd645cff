#include "core/base/json.h"
#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "tests/core/mesh/files/sample_files.h"

namespace kerf {
namespace {

std::string refusal(const std::filesystem::path& path) {
  const Result<Soup> soup = read_mesh(path);
  return soup ? "" : soup.error().message.substr(path.string().size());
}

TEST(ReadMesh, detects_the_format_by_content_not_extension) {
  const test::TemporaryFolder folder;
  for (const test::Sample& sample : test::sample_files()) {
    for (const char* ending : {".obj", ".ply", ".stl", ".off", ".txt", ""}) {
      const auto path = folder / (std::string("mesh") + ending);
      test::write_text(path, sample.bytes);
      const Result<Soup> soup = read_mesh(path);
      ASSERT_TRUE(soup) << sample.name << " as " << ending << ": " << soup.error().message;
      EXPECT_EQ(soup->format, format_row(sample.format).ending) << sample.name << " as " << ending;
    }
  }
}

TEST(ReadMesh, rejects_anything_but_a_regular_file) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "d.obj");
  ASSERT_EQ(::mkfifo((folder / "f.stl").c_str(), 0600), 0);
  test::write_text(folder / "e.ply", "");
  test::write_text(folder / "g.txt", "hello");
  EXPECT_EQ(refusal(folder / "d.obj"), ": this is a folder, not a mesh file.");
  EXPECT_EQ(refusal(folder / "f.stl"), ": this is a device or a pipe, not a mesh file.");
  EXPECT_EQ(refusal("/dev/zero"), ": this is a device or a pipe, not a mesh file.");
  EXPECT_EQ(refusal(folder / "e.ply"), ": the file is empty.");
  EXPECT_EQ(refusal(folder / "none.off"), ": cannot be opened: No such file or directory.");
  EXPECT_EQ(refusal(folder / "g.txt"),
            ": this is not a supported mesh format; Kerf reads OBJ, PLY, STL, OFF, glTF and 3MF.");
}

TEST(ReadMesh, names_the_actual_type_of_a_file_that_is_not_a_mesh) {
  const test::TemporaryFolder folder;
  const std::pair<std::string, std::string> files[] = {
      {"\x89PNG\r\n\x1a\n", "a PNG image"},
      {std::string("PK\x03\x04\x14\0\0\0", 8), "a ZIP archive"},
      {"\x1f\x8b\x08", "a file packed with gzip"},
      {std::string("\x64\x86\x05\0", 4), "object code of a compiler"},
      {"Kaydara FBX Binary  ", "an FBX file"},
      {"ISO-10303-21;\nHEADER;\n", "a STEP file"},
      {"#VRML V2.0 utf8\nShape {\n", "a VRML file"},
      {"<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">", "a Collada file"},
      {"\n<!DOCTYPE html><html>", "a web page"},
      {"  0\nSECTION\n  2\nENTITIES\n", "a DXF drawing"},
      {"{\"bodies\": []}", "a Kerf scene"},
      {"{\"kerf\":\"journal\",\"bodies\":[]}\n", "a Kerf journal"},
      {"{\"strokes\": []}", "a Kerf path"},
  };
  for (const auto& [bytes, kind] : files) {
    for (const char* ending : {".obj", ".ply", ".stl", ".off", ".txt", ""}) {
      test::write_text(folder / (std::string("mesh") + ending), bytes);
      EXPECT_EQ(refusal(folder / (std::string("mesh") + ending)),
                ": this is " + kind +
                    ", not a supported mesh format; Kerf reads OBJ, PLY, STL, OFF, glTF and 3MF.");
    }
  }
  test::write_text(folder / "wide.stl", std::string("\xff\xfes\0o\0", 6));
  EXPECT_EQ(refusal(folder / "wide.stl"), ": this is UTF-16 text; save it as UTF-8.");
}

TEST(ReadMesh, rejects_files_above_4_gib) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "big.stl", "x");
  std::error_code unsupported;
  std::filesystem::resize_file(folder / "big.stl", (uintmax_t{1} << 32) + 1, unsupported);
  if (unsupported) GTEST_SKIP() << "no sparse files here";
  EXPECT_EQ(refusal(folder / "big.stl"), ": the file exceeds the limit of 4 GiB.");
}

TEST(ReadMesh, reports_increasing_progress_and_can_be_cancelled) {
  const test::TemporaryFolder folder;
  std::string text;
  for (int i = 0; i < 2000; ++i) text += "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\n";
  test::write_text(folder / "t.obj", text);
  std::vector<double> seen;
  const Progress progress{[&](double fraction) { return seen.push_back(fraction), true; }};
  ASSERT_TRUE(read_mesh(folder / "t.obj", &progress));
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_GT(seen.size(), 50u);
  EXPECT_LE(seen.back(), 1.0);
  const Progress stop{[&](double fraction) { return fraction < 0.5; }};
  const Result<Soup> stopped = read_mesh(folder / "t.obj", &stop);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().message, "cancelled");
}

TEST(ReadMesh, reads_on_several_threads_concurrently) {
  const test::TemporaryFolder folder;
  const auto samples = test::sample_files();
  for (const auto& sample : samples) test::write_text(folder / sample.name, sample.bytes);
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (size_t t = 0; t < wrong.size(); ++t) {
    threads.emplace_back([&, t] {
      for (size_t i = 0; i < 200; ++i) {
        const Result<Soup> soup = read_mesh(folder / samples[(i + t) % samples.size()].name);
        wrong[t] += !soup || test::area(*soup) != 1.0;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

// External meshes that tests may use, or none.
std::optional<std::filesystem::path> outside_meshes(const char* folder) {
  const char* const root = std::getenv("KERF_TEST_MESHES");
  if (!root || !std::filesystem::is_directory(std::filesystem::path(root) / folder)) return std::nullopt;
  return std::filesystem::path(root) / folder;
}

std::vector<std::filesystem::path> entries_below(const std::filesystem::path& root) {
  std::vector<std::filesystem::path> entries;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

TEST(ReadMesh, matches_an_independent_reader_on_real_files) {
  const auto root = outside_meshes("real");
  if (!root) GTEST_SKIP() << "KERF_TEST_MESHES names no folder with real meshes";
  const auto expected = nlohmann::json::parse(std::ifstream(*root / "expected.json"));
  for (const auto& [name, counts] : expected.items()) {
    const Result<Soup> soup = read_mesh(*root / name);
    if (counts["triangles_in_file"] == 0) {
      EXPECT_FALSE(soup) << name;
      continue;
    }
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_EQ(soup->triangles_in_file, counts["triangles_in_file"].get<size_t>()) << name;
    EXPECT_EQ(soup->invalid_faces_dropped, counts.value("invalid_faces_dropped", size_t{0})) << name;
    EXPECT_EQ(soup->triangles_in_file, soup->triangles.size() + soup->invalid_faces_dropped) << name;
    if (counts.contains("area")) {
      const double area = counts["area"];
      EXPECT_NEAR(test::area(*soup), area, 1e-6 * area) << name;
    }
  }
}

TEST(ReadMesh, preserves_the_area_of_concave_polygons_in_real_files) {
  const auto root = outside_meshes("real");
  if (!root) GTEST_SKIP() << "KERF_TEST_MESHES names no folder with real meshes";
  // Newell areas of the polygons, computed by another program.
  for (const auto& [name, area] : {std::pair("path/L.off", 3.0),
                                   {"path/concave_polygon.obj", 0.2454966872},
                                   {"cad/wallhole.obj", 721.4213562373097},
                                   {"path/rabbit.obj", 32.96545745222049}}) {
    const Result<Soup> soup = read_mesh(*root / name);
    ASSERT_TRUE(soup) << soup.error().message;
    EXPECT_NEAR(test::area(*soup), area, 1e-9 * area) << name;
  }
}

TEST(ReadMesh, reports_errors_of_malformed_files) {
  const auto root = outside_meshes("malformed");
  if (!root) GTEST_SKIP() << "KERF_TEST_MESHES names no folder with malformed meshes";
  for (const auto& path : entries_below(*root)) {
    const Result<Soup> soup = read_mesh(path);
    if (soup) {
      EXPECT_FALSE(soup->triangles.empty()) << path;
    } else {
      EXPECT_TRUE(test::is_one_line_about(soup.error(), path.string())) << soup.error().message;
    }
    // Files with VALID in their names must load.
    const bool valid = path.filename().string().find("VALID") != std::string::npos;
    EXPECT_TRUE(soup.ok() || !valid) << path;
  }
}

}  // namespace
}  // namespace kerf
