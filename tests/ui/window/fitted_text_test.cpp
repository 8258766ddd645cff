#include "ui/window/widgets.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <array>

#include "core/base/random.h"
#include "tests/support/gui_context.h"
#include "tests/support/runs.h"

namespace kerf {
namespace {

// Each character is a pixel wide.
float characters(std::string_view text) {
  return static_cast<float>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
}

TEST(FittedText, ends_in_an_ellipsis_if_it_does_not_fit) {
  EXPECT_EQ(fitted_text("wheel_front", 11, characters), "wheel_front");
  EXPECT_EQ(fitted_text("wheel_front", 10, characters), "wheel_f...");
  EXPECT_EQ(fitted_text("two words", 7, characters), "two...");
  EXPECT_EQ(fitted_text("wheel", 3, characters), "...");
  EXPECT_EQ(fitted_text("wheel", 2, characters), "");
}

TEST(FittedText, is_truncated_at_a_whole_character_and_as_long_as_fits) {
  Random random(5);
  const std::string_view pieces[] = {"a", "\xc2\xb0", "\xe2\x82\xac", "\xf0\x9f\x98\x80"};
  for (uint64_t i = 0; i < runs(2'000); ++i) {
    std::string text;
    const uint64_t length = random.below(20);
    for (uint64_t n = 0; n < length; ++n) text += pieces[random.below(std::size(pieces))];
    const auto width = static_cast<float>(random.below(20));
    const std::string fitted = fitted_text(text, width, characters);
    if (characters(text) <= width) {
      EXPECT_EQ(fitted, text);
      continue;
    }
    EXPECT_EQ(characters(fitted), width >= 3 ? width : 0);
    if (fitted.empty()) continue;
    const size_t kept = fitted.size() - 3;
    EXPECT_EQ(fitted.substr(0, kept), text.substr(0, kept));
    EXPECT_NE(static_cast<unsigned char>(text[kept]) & 0xc0u, 0x80u) << "in the middle of a character";
  }
}

TEST(FittedText, may_keep_the_end_from_a_whole_character_on) {
  EXPECT_EQ(fitted_end("/home/a", 7, characters), "/home/a");
  EXPECT_EQ(fitted_end("/home/a", 6, characters), "...e/a");
  EXPECT_EQ(fitted_end("/\xd0\xb4\xd0\xbe\xd0\xbc", 3, characters), "...");
  EXPECT_EQ(fitted_end("/xx/\xd0\xb4\xd0\xbe\xd0\xbc/a/b", 8, characters), "...\xd0\xbc/a/b");
}

TEST(FittedNumber, drops_digits_then_its_unit_and_is_never_truncated) {
  const auto fitted = [](double value, const RealFormat& format, float width) {
    return fitted_number(value, format, "mm", 0, width, characters);
  };
  EXPECT_EQ(fitted(0.26874, "%.4g ", 9), "0.2687 mm");
  EXPECT_EQ(fitted(0.26874, "%.4g ", 8), "0.269 mm");
  EXPECT_EQ(fitted(0.26874, "%.4g ", 5), "0.269");
  EXPECT_EQ(fitted(3.062e-17, "%.4g ", 8), "3e-17 mm");
  EXPECT_EQ(fitted(3.062e-17, "%.4g ", 7), "3.1e-17");
  EXPECT_EQ(fitted(123456, "%.0f ", 5), "1.2e5");
  EXPECT_EQ(fitted(-123456, "%.0f ", 2), "...");
}

TEST(FittedNumber, is_zero_for_noise) {
  EXPECT_EQ(fitted_number(5.551e-17, "%.4g", "", 1, 9, characters), "0");
  EXPECT_EQ(fitted_number(-0.0, "%.4g", "", 1, 9, characters), "0");
}

TEST(ProgressText, reaches_100_percent_at_no_time) {
  EXPECT_EQ(progress_text(0), "");
  EXPECT_EQ(progress_text(0.4), "40 %");
  EXPECT_EQ(progress_text(0.999), "99 %");
  EXPECT_EQ(progress_text(1), "99 %");
}

TEST(WholeLabel, is_as_wide_as_its_text) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  ImGui::GetIO().DisplaySize = {400, 300};
  ImGui::GetIO().Fonts->Build();
  ImGui::NewFrame();
  for (const char* text : {"plate.stl", "plate ##2.stl", "###.obj", "a####", "#"}) {
    const float width = ImGui::CalcTextSize(text).x;
    for (const char* id : {"", "##id", "###id"})
      EXPECT_EQ(ImGui::CalcTextSize((whole_label(text) + id).c_str(), nullptr, true).x, width) << text << id;
  }
  ImGui::EndFrame();
  ImGui::DestroyContext();
}

// The number of vertices with which a list shows its selected value.
int vertices_of_list(const std::string& value) {
  test::GuiContext gui;
  for (int i = 0; i < 4; ++i) {
    gui.frame([&] {
      if (begin_fitted_combo("##list", value)) ImGui::EndCombo();
    });
  }
  return ImGui::GetDrawData()->TotalVtxCount;
}

TEST(FittedCombo, shows_a_value_with_two_number_signs_in_full) {
  EXPECT_EQ(vertices_of_list("bolt##2"), vertices_of_list("bolt--2"));
}

TEST(FieldText, is_truncated_at_a_whole_character) {
  std::array<char, 8> buffer{};
  const auto filled = [&](std::string_view text) {
    fill_field(buffer, text);
    return std::string(buffer.data());
  };
  EXPECT_EQ(filled("wheel_front"), "wheel_f");
  EXPECT_EQ(filled("wheel"), "wheel");
  EXPECT_EQ(filled("sixsix\xc2\xb0"), "sixsix");
  EXPECT_EQ(filled("five5\xc2\xb0"), "five5\xc2\xb0");
  EXPECT_EQ(filled("four\xf0\x9f\x98\x80"), "four");
  EXPECT_EQ(filled(""), "");
}

}  // namespace
}  // namespace kerf
