#include <embree3/rtcore.h>

#include <atomic>
#include <cstring>

#include "tests/bench/peer.h"
#include "tests/bench/timing.h"

namespace kerf::bench {

namespace {

// What a query hands to the filter: the context comes first.
struct Collector {
  RTCIntersectContext context;
  uint32_t faces[256];
  uint32_t count;
};

// Notes the triangle and lets the ray go on.
void record_and_pass(const RTCFilterFunctionNArguments* args) {
  auto* collector = reinterpret_cast<Collector*>(args->context);
  collector->faces[collector->count++ % 256] = RTCHitN_primID(args->hit, args->N, 0);
  args->valid[0] = 0;
}

class Embree : public Peer {
 public:
  Embree(const TriangleArrays& arrays, EmbreeQuality quality) {
    device_ = rtcNewDevice("threads=1");
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    scene_ = rtcNewScene(device_);
    unsigned flags = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;
    if (quality == EmbreeQuality::kMediumRobust) flags |= RTC_SCENE_FLAG_ROBUST;
    rtcSetSceneFlags(scene_, static_cast<RTCSceneFlags>(flags));
    const auto level = quality == EmbreeQuality::kLow ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
    rtcSetSceneBuildQuality(scene_, level);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry, level);
    void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12,
                                              arrays.positions.size() / 3);
    std::memcpy(positions, arrays.positions.data(), 4 * arrays.positions.size());
    void* corners = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12,
                                            arrays.corners.size() / 3);
    std::memcpy(corners, arrays.corners.data(), 4 * arrays.corners.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    given_bytes_ = static_cast<double>(bytes_);
    build_seconds_ = seconds_of([&] { rtcCommitScene(scene_); });
  }
  ~Embree() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  size_t all_hits(std::span<const Pose> rays, double reach) override {
    size_t hits = 0;
    Collector collector;
    for (const Pose& ray : rays) {
      rtcInitIntersectContext(&collector.context);
      collector.context.filter = record_and_pass;
      collector.count = 0;
      RTCRayHit query = query_of(ray, reach);
      rtcIntersect1(scene_, &collector.context, &query);
      hits += collector.count;
    }
    return hits;
  }

  size_t nearest_hits(std::span<const Pose> rays, double reach) override {
    size_t hits = 0;
    for (const Pose& ray : rays) {
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      RTCRayHit query = query_of(ray, reach);
      rtcIntersect1(scene_, &context, &query);
      hits += query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return hits;
  }

  double build_seconds() const override { return build_seconds_; }
  double bytes() const override { return static_cast<double>(bytes_) - given_bytes_; }

 private:
  static bool count_bytes(void* total, ssize_t bytes, bool) {
    *static_cast<std::atomic<ssize_t>*>(total) += bytes;
    return true;
  }

  static RTCRayHit query_of(const Pose& ray, double reach) {
    RTCRayHit q;
    q.ray.org_x = static_cast<float>(ray.origin.x);
    q.ray.org_y = static_cast<float>(ray.origin.y);
    q.ray.org_z = static_cast<float>(ray.origin.z);
    q.ray.tnear = 0;
    q.ray.dir_x = static_cast<float>(ray.direction.x);
    q.ray.dir_y = static_cast<float>(ray.direction.y);
    q.ray.dir_z = static_cast<float>(ray.direction.z);
    q.ray.tfar = static_cast<float>(reach);
    q.ray.time = 0;
    q.ray.mask = ~0u;
    q.ray.id = 0;
    q.ray.flags = 0;
    q.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    q.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return q;
  }

  std::atomic<ssize_t> bytes_{0};
  double given_bytes_ = 0, build_seconds_ = 0;
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace

bool has_embree() { return true; }
std::unique_ptr<Peer> make_embree(const TriangleArrays& arrays, EmbreeQuality quality) {
  return std::make_unique<Embree>(arrays, quality);
}

}  // namespace kerf::bench
