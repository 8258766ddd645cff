#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/files/three_mf_internal.h"
#include "core/mesh/mesh_file.h"
#include "tests/core/mesh/files/sample_files.h"

namespace kerf::test {
namespace {

struct PackedFile {
  std::string name, content;
  uint16_t method = 0;
  uint16_t flags = 0;
  uint32_t size = 0;  // declared
};

PackedFile stored(const std::string& name, const std::string& content) {
  return {name, content, 0, 0, static_cast<uint32_t>(content.size())};
}

std::string archive(const std::vector<PackedFile>& files) {
  std::string bytes, directory;
  for (const PackedFile& file : files) {
    std::string common;
    for (const uint16_t field : {uint16_t{20}, file.flags, file.method, uint16_t{0}, uint16_t{0x21}})
      append_little(field, common);
    const auto* const content = reinterpret_cast<const Bytef*>(file.content.data());
    append_little(static_cast<uint32_t>(crc32(0, content, static_cast<uInt>(file.content.size()))), common);
    append_little(static_cast<uint32_t>(file.content.size()), common);
    append_little(file.size, common);
    append_little(static_cast<uint16_t>(file.name.size()), common);
    append_little(uint16_t{0}, common);
    append_little(uint32_t{0x02014b50}, directory);
    append_little(uint16_t{20}, directory);
    directory += common;
    directory.append(10, '\0');
    append_little(static_cast<uint32_t>(bytes.size()), directory);
    directory += file.name;
    append_little(uint32_t{0x04034b50}, bytes);
    bytes += common + file.name + file.content;
  }
  const auto start = static_cast<uint32_t>(bytes.size()), size = static_cast<uint32_t>(directory.size());
  bytes += directory;
  append_little(uint32_t{0x06054b50}, bytes);
  const auto count = static_cast<uint16_t>(files.size());
  for (const uint16_t field : {uint16_t{0}, uint16_t{0}, count, count}) append_little(field, bytes);
  append_little(size, bytes);
  append_little(start, bytes);
  append_little(uint16_t{0}, bytes);
  return bytes;
}

std::vector<PackedFile> package(const std::string& model, const std::string& name = "3D/3dmodel.model") {
  return {
      stored("[Content_Types].xml",
             R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns=)"
             R"("http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" )"
             R"(ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension=)"
             R"("model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"),
      stored("_rels/.rels",
             R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns=)"
             R"("http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Type=)"
             R"("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel" Target="/)" +
                 name + R"(" Id="rel0"/></Relationships>)"),
      stored(name, model)};
}

constexpr const char* kTriangleMesh =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/>)"
    R"(</vertices><triangles><triangle v1="0" v2="1" v3="2"/></triangles></mesh>)";

std::string model(const std::string& unit, const std::string& resources, const std::string& items) {
  return R"(<?xml version="1.0" encoding="UTF-8"?><model unit=")" + unit +
         R"(" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )" +
         R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02"><resources>)" +
         resources + "</resources><build>" + items + "</build></model>";
}

std::string object(int id, const std::string& name, const std::string& content) {
  return "<object id=\"" + std::to_string(id) + "\" type=\"model\"" +
         (name.empty() ? "" : " name=\"" + name + "\"") + ">" + content + "</object>";
}

Soup read(const std::string& model) {
  auto soup = read_3mf(archive(package(model)), "a.3mf");
  EXPECT_TRUE(soup.ok()) << soup.error().message;
  return soup.ok() ? std::move(*soup) : Soup();
}

std::string refusal(const std::string& bytes) {
  const auto soup = read_3mf(bytes, "a.3mf");
  EXPECT_FALSE(soup.ok());
  if (soup) return "";
  EXPECT_TRUE(is_one_line_about(soup.error(), "a.3mf: ")) << soup.error().message;
  return soup.error().message;
}

TEST(ThreeMf, units_become_metres) {
  const std::vector<std::pair<std::string, double>> units{{"micron", 1e-6},     {"millimeter", 1e-3},
                                                          {"centimeter", 1e-2}, {"inch", 0.0254},
                                                          {"foot", 0.3048},     {"meter", 1}};
  for (const auto& [unit, metres] : units) {
    const Soup soup = read(model(unit, object(1, "fender", kTriangleMesh), "<item objectid=\"1\"/>"));
    ASSERT_EQ(soup.positions.size(), 3u) << unit;
    EXPECT_EQ(soup.positions[1], Vec3(metres, 0, 0)) << unit;
    ASSERT_EQ(soup.parts.size(), 1u);
    EXPECT_EQ(soup.parts[0].name, "fender");
    EXPECT_EQ(soup.format, "3mf");
  }
}

