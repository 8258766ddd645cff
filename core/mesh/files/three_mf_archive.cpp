#include <zlib.h>

#include <Model/COM/NMR_DLLInterfaces.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "core/mesh/files/bytes.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/three_mf_internal.h"

namespace kerf {

void ReleaseThreeMf::operator()(void** object) const { NMR::lib3mf_release(object); }

// Returns the millimetres that a reader gets. Not inlined, because GCC 12 omits the rounding to float where
// it vectorises the conversions to float and back.
[[gnu::noinline]] static float stored_millimetres(double metres) {
  constexpr float kPlaces = 1e6f;
  const auto millimetres = static_cast<float>(1000 * metres);
  return static_cast<float>(static_cast<double>(static_cast<int64_t>(millimetres * kPlaces)) / kPlaces);
}

Vec3 three_mf_position(const Vec3& p) {
  Vec3 stored;
  for (int k = 0; k < 3; ++k) stored[k] = static_cast<double>(stored_millimetres(p[k])) / 1000;
  return stored;
}

namespace {

constexpr uint32_t kDirectoryEnd = 0x06054b50, kDirectoryEnd64 = 0x06064b50, kLocator64 = 0x07064b50;
constexpr uint32_t kRecord = 0x02014b50, kLocalHead = 0x04034b50;
constexpr size_t kEndBytes = 22, kLocatorBytes = 20, kEnd64Bytes = 56, kRecordBytes = 46, kHeadBytes = 30;
constexpr std::string_view kModelEnding = ".model";
constexpr size_t kMaxComment = 0xffff, kMaxEntries = 100'000;
constexpr uint64_t kMaxUnpacked = uint64_t{1} << 32;
constexpr uint64_t kMaxRatio = 200, kAlwaysUnpacked = uint64_t{1} << 26;  // of unpacked to packed bytes
constexpr uint16_t kStored = 0, kDeflated = 8, kEncrypted = 1, kExtra64 = 1;

// Reads numbers of an archive. Those beyond its end are 0, which no check accepts as a signature.
class ZipBytes {
 public:
  explicit ZipBytes(std::string_view archive) : archive_(archive) {}

  template <typename T>
  T at(uint64_t place) const {
    if (place > archive_.size() || archive_.size() - place < sizeof(T)) return 0;
    return load<T>(archive_.data() + place, std::endian::little);
  }
  bool holds(uint64_t place, uint64_t bytes) const {
    return place <= archive_.size() && bytes <= archive_.size() - place;
  }
  std::string_view part(uint64_t place, uint64_t bytes) const { return archive_.substr(place, bytes); }
  size_t size() const { return archive_.size(); }

