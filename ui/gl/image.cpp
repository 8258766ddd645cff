#include "ui/gl/image.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdio>
#include <limits>
#include <string>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "core/mesh/files/bytes.h"

#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_MAX_DIMENSIONS (1 << 14)
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_image.h>
#include <stb_image_resize.h>
#include <stb_image_write.h>
#pragma GCC diagnostic pop

namespace kerf {

namespace {

std::array<uint8_t, 3> mean_colour(const Pixels& all, int left, int right, int top, int bottom) {
  std::array<unsigned, 3> sum{};
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const size_t at =
          3 * (static_cast<size_t>(y) * static_cast<size_t>(all.width) + static_cast<size_t>(x));
      for (size_t c = 0; c < 3; ++c) sum[c] += all.rgb[at + c];
    }
  }
  const auto pixels = static_cast<unsigned>((right - left) * (bottom - top));
  std::array<uint8_t, 3> mean{};
  for (size_t c = 0; c < 3; ++c) mean[c] = static_cast<uint8_t>((sum[c] + pixels / 2) / pixels);
  return mean;
}

}  // namespace

Pixels read_pixels(unsigned framebuffer, int width, int height) {
  Pixels pixels{width, height,
                std::vector<uint8_t>(3 * static_cast<size_t>(width) * static_cast<size_t>(height))};
  const size_t row = 3 * static_cast<size_t>(width);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.rgb.data());
  for (size_t low = 0, high = static_cast<size_t>(height); low + 1 < high--; ++low) {
    std::swap_ranges(pixels.rgb.begin() + static_cast<std::ptrdiff_t>(low * row),
                     pixels.rgb.begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                     pixels.rgb.begin() + static_cast<std::ptrdiff_t>(high * row));
  }
  return pixels;
}

Pixels cut_out(const Pixels& all, int x, int y, int width, int height) {
  KERF_ASSERT(x >= 0 && x < all.width && y >= 0 && y < all.height && width > 0 && height > 0);
  Pixels part{std::min(width, all.width - x), std::min(height, all.height - y), {}};
  for (int row = y; row < y + part.height; ++row) {
    const auto from = all.rgb.begin() + std::ptrdiff_t{3} * (std::ptrdiff_t{row} * all.width + x);
    part.rgb.insert(part.rgb.end(), from, from + std::ptrdiff_t{3} * part.width);
  }
  return part;
}

Pixels shrunk(const Pixels& all, int width, int height) {
  KERF_ASSERT(all.width > 0 && all.height > 0 && width > 0 && height > 0);
  const double scale =
      std::min(static_cast<double>(all.width) / width, static_cast<double>(all.height) / height);
  const auto wide = std::max(1, static_cast<int>(width * scale));
  const auto high = std::max(1, static_cast<int>(height * scale));
  const Pixels part = cut_out(all, (all.width - wide) / 2, (all.height - high) / 2, wide, high);
  Pixels small{std::min(width, wide), std::min(height, high), {}};
  for (int y = 0; y < small.height; ++y) {
    const int top = y * high / small.height, bottom = (y + 1) * high / small.height;
    for (int x = 0; x < small.width; ++x) {
      const int left = x * wide / small.width, right = (x + 1) * wide / small.width;
      for (const uint8_t channel : mean_colour(part, left, right, top, bottom)) small.rgb.push_back(channel);
    }
  }
  return small;
}

std::filesystem::path frame_file(const std::filesystem::path& folder, size_t frame) {
  char name[40];
  std::snprintf(name, sizeof name, "frame-%05zu.png", frame);
  return folder / name;
}

namespace {

// Returns the number of the frame whose file has this name; nullopt if no frame has it.
std::optional<size_t> frame_named(const std::string& name) {
  constexpr std::string_view kStem = "frame-";
  if (!name.starts_with(kStem)) return std::nullopt;
  size_t frame = 0;
  const auto [end, fault] = std::from_chars(name.data() + kStem.size(), name.data() + name.size(), frame);
  return fault == std::errc() && frame_file({}, frame) == name ? std::optional(frame) : std::nullopt;
}

}  // namespace

Status remove_later_frames(const std::filesystem::path& folder, size_t count) {
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::filesystem::path& file = at->path();
    const auto frame = frame_named(file.filename().string());
    if (!frame || *frame < count || at->is_directory(error)) continue;
    std::filesystem::remove(file, error);
    if (error) return failed("cannot remove " + file.string() + ": " + error.message());
  }
  return error ? Status(failed("cannot list " + folder.string() + ": " + error.message())) : Done{};
}

Status write_png(const Pixels& pixels, const std::filesystem::path& file) {
  KERF_ASSERT(pixels.rgb.size() ==
              3 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &bytes, pixels.width, pixels.height, 3, pixels.rgb.data(),
                              3 * pixels.width)) {
    return failed(file.string() + ": cannot compress the image");
  }
  return write_file_atomically(file, bytes);
}