TEST(ThreeMf, components_are_placed_by_all_transforms) {
  const std::string parts =
      object(1, "wheel", kTriangleMesh) + object(2, "", kTriangleMesh) +
      object(3, "car",
             "<components><component objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 5 0 0\"/>"
             "<component objectid=\"2\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/></components>");
  const Soup soup = read(model("meter", parts,
                               "<item objectid=\"3\" transform=\"0 1 0 -1 0 0 0 0 1 0 0 7\"/>"
                               "<item objectid=\"1\"/>"));
  ASSERT_EQ(soup.triangles.size(), 3u);
  ASSERT_EQ(soup.parts.size(), 3u);
  EXPECT_EQ(soup.parts[0].name, "wheel");
  EXPECT_EQ(soup.parts[1].name, "car");
  EXPECT_EQ(soup.parts[2].name, "wheel");
  // Rows are multiplied by vectors from the left: (2, 0, 0) + (5, 0, 0), then turned by a quarter.
  EXPECT_EQ(soup.positions[1], Vec3(0, 7, 7));
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 &p = soup.positions[a], &q = soup.positions[b], &r = soup.positions[c];
    EXPECT_GT(glm::cross(q - p, r - p).z, 0);
  }
}

TEST(ThreeMf, materials_and_colours_are_read) {
  const std::string resources =
      R"(<basematerials id="5"><base name="red paint" displaycolor="#CC0000"/>)"
      R"(<base name="glass" displaycolor="#00FF0080"/></basematerials>)"
      R"(<m:colorgroup id="6"><m:color color="#0000FF"/><m:color color="#FFFFFF80"/></m:colorgroup>)"
      R"(<object id="1" type="model" pid="5" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
      R"(<vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="1" y="1" z="0"/></vertices><triangles>)"
      R"(<triangle v1="0" v2="1" v3="2"/><triangle v1="2" v2="1" v3="3" pid="5" p1="1"/>)"
      R"(<triangle v1="0" v2="2" v3="3" pid="6" p1="0" p2="1" p3="0"/></triangles></mesh></object>)";
  const Soup soup = read(model("meter", resources, "<item objectid=\"1\"/>"));
  ASSERT_EQ(soup.triangles.size(), 3u);
  ASSERT_EQ(soup.materials.size(), 3u);
  EXPECT_EQ(soup.material_names[soup.materials[0]], "red paint");
  EXPECT_EQ(soup.material_names[soup.materials[1]], "glass");
  ASSERT_NE(soup.surfaces, nullptr);
  EXPECT_EQ(soup.surfaces->materials[soup.materials[0]].mtl[0].text, "Kd 0.8 0 0");
  EXPECT_EQ(soup.surfaces->materials[soup.materials[1]].mtl[1].text, "d 0.5019608");
  ASSERT_EQ(soup.colours.size(), soup.positions.size());
  const auto& third = soup.triangles[2];
  EXPECT_EQ(soup.colours[third[0]], (VertexColour{{0, 0, 0xffff, 0xffff}}));
  EXPECT_EQ(soup.colours[third[1]], (VertexColour{{0xffff, 0xffff, 0xffff, 0x8080}}));
}

