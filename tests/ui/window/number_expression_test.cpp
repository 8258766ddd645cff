#include "ui/window/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

const NumberUnit kMillimetres{Quantity::kLength, 1e-3, "mm"};
const NumberUnit kSpeed{Quantity::kLength, 1e-3, "mm/s", "/s"};
const NumberUnit kKelvin{Quantity::kPlain, 1, "K"};

// The value, or NaN where the text is refused, then with a reason.
double value_of(const std::string& text, const NumberUnit& unit = {}) {
  const Result<double> value = evaluate_number(text, unit);
  if (value) return *value;
  EXPECT_FALSE(value.error().message.empty()) << text;
  return NAN;
}

std::string reason(const std::string& text, const NumberUnit& unit = {}) {
  const Result<double> value = evaluate_number(text, unit);
  return value ? "" : value.error().message;
}

TEST(NumberExpression, a_trailing_unit_applies_to_the_whole_expression) {
  EXPECT_DOUBLE_EQ(value_of("1/4 in", kMillimetres), 6.35);
  EXPECT_DOUBLE_EQ(value_of("1 + 2 cm", kMillimetres), 30);
  EXPECT_DOUBLE_EQ(value_of("2ft", kMillimetres), 609.6);
  EXPECT_DOUBLE_EQ(value_of("(3-1)*1.5 M", kMillimetres), 3000);
  EXPECT_DOUBLE_EQ(value_of("2.75 mm", kMillimetres), 2.75);
  EXPECT_DOUBLE_EQ(value_of("20 \xc2\xb5m", kMillimetres), 0.02);
  EXPECT_DOUBLE_EQ(value_of("2 in", {Quantity::kLength, 0.0254, "in"}), 2);
  EXPECT_DOUBLE_EQ(value_of("3 m/s", kSpeed), 3000);
  EXPECT_DOUBLE_EQ(value_of("3 m", kSpeed), 3000);
  EXPECT_DOUBLE_EQ(value_of("45\xc2\xb0", kDegrees), 45);
  EXPECT_DOUBLE_EQ(value_of("90/2 deg", kDegrees), 45);
  EXPECT_DOUBLE_EQ(value_of("3.14159265358979312 rad", kDegrees), 180);
  EXPECT_DOUBLE_EQ(value_of("1.5 kW", kWatts), 1500);
  EXPECT_DOUBLE_EQ(value_of("1.5 kw", kWatts), 1500);
  EXPECT_DOUBLE_EQ(value_of("293 K", kKelvin), 293);
}

TEST(NumberExpression, digits_may_be_grouped_by_three) {
  EXPECT_EQ(value_of("4 000"), 4000);
  EXPECT_EQ(value_of("12 345 678.5"), 12'345'678.5);
  EXPECT_EQ(value_of("1 000*2 + 1 000"), 3000);
  EXPECT_EQ(value_of("-4 000 mm", kMillimetres), -4000);
  for (const char* wrong : {"4 00", "4 0000", "1234 567", "4  000", "0.123 456", "1 2", "1 000 00"})
    EXPECT_NE(reason(wrong).find("is not one number"), std::string::npos) << wrong << ": " << reason(wrong);
}

TEST(NumberExpression, everything_else_is_rejected_with_a_reason) {
  EXPECT_EQ(reason(""), "the field is empty");
  EXPECT_EQ(reason("   "), "the field is empty");
  EXPECT_EQ(reason("abc-5"), "\"abc\" is not a number");
  EXPECT_EQ(reason("1e999"), "\"1e999\" is too large");
  EXPECT_EQ(reason("1e-999"), "\"1e-999\" is too close to zero");
  EXPECT_EQ(reason("1e300*1e300"), "the value is too large");
  EXPECT_EQ(reason("1e306 km", kMillimetres), "the value is too large");
  EXPECT_EQ(reason("1/0"), "division by zero");
  EXPECT_EQ(reason("1/(2-2)"), "division by zero");
  EXPECT_EQ(reason("2*"), "a number is missing at the end");
  EXPECT_EQ(reason("(1+2"), "a \")\" is missing");
  EXPECT_EQ(reason("1+2)"), "a \")\" has no \"(\"");
  EXPECT_EQ(reason("3 K"), "\"K\" is not understood: the number has no unit");
  EXPECT_EQ(reason("3 mm", kKelvin), "\"mm\" is not understood: the unit is K");
  EXPECT_EQ(reason("3 W", kMillimetres), "\"W\" is not understood: the units are mm, cm, m, in and ft");
  EXPECT_EQ(reason("3 m/s", kMillimetres), "\"m/s\" is not understood: the units are mm, cm, m, in and ft");
  EXPECT_EQ(reason("1 in + 2", kMillimetres),
            "the unit must be at the end; it applies to the whole expression");
  EXPECT_EQ(reason("nan"), "\"nan\" is not a number");
  EXPECT_EQ(reason("inf"), "\"inf\" is not a number");
  EXPECT_EQ(reason("0x10"), "\"x10\" is not understood: the number has no unit");
  for (const char* comma : {"1,5", "1,000", ",5", "(1,5)", "1,5 mm"})
    EXPECT_EQ(reason(comma, kMillimetres).find("commas are not supported"), 0u)
        << reason(comma, kMillimetres);
}