std::optional<Pixels> read_png(const std::filesystem::path& file) {
  Pixels pixels;
  int channels = 0;
  uint8_t* data = stbi_load(file.c_str(), &pixels.width, &pixels.height, &channels, 3);
  if (data == nullptr) return std::nullopt;
  pixels.rgb.assign(data, data + 3 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
  stbi_image_free(data);
  return pixels;
}

// Returns true if all chunks of a PNG lie within it (PNG specification, third edition, 5.3); true for other
// formats. stb_image allocates the declared length of a chunk before it reads the chunk.
static bool has_whole_chunks(std::string_view bytes) {
  constexpr size_t kSignature = 8, kAround = 12;  // of a chunk: length, type and check sum
  if (!bytes.starts_with("\x89PNG")) return true;
  for (size_t at = kSignature; at < bytes.size();) {
    if (bytes.size() - at < kAround) return false;
    const uint64_t length = load<uint32_t>(bytes.data() + at, std::endian::big);
    if (length > bytes.size() - at - kAround) return false;
    if (bytes.substr(at + 4, 4) == "IEND") return true;
    at += kAround + length;
  }
  return true;
}

// Returns true if the Huffman tables of a segment DHT of a JPEG (ITU T.81, B.2.4.2) have at most 256 codes
// each. stb_image writes the codes to an array of this size.
static bool has_sound_tables(std::string_view segment) {
  constexpr size_t kHead = 17, kMaxCodes = 256;  // of a table: class and number, and 16 counts
  while (!segment.empty()) {
    if (segment.size() < kHead) return false;
    size_t codes = 0;
    for (const char count : segment.substr(1, kHead - 1)) codes += static_cast<uint8_t>(count);
    if (codes > std::min(kMaxCodes, segment.size() - kHead)) return false;
    segment.remove_prefix(kHead + codes);
  }
  return true;
}

// Returns true if all segments of a JPEG (ITU T.81, B.1.1) lie within it and its Huffman tables are sound;
// true for other formats.
static bool has_sound_segments(std::string_view bytes) {
  constexpr uint8_t kTables = 0xc4, kScan = 0xda, kEnd = 0xd9;
  const auto byte = [&](size_t at) { return static_cast<uint8_t>(bytes[at]); };
  const auto stands_alone = [](uint8_t marker) { return marker <= 1 || (marker >= 0xd0 && marker <= 0xd8); };
  if (!bytes.starts_with('\xff')) return true;
  for (size_t at = 0; at + 1 < bytes.size();) {
    if (byte(at) != 0xff) return false;
    const uint8_t marker = byte(++at);
    if (marker == 0xff || stands_alone(marker)) {
      at += marker != 0xff;
      continue;
    }
    if (marker == kEnd) return true;
    if (bytes.size() - at < 3) return false;
    const size_t length = load<uint16_t>(bytes.data() + at + 1, std::endian::big);
    if (length < 2 || length > bytes.size() - at - 1) return false;
    if (marker == kTables && !has_sound_tables(bytes.substr(at + 3, length - 2))) return false;
    at += 1 + length;
    // Entropy-coded data end at a marker that does not stand alone.
    while (marker == kScan && at + 1 < bytes.size() && (byte(at) != 0xff || stands_alone(byte(at + 1)))) ++at;
  }
  return true;
}

// Deflate expands a byte to 1032 bytes at most, of 8 pixels each. A header that claims more is damaged.
static constexpr double kMaxPixelsPerByte = 8 * 1032;

std::optional<TexturePixels> decode_texture(std::string_view bytes) {
  if (bytes.size() > static_cast<size_t>(std::numeric_limits<int>::max())) return std::nullopt;
  if (!has_whole_chunks(bytes) || !has_sound_segments(bytes)) return std::nullopt;
  TexturePixels pixels;
  int channels = 0;
  const auto* first = reinterpret_cast<const uint8_t*>(bytes.data());
  const auto size = static_cast<int>(bytes.size());
  if (!stbi_info_from_memory(first, size, &pixels.width, &pixels.height, &channels)) return std::nullopt;
  const double all = static_cast<double>(pixels.width) * pixels.height;
  if (!(all > 0 && all <= kMaxPixelsPerByte * size)) return std::nullopt;
  uint8_t* data = stbi_load_from_memory(first, size, &pixels.width, &pixels.height, &channels, 4);
  if (data == nullptr) return std::nullopt;
  pixels.rgba.assign(data, data + 4 * static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
  stbi_image_free(data);
  return pixels;
}

TexturePixels resized(const TexturePixels& from, int side, bool colours) {
  KERF_ASSERT(from.width > 0 && from.height > 0 && side > 0);
  if (from.width == side && from.height == side) return from;
  TexturePixels to{side, side,
                   std::vector<uint8_t>(4 * static_cast<size_t>(side) * static_cast<size_t>(side))};
  stbir_resize_uint8_generic(from.rgba.data(), from.width, from.height, 0, to.rgba.data(), side, side, 0, 4,
                             colours ? 3 : STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_WRAP, STBIR_FILTER_DEFAULT,
                             colours ? STBIR_COLORSPACE_SRGB : STBIR_COLORSPACE_LINEAR, nullptr);
  return to;
}

}  // namespace kerf