TEST(ThreeMf, is_read_back_as_written) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double scale = random.below(2) == 0 ? 0.05 : 3000;
    std::vector<Vec3> positions;
    for (int i = 0; i < 30; ++i)
      positions.push_back(scale * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<uint16_t> materials;
    for (uint32_t i = 0; i < 40; ++i) {
      const auto a = static_cast<uint32_t>(random.below(30)), b = static_cast<uint32_t>(1 + random.below(14));
      triangles.push_back({a, (a + b) % 30, (a + b + 1 + static_cast<uint32_t>(random.below(14))) % 30});
      materials.push_back(static_cast<uint16_t>(random.below(2)));
    }
    const std::vector<std::string> names{"red & <blue>", "gl\xc3\xa4nzend"};
    SurfaceLibrary library;
    library.materials = {{{{"Kd 0.8 0.2 0"}, {"d 0.4"}}, ""}, {}};
    MeshView view{positions, triangles, materials, names, {}, "left fender"};
    view.surfaces = &library;
    const std::string bytes = encoded(view, MeshFormat::k3mf);
    EXPECT_EQ(bytes, encoded(view, MeshFormat::k3mf));
    EXPECT_EQ(recognise_format(bytes, "obj"), MeshFormat::k3mf);
    const auto soup = read_3mf(bytes, "a.3mf");
    ASSERT_TRUE(soup.ok()) << soup.error().message;
    EXPECT_EQ(soup->warnings, std::vector<std::string>{});
    EXPECT_EQ(soup->triangles, triangles);
    EXPECT_EQ(soup->parts[0].name, "left fender");
    for (size_t i = 0; i < positions.size(); ++i) {
      const Vec3 wanted = three_mf_position(positions[i]);
      EXPECT_LE(glm::length(soup->positions[i] - wanted), 1e-15 * scale) << i;
      EXPECT_LE(glm::length(wanted - positions[i]), 2e-9 + 2e-7 * scale) << i;
    }
    for (size_t t = 0; t < triangles.size(); ++t)
      EXPECT_EQ(soup->material_names[soup->materials[t]], names[materials[t]]);
    for (size_t m = 0; m < soup->material_names.size(); ++m) {
      if (soup->material_names[m] != names[0]) continue;
      EXPECT_EQ(soup->surfaces->materials[m].mtl[0].text, "Kd 0.8 0.2 0");
      EXPECT_EQ(soup->surfaces->materials[m].mtl[1].text, "d 0.4");
    }
  }
}

TEST(ThreeMf, bytes_of_names_that_xml_cannot_hold_are_replaced) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 1}};
  const std::vector<uint16_t> materials{0, 1};
  const std::string valid = "b\xc3\xa4\xf0\x9f\x98\x80";
  const std::vector<std::string> names{"gl\xe4nzend", "a\xef\xbf\xbe\xed\xa0\x80\xc0\xaf" + valid};
  const std::string name = std::string(199, 'x') + "\xc3\xa4";
  const MeshView view{positions, triangles, materials, names, {}, "\xffx\xc3"};
  const auto soup = read_3mf(encoded(view, MeshFormat::k3mf), "a.3mf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(soup->parts[0].name, "_x_");
  EXPECT_EQ(soup->material_names, (std::vector<std::string>{"gl_nzend", "a________" + valid}));
  const auto cut_off = read_3mf(encoded({positions, triangles, {}, {}, {}, name}, MeshFormat::k3mf), "a.3mf");
  ASSERT_TRUE(cut_off.ok()) << cut_off.error().message;
  EXPECT_EQ(cut_off->parts[0].name, std::string(199, 'x'));
}

TEST(ThreeMf, a_single_material_is_read_back_as_written) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}};
  const std::vector<std::string> names{"steel"};
  const auto soup = read_3mf(encoded({positions, triangles, {}, names}, MeshFormat::k3mf), "a.3mf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(soup->material_names, names);
}

TEST(ThreeMf, opaque_materials_of_gltf_have_no_opacity) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {2, 1, 3}};
  const std::vector<uint16_t> materials{0, 1};
  const std::vector<std::string> names{"paint", "glass"};
  const std::string pbr = R"("pbrMetallicRoughness":{"baseColorFactor":[1,0,0,0.4]})";
  SurfaceLibrary library;
  library.materials = {{{}, "{" + pbr + "}"}, {{}, R"({"alphaMode":"BLEND",)" + pbr + "}"}};
  MeshView view{positions, triangles, materials, names};
  view.surfaces = &library;
  const auto soup = read_3mf(encoded(view, MeshFormat::k3mf), "a.3mf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  for (size_t t = 0; t < 2; ++t) {
    const auto& lines = soup->surfaces->materials[soup->materials[t]].mtl;
    const bool is_glass = soup->material_names[soup->materials[t]] == "glass";
    EXPECT_EQ(std::ranges::any_of(lines, [](const MtlLine& line) { return line.text == "d 0.4"; }), is_glass);
  }
}

