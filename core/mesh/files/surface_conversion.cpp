#include "core/mesh/files/surface_conversion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "core/base/geometry.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/surface_look.h"
#include "core/mesh/files/vertex_colour.h"

namespace kerf {

namespace {

using SurfaceJson = nlohmann::ordered_json;

// A number of a material, rounded to hide the error of converting it there and back.
std::string short_number(double x) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), static_cast<float>(x)).ptr;
  return {digits.data(), end};
}

// Returns the finite numbers with which a text begins.
std::vector<double> leading_numbers(std::string_view text) {
  std::vector<double> found;
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
    const size_t end = std::min(text.find_first_of(" \t"), text.size());
    const auto number = parse_number(text.substr(0, end));
    if (!number || !std::isfinite(*number)) break;
    found.push_back(*number);
    text.remove_prefix(end);
  }
  return found;
}

// The statements of a material in MTL that glTF can express.
class MtlStatements {
 public:
  explicit MtlStatements(const SurfaceMaterial& material) : material_(material) {}

  std::optional<double> number(std::string_view keyword) const {
    const auto all = numbers(keyword);
    return all.empty() ? std::nullopt : std::optional(all[0]);
  }
  std::optional<Vec3> colour(std::string_view keyword) const {
    const auto all = numbers(keyword);
    if (all.empty()) return std::nullopt;
    if (all.size() < 3) return Vec3(all[0]);
    return Vec3(all[0], all[1], all[2]);
  }
  // Return the maps that glTF can express; null if there is none.
  const MtlLine* base_map() const { return map({"map_Kd"}); }
  const MtlLine* normal_map() const { return map({"norm", "map_Bump", "bump"}); }
  const MtlLine* emission_map() const { return map({"map_Ke"}); }
  // Returns the one of these that has the kind of a line; null if there is none.
  const MtlLine* map_like(const MtlLine& line) const {
    if (is_of(line, "map_Kd")) return base_map();
    if (is_of(line, "map_Ke")) return emission_map();
    return is_of(line, "norm") || is_of(line, "map_Bump") || is_of(line, "bump") ? normal_map() : nullptr;
  }

 private:
  const MtlLine* map(std::initializer_list<std::string_view> keywords) const {
    for (const std::string_view keyword : keywords) {
      for (const MtlLine& line : material_.mtl) {
        if (line.image && is_of(line, keyword)) return &line;
      }
    }
    return nullptr;
  }

  static bool is_of(const MtlLine& line, std::string_view keyword) {
    const std::string_view text = line.text;
    if (text.size() <= keyword.size() || (text[keyword.size()] != ' ' && text[keyword.size()] != '\t'))
      return false;
    const auto low = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::equal(keyword.begin(), keyword.end(), text.begin(),
                      [&](char a, char b) { return low(a) == low(b); });
  }

  std::vector<double> numbers(std::string_view keyword) const {
    for (const MtlLine& line : material_.mtl) {
      if (line.image || !is_of(line, keyword)) continue;
      std::vector<double> found = leading_numbers(std::string_view(line.text).substr(keyword.size()));
      if (!found.empty()) return found;
    }
    return {};
  }

  const SurfaceMaterial& material_;
};

// Returns true for the kinds of images that glTF holds without an extension.
bool is_gltf_image(const SurfaceImage& image) {
  return image.mime_type == "image/png" || image.mime_type == "image/jpeg";
}

// Returns a material that the file only names. It is not metallic, unlike the default of glTF.
SurfaceJson undescribed_material() { return {{"pbrMetallicRoughness", {{"metallicFactor", 0}}}}; }

// Collects the materials of one glTF file.
class GltfCollection {
 public:
  explicit GltfCollection(MissingImages missing) : missing_(missing) {}

  // Precondition: the library has the material.
  SurfaceJson material(const SurfaceLibrary& library, uint16_t number) {
    library_ = &library;
    for (const std::string& name : library.required_extensions) required_.insert(name);
    const SurfaceMaterial& material = library.materials[number];
    return material.gltf.empty() ? from_mtl(material) : from_gltf(material);
  }

