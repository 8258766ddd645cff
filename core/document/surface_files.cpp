#include "core/document/surface_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "core/base/platform.h"
#include "core/mesh/files/surface_conversion.h"
#include "core/mesh/looks.h"

namespace kerf {

namespace {

bool same_lines(const std::vector<MtlLine>& a, const std::vector<MtlLine>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const MtlLine& one, const MtlLine& other) {
    return one.text == other.text && one.image == other.image;
  });
}

// Returns the extensions of a kind of image, the first one to write; none for an unknown kind.
std::vector<std::string_view> extensions_of(std::string_view mime_type) {
  if (mime_type == "image/png") return {".png"};
  if (mime_type == "image/jpeg") return {".jpg", ".jpeg"};
  if (mime_type == "image/webp") return {".webp"};
  if (mime_type == "image/ktx2") return {".ktx2"};
  return {};
}

// Appends the extension of an image unless the name has it, in any case.
void add_extension(const SurfaceImage& image, std::string& name) {
  std::string low = name;
  for (char& c : low) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  const auto known = extensions_of(image.mime_type);
  if (std::ranges::any_of(known, [&](std::string_view e) { return low.ends_with(e); })) return;
  if (!known.empty()) name += known[0];
  if (name.find('.') == std::string::npos) name += ".image";
}

// Returns a name for an image file on every system, with an extension.
std::string image_file_name(const SurfaceImage& image) {
  std::string name;
  for (const char c : image.name) {
    const bool plain = static_cast<unsigned char>(c) >= 0x20 &&
                       std::string_view("/\\:*?\"<>|").find(c) == std::string_view::npos;
    name += plain ? c : '_';
  }
  constexpr size_t kMaxName = 120;
  if (name.size() > kMaxName) name.erase(0, name.size() - kMaxName);
  while (!name.empty() && (name.front() == '.' || name.front() == ' ')) name.erase(0, 1);
  if (name.empty()) name = "image";
  add_extension(image, name);
  if (name.starts_with("piece-")) name = "image-" + name;
  return name;
}

// Returns "paint-2.png" for "paint.png".
std::string numbered_name(const std::string& name, size_t number) {
  const size_t dot = std::min(name.rfind('.'), name.size());
  return name.substr(0, dot) + "-" + std::to_string(number) + name.substr(dot);
}

bool has_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::error_code fault;
  if (!std::filesystem::is_regular_file(file, fault) ||
      std::filesystem::file_size(file, fault) != bytes.size())
    return false;
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()) == bytes;
}

}  // namespace

SurfaceFiles::SurfaceFiles(const World& world) {
  for (const BodyId id : world.ids()) add(world.body(id));
}

void SurfaceFiles::add(const Body& body) {
  std::vector<std::string>& names = names_[&body];
  const SurfaceLibrary* library = body.looks ? body.looks->surfaces().get() : nullptr;
  any_ = any_ || library;
  for (size_t m = 0; m < body.material_names.size(); ++m) {
    Material own{body.material_names[m].empty() ? "default" : body.material_names[m], {}};
    if (library && m < library->materials.size()) own.lines = mtl_lines(*library, library->materials[m]);
    for (MtlLine& line : own.lines) {
      if (!line.image) continue;
      const SurfaceImage& from = library->images[*line.image];
      if (from.bytes.empty()) {
        line.text += from.reference;
        line.image.reset();
      } else {
        line.image = image(from);
      }
    }
    const std::string base = own.name;
    for (size_t number = 2;; ++number) {
      const auto at = std::find_if(materials_.begin(), materials_.end(),
                                   [&](const Material& other) { return other.name == own.name; });
      if (at != materials_.end() && !same_lines(at->lines, own.lines)) {
        own.name = base + " " + std::to_string(number);
        continue;
      }
      names.push_back(own.name);
      if (at == materials_.end()) materials_.push_back(std::move(own));
      break;
    }
  }
}

uint32_t SurfaceFiles::image(const SurfaceImage& image) {
  const auto same = std::find_if(images_.begin(), images_.end(), [&](const SurfaceImage* other) {
    return other == &image || (other->name == image.name && other->bytes == image.bytes);
  });
  if (same == images_.end()) {
    images_.push_back(&image);
    return static_cast<uint32_t>(images_.size() - 1);
  }
  return static_cast<uint32_t>(same - images_.begin());
}

std::string SurfaceFiles::text(const std::vector<std::string>& image_names) const {
  std::string text;
  for (const Material& material : materials_) {
    text += "newmtl " + material.name + "\n";
    for (const MtlLine& line : material.lines)
      text += line.text + (line.image ? image_names[*line.image] : "") + "\n";
  }
  return text;
}

Result<std::string> SurfaceFiles::place(const std::filesystem::path& folder, const std::string& name,
                                        const std::string& bytes) {
  constexpr size_t kMaxNumber = 10'000;
  for (size_t number = 1; number < kMaxNumber; ++number) {
    std::string own = number == 1 ? name : numbered_name(name, number);
    const auto file = folder / own;
    if (has_bytes(file, bytes)) return own;
    std::error_code fault;
    if (std::filesystem::symlink_status(file, fault).type() != std::filesystem::file_type::not_found)
      continue;
    if (const Status written = write_file_atomically(file, bytes); !written) return written.error();
    created_.push_back(file);
    return own;
  }
  return failed((folder / name).string() + ": there are too many files of this name");
}

Status SurfaceFiles::write(const std::filesystem::path& folder, const std::string& name) {
  if (!any_) return Done{};
  std::vector<std::string> image_names;
  for (const SurfaceImage* image : images_) {
    const auto own = place(folder, image_file_name(*image), image->bytes);
    if (!own) return own.error();
    image_names.push_back(*own);
  }
  return unpack(place(folder, name, text(image_names)), library_);
}

void SurfaceFiles::remove() const {
  std::error_code fault;
  for (const auto& file : created_) std::filesystem::remove(file, fault);
}

}  // namespace kerf
