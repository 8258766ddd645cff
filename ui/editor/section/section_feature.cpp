#include "ui/editor/section/section_feature.h"

#include "ui/editor/section/section_edits.h"
#include "ui/editor/section/section_handles.h"
#include "ui/editor/section/section_rows.h"

namespace kerf {

namespace {

// Moves or turns the plane by one of its handles.
class DragOfPlane : public Interaction {
 public:
  DragOfPlane(Workspace& on, SectionDrag drag) : on_(on), drag_(std::move(drag)) {}

  const SectionDrag& drag() const { return drag_; }
  void move(const InputEvent&) override { show(drag_.to(on_.view.in_picture(on_.pointer))); }
  bool cancel() override {
    show(drag_.from());
    return true;
  }
  const char* words() const override {
    return drag_.kind() == SectionDrag::Kind::kMove ? "Moving the section plane"
                                                    : "Turning the section plane";
  }

 private:
  void show(const SectionPlane& plane) {
    on_.view.look.section = plane;
    on_.view.picture_old = true;
  }

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
    return {{"View", 1300, false, [this] { rows_.draw(on_.view, on_.message); }}};
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

  void mark(Landmarks& landmarks) const override {
    for (const SectionHandle& handle : section_handles(on_.view))
      landmarks.mark(name_of(handle), {grip_of(handle), Vec2(0)});
  }

 private:
  Workspace& on_;
  SectionRows rows_;
};

}  // namespace

std::unique_ptr<Feature> section_feature(Workspace& on) { return std::make_unique<SectionFeature>(on); }

}  // namespace kerf