  void finish(GltfSurfaces& out) {
    out.textures = std::move(textures_);
    out.samplers = std::move(samplers_);
    out.images = std::move(images_);
    out.sources = std::move(sources_);
    out.used_extensions.assign(extensions_.begin(), extensions_.end());
    for (const std::string& name : required_) {
      if (extensions_.contains(name)) out.required_extensions.push_back(name);
    }
  }

 private:
  static bool is_texture_key(std::string_view key) { return key.ends_with("exture"); }

  // Renumbers the textures of a material and records its extensions. The depth of the JSON was checked on
  // reading.
  void renumber(SurfaceJson& json) {
    if (json.is_array()) {
      for (SurfaceJson& item : json) renumber(item);
    }
    if (!json.is_object()) return;
    std::vector<std::string> lost;
    for (auto& [key, value] : json.items()) {
      if (key == "extensions" && value.is_object()) {
        for (auto& extension : value.items()) extensions_.insert(extension.key());
      }
      if (is_texture_key(key) && value.is_object() && value.contains("index")) {
        const auto own = texture(value["index"]);
        if (!own) {
          lost.push_back(key);
          continue;
        }
        value["index"] = *own;
      }
      renumber(value);
    }
    for (const std::string& key : lost) json.erase(key);
  }

  std::optional<size_t> texture(const SurfaceJson& index) {
    if (!index.is_number_unsigned() || index.get<uint64_t>() >= library_->textures.size())
      return std::nullopt;
    const Source from{library_, index.get<size_t>()};
    if (const auto known = texture_numbers_.find(from); known != texture_numbers_.end()) return known->second;
    SurfaceJson json = SurfaceJson::parse(library_->textures[from.second], nullptr, false);
    if (!json.is_object() || !renumber_sources(json)) return std::nullopt;
    if (json.contains("sampler")) {
      const auto own = sampler(json["sampler"]);
      if (own) json["sampler"] = *own;
      if (!own) json.erase("sampler");
    }
    textures_.push_back(std::move(json));
    texture_numbers_[from] = textures_.size() - 1;
    return textures_.size() - 1;
  }

  // Renumbers the image of a texture, and those of its extensions. Returns false if it has no image.
  bool renumber_sources(SurfaceJson& json) {
    bool any = false;
    const auto replace = [&](SurfaceJson& of) {
      if (!of.is_object() || !of.contains("source")) return;
      const SurfaceJson& source = of["source"];
      const bool fits = source.is_number_unsigned() && source.get<uint64_t>() < library_->images.size();
      const auto own = fits ? image(source.get<uint32_t>()) : std::nullopt;
      any = any || own;
      if (own) of["source"] = *own;
      if (!own) of.erase("source");
    };
    replace(json);
    if (json.contains("extensions") && json["extensions"].is_object()) {
      for (auto& [name, extension] : json["extensions"].items()) {
        extensions_.insert(name);
        replace(extension);
      }
    }
    return any;
  }

  std::optional<size_t> sampler(const SurfaceJson& index) {
    if (!index.is_number_unsigned() || index.get<uint64_t>() >= library_->samplers.size())
      return std::nullopt;
    const Source from{library_, index.get<size_t>()};
    const auto [known, added] = sampler_numbers_.try_emplace(from, samplers_.size());
    if (added) samplers_.push_back(SurfaceJson::parse(library_->samplers[from.second], nullptr, false));
    return known->second;
  }

  std::optional<size_t> image(uint32_t from) {
    const SurfaceImage& image = library_->images[from];
    if (image.bytes.empty() && missing_ == MissingImages::kLeaveOut) return std::nullopt;
    const auto [known, added] = image_numbers_.try_emplace(&image, images_.size());
    if (added) {
      SurfaceJson json{{"name", image.name}};
      if (!image.mime_type.empty()) json["mimeType"] = image.mime_type;
      images_.push_back(std::move(json));
      sources_.push_back(&image);
    }
    return known->second;
  }

