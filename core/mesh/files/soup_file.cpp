#include "core/mesh/files/soup_file.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "core/base/json.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/gltf_surfaces_internal.h"

namespace kerf {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are stored as they are in memory");

constexpr std::string_view kMagic = "kerfmesh";
constexpr uint32_t kFormat = 1;

// Writes members to bytes. Both classes have the same functions, so that one description serves both.
class SoupWriter {
 public:
  template <typename T>
  void number(T& value) {
    append_little(value, bytes);
  }
  template <typename T>
  void numbers(std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T>);
    count(values.size());
    if (!values.empty())
      bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  void text(std::string& value) {
    count(value.size());
    bytes += value;
  }
  template <typename T, typename Describe>
  void list(std::vector<T>& items, const Describe& describe) {
    count(items.size());
    for (T& item : items) describe(*this, item);
  }

  std::string bytes;

 private:
  void count(size_t number) { append_little(uint64_t{number}, bytes); }
};

// Reads members; after a fault it reads zeros.
class SoupReader {
 public:
  explicit SoupReader(std::string_view bytes) : left_(bytes) {}

  bool failed() const { return failed_; }
  bool at_end() const { return left_.empty(); }

  template <typename T>
  void number(T& value) {
    if (!has(1, sizeof(T))) return;
    value = load<T>(left_.data(), std::endian::little);
    left_.remove_prefix(sizeof(T));
  }
  template <typename T>
  void numbers(std::vector<T>& values) {
    const uint64_t count = this->count(sizeof(T));
    if (count == 0) return;
    values.resize(count);
    std::memcpy(values.data(), left_.data(), count * sizeof(T));
    left_.remove_prefix(count * sizeof(T));
  }
  void text(std::string& value) {
    const uint64_t size = count(1);
    value = left_.substr(0, size);
    left_.remove_prefix(size);
  }
  template <typename T, typename Describe>
  void list(std::vector<T>& items, const Describe& describe) {
    const uint64_t size = count(1);
    for (uint64_t i = 0; i < size && !failed_; ++i) describe(*this, items.emplace_back());
  }

 private:
  bool has(uint64_t count, size_t bytes) {
    failed_ = failed_ || count > left_.size() / bytes;
    return !failed_;
  }
  // Reads a count of items, each of at least this number of bytes.
  uint64_t count(size_t bytes) {
    uint64_t count = 0;
    number(count);
    return has(count, bytes) ? count : 0;
  }

  std::string_view left_;
  bool failed_ = false;
};

template <typename F, typename T>
void describe_channel(F& f, LookChannel<T>& channel) {
  f.numbers(channel.values);
  f.numbers(channel.corners);
}

template <typename F>
void describe_looks(F& f, CornerLooks& looks) {
  f.list(looks.uv_sets, [](F& to, auto& set) { describe_channel(to, set); });
  describe_channel(f, looks.normals);
  describe_channel(f, looks.tangents);
  f.list(looks.attributes, [](F& to, LookAttribute& attribute) {
    to.text(attribute.name);
    to.number(attribute.parts);
    describe_channel(to, attribute.channel);
  });
  uint8_t down = looks.v_points_down ? 1 : 0;
  f.number(down);
  looks.v_points_down = down != 0;
}

template <typename F>
void describe_texts(F& f, std::vector<std::string>& texts) {
  f.list(texts, [](F& to, std::string& text) { to.text(text); });
}

template <typename F>
void describe_surfaces(F& f, SurfaceLibrary& library) {
  f.list(library.materials, [](F& to, SurfaceMaterial& material) {
    to.list(material.mtl, [](F& line_to, MtlLine& line) {
      constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
      uint32_t image = line.image.value_or(kNone);
      line_to.text(line.text);
      line_to.number(image);
      if (image != kNone) line.image = image;
    });
    to.text(material.gltf);
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 2; ++row) to.number(material.uv_transform[column][row]);
    }
  });
  f.list(library.images, [](F& to, SurfaceImage& image) {
    for (std::string* text : {&image.name, &image.reference, &image.mime_type, &image.bytes}) to.text(*text);
  });
  describe_texts(f, library.textures);
  describe_texts(f, library.samplers);
  describe_texts(f, library.required_extensions);
}

// Describes everything but the surfaces, of which there may be none.
template <typename F>
void describe_soup(F& f, Soup& soup) {
  f.numbers(soup.positions);
  f.numbers(soup.colours);
  f.numbers(soup.triangles);
  f.numbers(soup.materials);
  describe_texts(f, soup.material_names);
  f.list(soup.parts, [](F& to, MeshPart& part) {
    to.text(part.name);
    to.number(part.first);
    to.number(part.last);
  });
  describe_looks(f, soup.looks);
}

bool is_one_line(const std::string& text) { return text.find_first_of("\r\n") == std::string::npos; }

