#include <algorithm>
#include <utility>

#include "core/mesh/files/gltf_surfaces_internal.h"
#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/side_file.h"
#include "core/mesh/files/surface_look.h"

namespace kerf {

bool is_shallow(const nlohmann::json& json, int depth) {
  if (!json.is_structured()) return true;
  return depth > 0 && std::all_of(json.begin(), json.end(),
                                  [&](const nlohmann::json& item) { return is_shallow(item, depth - 1); });
}

namespace {

constexpr size_t kMaxGltfImageBytes = size_t{1} << 30;

std::string json_text(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string text_member(const nlohmann::json& of, const char* key) {
  const auto at = of.find(key);
  return at != of.end() && at->is_string() ? at->get<std::string>() : "";
}

class GltfSurfaceReader {
 public:
  GltfSurfaceReader(const GltfFile& file, const std::filesystem::path& folder,
                    std::vector<std::string>& warnings)
      : file_(file), folder_(folder), warnings_(warnings) {}

  std::shared_ptr<const SurfaceLibrary> read(std::span<const std::optional<uint32_t>> materials) {
    if (std::none_of(materials.begin(), materials.end(), [](const auto& m) { return m.has_value(); }))
      return nullptr;
    for (const auto& m : materials) {
      SurfaceMaterial& material = library_->materials.emplace_back();
      if (m) material.gltf = object_text(&file_.element("materials", *m));
      material.uv_transform = read_uv_transform(material);
    }
    library_->textures = list_texts("textures");
    library_->samplers = list_texts("samplers");
    for (size_t i = 0; i < length("images"); ++i) read_image(i);
    const auto required = file_.root().find("extensionsRequired");
    if (required != file_.root().end()) {
      for (const nlohmann::json& name : *required) {
        if (name.is_string()) library_->required_extensions.push_back(name.get<std::string>());
      }
    }
    if (too_deep_) warnings_.emplace_back("Materials or textures that are nested too deeply were ignored.");
    return library_;
  }

 private:
  size_t length(const char* list) const {
    const auto at = file_.root().find(list);
    return at != file_.root().end() && at->is_array() ? at->size() : 0;
  }

  std::string object_text(const nlohmann::json* json) {
    if (json && is_shallow(*json)) return json_text(*json);
    too_deep_ = too_deep_ || json;
    return "{}";
  }

  std::vector<std::string> list_texts(const char* list) {
    std::vector<std::string> texts;
    for (size_t i = 0; i < length(list); ++i) texts.push_back(object_text(file_.find_element(list, i)));
    return texts;
  }

  void read_image(size_t i) {
    SurfaceImage& image = library_->images.emplace_back();
    const nlohmann::json* json = file_.find_element("images", i);
    if (!json) return warn_missing(image, i, "is malformed");
    image.mime_type = text_member(*json, "mimeType");
    image.name = one_line(text_member(*json, "name"));
    const std::string problem = read_image_bytes(*json, image);
    if (image.mime_type.empty()) image.mime_type = image_mime_type(image.bytes, image.name);
    if (!problem.empty()) warn_missing(image, i, problem);
    if (image.name.empty()) image.name = "image-" + std::to_string(i);
  }

  // Returns what is wrong; empty if the bytes were read.
  std::string read_image_bytes(const nlohmann::json& json, SurfaceImage& image) {
    const std::string where = "/images";
    if (json.contains("bufferView")) {
      const auto index = file_.index(json, "bufferView", "bufferViews", where);
      const auto view = index && *index ? file_.view(**index) : Result<GltfFile::View>(failed(""));
      if (!view) return "is in no buffer";
      image.bytes = view->bytes;
      return image.bytes.empty() ? "is empty" : "";
    }
    const std::string uri = text_member(json, "uri");
    if (uri.starts_with("data:")) {
      const size_t comma = uri.find(";base64,");
      auto bytes =
          comma == std::string::npos ? std::nullopt : from_base64(std::string_view(uri).substr(comma + 8));
      if (!bytes) return "is not base64 data";
      if (image.mime_type.empty()) image.mime_type = uri.substr(5, comma - 5);
      image.bytes = std::move(*bytes);
      return image.bytes.empty() ? "is empty" : "";
    }
    image.reference = uri;
    const auto path = decoded_path(uri);
    if (!path || path->empty()) return "has no file";
    const std::string file_name = one_line(side_file_name(*path));
    image.name = file_name;
    auto bytes = read_side_file(folder_, *path, kMaxGltfImageBytes);
    if (!bytes) return bytes.error().message;
    image.bytes = std::move(*bytes);
    return image.bytes.empty() ? "is empty" : "";
  }

  void warn_missing(const SurfaceImage& image, size_t i, const std::string& problem) {
    warnings_.push_back("The image " + (image.name.empty() ? std::to_string(i) : in_quotes(image.name)) +
                        " " + problem + ".");
  }

  const GltfFile& file_;
  const std::filesystem::path& folder_;
  std::vector<std::string>& warnings_;
  std::shared_ptr<SurfaceLibrary> library_ = std::make_shared<SurfaceLibrary>();
  bool too_deep_ = false;
};

}  // namespace

std::shared_ptr<const SurfaceLibrary> read_gltf_surfaces(const GltfFile& file,
                                                         std::span<const std::optional<uint32_t>> materials,
                                                         const std::filesystem::path& folder,
                                                         std::vector<std::string>& warnings) {
  return GltfSurfaceReader(file, folder, warnings).read(materials);
}

}  // namespace kerf