  SurfaceJson from_gltf(const SurfaceMaterial& material) {
    SurfaceJson json = SurfaceJson::parse(material.gltf, nullptr, false);
    if (!json.is_object()) return SurfaceJson::object();
    renumber(json);
    return json;
  }

  std::optional<SurfaceJson> texture_of_image(std::optional<uint32_t> from) {
    const bool fits = from && (missing_ == MissingImages::kKeep || is_gltf_image(library_->images[*from]));
    const auto own = fits ? image(*from) : std::nullopt;
    if (!own) return std::nullopt;
    const auto [known, added] = textures_of_images_.try_emplace(*own, textures_.size());
    if (added) textures_.push_back({{"source", *own}});
    return SurfaceJson{{"index", known->second}};
  }

  // Likewise for a map in MTL, null for none, with its transform of the UVs, which does not rotate.
  std::optional<SurfaceJson> texture_of_map(const MtlLine* line) {
    std::optional<SurfaceJson> map = line ? texture_of_image(line->image) : std::nullopt;
    if (!map) return map;
    const glm::mat3x2 uv = read_map_transform(*line);
    if (uv == SurfaceMaterial().uv_transform) return map;
    (*map)["extensions"]["KHR_texture_transform"] = {{"offset", {uv[2].x, uv[2].y}},
                                                     {"scale", {uv[0].x, uv[1].y}}};
    extensions_.insert("KHR_texture_transform");
    return map;
  }

  std::optional<SurfaceJson> normal_texture(const MtlLine* line) {
    std::optional<SurfaceJson> map = texture_of_map(line);
    const double scale = map ? read_normal_scale(*line) : 1;
    if (scale != 1) (*map)["scale"] = scale;
    return map;
  }

  // Kd is a colour in sRGB that multiplies its map. Ns becomes the roughness as in Blender.
  SurfaceJson from_mtl(const SurfaceMaterial& material) {
    const MtlStatements mtl(material);
    SurfaceJson json = SurfaceJson::object(), pbr = SurfaceJson::object();
    if (material.mtl.empty()) return undescribed_material();
    const Vec3 colour = mtl.colour("Kd").value_or(Vec3(1));
    const double opacity = std::clamp(mtl.number("d").value_or(1 - mtl.number("Tr").value_or(0)), 0.0, 1.0);
    pbr["baseColorFactor"] = {srgb_to_linear(colour.x), srgb_to_linear(colour.y), srgb_to_linear(colour.z),
                              opacity};
    if (auto map = texture_of_map(mtl.base_map())) pbr["baseColorTexture"] = *map;
    const double exponent = std::clamp(mtl.number("Ns").value_or(0), 0.0, 1000.0);
    pbr["metallicFactor"] = std::clamp(mtl.number("Pm").value_or(0), 0.0, 1.0);
    pbr["roughnessFactor"] = std::clamp(mtl.number("Pr").value_or(1 - std::sqrt(exponent / 1000)), 0.0, 1.0);
    json["pbrMetallicRoughness"] = std::move(pbr);
    if (auto map = normal_texture(mtl.normal_map())) json["normalTexture"] = *map;
    const auto emission = mtl.colour("Ke");
    auto emissive = texture_of_map(mtl.emission_map());
    if (emission && *emission != Vec3(0)) {
      json["emissiveFactor"] = {srgb_to_linear(emission->x), srgb_to_linear(emission->y),
                                srgb_to_linear(emission->z)};
    } else if (emissive) {
      json["emissiveFactor"] = {1, 1, 1};
    }
    if (emissive) json["emissiveTexture"] = *emissive;
    if (opacity < 1) json["alphaMode"] = "BLEND";
    return json;
  }

  using Source = std::pair<const SurfaceLibrary*, size_t>;

