#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/base/result.h"

namespace kerf {

// Appends the shortest decimal number that is read back as the same double, including the sign of zero. It
// always has a point or an exponent, so that JSON does not treat it as an integer. Precondition: x is finite.
void append_number(std::string& text, double x);

// The text of JSON. Fails if a string in it is not UTF-8.
Result<std::string> dump_json(const nlohmann::ordered_json& json, int indent = -1);

// The text of JSON in one line, as journals have it, with numbers as append_number() writes them.
Result<std::string> exact_text(const nlohmann::ordered_json& json);

// The name of a file in a file in `folder`: relative where it is in or below the folder or its parent, whole
// otherwise, and where `folder` is empty.
std::string path_text(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace kerf
