#include "core/mesh/looks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/assert.h"
#include "core/base/containers.h"
#include "core/base/number_format.h"
#include "core/base/random.h"
#include "core/base/tolerances.h"
#include "core/mesh/files/bytes.h"
#include "core/mesh/files/scanner.h"

namespace kerf {

namespace {

constexpr uint32_t kNoValue = LookChannel<Vec3>::kNone;

uint64_t bits_of(const Vec3& v) {
  return hash_combine(hash_combine(mix64(number_bits(v.x)), number_bits(v.y)), number_bits(v.z));
}
uint64_t bits_of(const glm::vec3& v) { return bits_of(Vec3(v)); }
uint64_t bits_of(const glm::vec2& v) { return bits_of(Vec3(v, 0)); }
uint64_t bits_of(const glm::vec4& v) { return hash_combine(bits_of(Vec3(v)), number_bits(double{v.w})); }

template <typename T>
bool has_finite_numbers(const T& v) {
  for (int k = 0; k < T::length(); ++k) {
    if (!std::isfinite(v[k])) return false;
  }
  return true;
}

// Values in the order of their first use; equal ones are one.
template <typename T>
class DistinctValues {
 public:
  uint32_t number(const T& value) {
    const auto next = static_cast<uint32_t>(values.size());
    const uint32_t found = table_.find_or_add(
        bits_of(value), next, [&](uint32_t other) { return values[other] == value; },
        [&](uint32_t other) { return bits_of(values[other]); });
    if (found == next) values.push_back(value);
    return found;
  }

  std::vector<T> values;

 private:
  KeyTable table_;
};

bool lies_before(const Vec3& a, const Vec3& b) {
  return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
}

double largest_part(const Vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Returns the weights of a point on the side from corner i of a triangle. They depend on the ends only, not
// on their order.
Vec3 weights_on_side(const Triangle& t, int i, const Vec3& point) {
  int from = i, to = (i + 1) % 3;
  if (lies_before(t[static_cast<size_t>(to)], t[static_cast<size_t>(from)])) std::swap(from, to);
  const Vec3 &a = t[static_cast<size_t>(from)], &b = t[static_cast<size_t>(to)];
  const double size = largest_part(b - a);
  Vec3 weights(0);
  weights[from] = 1;
  if (!(size > 0)) return weights;
  const Vec3 along = (b - a) / size;
  const double s =
      point == b ? 1 : std::clamp(glm::dot((point - a) / size, along) / glm::dot(along, along), 0.0, 1.0);
  weights[from] = 1 - s;
  weights[to] = s;
  return weights;
}

int longest_side(const Triangle& t) {
  int longest = 0;
  double best = -1;
  for (int i = 0; i < 3; ++i) {
    const double length = largest_part(t[static_cast<size_t>((i + 1) % 3)] - t[static_cast<size_t>(i)]);
    if (length > best) longest = i;
    best = std::max(best, length);
  }
  return longest;
}

class LooksHash {
 public:
  uint64_t sum() const { return sum_; }

  void add(std::string_view bytes) {
    sum_ = hash_combine(sum_, bytes.size());
    for (; bytes.size() >= sizeof(uint64_t); bytes.remove_prefix(sizeof(uint64_t)))
      sum_ = hash_combine(sum_, load<uint64_t>(bytes.data(), std::endian::little));
    for (const char c : bytes) sum_ = hash_combine(sum_, static_cast<unsigned char>(c));
  }
  template <typename T>
  void add_values(const std::vector<T>& values) {
    add({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)});
  }
  void add(const SurfaceLibrary& library) {
    for (const SurfaceMaterial& material : library.materials) {
      for (const MtlLine& line : material.mtl) add(line.text + ' ' + std::to_string(line.image.value_or(0)));
      add(material.gltf);
    }
    for (const SurfaceImage& image : library.images) add(image.name + ' ' + image.bytes);
    for (const auto* texts : {&library.textures, &library.samplers, &library.required_extensions}) {
      for (const std::string& text : *texts) add(text);
    }
  }

 private:
  uint64_t sum_ = 0;
};

}  // namespace

class Looks::Builder {
 public:
  Builder(const Soup& soup, std::span<const uint32_t> sources, const std::vector<bool>& turned)
      : soup_(soup), sources_(sources), turned_(turned) {
    KERF_ASSERT(sources.empty() ? turned.size() == soup.triangles.size() : turned.size() == sources.size());
  }

