#include "ui/editor/recent/recent_feature.h"

#include "ui/window/screenshot.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

constexpr double kLongestWait = 2;  // s, that a thumbnail waits for a picture that goes on changing

// The file that the picture shows, as it was opened; empty where it shows none, or several.
fs::path file_shown(const OpenWork& work) {
  if (!work.file.empty()) return work.file;
  return work.files.size() == 1 ? work.files.front() : fs::path();
}

// What a thumbnail is taken of: a file as it was opened or saved.
struct KeptState {
  fs::path file;
  size_t commands = 0;
  friend bool operator==(const KeptState&, const KeptState&) = default;
};

class RecentFeature : public Feature {
 public:
  explicit RecentFeature(Workspace& on) : on_(on) {}

  std::vector<ActionGroup> actions() override {
    return {{101, "File", {UserAction{.name = "Open recent", .items = [this] { return files(); }}}}};
  }

  void advance(double) override {
    if (recent_ == on_.settings.recent) return;
    recent_ = on_.settings.recent;
    on_.thumbnails.keep_only(recent_);
  }

  void drawn(Drawn what) override {
    if (what == Drawn::kPicture && is_due()) take();
  }

 private:
  std::vector<UserAction> files();
  bool is_due();
  void take();

  Workspace& on_;
  std::vector<fs::path> recent_;
  KeptState wanted_, taken_;
  double wanted_at_ = 0;  // s of the clock
};

std::vector<UserAction> RecentFeature::files() {
  std::vector<UserAction> actions;
  for (const fs::path& file : on_.settings.recent) {
    actions.push_back({.name = file.filename().string(), .tip = file.string()});
    actions.back().run = [this, file] { on_.open({file}); };
    actions.back().why_not = [file]() -> const char* {
      std::error_code error;
      return fs::exists(file, error) ? nullptr : "This file is not there any more.";
    };
    actions.back().tip_picture = [this, file] { return on_.thumbnails.find(file); };
  }
  if (!actions.empty()) actions.back().ends_group = true;
  actions.push_back({.name = "Forget them", .tip = "Empties this list; the files stay."});
  actions.back().run = [this] { on_.settings.recent.clear(); };
  actions.back().why_not = [this] {
    return on_.settings.recent.empty() ? "Nothing was opened yet." : nullptr;
  };
  return actions;
}

// Whether the picture shows a file as it was opened or saved, and is complete.
bool RecentFeature::is_due() {
  const KeptState now{file_shown(on_.work), on_.work.saved_commands};
  if (now == taken_ || now.file.empty()) return false;
  if (now != wanted_) {
    wanted_ = now;
    wanted_at_ = on_.clock->seconds();
  }
  if (!on_.window->draws() || on_.opening.loader.busy() || on_.picture->first().is_sending()) return false;
  return !on_.picture->busy() || on_.clock->seconds() - wanted_at_ > kLongestWait;
}

// A file that is not among the recent ones, as the default scene, has none. One that cannot be written is not
// missed enough to be told of.
void RecentFeature::take() {
  taken_ = wanted_;
  const fs::path file = whole_path(taken_.file);
  if (std::ranges::find(recent_, file) == recent_.end()) return;
  const Area part = pixels_of(on_.view.layout.first, *on_.window);
  (void)on_.thumbnails.keep(file, window_pixels(on_.window->pixel_size(), part));
}

}  // namespace

std::unique_ptr<Feature> recent_feature(Workspace& on) { return std::make_unique<RecentFeature>(on); }

}  // namespace kerf
