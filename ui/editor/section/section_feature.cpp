#include "ui/editor/section/section_feature.h"

#include <imgui.h>

#include "core/base/assert.h"
#include "ui/editor/section/section_handles.h"
#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/window/number_fields.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

// Edits, by buttons and by name
// --------------------------------------------------------------------------------------------------------

// Each edit ends with the plane shown.
void show(ViewState& view, const SectionPlane& plane) {
  view.look.section = plane;
  view.look.show.section = true;
  view.picture_old = true;
}

// Sets the plane through the middle of the world if it is shown and stands nowhere yet.
void place_section(ViewState& view, const World& world) {
  if (!view.look.show.section || view.look.section || world.ids().empty()) return;
  show(view, section_through(world.bounds(), -view.seen_first().forward));
}

// Shows what was taken away, and takes away what was shown.
void flip_section(ViewState& view) {
  KERF_ASSERT(view.look.section);
  show(view, {view.look.section->point, -view.look.section->normal});
}

// Turns the plane about its point: across an axis of the world (0: X, 1: Y, 2: Z), with the eye on the side
// that is taken away, or parallel to the picture. Precondition: the plane is placed.
void turn_section_across(ViewState& view, int axis) {
  KERF_ASSERT(view.look.section && axis >= 0 && axis < 3);
  Vec3 normal(0);
  normal[axis] = view.seen_first().forward[axis] > 0 ? -1 : 1;
  show(view, {view.look.section->point, normal});
}

void turn_section_to_view(ViewState& view) {
  KERF_ASSERT(view.look.section);
  show(view, {view.look.section->point, -view.seen_first().forward});
}

// The plane as text in the clipboard, and back; see section_text().
void copy_section(const ViewState& view, Message& message) {
  KERF_ASSERT(view.look.section);
  ImGui::SetClipboardText(section_text(*view.look.section).c_str());
  message.say("The section plane is in the clipboard as text, as kerf render --section takes it");
}

void paste_section(ViewState& view, Message& message) {
  const char* text = ImGui::GetClipboardText();
  const Result<SectionPlane> plane = parse_section(text != nullptr ? text : "");
  if (!plane) return message.say("The clipboard holds no section plane: " + plane.error().message, true);
  show(view, *plane);
  message.say("");
}

// The panel
// --------------------------------------------------------------------------------------------------------

bool button(const char* name, const char* landmark, const char* meaning, bool first = false) {
  if (!first) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  const bool clicked = ImGui::Button(name);
  mark_last_item(landmark);
  tooltip(meaning);
  return clicked;
}

void draw_turns(ViewState& view) {
  property("Turn");
  if (button("X", "section X", "Across the X axis.", true)) turn_section_across(view, 0);
  if (button("Y", "section Y", "Across the Y axis.")) turn_section_across(view, 1);
  if (button("Z", "section Z", "Across the Z axis.")) turn_section_across(view, 2);
  if (button("View", "section view", "Parallel to the picture.")) turn_section_to_view(view);
  if (button("Flip", "section flip", "Shows the other side.")) flip_section(view);
}

void draw_text(ViewState& view, Message& message) {
  property("As text");
  if (button("Copy", "section copy", "To the clipboard, as kerf render --section takes it.", true))
    copy_section(view, message);
  if (button("Paste", "section paste", "From the clipboard.")) paste_section(view, message);
}

// The feature
// --------------------------------------------------------------------------------------------------------

// Moves or turns the plane by one of its handles.
class DragOfPlane : public Interaction {
 public:
  DragOfPlane(Workspace& on, SectionDrag drag) : on_(on), drag_(std::move(drag)) {}

  const SectionDrag& drag() const { return drag_; }
  void move(const InputEvent&) override { show(on_.view, drag_.to(on_.view.in_picture(on_.pointer))); }
  bool cancel() override {
    show(on_.view, drag_.from());
    return true;
  }
  const char* words() const override {
    return drag_.kind() == SectionDrag::Kind::kMove ? "Moving the section plane"
                                                    : "Turning the section plane";
  }

