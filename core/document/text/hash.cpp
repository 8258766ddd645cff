#include "core/document/text/hash.h"

#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/base/random.h"

namespace kerf {

namespace {

constexpr size_t kBlock = 1 << 20;
static_assert(std::endian::native == std::endian::little, "words are hashed in the byte order of the file");

// Hashes bytes as words; the last one is padded with zeros.
uint64_t add_bytes(uint64_t hash, const char* bytes, size_t count) {
  for (size_t at = 0; at < count; at += sizeof(uint64_t)) {
    uint64_t word = 0;
    std::memcpy(&word, bytes + at, std::min(sizeof word, count - at));
    hash = hash_combine(hash, word);
  }
  return hash;
}

constexpr std::string_view kDigits = "0123456789abcdef";
constexpr int kLength = 16;

}  // namespace

Result<uint64_t> file_hash(const std::filesystem::path& file, const Progress* progress) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) return bad_input(file.string() + ": no such file");
  if (!std::filesystem::is_regular_file(status)) {
    return bad_input(file.string() + ": not a regular file; a journal can refer only to regular files");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return bad_input(file.string() + ": cannot be opened for reading");
  std::vector<char> block(kBlock);
  uint64_t hash = 0, size = 0;
  Pace pace(progress, std::filesystem::file_size(file, error) / kBlock + 1);
  while (stream) {
    if (!pace.step()) return cancelled();
    stream.read(block.data(), static_cast<std::streamsize>(kBlock));
    const auto count = static_cast<size_t>(stream.gcount());
    hash = add_bytes(hash, block.data(), count);
    size += count;
  }
  if (stream.bad()) return failed(file.string() + ": reading failed before the end");
  return hash_combine(hash, size);
}

std::string hash_text(uint64_t hash) {
  std::string text(kLength, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4) *digit = kDigits[hash & 15];
  return text;
}

std::optional<uint64_t> parse_hash(std::string_view text) {
  uint64_t hash = 0;
  const char* const last = text.data() + text.size();
  const auto [end, fault] = std::from_chars(text.data(), last, hash, 16);
  if (text.size() != kLength || fault != std::errc() || end != last) return std::nullopt;
  return hash;
}

}  // namespace kerf