 private:
  std::string_view archive_;
};

struct Directory {
  uint64_t first = 0, entries = 0;
};

std::optional<Directory> find_directory(const ZipBytes& zip) {
  if (zip.size() < kEndBytes) return std::nullopt;
  const size_t latest = zip.size() - kEndBytes, earliest = latest - std::min(latest, kMaxComment);
  for (size_t end = latest + 1; end-- > earliest;) {
    if (zip.at<uint32_t>(end) != kDirectoryEnd) continue;
    Directory directory{zip.at<uint32_t>(end + 16), zip.at<uint16_t>(end + 10)};
    if (end >= kLocatorBytes && zip.at<uint32_t>(end - kLocatorBytes) == kLocator64) {
      const auto end64 = zip.at<uint64_t>(end - kLocatorBytes + 8);
      if (!zip.holds(end64, kEnd64Bytes) || zip.at<uint32_t>(end64) != kDirectoryEnd64) return std::nullopt;
      directory = {zip.at<uint64_t>(end64 + 48), zip.at<uint64_t>(end64 + 32)};
    }
    return directory;
  }
  return std::nullopt;
}

// Numbers of a record that ZIP64 moves to an extra field if they exceed 32 bits.
struct LongNumbers {
  uint64_t size, packed, head;
};

// Returns false if the extra fields are damaged.
bool read_long_numbers(const ZipBytes& zip, uint64_t extra, uint64_t bytes, LongNumbers& numbers) {
  constexpr uint64_t kElsewhere = std::numeric_limits<uint32_t>::max();
  const uint64_t end = extra + bytes;
  while (extra + 4 <= end) {
    const auto kind = zip.at<uint16_t>(extra);
    uint64_t place = extra + 4;
    const uint64_t next = place + zip.at<uint16_t>(extra + 2);
    if (next > end) return false;
    for (uint64_t* number : {&numbers.size, &numbers.packed, &numbers.head}) {
      if (kind != kExtra64 || *number != kElsewhere) continue;
      if (place + 8 > next) return false;
      *number = zip.at<uint64_t>(place);
      place += 8;
    }
    extra = next;
  }
  return true;
}

// Reads the record at a place, which becomes that of the next one; nullopt if it is damaged.
std::optional<ZipEntry> read_record(const ZipBytes& zip, uint64_t& place) {
  if (!zip.holds(place, kRecordBytes) || zip.at<uint32_t>(place) != kRecord) return std::nullopt;
  const uint64_t name = zip.at<uint16_t>(place + 28), extra = zip.at<uint16_t>(place + 30);
  const uint64_t comment = zip.at<uint16_t>(place + 32), all = kRecordBytes + name + extra + comment;
  if (!zip.holds(place, all)) return std::nullopt;
  LongNumbers numbers{zip.at<uint32_t>(place + 24), zip.at<uint32_t>(place + 20),
                      zip.at<uint32_t>(place + 42)};
  if (!read_long_numbers(zip, place + kRecordBytes + name, extra, numbers)) return std::nullopt;
  if (!zip.holds(numbers.head, kHeadBytes) || zip.at<uint32_t>(numbers.head) != kLocalHead)
    return std::nullopt;
  const uint64_t content =
      numbers.head + kHeadBytes + zip.at<uint16_t>(numbers.head + 26) + zip.at<uint16_t>(numbers.head + 28);
  if (!zip.holds(content, numbers.packed)) return std::nullopt;
  ZipEntry entry{zip.part(place + kRecordBytes, name),
                 zip.part(content, numbers.packed),
                 zip.at<uint16_t>(place + 10),
                 zip.at<uint16_t>(place + 8),
                 numbers.size,
                 static_cast<size_t>(numbers.head),
                 static_cast<size_t>(place)};
  place += all;
  return entry;
}

// Passes deflated content to `use` in parts. Returns the number of its bytes; nullopt if it is damaged or has
// more than `most`.
template <typename Use>
std::optional<uint64_t> inflate_parts(std::string_view content, uint64_t most, const Use& use) {
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) return std::nullopt;
  std::array<char, 1 << 16> scratch;
  uint64_t size = 0;
  int state = Z_OK;
  while (state == Z_OK && size <= most) {
    if (stream.avail_in == 0) {
      constexpr size_t kMaxInput = size_t{1} << 30;
      stream.avail_in = static_cast<uInt>(std::min(content.size(), kMaxInput));
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
      content.remove_prefix(stream.avail_in);
    }
    stream.next_out = reinterpret_cast<Bytef*>(scratch.data());
    stream.avail_out = static_cast<uInt>(scratch.size());
    state = inflate(&stream, Z_NO_FLUSH);
    const size_t now = scratch.size() - stream.avail_out;
    use(std::string_view(scratch.data(), now));
    size += now;
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END && size <= most ? std::optional(size) : std::nullopt;
}

constexpr std::string_view kXmlBlanks = " \t\r\n";

std::string_view without_slashes(std::string_view path) {
  path.remove_prefix(std::min(path.find_first_not_of('/'), path.size()));
  return path;
}

// An attribute of an element. The prefix of its name is empty if it has none.
struct XmlAttribute {
  std::string_view prefix, name, value;
};

// Removes the next attribute from the rest of a tag after the name of the element; nullopt at its end. Like
// lib3mf it accepts anything between '=' and the value.
std::optional<XmlAttribute> take_attribute(std::string_view& tag) {
  const size_t quote = tag.find_first_of("\"'");
  if (quote == std::string_view::npos) return std::nullopt;
  std::string_view name = tag.substr(0, std::min(tag.find('='), quote));
  name = name.substr(0, name.find_last_not_of(kXmlBlanks) + 1);
  name.remove_prefix(name.find_last_of(kXmlBlanks) + 1);
  const size_t colon = name.rfind(':');
  const std::string_view prefix = name.substr(0, colon == std::string_view::npos ? 0 : colon);
  const size_t end = std::min(tag.find(tag[quote], quote + 1), tag.size());
  const std::string_view value = tag.substr(quote + 1, end - quote - 1);
  tag.remove_prefix(std::min(end + 1, tag.size()));
  return XmlAttribute{prefix, name.substr(colon + 1), value};
}

// An object of a model by the name of its file, without the first slash, and its id.
using ObjectKey = std::pair<std::string, uint32_t>;

// Finds the components of the objects of model files, and in relationship files the names of these. Both are
// given in parts.
class ComponentScan {
 public:
  void begin_file(std::string_view name) {
    file_ = std::string(without_slashes(name));
    text_.clear();
    object_ = nullptr;
    prefixes_.clear();
  }
  // Returns true if there is text that could hide elements, within comments, declarations or values, if an id
  // is no number of 32 bits or occurs twice, or if the prefix of the production extension has two meanings.
  bool refuses() const { return refuses_; }
  // Returns true if a relationship refers to a model whose name does not end like those that are scanned.
  bool has_other_model() const { return has_other_model_; }