TEST(ThreeMf, colours_are_read_back_as_written) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, {2, 1, 3}};
  std::vector<VertexColour> colours(4);
  for (uint16_t i = 0; i < 4; ++i)
    colours[i].part = {static_cast<uint16_t>(257 * 10 * i), 257 * 7, 0,
                       static_cast<uint16_t>(0xffff - 257 * i)};
  MeshView view{positions, triangles, {}, {}};
  view.colours = colours;
  const auto soup = read_3mf(encoded(view, MeshFormat::k3mf), "a.3mf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(soup->positions, positions);
  EXPECT_EQ(soup->triangles, triangles);
  EXPECT_EQ(soup->colours, colours);
}

std::string deflated(const std::string& content, int flush = Z_FINISH) {
  std::string packed(content.size() + 1000, '\0');
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 9, Z_DEFAULT_STRATEGY), Z_OK);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
  stream.avail_in = static_cast<uInt>(content.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, flush), flush == Z_FINISH ? Z_STREAM_END : Z_OK);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// An archive of one stored file, whose sizes and offset are in the second extra field of its record (ZIP64).
TEST(ThreeMf, entries_of_long_archives_are_found) {
  std::string bytes, directory, extra;
  append_little(uint32_t{0x04034b50}, bytes);
  bytes.append(22, '\0');
  for (const int length : {1, 0}) append_little(static_cast<uint16_t>(length), bytes);
  bytes += "ahello";
  append_little(uint32_t{0x02014b50}, directory);
  directory.append(16, '\0');
  for (int i = 0; i < 2; ++i) append_little(uint32_t{0xffffffff}, directory);
  for (const int field : {0x5455, 1}) append_little(static_cast<uint16_t>(field), extra);
  extra += 'x';
  for (const int field : {1, 24}) append_little(static_cast<uint16_t>(field), extra);
  for (const uint64_t number : {5u, 5u, 0u}) append_little(number, extra);
  for (const size_t length : {size_t{1}, extra.size(), size_t{0}})
    append_little(static_cast<uint16_t>(length), directory);
  directory.append(8, '\0');
  append_little(uint32_t{0xffffffff}, directory);
  directory += "a" + extra;
  const auto start = static_cast<uint32_t>(bytes.size()), size = static_cast<uint32_t>(directory.size());
  bytes += directory;
  append_little(uint32_t{0x06054b50}, bytes);
  for (const int field : {0, 0, 1, 1}) append_little(static_cast<uint16_t>(field), bytes);
  append_little(size, bytes);
  append_little(start, bytes);
  append_little(uint16_t{0}, bytes);
  const auto entries = zip_entries(bytes, "a.3mf");
  ASSERT_TRUE(entries.ok()) << entries.error().message;
  ASSERT_EQ(entries->size(), 1u);
  EXPECT_EQ(entries->front().name, "a");
  EXPECT_EQ(entries->front().content, "hello");
  EXPECT_EQ(entries->front().size, 5u);
}

TEST(ThreeMf, archives_that_lie_are_refused) {
  const std::string good = model("meter", object(1, "", kTriangleMesh), "<item objectid=\"1\"/>");
  auto files = package(good);
  files[2].size = 1u << 25;
  EXPECT_NE(refusal(archive(files)).find("another size than declared"), std::string::npos);
  files[2].size = 1u << 31;
  files.push_back(files[2]);
  files.push_back(files[2]);
  EXPECT_NE(refusal(archive(files)).find("limit of 4 GiB"), std::string::npos);
  files = package(good);
  files[2].flags = 1;
  EXPECT_NE(refusal(archive(files)).find("encrypted"), std::string::npos);
  files[2].flags = 0;
  files[2].method = 14;
  EXPECT_NE(refusal(archive(files)).find("compression"), std::string::npos);
  files = package(good);
  const std::string bomb = deflated(good + std::string(1 << 22, ' '));
  files[2] = {"3D/3dmodel.model", bomb, 8, 0, 100};
  EXPECT_NE(refusal(archive(files)).find("another size than declared"), std::string::npos);
  const std::string blank = good + std::string(1 << 26, ' ');
  files[2] = {"3D/3dmodel.model", deflated(blank), 8, 0, static_cast<uint32_t>(blank.size())};
  EXPECT_NE(refusal(archive(files)).find("200 times its size"), std::string::npos);
  files.erase(files.begin());
  EXPECT_NE(refusal(archive({files[0]})).find("not a usable 3MF file"), std::string::npos);
  EXPECT_NE(refusal("PK\x03\x04").find("damaged"), std::string::npos);
}

