#include <Model/COM/NMR_DLLInterfaces.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <glm/mat4x4.hpp>
#include <map>
#include <optional>
#include <utility>

#include "core/base/containers.h"
#include "core/base/number_format.h"
#include "core/base/random.h"
#include "core/mesh/files/readers.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/files/three_mf_internal.h"

namespace kerf {

namespace {

constexpr size_t kMaxThreeMfTriangles = 100'000'000;

double metres_of(DWORD unit) {
  constexpr std::array kMetres{1e-6, 1e-3, 1e-2, 0.0254, 0.3048, 1.0};
  return unit < kMetres.size() ? kMetres[unit] : 1e-3;
}

glm::dmat4 matrix_of(const NMR::MODELTRANSFORM& transform) {
  glm::dmat4 matrix(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = transform.m_fFields[row][column];
  }
  return matrix;
}

// Returns a text of lib3mf on one line; empty if there is none. `read` has the arguments (buffer, bytes,
// needed).
template <typename Read>
std::string text_of(const Read& read) {
  ULONG needed = 0;
  if (read(nullptr, 0u, &needed) != 0 || needed == 0) return "";
  std::string text(needed + size_t{1}, '\0');
  if (read(text.data(), static_cast<ULONG>(text.size()), &needed) != 0) return "";
  text.resize(std::min(text.find('\0'), text.size()));
  return one_line(text);
}

std::string fraction_text(uint8_t part) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(part / 255.0));
  return {digits.data(), end.ptr};
}

class ThreeMfReader {
 public:
  ThreeMfReader(const std::string& name, const Progress* progress) : name_(name), progress_(progress) {}

  Result<Soup> read(std::string_view bytes) {
    const auto entries = zip_entries(bytes, name_);
    if (!entries) return entries.error();
    if (const Status fit = check_3mf_entries(*entries, name_); !fit) return fit.error();
    if (const Status parsed = parse(bytes); !parsed) return parsed.error();
    DWORD unit = 1;
    NMR::lib3mf_model_getunit(model_.get(), &unit);
    if (const Status read = read_items(metres_of(unit)); !read) return read.error();
    if (has_textures()) warnings_.emplace_back("Textures of 3MF are not read.");
    return soup();
  }

 private:
  // An object to be placed.
  struct Open {
    ThreeMf object;
    glm::dmat4 to_scene;
    std::string name;  // of the objects that contain it
  };

  static bool report(int, NMR::ProgressIdentifier, void* progress) {
    return static_cast<const Progress*>(progress)->report(0);
  }

  Status parse(std::string_view bytes) {
    model_ = three_mf_object(NMR::lib3mf_createmodel);
    const ThreeMf reader =
        model_ ? three_mf_object(NMR::lib3mf_model_queryreader, model_.get(), "3mf") : nullptr;
    if (!reader) return failed(name_ + ": lib3mf cannot be used.");
    if (progress_)
      NMR::lib3mf_reader_setprogresscallback(reader.get(), report, const_cast<Progress*>(progress_));
    auto* const data = reinterpret_cast<BYTE*>(const_cast<char*>(bytes.data()));
    if (NMR::lib3mf_reader_readfrombuffer(reader.get(), data, bytes.size()) != 0) {
      if (progress_ && !progress_->report(0)) return cancelled();
      DWORD code = 0;
      LPCSTR message = nullptr;
      NMR::lib3mf_getlasterror(reader.get(), &code, &message);
      std::string why = message ? one_line(message) : "";
      while (why.ends_with('.')) why.pop_back();
      return bad_input(name_ + ": this is not a usable 3MF file" + (why.empty() ? "" : ": " + why) + ".");
    }
    record_irregularities(reader.get());
    return Done{};
  }

  // lib3mf drops malformed elements with a warning.
  void record_irregularities(void** reader) {
    DWORD count = 0;
    if (NMR::lib3mf_reader_getwarningcount(reader, &count) != 0 || count == 0) return;
    const std::string first = text_of([&](char* to, ULONG bytes, ULONG* needed) {
      DWORD code = 0;
      return NMR::lib3mf_reader_getwarningutf8(reader, 0, &code, to, bytes, needed);
    });
    warnings_.push_back("The 3MF file has " + count_text(count, "irregular element") +
                        (first.empty() ? "" : "; the first one: " + first) + ".");
  }

