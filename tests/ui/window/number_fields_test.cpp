#include "ui/window/number_text.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/support/gui_context.h"
#include "ui/window/widgets.h"

namespace kerf {
namespace {

class NumberEntries : public testing::Test {
 protected:
  NumberEntries() { report_entries_to(&message); }
  ~NumberEntries() override { report_entries_to(nullptr); }

  Message message;
  const NumberEntry radius{"Radius", RealFormat("%.3g "), length_unit("mm"), {0.25, 25}};
};

TEST_F(NumberEntries, accept_units_and_arithmetic_silently) {
  EXPECT_DOUBLE_EQ(*radius.entered("1/4 in", 1), 6.35);
  EXPECT_EQ(*radius.entered("2.5 mm", 1), 2.5);
  EXPECT_EQ(*radius.entered("2*3", 1), 6);
  EXPECT_TRUE(message.log.empty());
}

TEST_F(NumberEntries, report_rejected_text_and_the_value_kept) {
  EXPECT_FALSE(radius.entered("abc-5", 1.5).has_value());
  EXPECT_EQ(message.text, "Radius stays 1.5 mm: \"abc\" is not a number.");
  EXPECT_TRUE(message.is_error);
  EXPECT_FALSE(radius.entered("1e999", 1.5).has_value());
  EXPECT_EQ(message.text, "Radius stays 1.5 mm: \"1e999\" is too large.");
}

TEST_F(NumberEntries, report_clamping_and_keep_the_message_after_the_change) {
  EXPECT_EQ(*radius.entered("1 m", 1), 25);
  EXPECT_EQ(message.text, "Radius is limited to 25 mm, the maximum value");
  message.clear();
  EXPECT_EQ(message.text, "Radius is limited to 25 mm, the maximum value");
  message.clear();
  EXPECT_EQ(message.text, "");
  EXPECT_EQ(*radius.entered("-3", 1), 0.25);
  EXPECT_EQ(message.text, "Radius is limited to 0.25 mm, the minimum value");
}

TEST_F(NumberEntries, reject_values_that_must_be_positive) {
  const NumberEntry speed{"Speed", RealFormat("%.4g "), length_unit("mm", "/s"), kPositive};
  EXPECT_FALSE(speed.entered("0", 3).has_value());
  EXPECT_EQ(message.text, "Speed stays 3 mm/s: it must be more than 0.");
  EXPECT_EQ(*speed.entered("3 m/s", 3), 3000);
  EXPECT_EQ(message.text, "");
}

TEST_F(NumberEntries, use_the_unit_of_their_format) {
  const NumberEntry pace{"Pace", RealFormat("%.3g shots/s")};
  EXPECT_EQ(*pace.entered("4 shots/s", 1), 4);
  const NumberEntry share{"Volume", RealFormat("%.0f %%")};
  EXPECT_EQ(*share.entered("45 %", 1), 45);
  const NumberEntry power{"Power", RealFormat("%.4g W"), kWatts};
  EXPECT_EQ(*power.entered("1.5 kW", 1), 1500);
}

// Widgets of ImGui one below the other, of which no pixel is drawn.
class Entries : public testing::Test {
 protected:
  virtual void draw() = 0;
  void frame() {
    gui_.frame([&] { draw(); });
  }
  void click(ImVec2 at) {
    ImGuiIO& io = ImGui::GetIO();
    for (int i = 0; i < 2; ++i) frame();  // after the first one, the window has its size
    io.MousePos = {at.x + 3, at.y + 3};
    frame();
    io.MouseDown[0] = true;
    frame();
    io.MouseDown[0] = false;
    frame();
  }
  void type(const char* text) {
    ImGui::GetIO().AddInputCharactersUTF8(text);
    frame();
  }

 private:
  test::GuiContext gui_;
};

class FieldEntries : public Entries {
 protected:
  void draw() override {
    for (size_t i = 0; i < shown.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      at.at(i) = ImGui::GetCursorScreenPos();
      if (const auto text = edited.draw("##field", shown.at(i), shown.at(i)))
        entries.push_back(std::to_string(i) + ": " + *text);
      ImGui::PopID();
    }
  }

  EditedText edited;
  std::array<std::string, 2> shown{"0", "1"};
  std::array<ImVec2, 2> at{};
  std::vector<std::string> entries;
};

TEST_F(FieldEntries, are_reported_after_a_click_on_a_field_with_the_same_text) {
  frame();
  click(at[1]);
  type("0");
  click(at[0]);
  EXPECT_EQ(entries, std::vector<std::string>{"1: 0"});
  type("2");
  click(at[1]);
  EXPECT_EQ(entries, (std::vector<std::string>{"1: 0", "0: 2"}));
}

class SliderEntries : public Entries {
 protected:
  void draw() override {
    for (size_t i = 0; i < values.size(); ++i) {
      ImGui::PushID(static_cast<int>(i));
      at.at(i) = ImGui::GetCursorScreenPos();
      whole_slider({"Number", "##slider", "A number."}, values.at(i), 0, 9, "");
      ImGui::PopID();
    }
  }

  std::array<int, 2> values{3, 4};
  std::array<ImVec2, 2> at{};
};

TEST_F(SliderEntries, are_stored_after_a_click_on_the_slider_above) {
  frame();
  click(at[1]);
  type("7");
  click(at[0]);
  EXPECT_EQ(values, (std::array{3, 7}));
}

}  // namespace
}  // namespace kerf
