#include "core/mesh/files/mtl_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "core/mesh/files/scanner.h"
#include "core/mesh/files/side_file.h"
#include "core/mesh/files/surface_look.h"

namespace kerf {

namespace {

constexpr size_t kMaxLibraryBytes = size_t{1} << 26, kMaxImageBytes = size_t{1} << 30;
constexpr std::string_view kBlanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

// Removes the first word of a text with its blanks, and returns it.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return word;
}

std::string lower_case(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

bool refers_to_image(std::string_view keyword) {
  constexpr std::array<std::string_view, 5> kOthers{"bump", "disp", "decal", "refl", "norm"};
  const std::string key = lower_case(keyword);
  if (key == "map_aat") return false;
  return key.starts_with("map_") || std::find(kOthers.begin(), kOthers.end(), key) != kOthers.end();
}

// Removes the options of a map, e.g. "-s 2 2 1 -bm 0.5".
void skip_options(std::string_view& text) {
  while (text.size() > 1 && text[0] == '-') {
    std::string_view rest = text;
    const std::string option = lower_case(take_word(rest));
    const bool is_vector = option == "-o" || option == "-s" || option == "-t";
    size_t most = option == "-mm" ? 2 : is_vector ? 3 : 1;
    if (!is_vector && option != "-mm") {
      constexpr std::array<std::string_view, 9> kWithWord{"-blendu", "-blendv", "-boost",   "-cc",  "-clamp",
                                                          "-texres", "-bm",     "-imfchan", "-type"};
      if (std::find(kWithWord.begin(), kWithWord.end(), option) == kWithWord.end()) return;
      take_word(rest);
      most = 0;
    }
    for (; most > 0; --most) {
      std::string_view next = rest;
      if (!parse_number(take_word(next)) || next.empty()) break;
      rest = next;
    }
    text = rest;
  }
}

void add_line(std::string_view line, MtlFile& file) {
  std::string_view rest = line;
  const std::string_view keyword = take_word(rest);
  std::vector<MtlLine>& lines = file.materials.back().lines;
  if (refers_to_image(keyword)) {
    skip_options(rest);
    if (!rest.empty()) {
      lines.push_back({std::string(line.substr(0, line.size() - rest.size())),
                       static_cast<uint32_t>(file.references.size())});
      file.references.emplace_back(rest);
      return;
    }
  }
  lines.push_back({std::string(line)});
}

}  // namespace

MtlFile parse_mtl(std::string_view text) {
  text = without_byte_order_mark(text);
  MtlFile file;
  while (!text.empty()) {
    const size_t end = std::min(text.find_first_of("\n\r"), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    std::string_view rest = line;
    if (lower_case(take_word(rest)) == "newmtl") {
      file.materials.push_back({one_line(rest), {}});
    } else if (!line.empty() && !file.materials.empty()) {
      add_line(line, file);
    }
  }
  return file;
}

std::string image_mime_type(std::string_view bytes, std::string_view name) {
  if (bytes.starts_with("\x89PNG")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  if (bytes.starts_with("\xabKTX 20")) return "image/ktx2";
  if (bytes.starts_with("RIFF") && bytes.substr(std::min<size_t>(8, bytes.size())).starts_with("WEBP"))
    return "image/webp";
  const std::string ending = lower_case(name.substr(std::min(name.rfind('.'), name.size())));
  if (ending == ".png") return "image/png";
  if (ending == ".jpg" || ending == ".jpeg") return "image/jpeg";
  return "";
}

std::filesystem::path image_folder(const std::filesystem::path& folder, const std::filesystem::path& mtl,
                                   std::string_view reference) {
  const auto has_image = [&](const std::filesystem::path& in) {
    std::error_code fault;
    const auto image = side_file(in, reference);
    return image && std::filesystem::is_regular_file(*image, fault);
  };
  const std::filesystem::path of_library = mtl.parent_path();
  return !has_image(folder) && has_image(of_library) ? of_library : folder;
}

namespace {

// Reads the images of the libraries of an OBJ file, each once.
class MtlImages {
 public:
  MtlImages(const std::filesystem::path& folder, SurfaceLibrary& library, std::vector<std::string>& warnings)
      : folder_(folder), library_(library), warnings_(warnings) {}

  uint32_t number(const std::filesystem::path& mtl, const std::string& reference) {
    const std::filesystem::path folder = image_folder(folder_, mtl, reference);
    const auto [known, added] =
        numbers_.try_emplace({folder, reference}, static_cast<uint32_t>(library_.images.size()));
    if (!added) return known->second;
    library_.images.push_back(read_image(folder, reference, warnings_));
    return known->second;
  }

 private:
  const std::filesystem::path& folder_;
  SurfaceLibrary& library_;
  std::vector<std::string>& warnings_;
  std::map<std::pair<std::filesystem::path, std::string>, uint32_t> numbers_;  // by folder and reference
};

// The content of a library, and its file.
struct OpenLibrary {
  MtlFile file;
  std::filesystem::path path;
};

std::optional<OpenLibrary> open_library(const std::filesystem::path& folder, const std::string& reference) {
  const auto text = read_side_file(folder, reference, kMaxLibraryBytes);
  if (!text) return std::nullopt;
  return OpenLibrary{parse_mtl(*text), *side_file(folder, reference)};
}

// The statement mtllib lists names separated by blanks, but most writers write one name, which may have some.
std::vector<OpenLibrary> open_libraries(const std::filesystem::path& folder,
                                        std::span<const std::string> statements,
                                        std::vector<std::string>& warnings) {
  std::vector<OpenLibrary> open;
  for (const std::string& statement : statements) {
    if (auto whole = open_library(folder, statement)) {
      open.push_back(std::move(*whole));
      continue;
    }
    const size_t before = open.size();
    std::string_view rest = statement;
    while (!rest.empty()) {
      if (auto library = open_library(folder, std::string(take_word(rest))))
        open.push_back(std::move(*library));
    }
    if (open.size() == before && !folder.empty()) {
      warnings.push_back("The material library " + in_quotes(statement) +
                         " is not in the folder of this file; its materials keep their names only.");
    }
  }
  return open;
}

}  // namespace

std::shared_ptr<const SurfaceLibrary> read_mtl_surfaces(const std::filesystem::path& folder,
                                                        std::span<const std::string> libraries,
                                                        std::span<const std::string> material_names,
                                                        std::vector<std::string>& warnings) {
  const std::vector<OpenLibrary> open = open_libraries(folder, libraries, warnings);
  if (open.empty()) return nullptr;
  struct Place {
    const OpenLibrary* source;
    const MtlEntry* entry;
  };
  std::map<std::string_view, Place> places;
  for (const OpenLibrary& library : open) {
    for (const MtlEntry& entry : library.file.materials)
      places.try_emplace(entry.name, Place{&library, &entry});
  }
  auto surfaces = std::make_shared<SurfaceLibrary>();
  MtlImages images(folder, *surfaces, warnings);
  size_t missing = 0;
  for (const std::string& name : material_names) {
    SurfaceMaterial& material = surfaces->materials.emplace_back();
    const auto found = places.find(name);
    missing += found == places.end() && !name.empty();
    if (found == places.end()) continue;
    for (const MtlLine& line : found->second.entry->lines) {
      MtlLine& own = material.mtl.emplace_back(line);
      const OpenLibrary& library = *found->second.source;
      if (line.image) own.image = images.number(library.path, library.file.references[*line.image]);
    }
    material.uv_transform = read_uv_transform(material);
  }
  if (missing > 0) {
    warnings.push_back(std::to_string(missing) + (missing == 1
                                                      ? " material is not in a material library."
                                                      : " materials are not in a material library."));
  }
  return surfaces;
}

std::vector<std::filesystem::path> files_of_obj(const std::filesystem::path& file) {
  std::ifstream obj(file, std::ios::binary);
  std::vector<std::string> statements, warnings;
  bool is_first = true;
  for (std::string line; statements.size() < kMaxLibraries && std::getline(obj, line); is_first = false) {
    std::string_view rest = line;
    rest = trimmed(is_first ? without_byte_order_mark(rest) : rest);
    if (!rest.starts_with("mtllib") || take_word(rest) != "mtllib" || rest.empty()) continue;
    std::string joined(rest);
    for (std::string next; joined.ends_with('\\') && std::getline(obj, next);) {
      joined.back() = ' ';
      joined += trimmed(next);
    }
    rest = joined;
    if (std::ranges::find(statements, rest) == statements.end()) statements.emplace_back(rest);
  }
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::vector<std::filesystem::path> files;
  for (const OpenLibrary& library : open_libraries(folder, statements, warnings)) {
    files.push_back(library.path);
    for (const std::string& reference : library.file.references) {
      const std::filesystem::path of_image = image_folder(folder, library.path, reference);
      if (auto image = side_file(of_image, reference)) files.push_back(std::move(*image));
    }
  }
  return files;
}

SurfaceImage read_image(const std::filesystem::path& folder, const std::string& reference,
                        std::vector<std::string>& warnings) {
  SurfaceImage image;
  image.name = one_line(side_file_name(reference));
  image.reference = reference;
  auto bytes = read_side_file(folder, reference, kMaxImageBytes);
  if (bytes) image.bytes = std::move(*bytes);
  if (!bytes) warnings.push_back("The image " + in_quotes(reference) + " " + bytes.error().message + ".");
  image.mime_type = image_mime_type(image.bytes, image.name);
  return image;
}

}  // namespace kerf