TEST(NumberExpression, brackets_nest_to_the_documented_depth) {
  const auto nested = [](size_t depth) { return std::string(depth, '(') + "1" + std::string(depth, ')'); };
  EXPECT_EQ(value_of(nested(kMaxBrackets)), 1);
  EXPECT_EQ(reason(nested(kMaxBrackets + 1)), "too many nested brackets");
  EXPECT_EQ(reason(std::string(100'000, '(')), "too many nested brackets");
  EXPECT_EQ(value_of(std::string(100'000, '-') + "1"), 1);
}

// The reference: an expression is made together with its value.
class RandomExpression {
 public:
  explicit RandomExpression(uint64_t seed) : random_(seed) {}

  struct Made {
    std::string text;
    double value = 0;
  };
  Made sum(int depth) {
    Made made = product(depth);
    for (uint64_t i = random_.below(3); i > 0; --i) {
      const bool plus = random_.below(2) == 0;
      const Made next = product(depth);
      made.text += spaces() + (plus ? "+" : "-") + spaces() + next.text;
      made.value = plus ? made.value + next.value : made.value - next.value;
    }
    return made;
  }

 private:
  std::string spaces() { return std::string(random_.below(3), ' '); }

  Made product(int depth) {
    Made made = factor(depth);
    for (uint64_t i = random_.below(3); i > 0; --i) {
      const bool times = random_.below(2) == 0;
      const Made next = factor(depth);
      made.text += spaces() + (times ? "*" : "/") + spaces() + next.text;
      made.value = times ? made.value * next.value : made.value / next.value;
    }
    return made;
  }

  Made factor(int depth) {
    if (random_.below(4) == 0) {
      const Made made = factor(depth);
      return {"-" + spaces() + made.text, -made.value};
    }
    if (depth == 0 || random_.below(3) > 0) return number();
    const Made made = sum(depth - 1);
    return {"(" + spaces() + made.text + spaces() + ")", made.value};
  }

  Made number() {
    std::array<char, 64> text{};
    const double value = random_.uniform(1, 10) * std::pow(10.0, random_.uniform(-4, 8));
    const int digits = static_cast<int>(random_.below(17));
    switch (random_.below(3)) {
      case 0:
        std::snprintf(text.data(), text.size(), "%.*f", digits, value);
        break;
      case 1:
        std::snprintf(text.data(), text.size(), "%.*g", digits, value);
        break;
      default:
        std::snprintf(text.data(), text.size(), "%.*e", digits, value);
    }
    return {text.data(), std::strtod(text.data(), nullptr)};
  }

  Random random_;
};

TEST(NumberExpression, random_expressions_evaluate_to_the_expected_value) {
  RandomExpression random(71);
  size_t finite = 0;
  for (uint64_t i = 0; i < runs(20'000); ++i) {
    const RandomExpression::Made made = random.sum(4);
    const Result<double> value = evaluate_number(made.text);
    if (std::isfinite(made.value) && value) ++finite;
    // One that divides by zero somewhere may be finite again by a second division.
    if (value) {
      EXPECT_EQ(*value, made.value) << made.text;
    }
    if (!std::isfinite(made.value)) {
      EXPECT_FALSE(value.ok()) << made.text;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(finite, runs(20'000) / 2);
}

TEST(NumberExpression, random_texts_yield_a_finite_number_or_a_reason) {
  constexpr std::string_view kPieces[] = {"0", "1",   "9",        " ",    "000", ".", ",",   "e",  "E",
                                          "+", "-",   "*",        "/",    "(",   ")", "mm",  "in", "m",
                                          "W", "rad", "\xc2\xb0", "\xff", "%",   "x", "e999"};
  Random random(72);
  size_t read = 0;
  for (uint64_t i = 0; i < runs(200'000); ++i) {
    std::string text;
    for (uint64_t n = random.below(12); n > 0; --n) text += kPieces[random.below(std::size(kPieces))];
    if (random.below(50) == 0) text += '\0';
    const NumberUnit units[] = {{}, kMillimetres, kSpeed, kDegrees, kWatts, kKelvin};
    const Result<double> value = evaluate_number(text, units[random.below(std::size(units))]);
    if (value) {
      ++read;
      EXPECT_TRUE(std::isfinite(*value)) << text;
    } else {
      EXPECT_FALSE(value.error().message.empty()) << text;
    }
  }
  EXPECT_GT(read, runs(200'000) / 500);
}

// What fields show is read as the same value, within the digits that are shown.
TEST(NumberExpression, reads_the_text_shown_in_fields) {
  Random random(73);
  for (uint64_t i = 0; i < runs(20'000); ++i) {
    const double value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-12, 12));
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.4g mm", value);
    const double shown = std::strtod(text.data(), nullptr);
    EXPECT_EQ(value_of(text.data(), kMillimetres), shown) << text.data();
  }
}

}  // namespace
}  // namespace kerf