  static uint64_t hash_of(const Looks& looks) {
    LooksHash hash;
    const auto add = [&](const auto& channel) {
      hash.add_values(channel.values);
      if (channel.corners) hash.add_values(*channel.corners);
    };
    for (const auto& set : looks.uv_sets_) add(set);
    add(looks.normals_);
    add(looks.tangents_);
    for (const Attribute& attribute : looks.attributes_) {
      hash.add(attribute.name);
      add(attribute.channel);
    }
    if (looks.surfaces_) hash.add(*looks.surfaces_);
    return hash.sum();
  }

  std::shared_ptr<const Looks> build(std::vector<std::string>& warnings) {
    auto looks = std::make_shared<Looks>();
    looks->surfaces_ = soup_.surfaces;
    looks->v_points_down_ = soup_.looks.v_points_down;
    for (const auto& set : soup_.looks.uv_sets) {
      looks->uv_sets_.push_back(share(set, "UVs"));
    }
    // Materials refer to sets by number, so that empty ones before the last stay.
    while (!looks->uv_sets_.empty() && !looks->uv_sets_.back().corners) looks->uv_sets_.pop_back();
    find_reversed();
    looks->normals_ = share_reversed(soup_.looks.normals, "normals", [](const glm::vec3& n) { return -n; });
    looks->tangents_ = share_reversed(soup_.looks.tangents, "tangents",
                                      [](const glm::vec4& t) { return glm::vec4(t.x, t.y, t.z, -t.w); });
    share_attributes(*looks);
    if (soup_.keeps_corners || !looks->uv_sets_.empty() || looks->normals_.corners ||
        looks->tangents_.corners || !looks->attributes_.empty())
      looks->positions_ = share(LookChannel<Vec3>{soup_.positions, soup_.triangles}, "positions");
    share_corners(*looks);
    if (soup_.keeps_corners) looks->sources_.assign(sources_.begin(), sources_.end());
    warn_not_finite(warnings);
    if (!looks->surfaces_ && !looks->positions_.corners) return nullptr;
    looks->hash_ = hash_of(*looks);
    return looks;
  }

 private:
  size_t faces() const { return turned_.size(); }
  size_t source(size_t face) const { return sources_.empty() ? face : sources_[face]; }

  void record_not_finite(size_t face, const std::string& kind) {
    not_finite_.resize(faces());
    not_finite_[face] = true;
    if (std::ranges::find(kinds_not_finite_, kind) == kinds_not_finite_.end())
      kinds_not_finite_.push_back(kind);
  }

  void warn_not_finite(std::vector<std::string>& warnings) const {
    const auto count = static_cast<size_t>(std::ranges::count(not_finite_, true));
    if (count == 0) return;
    warnings.push_back(count_text(count, "face") + (count == 1 ? " has " : " have ") +
                       listed(kinds_not_finite_) + " that are not finite numbers and " +
                       (count == 1 ? "loses" : "lose") + " them.");
  }

