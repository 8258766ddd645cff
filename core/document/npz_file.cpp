#include "core/document/npz_file.h"

#include <array>
#include <limits>
#include <utility>

#include "core/mesh/files/bytes.h"

namespace kerf {

namespace {

constexpr std::array<uint32_t, 256> crc_table() {
  std::array<uint32_t, 256> table{};
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t crc = i;
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320u : crc >> 1;
    table[i] = crc;
  }
  return table;
}

uint32_t crc32_of(std::string_view bytes) {
  static constexpr std::array<uint32_t, 256> kTable = crc_table();
  uint32_t crc = 0xffffffffu;
  for (const char c : bytes) crc = kTable[(crc ^ static_cast<uint8_t>(c)) & 0xff] ^ crc >> 8;
  return ~crc;
}

std::string npy_head(std::string_view type, std::span<const size_t> shape) {
  std::string text = "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': (";
  for (const size_t n : shape) text += std::to_string(n) + ", ";
  text += "), }";
  constexpr size_t kMagic = 10, kAlignment = 64;
  text.append(kAlignment - (kMagic + text.size() + 1) % kAlignment, ' ');
  text += '\n';
  std::string head("\x93NUMPY\x01\x00", 8);
  append_little(static_cast<uint16_t>(text.size()), head);
  return head + text;
}

template <typename T>
std::string little_bytes(std::span<const T> values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(T));
  for (const T value : values) append_little(value, bytes);
  return bytes;
}

constexpr uint16_t kZipVersion = 20, kStored = 0, kNewYear1980 = 0x21;

}  // namespace

void NpzFile::add(std::string_view name, std::span<const double> values, std::span<const size_t> shape) {
  add_entry(name, "<f8", shape, little_bytes(values));
}

void NpzFile::add(std::string_view name, std::span<const int64_t> values, std::span<const size_t> shape) {
  add_entry(name, "<i8", shape, little_bytes(values));
}

void NpzFile::add_entry(std::string_view name, std::string_view type, std::span<const size_t> shape,
                        std::string_view bytes) {
  const std::string content = npy_head(type, shape) + std::string(bytes);
  const std::string file = std::string(name) + ".npy";
  // The fields that both headers of an entry share.
  std::string common;
  for (const uint16_t field : {kZipVersion, uint16_t{0}, kStored, uint16_t{0}, kNewYear1980})
    append_little(field, common);
  const auto size = static_cast<uint32_t>(content.size());
  for (const uint32_t field : {crc32_of(content), size, size}) append_little(field, common);
  append_little(static_cast<uint16_t>(file.size()), common);
  append_little(uint16_t{0}, common);
  append_little(uint32_t{0x02014b50}, directory_);
  append_little(kZipVersion, directory_);
  directory_ += common;
  directory_.append(10, '\0');  // no comment, first disk, no attributes
  append_little(static_cast<uint32_t>(bytes_.size()), directory_);
  directory_ += file;
  append_little(uint32_t{0x04034b50}, bytes_);
  bytes_ += common + file + content;
  ++entries_;
}

Result<std::string> NpzFile::take() {
  if (bytes_.size() + directory_.size() > std::numeric_limits<uint32_t>::max())
    return failed("the arrays exceed 4 GiB, the limit of the format");
  const auto start = static_cast<uint32_t>(bytes_.size());
  const auto size = static_cast<uint32_t>(directory_.size());
  bytes_ += directory_;
  append_little(uint32_t{0x06054b50}, bytes_);
  for (const uint16_t field : {uint16_t{0}, uint16_t{0}, entries_, entries_}) append_little(field, bytes_);
  append_little(size, bytes_);
  append_little(start, bytes_);
  append_little(uint16_t{0}, bytes_);
  return std::move(bytes_);
}

}  // namespace kerf
