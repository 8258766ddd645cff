#include <Model/COM/NMR_DLLInterfaces.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <new>
#include <optional>
#include <tuple>

#include "core/base/containers.h"
#include "core/base/random.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/surface_look.h"
#include "core/mesh/files/three_mf_internal.h"

namespace kerf {

namespace {

// Within the preconditions of encode_3mf() lib3mf fails for lack of memory only.
void expect_success(LIB3MFRESULT result) {
  if (result != 0) throw std::bad_alloc();
}

ThreeMf expect_object(ThreeMf object) {
  if (!object) throw std::bad_alloc();
  return object;
}

// The bytes that lib3mf writes, in any order.
struct ThreeMfSink {
  std::string bytes;
  size_t place = 0;

  static uint32_t write(BYTE* data, uint32_t count, void* self) {
    auto& sink = *static_cast<ThreeMfSink*>(self);
    const std::string_view part(reinterpret_cast<const char*>(data), count);
    if (sink.bytes.size() < sink.place + count) sink.bytes.resize(sink.place + count);
    std::copy(part.begin(), part.end(), sink.bytes.begin() + static_cast<std::ptrdiff_t>(sink.place));
    sink.place += count;
    return 0;
  }
  static uint32_t seek(uint64_t place, void* self) {
    static_cast<ThreeMfSink*>(self)->place = place;
    return 0;
  }
};

// Returns the number of bytes of the first character of a text in UTF-8 (RFC 3629) that is not empty; 0 if it
// is malformed or if XML cannot hold it on one line.
size_t bytes_of_character(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<uint8_t>(text[i]) : uint8_t{0}; };
  const uint8_t first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  if (first < 0xc2 || first > 0xf4) return 0;
  const size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  uint32_t code = first & (0x7fu >> bytes);
  for (size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3fu);
  }
  constexpr std::array<uint32_t, 5> kMinCode{0, 0, 0x80, 0x800, 0x10000};  // by number of bytes
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff, is_character = code != 0xfffe && code != 0xffff;
  return code >= kMinCode[bytes] && code <= 0x10ffff && !is_surrogate && is_character ? bytes : 0;
}

// Returns a name that XML and the buffers of lib3mf can hold. lib3mf writes any bytes.
std::string plain_name(std::string_view name) {
  constexpr size_t kMaxName = 200;
  std::string plain;
  while (!name.empty()) {
    const size_t bytes = bytes_of_character(name);
    const std::string_view next = bytes == 0 ? "_" : name.substr(0, bytes);
    if (plain.size() + next.size() > kMaxName) break;
    plain += next;
    name.remove_prefix(next.size());
  }
  return plain;
}

std::string ascii_name(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) >= 0x80) c = '_';
  }
  return name;
}

struct ThreeMfColour {
  BYTE red = 204, green = 204, blue = 204, alpha = 255;  // of materials without a description
};

ThreeMfColour colour_of(const std::optional<SurfaceLook>& look) {
  ThreeMfColour colour;
  if (!look) return colour;
  const auto part = [&](int k) { return eight_bits(part_of_linear(look->base[k])); };
  const double opacity = look->alpha == SurfaceLook::Alpha::kOpaque ? 1 : look->base.w;
  return {part(0), part(1), part(2), eight_bits(colour_part(opacity))};
}

class ThreeMfWriter {
 public:
  explicit ThreeMfWriter(std::span<const MeshView> meshes)
      : meshes_(meshes), model_(expect_object(three_mf_object(NMR::lib3mf_createmodel))) {}

