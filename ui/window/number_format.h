#pragma once

#include <string>
#include <string_view>

namespace kerf {

// The printf format of a number in a widget, with at most one conversion: "%.1f MB". The compiler checks it,
// as it checks the formats of functions with an attribute, which widgets that are given a pointer to their
// number cannot have. `conversions` are the letters that suit the type of the number.
class NumberFormat {
 public:
  const char* c_str() const { return text_; }
  // The text after the number, as it is shown: "MB" of "%.1f MB", without the space.
  std::string unit() const;

 protected:
  consteval NumberFormat(const char* text, std::string_view conversions) : text_(text) {
    if (!is_format(text, conversions)) throw "This is not a format of one number.";
  }

 private:
  static consteval bool is_format(std::string_view text, std::string_view conversions) {
    size_t found = 0;
    for (size_t i = 0; i < text.size(); ++i) {
      if (text[i] != '%') continue;
      ++i;
      if (i < text.size() && text[i] == '%') continue;
      while (i < text.size() && std::string_view("+-#.0123456789").find(text[i]) != std::string_view::npos)
        ++i;
      if (i == text.size() || conversions.find(text[i]) == std::string_view::npos) return false;
      ++found;
    }
    return found <= 1;
  }

  const char* text_;
};

// The format of a float or a double.
struct RealFormat : NumberFormat {
  consteval RealFormat(const char* text) : NumberFormat(text, "aefgAEFG") {}
};

// The format of an int.
struct WholeFormat : NumberFormat {
  consteval WholeFormat(const char* text) : NumberFormat(text, "d") {}
};

}  // namespace kerf
