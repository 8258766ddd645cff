#pragma once

namespace kerf {

// What has changed in a picture since it was drawn last.
enum class PictureChange {
  kNothing,
  kHeat,  // the heat of faces, which alters their colours and no shadow
  kAll,   // anything
};

// Whether a picture stands still, so that work on it that takes several frames is worth while.
class PictureRest {
 public:
  // To be called once a frame, at a time in seconds of a clock that never goes back.
  void follow(PictureChange change, double now) {
    now_ = now;
    if (change != PictureChange::kNothing) changed_ = now;
    if (change == PictureChange::kAll) moved_ = now;
  }
  // Whether nothing in it has changed for a moment.
  bool rests() const { return now_ - changed_ > kMoment; }
  // Whether nothing but heat has.
  bool shapes_rest() const { return now_ - moved_ > kMoment; }

 private:
  static constexpr double kMoment = 0.15;  // s
  double now_ = 0, changed_ = 0, moved_ = 0;
};

}  // namespace kerf