  std::string bytes() {
    expect_success(NMR::lib3mf_model_setunit(model_.get(), NMR::MODELUNIT_MILLIMETER));
    for (const MeshView& mesh : meshes_) add_object(mesh);
    for (const ThreeMf& object : objects_) {
      items_.push_back(expect_object(
          three_mf_object(NMR::lib3mf_model_addbuilditem, model_.get(), object.get(), nullptr)));
    }
    expect_success(NMR::lib3mf_model_setbuilduuidutf8(model_.get(), uuid(1).c_str()));
    for (size_t i = 0; i < items_.size(); ++i) {
      expect_success(NMR::lib3mf_object_setuuidutf8(objects_[i].get(), uuid(2 + 2 * i).c_str()));
      expect_success(NMR::lib3mf_builditem_setuuidutf8(items_[i].get(), uuid(3 + 2 * i).c_str()));
    }
    const ThreeMf writer = expect_object(three_mf_object(NMR::lib3mf_model_querywriter, model_.get(), "3mf"));
    ThreeMfSink sink;
    expect_success(NMR::lib3mf_writer_writetocallback(writer.get(),
                                                      reinterpret_cast<void*>(&ThreeMfSink::write),
                                                      reinterpret_cast<void*>(&ThreeMfSink::seek), &sink));
    return without_times(std::move(sink.bytes));
  }

 private:
  void add_object(const MeshView& mesh) {
    objects_.push_back(expect_object(three_mf_object(NMR::lib3mf_model_addmeshobject, model_.get())));
    set_name(mesh);
    set_geometry(mesh);
    if (!mesh.colours.empty()) {
      set_colours(mesh);
    } else if (std::ranges::any_of(mesh.material_names, [](const std::string& n) { return !n.empty(); })) {
      set_materials(mesh);
    }
  }

  // The object of the mesh that is being added.
  void** object() const { return objects_.back().get(); }

  void set_name(const MeshView& mesh) const {
    const std::string name = plain_name(mesh.name);
    if (name.empty() || NMR::lib3mf_object_setnameutf8(object(), name.c_str()) == 0) return;
    expect_success(NMR::lib3mf_object_setnameutf8(object(), ascii_name(name).c_str()));
  }