  // Returns the values of the loaded faces, of a kind for messages. A face that lacks one at a corner has
  // none.
  template <typename T>
  Channel<T> share(const LookChannel<T>& from, const std::string& kind) {
    Channel<T> channel;
    if (!from.any()) return channel;
    Corners corners(faces(), {kNoValue, kNoValue, kNoValue});
    DistinctValues<T> distinct;
    bool any = false;
    for (size_t f = 0; f < faces(); ++f) {
      const auto& own = from.corners[source(f)];
      if (std::max({own[0], own[1], own[2]}) >= from.values.size()) continue;
      if (!std::all_of(own.begin(), own.end(),
                       [&](uint32_t v) { return has_finite_numbers(from.values[v]); })) {
        record_not_finite(f, kind);
        continue;
      }
      for (size_t i = 0; i < 3; ++i) corners[f][i] = distinct.number(from.values[own[i]]);
      any = true;
    }
    if (!any) return channel;
    channel.values = std::move(distinct.values);
    channel.values.shrink_to_fit();
    channel.corners = std::make_shared<const Corners>(std::move(corners));
    return channel;
  }

  // Normals of a face that the mesh turned are stored reversed if they disagree with its orientation in the
  // file: they were right, and evaluation reverses those of turned faces. So are signs of bitangents.
  void find_reversed() {
    const LookChannel<glm::vec3>& normals = soup_.looks.normals;
    if (!normals.any()) return;
    for (size_t f = 0; f < faces(); ++f) {
      const auto& corners = normals.corners[source(f)];
      if (!turned_[f] || std::max({corners[0], corners[1], corners[2]}) >= normals.values.size()) continue;
      const auto& [a, b, c] = soup_.triangles[source(f)];
      const Vec3 across =
          glm::cross(soup_.positions[b] - soup_.positions[a], soup_.positions[c] - soup_.positions[a]);
      Vec3 sum(0);
      for (const uint32_t v : corners) sum += Vec3(normals.values[v]);
      if (glm::dot(sum, across) < 0) reversed_.push_back(f);
    }
  }

  // Shares a channel with the values of reversed faces replaced by reverse(value).
  template <typename T, typename Reverse>
  Channel<T> share_reversed(const LookChannel<T>& from, const std::string& kind, const Reverse& reverse) {
    if (!from.any() || reversed_.empty()) return share(from, kind);
    LookChannel<T> own = from;
    for (const size_t f : reversed_) {
      auto& corners = own.corners[source(f)];
      if (std::max({corners[0], corners[1], corners[2]}) >= from.values.size()) continue;
      for (uint32_t& v : corners) {
        own.values.push_back(reverse(from.values[v]));
        v = static_cast<uint32_t>(own.values.size() - 1);
      }
    }
    return share(own, kind);
  }

  void share_attributes(Looks& looks) {
    for (const LookAttribute& attribute : soup_.looks.attributes) {
      Channel<glm::vec4> channel =
          share(attribute.channel, "values of attribute " + in_quotes(attribute.name));
      if (channel.corners) looks.attributes_.push_back({attribute.name, attribute.parts, std::move(channel)});
    }
  }

  static void share_corners(Looks& looks) {
    std::vector<std::shared_ptr<const Corners>*> all{&looks.positions_.corners, &looks.normals_.corners};
    for (auto& set : looks.uv_sets_) all.push_back(&set.corners);
    all.push_back(&looks.tangents_.corners);
    for (auto& attribute : looks.attributes_) all.push_back(&attribute.channel.corners);
    for (size_t i = 0; i < all.size(); ++i) {
      for (size_t k = 0; k < i && *all[i]; ++k) {
        if (*all[k] && **all[k] == **all[i]) *all[i] = *all[k];
      }
    }
  }

