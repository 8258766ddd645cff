#include "ui/game/match_picture.h"

#include <algorithm>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "ui/gl/context.h"
#include "ui/gl/image.h"
#include "ui/render/bodies/overlay_marks.h"

namespace kerf {

namespace {

constexpr double kSlow = 0.25;
constexpr double kSpeedSeconds = 0.7;  // averaging time of the speed

constexpr double kSlowMotionInReplay = 1.2;  // s
constexpr double kSlowEnd = 3;               // s, after the end of the match

constexpr double kRadius = 3.2;         // relative to the beam
constexpr double kScorchSpacing = 0.6;  // minimum distance between two marks, in radii
constexpr double kCoolSeconds = 1.4;
constexpr size_t kLooked = 24;  // of the latest marks are checked for an existing one

constexpr size_t kMaxRings = 16;
constexpr int kRingParts = 28;
constexpr double kRingWidth = 0.012;  // m

constexpr double kFilmedView = 55;  // degrees

}  // namespace

int MatchClock::advance(double seconds) {
  KERF_ASSERT(seconds >= 0);
  const double stopped = std::min(seconds, stopped_s_), moving = seconds - stopped;
  stopped_s_ -= stopped;
  const double slow = std::min(moving, slow_s_);
  slow_s_ -= slow;
  owed_ += (moving - slow * (1 - kSlow)) * pace_ * kTicksPerSecond;
  const int due = static_cast<int>(std::floor(owed_));
  owed_ -= due;
  const int ticks = std::min(due, kMaxTicks);
  dropped_ = due - ticks;
  if (due > 0) {
    const double share = 1 - std::exp(-seconds / kSpeedSeconds);
    speed_ += share * (static_cast<double>(ticks) / due - speed_);
  }
  return ticks;
}

double MatchClock::pace() const {
  if (stopped_s_ > 0) return 0;
  return is_slow() ? kSlow * pace_ : pace_;
}

MatchReplay::MatchReplay(const MatchSetup& setup, const MatchMoment& moment, std::vector<Controls> controls)
    : controls_(std::move(controls)), to_(moment.to), camera_(moment.vehicle) {
  KERF_ASSERT(moment.from <= moment.to && moment.to <= controls_.size());
  prepared_ = std::async(std::launch::async, [this, setup, moment] {
    return match_at(setup, moment.start, controls_, moment.from, [this] { return stopped_.load(); });
  });
}

MatchReplay::~MatchReplay() { stopped_ = true; }

MatchReplay::State MatchReplay::state() {
  if (!match_) {
    if (prepared_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return State::kPreparing;
    match_ = prepared_.get();
  }
  const bool over = skipped_ || match_->standing().elapsed() >= to_ || match_->settled();
  return over ? State::kOver : State::kPlaying;
}

int MatchReplay::due(double seconds) { return clock_.advance(seconds); }

void MatchReplay::tick() {
  KERF_ASSERT(match_);
  if (state() == State::kOver) return;
  const bool was_over = match_->standing().over();
  match_->tick(controls_[static_cast<size_t>(match_->standing().elapsed())]);
  if (!was_over && match_->standing().over()) clock_.slow_down(kSlowEnd);
  for (const Event& event : match_->events()) {
    const bool enemy = event.vehicle != Match::kPlayer;
    if (event.kind == Event::Kind::kInHalves && enemy) clock_.slow_down(kSlowMotionInReplay);
  }
}

void MatchGraph::clear() { *this = MatchGraph(); }

void MatchGraph::watch(BodyId body) {
  if (body == body_) return;
  clear();
  body_ = body;
}

void MatchGraph::follow(const Match& match) {
  for (const Event& event : match.events()) {
    const bool enemy = event.vehicle != Match::kPlayer && event.vehicle != Event::kNobody;
    if (event.kind == Event::Kind::kCut && event.by == Match::kPlayer && enemy)
      watch(match.vehicles()[event.vehicle].chassis);
  }
  if (!body_.valid()) return;
  for (const Detached& piece : match.delta().detached) changed_ = changed_ || piece.from == body_;
  for (const BodyDelta& body : match.delta().bodies) {
    if (body.body != body_) continue;
    changed_ = true;
    std::vector<CutFace>& all = removed_[body_];
    all.insert(all.end(), body.removed.begin(), body.removed.end());
    if (all.size() > DrawnGraph::kMost) all.erase(all.begin(), all.end() - DrawnGraph::kMost);
  }
}

const std::shared_ptr<const DrawnGraph>& MatchGraph::drawn(const Match& match) {
  const Ticks now = match.standing().ticks;
  KERF_ASSERT(!drawn_ || now >= made_);
  const bool waits = drawn_ && seconds_of_ticks(now - made_) < kPause;
  if (!changed_ || waits || !match.world().contains(body_)) return drawn_;
  const CutGraph graph = cut_graph(match.world(), removed_);
  const auto start = start_next_to_cut(graph);
  if (!start) return drawn_;
  drawn_ =
      std::make_shared<DrawnGraph>(draw_graph(graph, traverse_cut(graph, *start), GraphScope::kAroundCut));
  changed_ = false;
  made_ = now;
  return drawn_;
}

void Scorches::burn(const Match& match, const BeamPicture& beam, const Sight& sight) {
  const double length = glm::length(beam.to - beam.from);
  if (!(length > 0)) return;
  const auto hit = sight.nearest({beam.from, (beam.to - beam.from) / length}, length * 1.001 + 1e-3,
                                 [&](BodyId id) { return match.is_wall(id); });
  if (!hit) return;
  const double radius = kRadius * beam.radius;
  const size_t from = places_.size() - std::min(places_.size(), kLooked);
  for (size_t i = from; i < places_.size(); ++i) {
    if (glm::length(places_[i].at - beam.to) > kScorchSpacing * radius) continue;
    places_[i].heat = 1;
    return;
  }
  places_.push_back({beam.to, hit->normal, radius, 1});
  if (places_.size() > kMost) places_.pop_front();
}

void Scorches::advance(double seconds) {
  for (Scorch& s : places_) s.heat = std::max(0.0, s.heat - seconds / kCoolSeconds);
}

namespace {

constexpr double kSlowPicture = 1.0 / 24;  // s
constexpr double kFarTooSlow = 0.15;       // s
constexpr int kWarmUp = 3, kSlowPictures = 3;
constexpr double kFastPicture = 1.0 / 40;  // s
constexpr int kFastPictures = 60;
constexpr double kResolutionStep = 0.1;
constexpr double kBrighter = 1.4;
constexpr double kBiteSize = 1.4;     // of sparks, compared with those of a car in the editor
constexpr double kScorched = 0.4;     // kg/s, of a surface that stops a beam
constexpr double kSparks = 5;         // m/s, minimum for sparks in a crash
constexpr double kCrashSize = 2;      // of crash sparks
constexpr double kRubbedOff = 0.035;  // kg per m/s of a crash
constexpr int kBurstJets = 8;         // of a fuel tank
constexpr double kBurstSize = 3;
constexpr double kBurstMass = 0.3;  // kg, of each jet

Paint paint_of(const Match& match, const std::string& name) {
  for (const Vehicle& v : match.vehicles()) {
    const auto found = v.what().paints.find(name);
    if (found != v.what().paints.end()) return found->second;
  }
  return {};
}

// Returns the drawn beam of a vehicle, up to its end on a wall or the ground; nullopt if it is off.
// `strike` is the first surface it hits, cut or not. Precondition: the match has this vehicle.
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

// The second beam next to a beam, without its own hit.
BeamPicture twin_of(BeamPicture beam) {
  const Vec3 way =
      moved_aside({beam.from, glm::normalize(beam.to - beam.from)}, kTwinAside).origin - beam.from;
  beam.from += way;
  beam.to += way;
  beam.strike.reset();
  return beam;
}

// The lamps of an arena. Each costs another pass over all bodies, so a slow machine uses only two, slightly
// brighter.
std::vector<Light> lights_of(const std::vector<Light>& lamps, PicturePreset preset) {
  if (lamps.empty()) return {Light{}};
  if (preset != PicturePreset::kLow || lamps.size() <= 2) return lamps;
  std::vector<Light> two{lamps.front(), lamps.back()};
  for (Light& light : two) light.intensity *= kBrighter;
  return two;
}

// Vehicles and arena share one list of materials.
std::map<std::string, Paint> paints_of(const Match& match) {
  std::map<std::string, Paint> paints = match.rules().arena.description.paints;
  for (const Vehicle& v : match.vehicles()) {
    for (const auto& [name, paint] : v.what().paints) paints.emplace(name, paint_of(match, name));
  }
  return paints;
}

}  // namespace

// Presets

PicturePreset PresetChoice::select(PicturePreset setting) const {
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

void CutRings::add(const Event& event) {
  if (event.across == Vec3(0) || event.kind != Event::Kind::kPieceOff) return;
  rings_.push_back({event.at, event.across, std::clamp(0.4 * std::sqrt(event.size), 0.08, 1.2), 0});
  if (rings_.size() > kMaxRings) rings_.erase(rings_.begin());
}

void CutRings::advance(double seconds) {
  for (Ring& ring : rings_) ring.age += seconds;
  std::erase_if(rings_, [](const Ring& ring) { return ring.age > kSeconds; });
}

void CutRings::append_to(Effects& effects) const {
  for (const Ring& ring : rings_) {
    const double share = ring.age / kSeconds, radius = ring.radius * (1 + 0.6 * share);
    const Vec3 other = std::abs(ring.across.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 u = glm::normalize(glm::cross(ring.across, other)), v = glm::cross(ring.across, u);
    Vec3 tail = ring.at + radius * u;
    for (int i = 1; i <= kRingParts; ++i) {
      const double angle = 2 * kPi * i / kRingParts;
      const Vec3 at = ring.at + radius * (std::cos(angle) * u + std::sin(angle) * v);
      effects.sparks.push_back({at, tail, kRingWidth * (1 - 0.7 * share), 1 - share});
      tail = at;
    }
  }
}

bool draws_in_software() {
  const std::string renderer = gl::renderer_name();
  for (const char* software : {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer"}) {
    if (renderer.find(software) != std::string_view::npos) return true;
  }
  return false;
}

// Viewport

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
  rings_.clear();
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
    rings_.add(event);
    if (event.kind == Event::Kind::kTankBurst) add_burst(event.at);
    if (event.kind == Event::Kind::kStruck)
      particles_.add({event.at, {0, -1, 0}, kCrashSize, kRubbedOff * kSparks}, {0, 1, 0});
    if (event.kind != Event::Kind::kCut) continue;
    const size_t by = event.by < match.vehicles().size() ? event.by : Match::kPlayer;
    const auto& last = match.vehicles()[by].gun.last;
    particles_.add({event.at, last ? last->direction : Vec3(0, -1, 0), kBiteSize, event.size}, {0, 1, 0});
  }
}

// Flying fire in all directions.
void MatchPicture::add_burst(const Vec3& at) {
  for (int i = 0; i < kBurstJets; ++i) {
    const double angle = 2 * kPi * i / kBurstJets;
    const Vec3 inward = glm::normalize(Vec3(std::cos(angle), -0.8, std::sin(angle)));
    particles_.add({at, inward, kBurstSize, kBurstMass}, {0, 1, 0});
  }
}

void MatchPicture::advance(const Match& match, double seconds) {
  const Sight sight(match.world());
  auto effects = std::make_shared<Effects>();
  for (size_t i = 0; i < match.vehicles().size(); ++i) {
    const auto beam = beam_of(match, i, sight);
    if (!beam) continue;
    effects->beams.push_back(*beam);
    if (match.vehicles()[i].gun.twin) effects->beams.push_back(twin_of(*beam));
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
  rings_.advance(seconds);
  rings_.append_to(*effects);
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

Result<MatchFrames> MatchFrames::open(const std::filesystem::path& folder, int width, int height) {
  auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  gl::Framebuffer frame({width, height, 1, false});
  if (!frame.complete())
    return bad_input("--size: this machine does not support images of " + std::to_string(width) + "x" +
                     std::to_string(height));
  const auto antialias = affordable_antialias(width, height, true);
  if (!antialias) return antialias.error();
  const PicturePreset preset = *antialias ? PicturePreset::kHigh : PicturePreset::kMedium;
  return MatchFrames{std::move(*context), std::move(*picture), std::move(frame), folder, preset};
}

Status MatchFrames::take(const Match& match, const CameraView& view) {
  const int width = frame.shape().width, height = frame.shape().height;
  picture.draw(match, view, {frame.name(), 0, 0, width, height}, preset);
  return write_png(read_pixels(frame.name(), width, height), frame_file(folder, taken++));
}

Status MatchFrames::end() const { return remove_later_frames(folder, taken); }

MatchFilm::MatchFilm(MatchFrames frames, const Options& options)
    : frames_(std::move(frames)), options_(options) {
  camera_.viewpoint = Viewpoint::kChase;
}

Result<MatchFilm> MatchFilm::begin(const Match& match, const Options& options) {
  KERF_ASSERT(options.frames_per_second > 0);
  auto frames = MatchFrames::open(options.folder, options.width, options.height);
  if (!frames) return frames.error();
  frames->picture.show(match);
  return MatchFilm(std::move(*frames), options);
}

Status MatchFilm::follow(const Match& match, const Controls& controls) {
  frames_.picture.follow(match);
  camera_.follow(match, aim_of(controls), kTick);
  frames_.picture.advance(match, kTick);
  const double due = seconds_of_ticks(match.standing().elapsed()) * options_.frames_per_second;
  while (static_cast<double>(frames_.taken) < due) {
    CameraView view = camera_.view(frames_.aspect(), kFilmedView);
    if (options_.eye && options_.target) view = look_at(*options_.eye, *options_.target, frames_.aspect());
    if (const Status taken = frames_.take(match, view); !taken) return taken;
  }
  return Done{};
}

}  // namespace kerf
