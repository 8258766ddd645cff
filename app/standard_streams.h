#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"

namespace kerf {

// The name that stands for standard input or standard output on the command line.
inline constexpr const char* kStream = "-";

// Returns the file to read for an argument: the argument itself or, for "-", a file in memory with all of
// standard input, which exists until the program ends. Fails if standard input was read before or cannot be
// read. Call it before catch_interrupts(), because a signal does not end the wait for input.
Result<std::string> input_file(const std::string& argument);

// Returns a message with "standard input" and "standard output" in place of the files that stand for them.
std::string with_stream_names(std::string message);

// Calls `write` with a file of this extension in a temporary folder, and copies the file to standard output.
Status write_to_output(const std::string& extension,
                       const std::function<Status(const std::filesystem::path& file)>& write);

}  // namespace kerf