  void set_geometry(const MeshView& mesh) {
    std::vector<NMR::MODELMESHVERTEX> vertices(mesh.positions.size());
    for (size_t i = 0; i < vertices.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        assert(std::abs(mesh.positions[i][k]) <= kMaxThreeMf);
        vertices[i].m_fPosition[k] = static_cast<float>(1000 * mesh.positions[i][k]);
        hash_ = hash_combine(hash_, number_bits(vertices[i].m_fPosition[k]));
      }
    }
    std::vector<NMR::MODELMESHTRIANGLE> triangles(mesh.triangles.size());
    for (size_t t = 0; t < triangles.size(); ++t)
      std::copy_n(mesh.triangles[t].begin(), 3, triangles[t].m_nIndices);
    expect_success(NMR::lib3mf_meshobject_setgeometry(object(), vertices.data(),
                                                      static_cast<DWORD>(vertices.size()), triangles.data(),
                                                      static_cast<DWORD>(triangles.size())));
  }

  ThreeMf properties() const {
    return expect_object(three_mf_object(NMR::lib3mf_meshobject_createpropertyhandler, object()));
  }
  ThreeMf default_properties() const {
    return expect_object(three_mf_object(NMR::lib3mf_object_createdefaultpropertyhandler, object()));
  }

  void set_colours(const MeshView& mesh) const {
    std::vector<NMR::MODELMESH_TRIANGLECOLOR_SRGB> colours(mesh.triangles.size());
    for (size_t t = 0; t < colours.size(); ++t) {
      for (size_t i = 0; i < 3; ++i) {
        const auto& part = mesh.colours[mesh.triangles[t][i]].part;
        colours[t].m_Colors[i] = {eight_bits(part[0]), eight_bits(part[1]), eight_bits(part[2]),
                                  eight_bits(part[3])};
      }
    }
    expect_success(NMR::lib3mf_propertyhandler_setgradientcolorarray(properties().get(), colours.data()));
    expect_success(
        NMR::lib3mf_defaultpropertyhandler_setcolor(default_properties().get(), &colours[0].m_Colors[0]));
  }

  void set_materials(const MeshView& mesh) {
    if (!group_) {
      group_ = expect_object(three_mf_object(NMR::lib3mf_model_addbasematerialgroup, model_.get()));
      expect_success(NMR::lib3mf_basematerial_getresourceid(group_.get(), &group_id_));
    }
    std::vector<std::optional<SurfaceLook>> looks;
    if (mesh.surfaces) looks = surface_looks(*mesh.surfaces);
    std::vector<std::optional<DWORD>> numbers(mesh.material_names.size());
    std::vector<DWORD> groups(mesh.triangles.size(), group_id_), indices;
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      const uint16_t m = mesh.materials.empty() ? uint16_t{0} : mesh.materials[t];
      if (!numbers[m]) numbers[m] = material(mesh, m, m < looks.size() ? looks[m] : std::nullopt);
      indices.push_back(*numbers[m]);
    }
    expect_success(
        NMR::lib3mf_propertyhandler_setbasematerialarray(properties().get(), groups.data(), indices.data()));
    expect_success(NMR::lib3mf_defaultpropertyhandler_setbasematerial(default_properties().get(), group_id_,
                                                                      indices[0]));
  }

  // Returns the number of a material in the group; adds it once.
  DWORD material(const MeshView& mesh, uint16_t material, const std::optional<SurfaceLook>& look) {
    const auto [known, added] =
        materials_.try_emplace({mesh.surfaces, material, mesh.material_names[material]}, DWORD{0});
    if (!added) return known->second;
    const ThreeMfColour c = colour_of(look);
    std::string name = plain_name(mesh.material_names[material]);
    if (name.empty()) name = "default";
    DWORD& number = known->second;
    if (NMR::lib3mf_basematerial_addmaterialutf8(group_.get(), name.c_str(), c.red, c.green, c.blue,
                                                 &number) != 0) {
      expect_success(NMR::lib3mf_basematerial_addmaterialutf8(group_.get(), ascii_name(name).c_str(), c.red,
                                                              c.green, c.blue, &number));
    }
    expect_success(
        NMR::lib3mf_basematerial_setdisplaycolorrgba(group_.get(), number, c.red, c.green, c.blue, c.alpha));
    return number;
  }

  // The same for the same meshes, so that their file is, too.
  std::string uuid(uint64_t which) const {
    const uint64_t high = hash_combine(hash_, which), low = mix64(high);
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%08x-%04x-4%03x-8%03x-%012llx",
                  static_cast<unsigned>(high >> 32), static_cast<unsigned>(high >> 16 & 0xffff),
                  static_cast<unsigned>(high & 0xfff), static_cast<unsigned>(low >> 48 & 0xfff),
                  static_cast<unsigned long long>(low & 0xffffffffffffull));
    return text.data();
  }

  // Replaces the times in an archive by the first day of its calendar.
  static std::string without_times(std::string bytes) {
    constexpr size_t kTimeInHead = 10, kTimeInRecord = 12;
    const auto entries = zip_entries(bytes, "");
    if (!entries) throw std::bad_alloc();
    for (const ZipEntry& entry : *entries) {
      for (const size_t at : {entry.head + kTimeInHead, entry.record + kTimeInRecord})
        store_little(uint32_t{0x00210000}, bytes.data() + at);
    }
    return bytes;
  }

  std::span<const MeshView> meshes_;
  ThreeMf model_, group_;  // the group has the materials of all meshes; null without any
  std::vector<ThreeMf> objects_, items_;
  DWORD group_id_ = 0;
  std::map<std::tuple<const SurfaceLibrary*, uint16_t, std::string>, DWORD> materials_;
  uint64_t hash_ = 0;
};

}  // namespace

void encode_3mf(std::span<const MeshView> meshes, const ByteSink& sink) {
  sink(ThreeMfWriter(meshes).bytes());
}

}  // namespace kerf