  bool has_textures() const {
    const ThreeMf textures = three_mf_object(NMR::lib3mf_model_get2dtextures, model_.get());
    BOOL any = 0;
    return textures && NMR::lib3mf_resourceiterator_movenext(textures.get(), &any) == 0 && any != 0;
  }

  Error broken() const { return bad_input(name_ + ": the objects of the 3MF file cannot be read."); }

  Status read_items(double metres) {
    const ThreeMf items = three_mf_object(NMR::lib3mf_model_getbuilditems, model_.get());
    BOOL more = 0;
    while (items && NMR::lib3mf_builditemiterator_movenext(items.get(), &more) == 0 && more != 0) {
      const ThreeMf item = three_mf_object(NMR::lib3mf_builditemiterator_getcurrent, items.get());
      ThreeMf object = item ? three_mf_object(NMR::lib3mf_builditem_getobjectresource, item.get()) : nullptr;
      if (!object) return broken();
      NMR::MODELTRANSFORM transform{};
      BOOL moved = 0;
      NMR::lib3mf_builditem_hasobjecttransform(item.get(), &moved);
      glm::dmat4 to_scene(1);
      if (moved != 0 && NMR::lib3mf_builditem_getobjecttransform(item.get(), &transform) == 0)
        to_scene = matrix_of(transform);
      for (int k = 0; k < 3; ++k) {
        for (int column = 0; column < 4; ++column) to_scene[column][k] *= metres;
      }
      open_.push_back({std::move(object), to_scene, ""});
      while (!open_.empty()) {
        if (const Status placed = place_next(); !placed) return placed;
      }
    }
    return Done{};
  }

  // Places the last open object: its mesh, or its components, which are opened.
  Status place_next() {
    Open next = std::move(open_.back());
    open_.pop_back();
    if (++objects_ > kMaxThreeMfObjects) return bad_input(name_ + ": the 3MF file has too many components.");
    std::string own = text_of([&](char* to, ULONG bytes, ULONG* needed) {
      return NMR::lib3mf_object_getnameutf8(next.object.get(), to, bytes, needed);
    });
    if (!own.empty()) next.name = std::move(own);
    BOOL is_mesh = 0, is_group = 0;
    NMR::lib3mf_object_ismeshobject(next.object.get(), &is_mesh);
    NMR::lib3mf_object_iscomponentsobject(next.object.get(), &is_group);
    if (is_mesh != 0) return place_mesh(next);
    return is_group != 0 ? open_components(next) : Status(Done{});
  }

  Status open_components(const Open& group) {
    DWORD count = 0;
    NMR::lib3mf_componentsobject_getcomponentcount(group.object.get(), &count);
    for (DWORD i = count; i-- > 0;) {
      const ThreeMf part = three_mf_object(NMR::lib3mf_componentsobject_getcomponent, group.object.get(), i);
      ThreeMf object = part ? three_mf_object(NMR::lib3mf_component_getobjectresource, part.get()) : nullptr;
      if (!object) return broken();
      NMR::MODELTRANSFORM transform{};
      BOOL moved = 0;
      NMR::lib3mf_component_hastransform(part.get(), &moved);
      const bool known = moved != 0 && NMR::lib3mf_component_gettransform(part.get(), &transform) == 0;
      const glm::dmat4 own = known ? matrix_of(transform) : glm::dmat4(1);
      open_.push_back({std::move(object), group.to_scene * own, group.name});
      if (open_.size() > kMaxThreeMfObjects)
        return bad_input(name_ + ": the 3MF file has too many components.");
    }
    return Done{};
  }