 private:
  Workspace& on_;
  SectionDrag drag_;
};

using Edit = std::function<void(ViewState&)>;

// The plane is shown first, where it is not.
UserAction edit_action(Workspace& on, const char* name, const char* tip, Edit edit) {
  UserAction action{.name = name, .tip = tip, .in_menu = false};
  action.run = [&on, edit = std::move(edit)] {
    on.view.look.show.section = true;
    place_section(on.view, on.world());
    if (on.view.look.section) edit(on.view);
  };
  return action;
}

UserAction across(Workspace& on, const char* name, int axis) {
  return edit_action(on, name, "Turns the section plane about its point; what is towards the eye goes.",
                     [axis](ViewState& view) { turn_section_across(view, axis); });
}

class SectionFeature : public Feature {
 public:
  explicit SectionFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"View", Tab::kLook, 1000, true, [this] { draw_rows(); }}};
  }

  std::vector<ActionGroup> actions() override {
    return {{1500,
             "View",
             {edit_action(on_, "Section plane: flip", "Shows the other side.", flip_section),
              across(on_, "Section plane: across X", 0), across(on_, "Section plane: across Y", 1),
              across(on_, "Section plane: across Z", 2),
              edit_action(on_, "Section plane: parallel to the picture", "Turns it about its point.",
                          turn_section_to_view),
              edit_action(on_, "Section plane: copy", "As text, as kerf render --section takes it.",
                          [this](ViewState& view) { copy_section(view, on_.message); }),
              UserAction{.name = "Section plane: paste",
                         .tip = "Sets it as the text in the clipboard says.",
                         .run = [this] { paste_section(on_.view, on_.message); },
                         .in_menu = false}}}};
  }

  std::vector<Gesture> gestures() const override {
    return {{120, "Left drag on the section plane's handles", "Move it along its normal, or turn it"}};
  }

  std::unique_ptr<Interaction> claim(const Press&) override {
    auto drag = section_drag_at(on_.view, on_.pointer);
    return drag ? std::make_unique<DragOfPlane>(on_, std::move(*drag)) : nullptr;
  }

  void advance(double) override { place_section(on_.view, on_.world()); }

  void forget() override {
    on_.view.look.section.reset();
    on_.view.look.show.section = false;
  }

  void draw_marks(ImDrawList& list) override {
    if (on_.cutting()) return;
    const auto* held = dynamic_cast<const DragOfPlane*>(on_.held.get());
    draw_section(on_.view, on_.world().bounds(), on_.points() ? std::optional(on_.pointer) : std::nullopt,
                 held != nullptr ? std::optional(held->drag()) : std::nullopt, list);
  }

  void mark(Landmarks& landmarks) const override { mark_handles(section_handles(on_.view), landmarks); }

 private:
  void draw_rows();

  Workspace& on_;
  NumberFields fields_;
};

// Rows of the panel while the plane is shown: its point and its normal as numbers that can be typed, in the
// numbers of the file, and buttons that flip, turn, copy and paste it.
void SectionFeature::draw_rows() {
  ViewState& view = on_.view;
  if (shown_section(view.look) == nullptr || !begin_properties("section plane")) return;
  SectionPlane plane = *view.look.section;
  bool typed = fields_.vector("Section", plane.point, "%.5g",
                              "X, Y and Z of the point that the plane goes through and turns about.",
                              file_unit(view.frame.unit), on_.world().loaded_bounds().diagonal());
  typed |= fields_.vector("Normal", plane.normal, "%.4g",
                          "The direction that the plane faces, of any length. What lies on this side is not "
                          "drawn.");
  if (typed && plane.normal != Vec3(0)) {
    view.look.section = SectionPlane::facing(plane.point, plane.normal);
    view.picture_old = true;
  }
  draw_turns(view);
  draw_text(view, on_.message);
  end_properties();
}

}  // namespace

std::unique_ptr<Feature> section_feature(Workspace& on) { return std::make_unique<SectionFeature>(on); }

}  // namespace kerf