  const Soup& soup_;
  std::span<const uint32_t> sources_;
  const std::vector<bool>& turned_;
  std::vector<bool> not_finite_;  // by face; empty if all values are finite
  std::vector<std::string> kinds_not_finite_;
  std::vector<size_t> reversed_;  // faces, ascending
};

std::shared_ptr<const Looks> Looks::make(const Soup& soup, std::span<const uint32_t> sources,
                                         const std::vector<bool>& turned,
                                         std::vector<std::string>& warnings) {
  if (!soup.looks.any() && !soup.surfaces && !soup.keeps_corners) return nullptr;
  return Builder(soup, sources, turned).build(warnings);
}

Vec3 Looks::barycentrics(FaceId loaded, const Vec3& point) const {
  KERF_ASSERT(contains(loaded));
  const Triangle t = positions_.at(loaded);
  Vec3 u = t[1] - t[0], w = t[2] - t[0], d = point - t[0];
  const double size = std::max(largest_part(u), largest_part(w));
  if (!(size > 0)) return {1, 0, 0};
  // Division by the size keeps the products in range.
  u /= size;
  w /= size;
  d /= size;
  const Vec3 n = glm::cross(u, w);
  const double across2 = glm::dot(n, n);
  if (!(across2 > 0)) return weights_on_side(t, longest_side(t), point);
  const double second = glm::dot(glm::cross(d, w), n) / across2,
               third = glm::dot(glm::cross(u, d), n) / across2;
  const Vec3 weights(1 - second - third, second, third);
  // A weight times its height, of at least |n| sizes, is the distance from the side.
  const double rounding =
      kSideRoundings * (largest_part(t[0]) + largest_part(point)) / (size * std::sqrt(across2));
  const double slack = std::max(kOnLoadedSide, rounding);
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(weights[i]) < std::abs(weights[nearest])) nearest = i;
  }
  const bool is_outside = std::min({weights.x, weights.y, weights.z}) < -slack;
  return std::abs(weights[nearest]) < slack && !is_outside ? weights_on_side(t, (nearest + 1) % 3, point)
                                                           : weights;
}

bool Looks::agrees(FaceId loaded, const Triangle& part) const {
  KERF_ASSERT(contains(loaded));
  const Triangle t = positions_.at(loaded);
  const auto across = [](const Triangle& s) {
    const double size = std::max(largest_part(s[1] - s[0]), largest_part(s[2] - s[0]));
    return size > 0 ? glm::cross((s[1] - s[0]) / size, (s[2] - s[0]) / size) : Vec3(0);
  };
  return !(glm::dot(across(t), across(part)) < 0);
}

namespace {

// Height of a point above the plane of a triangle [m]; 0 if that has no area.
double height_above(const Triangle& t, const Vec3& at) {
  const double size = std::max(largest_part(t[1] - t[0]), largest_part(t[2] - t[0]));
  if (!(size > 0)) return 0;
  const Vec3 across = glm::cross((t[1] - t[0]) / size, (t[2] - t[0]) / size);
  const double length = glm::length(across);
  return length > 0 ? glm::dot(across / length, at - t[0]) : 0;
}

}  // namespace

bool Looks::lies_on_plane(FaceId loaded, const Vec3& at) const {
  KERF_ASSERT(contains(loaded));
  const Triangle t = positions_.at(loaded);
  const double size = std::max(largest_part(t[1] - t[0]), largest_part(t[2] - t[0]));
  const double slack =
      std::max(kOnLoadedSide * size, kSideRoundings * (largest_part(t[0]) + largest_part(at)));
  return std::abs(height_above(t, at)) <= slack;
}

Looks::Point Looks::locate(FaceId loaded, const Vec3& at, bool& is_inside) const {
  Point point{loaded, barycentrics(loaded, at)};
  const Vec3& w = point.weights;
  point.is_on_plane = lies_on_plane(loaded, at);
  is_inside = point.is_on_plane && std::min({w.x, w.y, w.z}) >= -kOnLoadedSide;
  return point;
}

bool Looks::continue_in(Point& point, FaceId adjacent, const Vec3& at) const {
  if (adjacent == point.face || !lies_on_plane(adjacent, at)) return false;
  const Vec3 weights = barycentrics(adjacent, at);
  const bool is_contained = std::min({weights.x, weights.y, weights.z}) >= -kOnLoadedSide;
  if (!is_contained && (point.is_on_plane || point.adjacent.valid())) return false;
  point.adjacent = adjacent;
  point.adjacent_weights = weights;
  return is_contained;
}

