#include "ui/game/match_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "ui/render/bodies/body_marks.h"

namespace kerf {

namespace {

constexpr double kSlowPicture = 1.0 / 24;  // s
constexpr double kFarTooSlow = 0.15;       // s
constexpr int kWarmUp = 3, kSlowPictures = 3;
constexpr double kFastPicture = 1.0 / 40;  // s
constexpr int kFastPictures = 60;
constexpr double kResolutionStep = 0.1;
constexpr double kBrighter = 1.4;
constexpr double kBiteSize = 1.4;     // of sparks, compared with those of a car in the editor
constexpr double kScorched = 0.4;     // kg/s, of the surface that stops a beam
constexpr double kSparks = 5;         // m/s, from which on a crash throws sparks
constexpr double kCrashSize = 2;      // of these
constexpr double kRubbedOff = 0.035;  // kg, for each m/s of a crash

Paint paint_of(const Match& match, const std::string& name) {
  for (const Vehicle& v : match.vehicles()) {
    const auto found = v.what().paints.find(name);
    if (found != v.what().paints.end()) return found->second;
  }
  return {};
}

// The beam of a vehicle as it is drawn, up to the wall or the ground where it ends; nothing if it is off.
// `strike` is the first surface that it meets, be it cut or not. Precondition: the match has this vehicle.
std::optional<BeamPicture> beam_of(const Match& match, size_t vehicle, const Sight& sight) {
  KERF_ASSERT(vehicle < match.vehicles().size());
  const Vehicle& v = match.vehicles()[vehicle];
  if (!v.gun.firing || !v.gun.last) return std::nullopt;
  const Pose& pose = *v.gun.last;
  BeamPicture beam{pose.origin, pose.origin + pose.direction * v.gun.length, std::nullopt, v.gun.radius};
  const auto hit = sight.nearest(pose, v.gun.length * (1 + 1e-6), [&](BodyId id) { return !v.has(id); });
  if (hit) beam.strike = pose.origin + pose.direction * hit->length;
  beam.on_ground = hit && !hit->body.valid();
  return beam;
}

// The lamps of an arena. Each draws all bodies once more, so that a slow machine has two instead of all, a
// little brighter.
std::vector<Light> lights_of(const std::vector<Light>& lamps, PicturePreset preset) {
  if (lamps.empty()) return {Light{}};
  if (preset != PicturePreset::kLow || lamps.size() <= 2) return lamps;
  std::vector<Light> two{lamps.front(), lamps.back()};
  for (Light& light : two) light.intensity *= kBrighter;
  return two;
}

// Vehicles and arena name their materials in one list.
std::map<std::string, Paint> paints_of(const Match& match) {
  std::map<std::string, Paint> paints = match.rules().arena.description.paints;
  for (const Vehicle& v : match.vehicles()) {
    for (const auto& [name, paint] : v.what().paints) paints.emplace(name, paint_of(match, name));
  }
  return paints;
}

}  // namespace

// Presets
// --------------------------------------------------------------------------------------------------------

PicturePreset PresetChoice::choose(PicturePreset setting) const {
  return setting == PicturePreset::kAutomatic ? best_ : setting;
}

void PresetChoice::took(double seconds) {
  if (++seen_ <= kWarmUp) return;
  slow_ = seconds > kSlowPicture ? slow_ + 1 : 0;
  if (slow_ > 1 && seconds > kFarTooSlow) best_ = PicturePreset::kLow;
  if (slow_ < kSlowPictures || best_ == PicturePreset::kLow) return;
  best_ = best_ == PicturePreset::kHigh ? PicturePreset::kMedium : PicturePreset::kLow;
  slow_ = seen_ = 0;
}

void ResolutionChoice::took(double seconds) {
  slow_ = seconds > kSlowPicture ? slow_ + 1 : 0;
  fast_ = seconds < kFastPicture ? fast_ + 1 : 0;
  if (slow_ >= kSlowPictures) {
    share_ = std::max(kLeast, share_ - kResolutionStep);
    slow_ = 0;
  } else if (fast_ >= kFastPictures) {
    share_ = std::min(1.0, share_ + kResolutionStep);
    fast_ = 0;
  }
}

bool draws_in_software() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string_view renderer = name != nullptr ? name : "";
  for (const char* software : {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer"}) {
    if (renderer.find(software) != std::string_view::npos) return true;
  }
  return false;
}

// The picture
// --------------------------------------------------------------------------------------------------------

Result<MatchPicture> MatchPicture::create() {
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();
  MatchPicture picture(std::move(*renderer));
  picture.look_.tint_pieces = false;
  return picture;
}

void MatchPicture::show(const Match& match) {
  renderer_.show(match.world(), paints_of(match));
  particles_.clear();
  scorches_.clear();
  graph_.clear();
}

void MatchPicture::follow(const Match& match) {
  const auto& events = match.events();
  if (std::any_of(events.begin(), events.end(),
                  [](const Event& e) { return e.kind == Event::Kind::kWaveBegins; }))
    return show(match);
  renderer_.follow(match.world(), match.delta());
  graph_.follow(match);
  for (const Event& event : events) {
    if (event.kind == Event::Kind::kImpact && event.size >= kSparks)
      particles_.add({event.at, {0, -1, 0}, kCrashSize, kRubbedOff * event.size}, {0, 1, 0});
    if (event.kind != Event::Kind::kCut) continue;
    const size_t by = event.by < match.vehicles().size() ? event.by : Match::kPlayer;
    const auto& last = match.vehicles()[by].gun.last;
    particles_.add({event.at, last ? last->direction : Vec3(0, -1, 0), kBiteSize, event.size}, {0, 1, 0});
  }
}

void MatchPicture::advance(const Match& match, double seconds) {
  const Sight sight(match.world());
  auto effects = std::make_shared<Effects>();
  for (size_t i = 0; i < match.vehicles().size(); ++i) {
    const auto beam = beam_of(match, i, sight);
    if (!beam) continue;
    effects->beams.push_back(*beam);
    const Vec3 along = glm::normalize(beam->to - beam->from);
    const bool ends_on_something = match.vehicles()[i].gun.length < match.rules().description.laser.range;
    if (!ends_on_something) continue;
    particles_.add({beam->to, along, kBiteSize, kScorched * seconds}, {0, 1, 0});
    scorches_.burn(match, *beam, sight);
  }
  particles_.advance(seconds, {0, 1, 0}, match.rules().arena.description.ground);
  particles_.append_to(*effects);
  scorches_.advance(seconds);
  scorches_.append_to(*effects);
  look_.effects = std::move(effects);
}

void MatchPicture::dress(const Match& match, PicturePreset preset) {
  look_.antialias = preset == PicturePreset::kHigh;
  look_.lights = lights_of(match.rules().arena.description.lamps, preset);
  look_.show.shadows = preset == PicturePreset::kLow ? Shadows::kNone : Shadows::kAll;
  look_.graph = look_.show.graph ? graph_.drawn(match) : nullptr;
  look_.bodies = gather_body_marks(match.world(), match.physics(), look_.show);
}

void MatchPicture::draw(const Match& match, const CameraView& view, const Target& target,
                        PicturePreset preset, double share) {
  KERF_ASSERT(preset != PicturePreset::kAutomatic && share > 0 && share <= 1);
  dress(match, preset);
  if (preset != PicturePreset::kLow || share == 1)
    return renderer_.draw(match.world(), view, look_, std::nullopt, target);
  const auto scaled = [&](int pixels) { return std::max(1, static_cast<int>(std::lround(share * pixels))); };
  const gl::Framebuffer::Shape small{scaled(target.width), scaled(target.height), 1, false};
  if (!small_ || !(small_->shape() == small)) small_.emplace(small);
  renderer_.draw(match.world(), view, look_, std::nullopt, {small_->name(), 0, 0, small.width, small.height});
  glBindFramebuffer(GL_READ_FRAMEBUFFER, small_->name());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
  glBlitFramebuffer(0, 0, small.width, small.height, target.x, target.y, target.x + target.width,
                    target.y + target.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
}

}  // namespace kerf