  Status place_mesh(const Open& mesh) {
    DWORD vertex_count = 0, triangle_count = 0;
    NMR::lib3mf_meshobject_getvertexcount(mesh.object.get(), &vertex_count);
    NMR::lib3mf_meshobject_gettrianglecount(mesh.object.get(), &triangle_count);
    if (triangle_count > kMaxThreeMfTriangles - polygons_.size() ||
        positions_.size() + vertex_count > 3 * kMaxThreeMfTriangles)
      return bad_input(name_ + ": exceeds the maximum number of faces per 3MF file.");
    DWORD beams = 0;
    NMR::lib3mf_meshobject_getbeamcount(mesh.object.get(), &beams);
    if (beams != 0 && !std::exchange(has_beams_, true))
      warnings_.emplace_back("Beam lattices of 3MF are not read.");
    if (triangle_count == 0) return Done{};
    std::vector<NMR::MODELMESHVERTEX> vertices(vertex_count);
    std::vector<NMR::MODELMESHTRIANGLE> triangles(triangle_count);
    if (NMR::lib3mf_meshobject_getvertices(mesh.object.get(), vertices.data(), vertex_count, nullptr) != 0 ||
        NMR::lib3mf_meshobject_gettriangleindices(mesh.object.get(), triangles.data(), triangle_count,
                                                  nullptr) != 0)
      return broken();
    const size_t first = positions_.size();
    for (const NMR::MODELMESHVERTEX& v : vertices) {
      const glm::dvec4 at(v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2], 1);
      positions_.emplace_back(mesh.to_scene * at);
    }
    polygons_.begin_parts(PolygonList::Level::kObject, {mesh.name});
    const Properties properties = properties_of(mesh.object.get(), triangle_count);
    const bool mirrors = glm::determinant(glm::dmat3(mesh.to_scene)) < 0;
    copies_.clear();
    for (size_t t = 0; t < triangles.size(); ++t) {
      if (t % (size_t{1} << 20) == 0 && progress_ && !progress_->report(0)) return cancelled();
      std::array<int64_t, 3> corners;
      for (size_t i = 0; i < 3; ++i) {
        const DWORD v = triangles[t].m_nIndices[i];
        corners[i] = v < vertex_count ? static_cast<int64_t>(first + v) : -1;
        if (!properties.colours.empty() && corners[i] >= 0)
          corners[i] = coloured(static_cast<size_t>(corners[i]), properties.colours[t].m_Colors[i]);
      }
      if (mirrors) std::swap(corners[1], corners[2]);
      for (const int64_t corner : corners) polygons_.add_corner(corner);
      polygons_.close(properties.materials.empty() ? no_material() : properties.materials[t]);
    }
    return Done{};
  }

  // Materials and colours by triangle; empty if the mesh has none.
  struct Properties {
    std::vector<uint16_t> materials;
    std::vector<NMR::MODELMESH_TRIANGLECOLOR_SRGB> colours;
  };

  Properties properties_of(void** mesh, size_t count) {
    Properties properties;
    const ThreeMf handler = three_mf_object(NMR::lib3mf_meshobject_createpropertyhandler, mesh);
    if (!handler) return properties;
    std::vector<DWORD> groups(count, 0), indices(count, 0);
    if (NMR::lib3mf_propertyhandler_getbasematerialarray(handler.get(), groups.data(), indices.data()) == 0) {
      const bool any = std::any_of(groups.begin(), groups.end(), [](DWORD group) { return group != 0; });
      for (size_t t = 0; any && t < count; ++t)
        properties.materials.push_back(groups[t] == 0 ? no_material() : material(groups[t], indices[t]));
    }
    properties.colours.resize(count);
    const auto has_colour = [](const NMR::MODELMESH_TRIANGLECOLOR_SRGB& colour) {
      return std::any_of(std::begin(colour.m_Colors), std::end(colour.m_Colors), is_set);
    };
    if (NMR::lib3mf_propertyhandler_getcolorarray(handler.get(), properties.colours.data()) != 0 ||
        std::none_of(properties.colours.begin(), properties.colours.end(), has_colour))
      properties.colours.clear();
    return properties;
  }

  static bool is_set(const NMR::MODELMESHCOLOR_SRGB& c) {
    return c.m_Red != 0 || c.m_Green != 0 || c.m_Blue != 0 || c.m_Alpha != 0;
  }

  // Returns a position of the colour at a position, a copy if that already has another colour.
  int64_t coloured(size_t position, const NMR::MODELMESHCOLOR_SRGB& c) {
    if (!is_set(c)) return static_cast<int64_t>(position);
    VertexColour colour;
    const std::array<BYTE, 4> parts{c.m_Red, c.m_Green, c.m_Blue, c.m_Alpha};
    for (size_t k = 0; k < 4; ++k) colour.part[k] = static_cast<uint16_t>(257 * parts[k]);
    const uint64_t key = uint64_t{position} << 32 | uint64_t{parts[0]} << 24 | uint64_t{parts[1]} << 16 |
                         uint64_t{parts[2]} << 8 | parts[3];
    const auto [known, added] = copies_.try_emplace(key, position);
    if (!added) return static_cast<int64_t>(known->second);
    const auto [owner, is_first] = owners_.try_emplace(position, key);
    if (!is_first) {
      known->second = positions_.size();
      positions_.push_back(Vec3(positions_[position]));
    }
    colours_.resize(std::max(colours_.size(), known->second + 1));
    colours_[known->second] = colour;
    return static_cast<int64_t>(known->second);
  }

  uint16_t no_material() {
    return number_of({0, 0}, [] { return std::pair(std::string(), SurfaceMaterial()); });
  }

  uint16_t material(DWORD group, DWORD index) {
    return number_of({group, index}, [&] {
      std::pair<std::string, SurfaceMaterial> found;
      const ThreeMf materials = three_mf_object(NMR::lib3mf_model_getbasematerialbyid, model_.get(), group);
      if (!materials) return found;
      found.first = text_of([&](char* to, ULONG bytes, ULONG* needed) {
        return NMR::lib3mf_basematerial_getnameutf8(materials.get(), index, to, bytes, needed);
      });
      std::array<BYTE, 4> c{};
      if (NMR::lib3mf_basematerial_getdisplaycolor(materials.get(), index, &c[0], &c[1], &c[2], &c[3]) != 0)
        return found;
      found.second.mtl.push_back(
          {"Kd " + fraction_text(c[0]) + " " + fraction_text(c[1]) + " " + fraction_text(c[2])});
      if (c[3] != 255) found.second.mtl.push_back({"d " + fraction_text(c[3])});
      described_ = true;
      return found;
    });
  }

  // Returns the number of a material of the file, which `describe` reads if it is new.
  template <typename Describe>
  uint16_t number_of(const std::pair<DWORD, DWORD>& key, const Describe& describe) {
    const auto [known, added] = numbers_.try_emplace(key, uint16_t{0});
    constexpr size_t kMaxMaterials = std::numeric_limits<uint16_t>::max();
    if (added && material_names_.size() < kMaxMaterials) {
      known->second = static_cast<uint16_t>(material_names_.size());
      auto [name, surface] = describe();
      material_names_.push_back(std::move(name));
      library_->materials.push_back(std::move(surface));
    }
    return known->second;
  }

  Result<Soup> soup() {
    Result<Soup> soup = polygons_.to_soup(std::move(positions_), name_);
    if (!soup) return soup;
    if (!colours_.empty()) colours_.resize(soup->positions.size());
    soup->colours = std::move(colours_);
    soup->material_names = std::move(material_names_);
    if (soup->material_names.size() == 1 && soup->material_names[0].empty()) soup->material_names.clear();
    if (described_) soup->surfaces = library_;
    soup->format = "3mf";
    soup->warnings = std::move(warnings_);
    return soup;
  }

  std::string name_;
  const Progress* progress_;
  ThreeMf model_;
  std::vector<Open> open_;
  size_t objects_ = 0;
  std::vector<Vec3> positions_;
  std::vector<VertexColour> colours_;  // by position, up to the last coloured one
  std::map<uint64_t, size_t> copies_;  // of the current mesh: by position and colour
  std::map<size_t, uint64_t> owners_;  // by position: its first colour
  PolygonList polygons_;
  std::map<std::pair<DWORD, DWORD>, uint16_t> numbers_;  // by group and index in it; group 0: no material
  std::vector<std::string> material_names_, warnings_;
  std::shared_ptr<SurfaceLibrary> library_ = std::make_shared<SurfaceLibrary>();
  bool described_ = false, has_beams_ = false;
};

}  // namespace

Result<Soup> read_3mf(std::string_view bytes, const std::string& file_name, const Progress* progress) {
  return ThreeMfReader(one_line(file_name), progress).read(bytes);
}

}  // namespace kerf