// With all of their bytes.
TEST(ThreeMf, deflated_files_without_an_end_are_refused) {
  const std::string text(1000, 'a');
  const auto check = [&](const std::string& content) {
    return check_3mf_entries({ZipEntry{"a.txt", content, 8, 0, text.size()}}, "a.3mf").ok();
  };
  EXPECT_TRUE(check(deflated(text)));
  EXPECT_FALSE(check(deflated(text, Z_SYNC_FLUSH)));
}

// Returns a model in which each object contains the one before it ten times. `before` and `after` enclose the
// number of a component.
std::string multiplying_model(const std::string& before, const std::string& after = "\"") {
  std::string resources = object(1, "", kTriangleMesh);
  for (int id = 2; id < 12; ++id) {
    std::string components;
    for (int i = 0; i < 10; ++i) components += "<component " + before + std::to_string(id - 1) + after + "/>";
    resources += object(id, "", "<components>" + components + "</components>");
  }
  return model("meter", resources, "<item objectid=\"11\"/>");
}

TEST(ThreeMf, components_that_multiply_are_refused) {
  for (const char* before :
       {"objectid=\"", "objectid = '", "objectid=\"00", "objectid=\" +", "objectid=\x01\"",
        "m:a=\" objectid='1' \" objectid=\"", "m:objectid=\"1\" objectid=\"", "path=\"/a.model\" objectid=\"",
        "m:path=\"/a.model\" objectid=\""}) {
    const std::string after = std::string_view(before).ends_with('\'') ? "'" : "\"";
    const std::string bytes = archive(package(multiplying_model(before, after)));
    EXPECT_NE(refusal(bytes).find("too many components"), std::string::npos) << before;
  }
}

TEST(ThreeMf, ids_that_are_no_numbers_or_occur_twice_are_refused) {
  for (const char* before :
       {"objectid=\"1\" objectid=\"", "objectid=\"-", "objectid=\"1000000000000", "objectid=\"\v"}) {
    const std::string bytes = archive(package(multiplying_model(before)));
    EXPECT_NE(refusal(bytes).find("invalid ids"), std::string::npos) << before;
  }
}

TEST(ThreeMf, ids_of_other_namespaces_are_ignored) {
  const std::string text = std::string("<object id=\"1\" xmlns:x=\"http://example.com/x\" x:id=\"a\">") +
                           kTriangleMesh + "</object>";
  EXPECT_EQ(read(model("meter", text, "<item objectid=\"1\"/>")).triangles.size(), 1u);
}

// The object has the id of the component in the other file.
TEST(ThreeMf, components_of_other_files_are_read) {
  const std::string component =
      "<components><component xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
      "p:path=\"/3D/b.model\" objectid=\"1\"/></components>";
  std::vector<PackedFile> files = package(model("meter", object(1, "", component), "<item objectid=\"1\"/>"));
  files.push_back(stored("3D/_rels/3dmodel.model.rels", package("", "3D/b.model")[1].content));
  files.push_back(stored("3D/b.model", model("meter", object(1, "", kTriangleMesh), "")));
  const auto soup = read_3mf(archive(files), "a.3mf");
  ASSERT_TRUE(soup.ok()) << soup.error().message;
  EXPECT_EQ(soup->triangles.size(), 1u);
}

TEST(ThreeMf, prefixes_with_two_meanings_are_refused) {
  const std::string text =
      "<a xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\"/>"
      "<a xmlns:p=\"http://example.com/x\"/>";
  const std::string bytes =
      archive(package(model("meter", object(1, "", kTriangleMesh) + text, "<item objectid=\"1\"/>")));
  EXPECT_NE(refusal(bytes).find("invalid ids"), std::string::npos);
}