template <typename T>
bool fits(const LookChannel<T>& channel, size_t triangles) {
  const auto known = [&](uint32_t v) { return v < channel.values.size() || v == LookChannel<T>::kNone; };
  return channel.corners.size() == triangles &&
         std::ranges::all_of(channel.corners, [&](const auto& c) { return std::ranges::all_of(c, known); });
}

bool fits(const CornerLooks& looks, size_t triangles) {
  const auto is_empty_or_fits = [&](const auto& channel) {
    return !channel.any() || fits(channel, triangles);
  };
  const auto fits_set = [&](const auto& set) { return fits(set, triangles); };
  const auto fits_attribute = [&](const LookAttribute& a) {
    return is_one_line(a.name) && a.parts >= 1 && a.parts <= 4 && fits(a.channel, triangles);
  };
  return is_empty_or_fits(looks.normals) && is_empty_or_fits(looks.tangents) &&
         looks.attributes.size() <= kMaxLookAttributes && std::ranges::all_of(looks.uv_sets, fits_set) &&
         std::ranges::all_of(looks.attributes, fits_attribute);
}

// Returns true for a JSON object of the depth that readers of glTF accept.
bool is_json_object(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  return json.is_object() && is_shallow(json);
}

bool is_sound(const SurfaceLibrary& library) {
  const auto is_line = [&](const MtlLine& line) {
    return is_one_line(line.text) && (!line.image || *line.image < library.images.size());
  };
  const auto is_material = [&](const SurfaceMaterial& m) {
    return std::ranges::all_of(m.mtl, is_line) && (m.gltf.empty() || is_json_object(m.gltf));
  };
  const auto is_image = [](const SurfaceImage& image) {
    return is_one_line(image.name) && is_one_line(image.reference) && is_one_line(image.mime_type);
  };
  return std::ranges::all_of(library.materials, is_material) &&
         std::ranges::all_of(library.images, is_image) &&
         std::ranges::all_of(library.textures, is_json_object) &&
         std::ranges::all_of(library.samplers, is_json_object);
}

bool is_sound(const Soup& soup) {
  const size_t triangles = soup.triangles.size(), names = soup.material_names.size();
  const auto is_triangle = [&](const Soup::Triangle& t) {
    return std::max({t[0], t[1], t[2]}) < soup.positions.size();
  };
  const auto is_part = [&](const MeshPart& p) {
    return is_one_line(p.name) && p.first < p.last && p.last <= triangles;
  };
  return (soup.colours.empty() || soup.colours.size() == soup.positions.size()) &&
         (soup.materials.empty() || soup.materials.size() == triangles) &&
         std::ranges::all_of(soup.triangles, is_triangle) &&
         std::ranges::all_of(soup.materials, [&](uint16_t m) { return m < names; }) &&
         std::ranges::all_of(soup.material_names, is_one_line) && std::ranges::all_of(soup.parts, is_part) &&
         fits(soup.looks, triangles) && (!soup.surfaces || is_sound(*soup.surfaces));
}

}  // namespace

std::string encode_soup(const Soup& soup) {
  SoupWriter writer;
  writer.bytes = kMagic;
  uint32_t format = kFormat;
  writer.number(format);
  Soup copy = soup;
  describe_soup(writer, copy);
  std::vector<SurfaceLibrary> surfaces;
  if (soup.surfaces) surfaces.push_back(*soup.surfaces);
  writer.list(surfaces, [](SoupWriter& to, SurfaceLibrary& library) { describe_surfaces(to, library); });
  return std::move(writer.bytes);
}

bool is_soup_file(std::string_view bytes) { return bytes.starts_with(kMagic); }

Result<Soup> read_soup(std::string_view bytes, const std::string& file_name) {
  const Error damaged = bad_input(file_name + ": this is not a complete Kerf mesh; save it again.");
  if (!is_soup_file(bytes)) return damaged;
  SoupReader reader(bytes.substr(kMagic.size()));
  uint32_t format = 0;
  reader.number(format);
  if (format > kFormat)
    return bad_input(file_name + ": this Kerf mesh was saved by a later version of Kerf; update Kerf.");
  Soup soup;
  describe_soup(reader, soup);
  std::vector<SurfaceLibrary> surfaces;
  reader.list(surfaces, [](SoupReader& from, SurfaceLibrary& library) { describe_surfaces(from, library); });
  if (!surfaces.empty()) soup.surfaces = std::make_shared<const SurfaceLibrary>(std::move(surfaces.front()));
  if (reader.failed() || !reader.at_end() || !is_sound(soup)) return damaged;
  soup.format = kSoupFileEnding;
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  if (soup.triangles.empty()) return no_face_left(soup, file_name);
  return soup;
}

}  // namespace kerf
