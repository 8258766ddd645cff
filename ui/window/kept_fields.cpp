#include "ui/window/kept_fields.h"

#include "core/base/platform.h"
#include "core/document/text/json.h"

namespace kerf {

using Json = nlohmann::json;
namespace fs = std::filesystem;

KeptFields& KeptFields::flag(const char* key, bool& x) {
  return any(key, x, [&](const Json& value) {
    if (value.is_boolean()) x = value.get<bool>();
  });
}

KeptFields& KeptFields::any(const char* key, const Json& written,
                            const std::function<void(const Json&)>& read) {
  if (!reads_) {
    json_[key] = written;
  } else if (const auto found = json_.find(key); found != json_.end()) {
    read(*found);
    json_.erase(found);
  }
  return *this;
}

bool set_aside(const fs::path& file) {
  std::error_code error;
  fs::rename(file, fs::path(file) += ".bad", error);
  return !error;
}

Json read_kept(const fs::path& file, std::string& fault) {
  std::error_code error;
  if (!fs::exists(file, error)) return Json::object();
  if (const auto text = read_text_file(file)) {
    const auto json = parse_json(*text, file.string());
    if (json && json->is_object()) return *json;
  }
  fault = set_aside(file)
              ? "The settings could not be read; their file was set aside as " + file.string() + ".bad"
              : file.string() + ": cannot be read or set aside; the defaults are used";
  return Json::object();
}

Status write_kept(const Json& settings, const fs::path& file) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    return failed(file.parent_path().string() +
                  ": cannot create the folder for the settings: " + error.message());
  return write_file_atomically(file, settings.dump(2) + "\n");
}

}  // namespace kerf