TEST(ThreeMf, models_of_other_names_are_read_if_their_ending_is_usual) {
  const std::string text = model("meter", object(1, "", kTriangleMesh), "<item objectid=\"1\"/>");
  for (const char* name : {"3D/part.model", "3D/3DModel.model", "a.model"}) {
    const std::string bytes = archive(package(text, name));
    const auto soup = read_3mf(bytes, "a.3mf");
    ASSERT_TRUE(soup.ok()) << name << soup.error().message;
    EXPECT_EQ(soup->triangles.size(), 1u) << name;
  }
  for (const char* name : {"3D/3dmodel.xml", "3D/3dmodel.MODEL", "3D/3dmodel"}) {
    const std::string bytes = archive(package(text, name));
    EXPECT_NE(refusal(bytes).find("must end with '.model'"), std::string::npos) << name;
  }
}

TEST(ThreeMf, deep_components_are_refused) {
  for (const int levels : {50, 20'000}) {
    std::string resources = object(1, "", kTriangleMesh);
    for (int id = 2; id <= levels; ++id) {
      resources +=
          object(id, "", "<components><component objectid=\"" + std::to_string(id - 1) + "\"/></components>");
    }
    const std::string bytes =
        archive(package(model("meter", resources, "<item objectid=\"" + std::to_string(levels) + "\"/>")));
    if (levels == 50) {
      EXPECT_TRUE(read_3mf(bytes, "a.3mf").ok());
    } else {
      EXPECT_NE(refusal(bytes).find("too many components"), std::string::npos);
    }
  }
}

TEST(ThreeMf, elements_in_comments_are_refused) {
  for (const char* text : {"<!-- > <object id=\"9\"> -->", "<!DOCTYPE a>", "<metadata name=\"<\"/>"}) {
    const std::string bytes =
        archive(package(model("meter", object(1, "", kTriangleMesh) + text, "<item objectid=\"1\"/>")));
    EXPECT_NE(refusal(bytes).find("elements in comments"), std::string::npos);
  }
  const std::string bytes = archive(package(
      model("meter", "<!-- plain > \" -->" + object(1, "", kTriangleMesh), "<item objectid=\"1\"/>")));
  EXPECT_TRUE(read_3mf(bytes, "a.3mf").ok());
}

TEST(ThreeMf, damaged_models_end_well) {
  const std::string good = model(
      "meter",
      object(1, "a", kTriangleMesh) + object(2, "b", "<components><component objectid=\"1\"/></components>"),
      "<item objectid=\"2\"/>");
  const std::vector<std::string> words{"<",          ">",     "\"",  "/",        "&",   "-1",
                                       "4294967295", "1e999", "nan", "objectid", "\xff"};
  for (uint64_t seed = 1; seed <= 2000; ++seed) {
    Random random(seed);
    std::string damaged = good;
    for (uint64_t i = 0; i <= random.below(3); ++i) {
      const size_t at = random.below(damaged.size());
      damaged.replace(at, random.below(8), words[random.below(words.size())]);
    }
    const auto soup = read_3mf(archive(package(damaged)), "a.3mf");
    if (!soup) EXPECT_TRUE(is_one_line_about(soup.error(), "a.3mf: ")) << seed << soup.error().message;
  }
}

TEST(ThreeMf, coordinates_beyond_its_range_are_refused) {
  const std::vector<Vec3> positions{{0, 0, 0}, {2e6, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}};
  const Status status = write_mesh({positions, triangles, {}, {}}, "/nowhere/a.3mf", MeshFormat::k3mf);
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().message.find("3MF cannot store coordinates beyond"), std::string::npos);
}

TEST(ThreeMf, faces_that_have_the_same_corner_twice_are_refused) {
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (const std::array<uint32_t, 3>& flat :
       {std::array<uint32_t, 3>{0, 0, 1}, std::array<uint32_t, 3>{0, 1, 1},
        std::array<uint32_t, 3>{0, 1, 0}}) {
    const std::vector<std::array<uint32_t, 3>> triangles{{0, 1, 2}, flat};
    const auto bytes = encode_mesh({positions, triangles, {}, {}}, MeshFormat::k3mf);
    ASSERT_FALSE(bytes);
    EXPECT_EQ(bytes.error().message,
              "3MF cannot store faces that have the same corner twice; select another format");
  }
}

}  // namespace
}  // namespace kerf::test