template <typename T>
bool Looks::continues(const Channel<T>& channel, FaceId a, FaceId b) const {
  if (!channel.contains(b)) return false;
  const auto &at_a = (*positions_.corners)[a.index], &at_b = (*positions_.corners)[b.index];
  int shared = 0;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      if (at_a[i] != at_b[k]) continue;
      if ((*channel.corners)[a.index][i] != (*channel.corners)[b.index][k]) return false;
      ++shared;
    }
  }
  return shared > 0;
}

template <typename T>
std::vector<uint32_t> Looks::charts(const Channel<T>& channel) const {
  const size_t faces = channel.corners ? channel.corners->size() : 0;
  std::vector<uint32_t> lowest(faces);
  std::iota(lowest.begin(), lowest.end(), uint32_t{0});
  const auto root = [&](uint32_t f) {
    while (lowest[f] != f) f = lowest[f] = lowest[lowest[f]];
    return f;
  };
  const auto key = [&](uint32_t side) {
    return uint64_t{(*positions_.corners)[side / 3][side % 3]} << 32 | (*channel.corners)[side / 3][side % 3];
  };
  KeyTable first;  // sides, by their corner and its value
  for (uint32_t f = 0; f < faces; ++f) {
    for (uint32_t side = 3 * f; side < 3 * f + 3 && channel.contains(FaceId(f)); ++side) {
      const uint32_t found = first.find_or_add(
          mix64(key(side)), side, [&](uint32_t other) { return key(other) == key(side); },
          [&](uint32_t other) { return mix64(key(other)); });
      const uint32_t a = root(found / 3), b = root(f);
      lowest[std::max(a, b)] = std::min(a, b);
    }
  }
  for (uint32_t f = 0; f < faces; ++f) lowest[f] = root(f);
  return lowest;
}

template std::vector<uint32_t> Looks::charts<glm::vec2>(const Channel<glm::vec2>&) const;
template std::vector<uint32_t> Looks::charts<glm::vec3>(const Channel<glm::vec3>&) const;
template std::vector<uint32_t> Looks::charts<glm::vec4>(const Channel<glm::vec4>&) const;

template <typename V, typename T>
V Looks::value(const Channel<T>& channel, const Point& point) const {
  const auto sum = [&](FaceId face, const Vec3& weights) {
    const auto [a, b, c] = channel.at(face);
    return weights.x * V(a) + weights.y * V(b) + weights.z * V(c);
  };
  const bool continued = point.adjacent.valid() && continues(channel, point.face, point.adjacent);
  return continued ? sum(point.adjacent, point.adjacent_weights) : sum(point.face, point.weights);
}

template glm::dvec2 Looks::value<glm::dvec2>(const Channel<glm::vec2>&, const Point&) const;
template Vec3 Looks::value<Vec3>(const Channel<glm::vec3>&, const Point&) const;
template glm::dvec4 Looks::value<glm::dvec4>(const Channel<glm::vec4>&, const Point&) const;

bool Looks::has_seam(FaceId a, FaceId b) const {
  return a != b && std::ranges::any_of(uv_sets_, [&](const auto& set) {
           return set.contains(a) && set.contains(b) && !continues(set, a, b);
         });
}

size_t Looks::bytes() const {
  std::vector<const Corners*> counted;
  size_t bytes = 0;
  const auto add = [&](const auto& channel) {
    bytes += channel.values.capacity() * sizeof(channel.values[0]);
    const Corners* corners = channel.corners.get();
    if (!corners || std::find(counted.begin(), counted.end(), corners) != counted.end()) return;
    counted.push_back(corners);
    bytes += corners->capacity() * sizeof((*corners)[0]);
  };
  add(positions_);
  add(normals_);
  for (const auto& set : uv_sets_) add(set);
  add(tangents_);
  for (const auto& attribute : attributes_) add(attribute.channel);
  return bytes;
}

}  // namespace kerf
