#include "ui/game/sounds.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <fcntl.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/random.h"

namespace kerf {

namespace {

constexpr double kFullTurn = 2 * kPi;

size_t samples_of(double seconds) { return static_cast<size_t>(seconds * kSampleRate); }
double time_of(size_t sample) { return static_cast<double>(sample) / kSampleRate; }

Wave noise(size_t samples, uint64_t seed) {
  Random random(seed);
  Wave wave(samples);
  for (float& x : wave) x = static_cast<float>(random.uniform(-1, 1));
  return wave;
}

// A two-pole band-pass around a frequency [Hz] of a width [Hz]. A loop is filtered twice in succession, so
// that its end joins its beginning.
Wave band(const Wave& in, double frequency, double width, bool loop) {
  const double r = std::exp(-kPi * width / kSampleRate);
  const double a1 = 2 * r * std::cos(kFullTurn * frequency / kSampleRate), a2 = -r * r,
               gain = (1 - r * r) * 0.5;
  Wave out(in.size());
  double y1 = 0, y2 = 0, x2 = 0, x1 = 0;
  for (int turn = loop ? 0 : 1; turn < 2; ++turn) {
    for (size_t i = 0; i < in.size(); ++i) {
      const double y = gain * (in[i] - x2) + a1 * y1 + a2 * y2;
      x2 = x1;
      x1 = in[i];
      y2 = y1;
      y1 = y;
      out[i] = static_cast<float>(y);
    }
  }
  return out;
}

void add(Wave& to, const Wave& what, double gain) {
  for (size_t i = 0; i < std::min(to.size(), what.size()); ++i) to[i] += static_cast<float>(gain * what[i]);
}

// A damped sine: frequency [Hz], loudness, and the time [s] in which it decays to 1/e.
struct Mode {
  double frequency, gain, decay;
};

void ring(Wave& wave, const Mode& mode, double phase = 0) {
  for (size_t i = 0; i < wave.size(); ++i) {
    const double t = time_of(i);
    wave[i] += static_cast<float>(mode.gain * std::sin(kFullTurn * mode.frequency * t + phase) *
                                  std::exp(-t / mode.decay));
  }
}

// Scales to a maximum of `peak`, and fades the first and last milliseconds unless it is a loop.
Wave finished(Wave wave, double peak, bool loop) {
  float most = 1e-9f;
  for (const float x : wave) most = std::max(most, std::abs(x));
  const size_t edge = samples_of(0.004);
  for (size_t i = 0; i < wave.size(); ++i) {
    const size_t from_end = std::min(i, wave.size() - 1 - i);
    const double fade = loop ? 1 : std::min(1.0, static_cast<double>(from_end) / static_cast<double>(edge));
    wave[i] = static_cast<float>(wave[i] / most * peak * fade);
  }
  return wave;
}

constexpr size_t kLoops = static_cast<size_t>(Sounds::Loop::kCount);
constexpr size_t kShots = static_cast<size_t>(Sounds::Shot::kCount);
constexpr size_t kShotSources = 12;
constexpr float kFullVolumeWithin = 5;  // m, radius of full volume

void fill(ALuint buffer, const Wave& wave) {
  const auto samples = to_16_bits(wave);
  alBufferData(buffer, AL_FORMAT_MONO16, samples.data(),
               static_cast<ALsizei>(samples.size() * sizeof(int16_t)), kSampleRate);
}

void place(ALuint source, const Vec3& at, double gain, double pitch) {
  alSource3f(source, AL_POSITION, static_cast<float>(at.x), static_cast<float>(at.y),
             static_cast<float>(at.z));
  alSourcef(source, AL_GAIN, static_cast<float>(std::min(gain, 1.0)));
  alSourcef(source, AL_PITCH, static_cast<float>(std::clamp(pitch, 0.1, 4.0)));
}

// Suppresses standard error while it exists: the drivers tried without a device print messages there.
class QuietErrors {
 public:
  QuietErrors() : kept_(::dup(STDERR_FILENO)) {
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
    if (nowhere >= 0) ::close(nowhere);
  }
  ~QuietErrors() {
    if (kept_ < 0) return;
    ::dup2(kept_, STDERR_FILENO);
    ::close(kept_);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  int kept_;
};

constexpr double kSoftImpact = 1.2, kLoudImpact = 9;  // m/s
constexpr double kLargeSheet = 1.5;                   // m^2
constexpr double kCuttingFade = 13;                   // 1/s
constexpr double kFullSpeed = 24;                     // m/s

using Kind = Event::Kind;
using Shot = Sounds::Shot;
using Loop = Sounds::Loop;

}  // namespace

Wave engine_loop() {
  Wave wave(samples_of(1));
  for (int harmonic = 1; harmonic <= 14; ++harmonic) {
    const double gain = (harmonic % 2 == 0 ? 1.0 : 0.55) / std::pow(harmonic, 1.15);
    for (size_t i = 0; i < wave.size(); ++i) {
      const double t = time_of(i), uneven = 1 + 0.18 * std::sin(kFullTurn * 14 * t + harmonic);
      wave[i] += static_cast<float>(gain * uneven *
                                    std::sin(kFullTurn * 28 * harmonic * t + 0.7 * harmonic * harmonic));
    }
  }
  add(wave, band(noise(wave.size(), 3), 240, 180, true), 1.6);
  return finished(std::move(wave), 0.7, true);
}

Wave laser_loop() {
  Wave wave(samples_of(1));
  constexpr std::array<std::array<double, 2>, 6> kPartials{
      {{96, 0.9}, {97, 0.6}, {192, 0.5}, {289, 0.35}, {577, 0.22}, {1154, 0.12}}};
  for (const auto& [frequency, gain] : kPartials) {
    for (size_t i = 0; i < wave.size(); ++i) {
      const double t = time_of(i), tremble = 1 + 0.3 * std::sin(kFullTurn * 31 * t);
      wave[i] += static_cast<float>(gain * tremble * std::sin(kFullTurn * frequency * t));
    }
  }
  add(wave, band(noise(wave.size(), 5), 3100, 1400, true), 0.5);
  return finished(std::move(wave), 0.5, true);
}

Wave warning_loop() {
  Wave wave(samples_of(1));
  for (size_t i = 0; i < wave.size(); ++i) {
    const double t = time_of(i);
    wave[i] = static_cast<float>(std::sin(kFullTurn * 620 * t) + 0.4 * std::sin(kFullTurn * 1240 * t));
  }
  return finished(std::move(wave), 0.3, true);
}

Wave cutting_loop() {
  Random random(7);
  Wave clicks(samples_of(1));
  for (int i = 0; i < 420; ++i)
    clicks[random.below(clicks.size())] = static_cast<float>(random.uniform(-1, 1) * random.unit());
  Wave wave = band(clicks, 4200, 1600, true);
  add(wave, band(clicks, 1700, 700, true), 0.8);
  add(wave, band(noise(wave.size(), 11), 6000, 3000, true), 0.05);
  return finished(std::move(wave), 0.7, true);
}

Wave impact_sound() {
  Wave wave(samples_of(0.6));
  for (const Mode& mode : {Mode{62, 1.2, 0.09}, Mode{104, 0.7, 0.07}, Mode{233, 0.3, 0.11},
                           Mode{411, 0.2, 0.13}, Mode{890, 0.12, 0.1}})
    ring(wave, mode);
  Wave crash = band(noise(wave.size(), 13), 900, 900, false);
  for (size_t i = 0; i < crash.size(); ++i) crash[i] *= static_cast<float>(std::exp(-time_of(i) / 0.07));
  add(wave, crash, 2.5);
  return finished(std::move(wave), 0.9, false);
}

Wave sheet_sound() {
  Wave wave(samples_of(1.1));
  constexpr std::array kModes{Mode{317, 0.6, 0.20},  Mode{523, 0.8, 0.26},  Mode{861, 0.7, 0.22},
                              Mode{1297, 0.6, 0.20}, Mode{1733, 0.5, 0.16}, Mode{2411, 0.4, 0.12},
                              Mode{3299, 0.3, 0.09}, Mode{4817, 0.2, 0.05}};
  constexpr std::array kBounces{0.0, 0.16, 0.27, 0.34};
  for (size_t bounce = 0; bounce < kBounces.size(); ++bounce) {
    Wave hit(wave.size() - samples_of(kBounces[bounce]));
    for (size_t m = 0; m < kModes.size(); ++m)
      ring(hit,
           {kModes[m].frequency * (1 + 0.004 * static_cast<double>(bounce)), kModes[m].gain, kModes[m].decay},
           0.9 * static_cast<double>(m * (bounce + 1)));
    const double gain = 1 / static_cast<double>(1 + bounce);
    const size_t from = samples_of(kBounces[bounce]);
    for (size_t i = 0; i < hit.size(); ++i) wave[from + i] += static_cast<float>(gain * hit[i]);
  }
  return finished(std::move(wave), 0.7, false);
}

Wave explosion_sound() {
  Wave wave = band(noise(samples_of(1.4), 17), 90, 120, false);
  add(wave, band(noise(wave.size(), 19), 500, 600, false), 0.5);
  for (size_t i = 0; i < wave.size(); ++i) wave[i] *= static_cast<float>(std::exp(-time_of(i) / 0.35));
  Wave thud(wave.size());
  ring(thud, {44, 1, 0.3});
  return add(wave, thud, 0.6), finished(std::move(wave), 0.9, false);
}

Wave chime_sound(bool good) {
  Wave wave(samples_of(0.9));
  const std::array<double, 3> tones =
      good ? std::array{392.0, 493.9, 587.3} : std::array{392.0, 311.1, 233.1};
  for (size_t k = 0; k < tones.size(); ++k) {
    Wave tone(wave.size() - samples_of(0.13 * static_cast<double>(k)));
    ring(tone, {tones[k], 0.8, 0.22});
    ring(tone, {2 * tones[k], 0.25, 0.12});
    const size_t from = wave.size() - tone.size();
    for (size_t i = 0; i < tone.size(); ++i) wave[from + i] += tone[i];
  }
  return finished(std::move(wave), 0.5, false);
}

double faded_cutting_gain(double gain, double seconds) { return gain * std::exp(-kCuttingFade * seconds); }

std::vector<int16_t> to_16_bits(std::span<const float> wave) {
  std::vector<int16_t> samples;
  samples.reserve(wave.size());
  for (const float x : wave)
    samples.push_back(static_cast<int16_t>(std::lround(32767 * std::clamp(x, -1.0f, 1.0f))));
  return samples;
}

struct Sounds::Device {
  ALCdevice* device = nullptr;
  ALCcontext* context = nullptr;
  std::array<ALuint, kLoops + kShots> buffers{};
  std::array<ALuint, kLoops * kVoices> loops{};
  std::array<ALuint, kShotSources> shots{};
  size_t next_shot = 0;

