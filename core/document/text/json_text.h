#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"

namespace kerf {

// The text of JSON. Fails if a string in it is not UTF-8.
Result<std::string> dump_json(const nlohmann::ordered_json& json, int indent = -1);

// The same in one line, with numbers as append_number() writes them: as journals have them.
Result<std::string> exact_text(const nlohmann::ordered_json& json);

// The name of a file in a file in `folder`: relative where it is in or below the folder or its parent, whole
// otherwise, and where `folder` is empty.
std::string path_text(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace kerf