  void add(std::string_view part) {
    constexpr size_t kMaxTag = size_t{1} << 20;
    text_ += part;
    size_t at = text_.find('<');
    while (at != std::string::npos) {
      const size_t end = end_of_tag(at);
      if (end == std::string::npos) break;
      add_tag(std::string_view(text_).substr(at + 1, end - at - 1));
      at = text_.find('<', end);
    }
    text_.erase(0, std::min(at, text_.size()));
    refuses_ = refuses_ || text_.size() > kMaxTag;
  }

  // Returns true if an object has more than kMaxThreeMfObjects objects within it, or too many levels.
  bool has_too_many() {
    std::vector<ObjectKey> keys;
    for (const auto& [key, parts] : objects_) keys.push_back(key);
    return std::any_of(keys.begin(), keys.end(),
                       [&](const ObjectKey& key) { return extent(key, 0).objects > kMaxThreeMfObjects; });
  }

 private:
  // Returns the place of the '>' that ends a tag or comment; npos if it is not there yet.
  size_t end_of_tag(size_t at) const {
    if (text_.compare(at, 4, "<!--") == 0) {
      const size_t end = text_.find("-->", at + 4);
      return end == std::string::npos ? end : end + 2;
    }
    char quote = 0;
    for (size_t i = at + 1; i < text_.size(); ++i) {
      const char c = text_[i];
      if (quote == 0 && c == '>') return i;
      if (c == quote) {
        quote = 0;
      } else if (quote == 0 && (c == '"' || c == '\'')) {
        quote = c;
      }
    }
    return std::string::npos;
  }

  void add_tag(std::string_view tag) {
    const bool is_declaration = tag.starts_with('!') && !tag.starts_with("!--");
    refuses_ = refuses_ || is_declaration || tag.find('<') != std::string_view::npos;
    const size_t end = std::min(tag.find_first_of(" \t\r\n/"), tag.size());
    std::string_view name = tag.substr(0, end);
    name.remove_prefix(name.find(':') + 1);
    tag.remove_prefix(end);
    if (tag.find("xmlns:") != std::string_view::npos) add_namespaces(tag);
    if (name == "Relationship" && attribute(tag, "Type").ends_with("3dmodel"))
      has_other_model_ = has_other_model_ || !attribute(tag, "Target").ends_with(kModelEnding);
    if (name == "object") object_ = &objects_[{file_, id(tag, "id")}];
    if (name != "component" || !object_) return;
    const std::string_view path = without_slashes(attribute(tag, "path", true));
    object_->push_back({path.empty() ? file_ : std::string(path), id(tag, "objectid")});
  }

  void add_namespaces(std::string_view tag) {
    constexpr std::string_view kProduction =
        "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
    while (const auto next = take_attribute(tag)) {
      if (next->prefix != "xmlns") continue;
      const bool is_production = next->value == kProduction;
      const auto known = prefixes_.try_emplace(std::string(next->name), is_production).first;
      refuses_ = refuses_ || known->second != is_production;
    }
  }

  // Returns the value of an attribute of the production extension, or of one without a prefix; empty if there
  // is none. lib3mf ignores the same names with other prefixes.
  std::string_view attribute(std::string_view tag, std::string_view name, bool of_production = false) {
    std::optional<std::string_view> value;
    while (const auto next = take_attribute(tag)) {
      const auto known = prefixes_.find(next->prefix);
      const bool is_of_production = known != prefixes_.end() && known->second;
      if (next->name != name || !(of_production ? is_of_production : next->prefix.empty())) continue;
      refuses_ = refuses_ || value || next->value.find('&') != std::string_view::npos;
      value = next->value;
    }
    return value.value_or("");
  }