  MissingImages missing_;
  const SurfaceLibrary* library_ = nullptr;  // of the current material
  SurfaceJson textures_ = SurfaceJson::array(), samplers_ = SurfaceJson::array(),
              images_ = SurfaceJson::array();
  std::vector<const SurfaceImage*> sources_;
  std::map<Source, size_t> texture_numbers_, sampler_numbers_;
  std::map<size_t, size_t> textures_of_images_;
  std::map<const SurfaceImage*, size_t> image_numbers_;
  std::set<std::string> extensions_, required_;
};

// Returns a number of an object of glTF; 0 if there is none.
double json_number(const SurfaceJson& of, const char* key) {
  if (!of.is_object() || !of.contains(key) || !of[key].is_number()) return 0;
  return of[key].get<double>();
}

// Reads members of a material in glTF.
class GltfMembers {
 public:
  GltfMembers(const SurfaceLibrary& library, const SurfaceJson& json) : library_(library), json_(json) {}

  std::vector<double> numbers(const SurfaceJson& of, const char* key) const {
    std::vector<double> found;
    if (!of.is_object() || !of.contains(key)) return found;
    const SurfaceJson& value = of[key];
    if (value.is_number()) return {value.get<double>()};
    for (const SurfaceJson& item : value) {
      if (item.is_number()) found.push_back(item.get<double>());
    }
    return found;
  }
  // Returns the image of a texture that uses the first UVs.
  std::optional<uint32_t> image(const SurfaceJson& of, const char* key) const {
    if (!of.is_object() || !of.contains(key) || !of[key].is_object()) return std::nullopt;
    if (!uses_first_uvs(of[key])) return std::nullopt;
    const auto index = whole(of[key], "index");
    if (!index || *index >= library_.textures.size()) return std::nullopt;
    const auto texture = SurfaceJson::parse(library_.textures[*index], nullptr, false);
    auto source = whole(texture, "source");
    if (!source && texture.is_object() && texture.contains("extensions")) {
      for (const SurfaceJson& extension : texture["extensions"]) {
        if (!source) source = whole(extension, "source");
      }
    }
    if (!source || *source >= library_.images.size()) return std::nullopt;
    return static_cast<uint32_t>(*source);
  }
  const SurfaceJson& object(const char* key) const {
    static const SurfaceJson kNothing = SurfaceJson::object();
    return json_.contains(key) ? json_[key] : kNothing;
  }

 private:
  static std::optional<uint64_t> whole(const SurfaceJson& of, const char* key) {
    if (!of.is_object() || !of.contains(key) || !of[key].is_number_unsigned()) return std::nullopt;
    return of[key].get<uint64_t>();
  }

  const SurfaceLibrary& library_;
  const SurfaceJson& json_;
};

// Returns true if the emissive factor of a material is not zero, its default, which makes its texture black.
bool glows(const SurfaceJson& material) {
  if (!material.contains("emissiveFactor") || !material["emissiveFactor"].is_array()) return false;
  return std::ranges::any_of(material["emissiveFactor"], [](const SurfaceJson& part) {
    return part.is_number() && part.get<double>() > 0;
  });
}

std::string colour_line(const char* keyword, const std::vector<double>& linear) {
  std::string line = keyword;
  for (size_t k = 0; k < 3; ++k)
    line += " " + short_number(linear_to_srgb(k < linear.size() ? linear[k] : 1));
  return line;
}

// Returns the options of a map in MTL for the transform of a texture, with three numbers each because some
// readers expect them; none for a rotation, which MTL cannot state.
std::string transform_options(const SurfaceJson& texture) {
  const glm::mat3x2 uv = read_map_transform(texture);
  if (uv == SurfaceMaterial().uv_transform || uv[0].y != 0 || uv[1].x != 0) return "";
  const double bottom = 1.0 - static_cast<double>(uv[1].y) - static_cast<double>(uv[2].y);
  return "-s " + short_number(uv[0].x) + " " + short_number(uv[1].y) + " 1 -o " + short_number(uv[2].x) +
         " " + short_number(bottom) + " 0 ";
}

