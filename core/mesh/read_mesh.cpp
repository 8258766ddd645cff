#include "core/mesh/read_mesh.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <new>
#include <string_view>
#include <system_error>

#include "core/mesh/files/gltf_reader.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/obj_reader.h"
#include "core/mesh/files/off_reader.h"
#include "core/mesh/files/ply_reader.h"
#include "core/mesh/files/scanner.h"
#include "core/mesh/files/stl_reader.h"

namespace kerf {
namespace {

constexpr size_t kLargestFile = size_t{1} << 32;
constexpr size_t kChunk = size_t{1} << 24;
constexpr double kLoadingShare = 0.2;  // of the progress; the rest is parsing

class OpenFile {
 public:
  // Does not wait for a pipe that nobody writes to.
  explicit OpenFile(const std::filesystem::path& path)
      : descriptor_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

// The bytes are read, not mapped: a mapped file that another program cuts short ends the process.
struct FileBytes {
  std::unique_ptr<char[]> data;
  size_t size = 0;

  std::string_view view() const { return {data.get(), size}; }
};

// The size of an open regular file.
Result<size_t> readable_size(int file, const std::string& name) {
  struct stat info {};
  if (::fstat(file, &info) != 0) return failed(name + ": " + std::generic_category().message(errno) + ".");
  if (S_ISDIR(info.st_mode)) return bad_input(name + ": this is a folder, not a mesh file.");
  if (!S_ISREG(info.st_mode)) return bad_input(name + ": this is a device or a pipe, not a mesh file.");
  const auto size = static_cast<size_t>(info.st_size);
  if (size == 0) return bad_input(name + ": the file is empty.");
  if (size > kLargestFile)
    return bad_input(name + ": the file is larger than 4 GiB, which is the most that is read.");
  return size;
}

Result<FileBytes> read_bytes(const std::filesystem::path& path, const std::string& name,
                             const Progress* progress) {
  const OpenFile file(path);
  if (file.descriptor() < 0) {
    return bad_input(name + ": cannot be opened: " + std::generic_category().message(errno) + ".");
  }
  const Result<size_t> size = readable_size(file.descriptor(), name);
  if (!size) return size.error();
  FileBytes bytes{std::make_unique_for_overwrite<char[]>(*size), 0};
  while (bytes.size < *size) {
    if (progress &&
        !progress->report(kLoadingShare * static_cast<double>(bytes.size) / static_cast<double>(*size))) {
      return cancelled();
    }
    const ssize_t got =
        ::read(file.descriptor(), bytes.data.get() + bytes.size, std::min(kChunk, *size - bytes.size));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return failed(name + ": cannot be read: " + std::generic_category().message(errno) + ".");
    if (got == 0) break;
    bytes.size += static_cast<size_t>(got);
  }
  return bytes;
}

Error not_a_mesh(const std::string& name, std::string_view kind) {
  const std::string what = kind.empty() ? "" : std::string(kind) + ", which is ";
  return bad_input(name + ": this is " + what + "no mesh that Kerf reads; it reads " +
                   list_mesh_titles(" and ") + ".");
}

Result<Soup> parse(std::string_view bytes, const std::string& name, const std::filesystem::path& path,
                   const Progress* progress) {
  const std::optional<MeshFormat> by_content = recognise_format(bytes, {});
  if (!by_content) {
    // What is no other kind of file may be a damaged one of the format that its name says.
    if (bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff"))
      return bad_input(name + ": this is UTF-16 text; save it as UTF-8.");
    const std::string_view kind = kind_of_file(bytes);
    if (!kind.empty()) return not_a_mesh(name, kind);
  }
  const std::optional<MeshFormat> format = by_content ? by_content : mesh_format(path.extension().string());
  if (!format) return not_a_mesh(name, {});
  switch (*format) {
    case MeshFormat::kObj:
      return read_obj(bytes, name, progress);
    case MeshFormat::kPly:
      return read_ply(bytes, name, progress);
    case MeshFormat::kStl:
      return read_stl(bytes, name, progress);
    case MeshFormat::kGlb:
    case MeshFormat::kGltf:
      return read_gltf(bytes, name, progress, path.has_parent_path() ? path.parent_path() : ".");
    case MeshFormat::kOff:
      break;
  }
  return read_off(bytes, name, progress);
}

Result<Soup> load_and_parse(const std::filesystem::path& path, const std::string& name,
                            const Progress* progress) {
  const Result<FileBytes> bytes = read_bytes(path, name, progress);
  if (!bytes) return bytes.error();
  const Progress parsing = share_of(progress, kLoadingShare, 1);
  return parse(bytes->view(), name, path, &parsing);
}

}  // namespace

Result<Soup> read_mesh(const std::filesystem::path& path, const Progress* progress) {
  const std::string name = one_line(path.string());
  try {
    return load_and_parse(path, name, progress);
  } catch (const std::bad_alloc&) {
    return failed(name + ": there is not enough memory to read it.");
  }
}

}  // namespace kerf