  ~Device() {
    if (context != nullptr) {
      alDeleteSources(static_cast<ALsizei>(loops.size()), loops.data());
      alDeleteSources(static_cast<ALsizei>(shots.size()), shots.data());
      alDeleteBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
      alcMakeContextCurrent(nullptr);
      alcDestroyContext(context);
    }
    if (device != nullptr) alcCloseDevice(device);
  }

  bool open() {
    {
      const QuietErrors quiet;
      device = alcOpenDevice(nullptr);
    }
    context = device != nullptr ? alcCreateContext(device, nullptr) : nullptr;
    if (context == nullptr || alcMakeContextCurrent(context) == ALC_FALSE) return false;
    alGenBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
    const std::array waves{engine_loop(),     laser_loop(),      cutting_loop(),
                           warning_loop(),    impact_sound(),    sheet_sound(),
                           explosion_sound(), chime_sound(true), chime_sound(false)};
    static_assert(waves.size() == kLoops + kShots);
    for (size_t i = 0; i < waves.size(); ++i) fill(buffers[i], waves[i]);
    alGenSources(static_cast<ALsizei>(loops.size()), loops.data());
    alGenSources(static_cast<ALsizei>(shots.size()), shots.data());
    for (size_t i = 0; i < loops.size(); ++i) {
      alSourcei(loops[i], AL_BUFFER, static_cast<ALint>(buffers[i / kVoices]));
      alSourcei(loops[i], AL_LOOPING, AL_TRUE);
      alSourcef(loops[i], AL_REFERENCE_DISTANCE, kFullVolumeWithin);
    }
    for (const ALuint source : shots) alSourcef(source, AL_REFERENCE_DISTANCE, kFullVolumeWithin);
    return alGetError() == AL_NO_ERROR;
  }
};

Sounds::Sounds() : device_(std::make_unique<Device>()) {
  if (!device_->open()) device_.reset();
}

Sounds::~Sounds() = default;

void Sounds::set_volume(double volume) {
  if (on()) alListenerf(AL_GAIN, static_cast<float>(std::clamp(volume, 0.0, 1.0)));
}

void Sounds::listen(const Vec3& at, const Vec3& forward) {
  KERF_ASSERT(is_unit(forward));
  if (!on()) return;
  alListener3f(AL_POSITION, static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z));
  const std::array<float, 6> ears{
      static_cast<float>(forward.x), static_cast<float>(forward.y), static_cast<float>(forward.z), 0, 1, 0};
  alListenerfv(AL_ORIENTATION, ears.data());
}

void Sounds::set(Loop loop, size_t voice, const Vec3& at, double gain, double pitch) {
  KERF_ASSERT(voice < kVoices && loop != Loop::kCount && pitch > 0);
  if (!on()) return;
  const ALuint source = device_->loops[static_cast<size_t>(loop) * kVoices + voice];
  ALint state = 0;
  alGetSourcei(source, AL_SOURCE_STATE, &state);
  if (!(gain > 0)) {
    if (state == AL_PLAYING) alSourcePause(source);
    return;
  }
  place(source, at, gain, pitch);
  if (state != AL_PLAYING) alSourcePlay(source);
}

void Sounds::play(Shot shot, const Vec3& at, double gain, double pitch) {
  KERF_ASSERT(shot != Shot::kCount && pitch > 0);
  if (!on() || !(gain > 0)) return;
  const ALuint source = device_->shots[device_->next_shot++ % kShotSources];
  alSourceStop(source);
  alSourcei(source, AL_BUFFER, static_cast<ALint>(device_->buffers[kLoops + static_cast<size_t>(shot)]));
  place(source, at, gain, pitch);
  alSourcePlay(source);
}

void Sounds::hush() {
  if (!on()) return;
  alSourcePausev(static_cast<ALsizei>(device_->loops.size()), device_->loops.data());
}

// Chimes are for the player. The events of the match itself have no place.
void MatchSounds::on_tick(const Match& match) {
  const Vec3 own = match.world().body(match.vehicles()[Match::kPlayer].chassis).placement.position;
  for (const Event& e : match.events()) {
    switch (e.kind) {
      case Kind::kCut:
        if (e.by < Sounds::kVoices) cutting_[e.by] = 0.8;
        break;
      case Kind::kPieceOff:
      case Kind::kWheelLost:
      case Kind::kTurretLost:
      case Kind::kInHalves:
        sounds_.play(Shot::kSheet, e.at, 0.9, 1.3 - 0.5 * std::min(1.0, e.size / kLargeSheet));
        break;
      case Kind::kImpact:
        if (e.size > kSoftImpact) sounds_.play(Shot::kImpact, e.at, std::min(1.0, e.size / kLoudImpact));
        break;
      case Kind::kStruck:
        sounds_.play(Shot::kImpact, e.at, 1, 0.7);
        break;
      case Kind::kTankBurst:
        sounds_.play(Shot::kExplosion, e.at, 0.8, 1.4);
        break;
      case Kind::kKilled:
        sounds_.play(Shot::kExplosion, e.at, 1);
        break;
      case Kind::kLooted:
      case Kind::kUpgraded:
      case Kind::kWaveCleared:
      case Kind::kWon:
        sounds_.play(Shot::kGoodChime, own, 0.7);
        break;
      case Kind::kLost:
      case Kind::kCarLost:
        sounds_.play(Shot::kBadChime, own, 0.7);
        break;
      default:
        break;
    }
  }
}

void MatchSounds::advance(const Match& match, const Vec3& eye, const Vec3& forward, double volume,
                          double seconds) {
  if (!sounds_.on()) return;
  sounds_.set_volume(volume);
  sounds_.listen(eye, forward);
  for (size_t i = 0; i < Sounds::kVoices; ++i) {
    const bool there = i < match.vehicles().size();
    const Vehicle* v = there ? &match.vehicles()[i] : nullptr;
    const Body* chassis = there ? &match.world().body(v->chassis) : nullptr;
    const Vec3 at = there ? chassis->placement.position : Vec3(0);
    const double speed = there ? glm::length(chassis->motion.velocity) / kFullSpeed : 0;
    const double load = there ? std::abs(v->controls.throttle) / 100.0 : 0;
    sounds_.set(Loop::kEngine, i, at, there && v->alive ? 0.22 + 0.25 * load : 0,
                0.8 + 1.6 * speed + 0.25 * load);
    sounds_.set(Loop::kLaser, i, at, there && v->gun.firing ? 0.55 : 0, 1);
    const bool warns = there && v->is_announcing();
    sounds_.set(Loop::kWarning, i, at, warns ? 0.5 : 0, warns ? 0.8 + v->gun.warning_s : 1);
    cutting_[i] = faded_cutting_gain(cutting_[i], seconds);
    sounds_.set(Loop::kCutting, i, at, there && v->gun.firing && cutting_[i] > 0.02 ? cutting_[i] : 0, 1);
  }
}

}  // namespace kerf