// Returns the option of a normal map in MTL for the scale of a texture.
std::string scale_option(const SurfaceJson& texture) {
  if (!texture.is_object() || !texture.contains("scale") || !texture["scale"].is_number()) return "";
  const auto scale = texture["scale"].get<float>();
  return scale == 1 || !std::isfinite(scale) ? "" : "-bm " + short_number(scale) + " ";
}

}  // namespace

nlohmann::ordered_json metallic_roughness(const nlohmann::ordered_json& material) {
  SurfaceJson pbr = SurfaceJson::object();
  if (!material.is_object()) return pbr;
  if (material.contains("pbrMetallicRoughness")) return material["pbrMetallicRoughness"];
  const auto extensions = material.find("extensions");
  if (extensions == material.end() || !extensions->is_object()) return pbr;
  const auto from = extensions->find("KHR_materials_pbrSpecularGlossiness");
  if (from == extensions->end() || !from->is_object()) return pbr;
  if (from->contains("diffuseFactor")) pbr["baseColorFactor"] = (*from)["diffuseFactor"];
  if (from->contains("diffuseTexture")) pbr["baseColorTexture"] = (*from)["diffuseTexture"];
  const auto gloss = from->find("glossinessFactor");
  pbr["metallicFactor"] = 0;
  pbr["roughnessFactor"] = gloss != from->end() && gloss->is_number() ? 1 - gloss->get<double>() : 0.0;
  return pbr;
}

std::vector<MtlLine> mtl_lines(const SurfaceLibrary& library, const SurfaceMaterial& material) {
  if (material.gltf.empty()) return material.mtl;
  std::vector<MtlLine> lines;
  const auto json = SurfaceJson::parse(material.gltf, nullptr, false);
  if (!json.is_object()) return lines;
  const GltfMembers members(library, json);
  const SurfaceJson pbr = metallic_roughness(json);
  const auto base = members.numbers(pbr, "baseColorFactor");
  const auto metallic = members.numbers(pbr, "metallicFactor"),
             rough = members.numbers(pbr, "roughnessFactor");
  const SurfaceJson& alpha = members.object("alphaMode");
  const bool translucent = alpha == "MASK" || alpha == "BLEND";
  const double roughness = rough.empty() ? 1 : std::clamp(rough[0], 0.0, 1.0);
  lines.push_back({colour_line("Kd", base)});
  lines.push_back({"Ns " + short_number(1000 * (1 - roughness) * (1 - roughness))});
  lines.push_back({"d " + short_number(translucent && base.size() > 3 ? base[3] : 1)});
  lines.push_back({"Pr " + short_number(roughness)});
  lines.push_back({"Pm " + short_number(metallic.empty() ? 1 : metallic[0])});
  // Without its map the factor would light the whole surface.
  if (const auto emission = members.numbers(json, "emissiveFactor");
      !emission.empty() && uses_first_uvs(members.object("emissiveTexture")))
    lines.push_back({colour_line("Ke", emission)});
  const auto add_map = [&](const std::string& text, const SurfaceJson& of, const char* key) {
    const auto image = members.image(of, key);
    if (image) lines.push_back({text + transform_options(of[key]), image});
  };
  add_map("map_Kd ", pbr, "baseColorTexture");
  if (translucent) add_map("map_d ", pbr, "baseColorTexture");
  if (glows(json)) add_map("map_Ke ", json, "emissiveTexture");
  add_map("norm " + scale_option(members.object("normalTexture")), json, "normalTexture");
  return lines;
}

GltfSurfaces gltf_surfaces(std::span<const GltfMaterial> materials, MissingImages missing) {
  GltfSurfaces out;
  GltfCollection collection(missing);
  out.materials = SurfaceJson::array();
  for (const auto& [library, number, name] : materials) {
    const bool known = library && number < library->materials.size();
    SurfaceJson material = known ? collection.material(*library, number) : undescribed_material();
    SurfaceJson named = SurfaceJson::object();
    if (!name.empty()) named["name"] = std::string(name);
    for (auto& [key, value] : material.items()) {
      if (key != "name") named[key] = std::move(value);
    }
    out.materials.push_back(std::move(named));
  }
  collection.finish(out);
  return out;
}