  // Likewise for a number, which may have zeros and blanks before it; 0 if there is none.
  uint32_t id(std::string_view tag, std::string_view name) {
    std::string_view text = attribute(tag, name);
    text.remove_prefix(std::min(text.find_first_not_of(kXmlBlanks), text.size()));
    text = text.substr(0, text.find_last_not_of(kXmlBlanks) + 1);
    if (text.empty()) return 0;
    const int64_t number = parse_integer(text).value_or(-1);
    const bool fits = number >= 0 && number <= std::numeric_limits<uint32_t>::max();
    refuses_ = refuses_ || !fits;
    return fits ? static_cast<uint32_t>(number) : 0;
  }

  // The number of objects within an object with itself, and of their levels.
  struct Extent {
    uint64_t objects = 1;
    int levels = 1;
  };

  // Returns more than kMaxThreeMfObjects objects if there are too many levels.
  Extent extent(const ObjectKey& key, int depth) {
    if (depth > kMaxThreeMfDepth) return {kMaxThreeMfObjects + 1, 1};
    if (const auto known = extents_.find(key); known != extents_.end()) return known->second;
    const auto parts = objects_.find(key);
    Extent all;
    for (size_t i = 0; parts != objects_.end() && i < parts->second.size(); ++i) {
      const Extent own = extent(parts->second[i], depth + 1);
      all = {all.objects + own.objects, std::max(all.levels, own.levels + 1)};
      if (all.objects > kMaxThreeMfObjects) break;
    }
    if (all.levels > kMaxThreeMfDepth) all.objects = kMaxThreeMfObjects + 1;
    extents_.emplace(key, all);
    return all;
  }

  std::string file_, text_;
  std::map<ObjectKey, std::vector<ObjectKey>> objects_;
  std::map<ObjectKey, Extent> extents_;
  // By prefix of the current file: true if it is that of the production extension.
  std::map<std::string, bool, std::less<>> prefixes_;
  std::vector<ObjectKey>* object_ = nullptr;
  bool refuses_ = false, has_other_model_ = false;
};

}  // namespace

Result<std::vector<ZipEntry>> zip_entries(std::string_view archive, const std::string& name) {
  const Error damaged = bad_input(name + ": the archive is damaged or ends too early.");
  const ZipBytes zip(archive);
  const auto directory = find_directory(zip);
  if (!directory || directory->entries > kMaxEntries) return damaged;
  std::vector<ZipEntry> entries;
  uint64_t place = directory->first;
  for (uint64_t i = 0; i < directory->entries; ++i) {
    const auto entry = read_record(zip, place);
    if (!entry) return damaged;
    entries.push_back(*entry);
  }
  return entries;
}

Status check_3mf_entries(const std::vector<ZipEntry>& entries, const std::string& name) {
  uint64_t total = 0, packed = 0;
  for (const ZipEntry& entry : entries) {
    if ((entry.flags & kEncrypted) != 0) return bad_input(name + ": the archive is encrypted.");
    if (entry.method != kStored && entry.method != kDeflated)
      return bad_input(name + ": the archive has an unsupported kind of compression; save it with deflate.");
    if (entry.size > kMaxUnpacked || total + entry.size > kMaxUnpacked)
      return bad_input(name + ": the content of the archive exceeds the limit of 4 GiB.");
    total += entry.size;
    packed += entry.content.size();
  }
  if (total > kAlwaysUnpacked && total / kMaxRatio > packed)
    return bad_input(name + ": the archive unpacks to more than 200 times its size.");
  ComponentScan scan;
  for (const ZipEntry& entry : entries) {
    const bool is_scanned = entry.name.ends_with(kModelEnding) || entry.name.ends_with(".rels");
    if (is_scanned) scan.begin_file(entry.name);
    const auto use = [&](std::string_view part) {
      if (is_scanned && !scan.refuses()) scan.add(part);
    };
    std::optional<uint64_t> size = entry.content.size();
    if (entry.method == kDeflated) {
      size = inflate_parts(entry.content, entry.size, use);
    } else {
      constexpr size_t kPart = size_t{1} << 16;
      for (size_t i = 0; i < entry.content.size(); i += kPart) use(entry.content.substr(i, kPart));
    }
    if (size != entry.size)
      return bad_input(name + ": the archive is damaged: a file in it has another size than declared.");
  }
  if (scan.refuses())
    return bad_input(name +
                     ": the model has invalid ids, or elements in comments, declarations or values; "
                     "remove these.");
  if (scan.has_other_model())
    return bad_input(name + ": the name of a model in the archive must end with '.model'.");
  if (scan.has_too_many()) return bad_input(name + ": the 3MF file has too many components.");
  return Done{};
}

}  // namespace kerf
