#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <type_traits>

#include "core/base/number_range.h"
#include "core/base/result.h"
#include "core/base/vec3.h"

namespace kerf {

// The size of a picture in pixels.
struct PixelSize {
  int width = 0, height = 0;
};

// Parses "WxH", each number from 1 to 16384.
Result<PixelSize> parse_size(const std::string& text);

// Parses "x,y,z", three finite numbers. The error names `option`.
Result<Vec3> parse_point(const std::string& option, const std::string& text);

// Parses a text that consists of one finite number. Returns false for any other text.
bool parse_number(std::string_view text, double& value);

// Whether a text is a number within a range; if not, what it must be.
std::string check_number(const std::string& text, const NumberRange& range, bool whole);

// The help of an option with its limits at the end.
std::string help_with_limits(const std::string& help, const NumberRange& range);

template <typename T>
struct NumberOf {
  using Type = T;
};
template <typename T>
struct NumberOf<std::optional<T>> {
  using Type = T;
};

// Adds an option for a number, or an optional one. Its help ends with the limits of the range, and another
// value is a wrong command line.
template <typename T>
CLI::Option* add_number(CLI::App& command, const std::string& name, T& x, const NumberRange& range,
                        const std::string& help) {
  constexpr bool kWhole = std::is_integral_v<typename NumberOf<T>::Type>;
  CLI::Option* const option = command.add_option(name, x, help_with_limits(help, range));
  return option->check([range](const std::string& text) { return check_number(text, range, kWhole); });
}

}  // namespace kerf