namespace {

// Returns the sampler of a texture of a material in glTF, an empty object if there is none.
SurfaceJson sampler_of(const SurfaceLibrary& library, const SurfaceJson& texture) {
  const auto item = [](const SurfaceJson& of, const char* key, const std::vector<std::string>& texts) {
    const bool known = of.is_object() && of.contains(key) && of[key].is_number_unsigned() &&
                       of[key].get<uint64_t>() < texts.size();
    return known ? SurfaceJson::parse(texts[of[key].get<size_t>()], nullptr, false) : SurfaceJson::object();
  };
  return item(item(texture, "index", library.textures), "sampler", library.samplers);
}

// Adds the members of a texture in glTF, and of its sampler, that MTL cannot express.
void add_lost_of_texture(const SurfaceLibrary& library, const std::string& key, const SurfaceJson& texture,
                         std::set<std::string>& lost) {
  const char* const kTransform = "KHR_texture_transform";
  if (!texture.is_object()) return;
  if (!uses_first_uvs(texture)) {
    lost.insert(key + " texCoord");
    return;
  }
  constexpr double kRepeat = 10497;
  const SurfaceJson sampler = sampler_of(library, texture);
  for (const char* const wrap : {"wrapS", "wrapT"}) {
    if (sampler.is_object() && sampler.contains(wrap) && json_number(sampler, wrap) != kRepeat)
      lost.insert(key + " " + wrap);
  }
  if (texture.contains("extensions") && texture["extensions"].is_object() &&
      texture["extensions"].contains(kTransform) &&
      json_number(texture["extensions"][kTransform], "rotation") != 0) {
    lost.insert(kTransform);
  }
}

}  // namespace

std::vector<std::string> lost_in_mtl(const SurfaceLibrary& library, const SurfaceMaterial& material) {
  std::set<std::string> lost;
  const auto json = SurfaceJson::parse(material.gltf, nullptr, false);
  if (!json.is_object()) return {};
  const auto add = [&](const SurfaceJson& of, const std::set<std::string>& kept) {
    for (const auto& [key, value] : of.items()) {
      if (key == "extensions" && value.is_object()) {
        for (const auto& extension : value.items()) lost.insert(extension.key());
      } else if (!kept.contains(key)) {
        lost.insert(key);
      } else if (key.ends_with("Texture")) {
        add_lost_of_texture(library, key, value, lost);
      }
    }
  };
  add(json,
      {"name", "pbrMetallicRoughness", "normalTexture", "emissiveTexture", "emissiveFactor", "alphaMode"});
  if (json.contains("pbrMetallicRoughness") && json["pbrMetallicRoughness"].is_object()) {
    add(json["pbrMetallicRoughness"],
        {"baseColorFactor", "baseColorTexture", "metallicFactor", "roughnessFactor"});
  }
  if (json.contains("emissiveTexture") && !glows(json)) lost.insert("emissiveTexture without emissiveFactor");
  return {lost.begin(), lost.end()};
}

