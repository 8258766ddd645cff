#include "ui/sound/sounds.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "ui/sound/waves.h"

namespace kerf {

namespace {

constexpr size_t kLoops = static_cast<size_t>(Sounds::Loop::kCount);
constexpr size_t kShots = static_cast<size_t>(Sounds::Shot::kCount);
constexpr size_t kShotSources = 12;
constexpr float kFullVolumeWithin = 5;  // m, within which sounds are at their full volume

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

// While it exists nothing is written to standard error: the drivers that are tried where there is no device
// complain there.
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

}  // namespace

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
    const std::array waves{engine_loop(), laser_loop(),      cutting_loop(),    impact_sound(),
                           sheet_sound(), explosion_sound(), chime_sound(true), chime_sound(false)};
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

}  // namespace kerf