namespace {

std::string mtl_keyword(const MtlLine& line) { return line.text.substr(0, line.text.find_first_of(" \t")); }

std::string lower_case(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return text;
}

// Returns true for the values that Blender writes for every material unless its user changed them.
bool is_default_of_exporter(std::string_view keyword, const std::vector<double>& values) {
  if (keyword == "ka") return values == std::vector<double>{1, 1, 1};
  if (keyword == "ks") return values == std::vector<double>{0.5, 0.5, 0.5};
  return keyword == "ni" && (values == std::vector<double>{1.45} || values == std::vector<double>{1.5});
}

// Adds the keywords of the statements in MTL, other than maps, comments and defaults, that are not among
// those kept.
void add_lost_statements(const SurfaceMaterial& material, std::span<const std::string_view> kept,
                         std::set<std::string>& lost) {
  for (const MtlLine& line : material.mtl) {
    const std::string keyword = mtl_keyword(line);
    if (line.image || keyword.starts_with('#')) continue;
    const std::string folded = lower_case(keyword);
    if (std::ranges::find(kept, folded) != kept.end()) continue;
    const std::vector<double> values = leading_numbers(std::string_view(line.text).substr(keyword.size()));
    if (!is_default_of_exporter(folded, values)) lost.insert(keyword);
  }
}

// Returns true if two lines have the same image with the same options, as in files for several readers.
bool are_equal_maps(const MtlLine& a, const MtlLine& b) {
  return a.image == b.image && a.text.substr(mtl_keyword(a).size()) == b.text.substr(mtl_keyword(b).size());
}

// Adds the options of a map in MTL that glTF cannot express.
void add_lost_options(const MtlLine& map, bool is_normal_map, std::set<std::string>& lost) {
  std::istringstream words(map.text);
  for (std::string word; words >> word;) {
    const std::string option = lower_case(word);
    const bool is_kept = option == "-s" || option == "-o" || (option == "-bm" && is_normal_map);
    if (option.starts_with('-') && !parse_number(option) && !is_kept)
      lost.insert(mtl_keyword(map) + " " + option);
  }
}

}  // namespace

std::vector<std::string> lost_in_3mf(const SurfaceMaterial& material) {
  std::set<std::string> lost;
  constexpr std::array<std::string_view, 4> kKept{"kd", "d", "tr", "illum"};
  add_lost_statements(material, kKept, lost);
  const auto json = SurfaceJson::parse(material.gltf, nullptr, false);
  const auto add = [&](const SurfaceJson& of, const std::set<std::string>& kept) {
    if (!of.is_object()) return;
    for (const auto& [key, value] : of.items()) {
      if (!key.ends_with("Texture") && !kept.contains(key)) lost.insert(key);
    }
  };
  add(json, {"name", "pbrMetallicRoughness", "alphaMode", "extras"});
  if (json.is_object()) {
    if (json.contains("pbrMetallicRoughness"))
      add(json["pbrMetallicRoughness"], {"baseColorFactor", "metallicFactor"});
    // 3MF has no metals. Materials of glTF are metallic by default.
    const SurfaceJson pbr = metallic_roughness(json);
    const bool has_factor = pbr.is_object() && pbr.contains("metallicFactor");
    if (!has_factor || json_number(pbr, "metallicFactor") != 0) lost.insert("metallicFactor");
  }
  return {lost.begin(), lost.end()};
}

std::vector<std::string> lost_in_gltf(const SurfaceLibrary& library, const SurfaceMaterial& material) {
  if (!material.gltf.empty()) return {};
  std::set<std::string> lost;
  constexpr std::array<std::string_view, 8> kKept{"kd", "d", "tr", "ns", "pr", "pm", "ke", "illum"};
  add_lost_statements(material, kKept, lost);
  const MtlStatements mtl(material);
  // glTF clamps the emission to 1.
  const auto emission = mtl.colour("Ke");
  if (emission && std::max({emission->x, emission->y, emission->z}) > 1) lost.insert("Ke above 1");
  for (const MtlLine& line : material.mtl) {
    if (!line.image) continue;
    const SurfaceImage& image = library.images[*line.image];
    const MtlLine* const kept = mtl.map_like(line);
    if (!kept || !are_equal_maps(line, *kept) || (!image.bytes.empty() && !is_gltf_image(image))) {
      lost.insert(mtl_keyword(line));
    } else if (kept == &line && !image.bytes.empty()) {
      add_lost_options(line, &line == mtl.normal_map(), lost);
    }
  }
  return {lost.begin(), lost.end()};
}

}  // namespace kerf
