#include "core/mesh/files/file_frame.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"

namespace kerf {

namespace {

// Lengths in the numbers of the file.
constexpr double kLargestModelInMetres = 50;         // a lorry, a house, an airliner's fuselage
constexpr double kLargestModelInCentimetres = 1000;  // a car has 450, and 4,500 in millimetres
constexpr double kSmallestPart = 2.5;  // in millimetres; smaller STL files are models of about unit size

// How far from a plane, relative to its height, a mesh may begin that stands on it.
constexpr double kStandingSlack = 0.01;

bool stands_at_zero(double low, double high) {
  const double slack = kStandingSlack * (high - low);
  return low < high && -slack <= low && low <= slack;
}

FileUnit guess_unit(MeshFormat format, double longest) {
  if (format == MeshFormat::kStl) return longest < kSmallestPart ? FileUnit::kMetre : FileUnit::kMillimetre;
  if (longest <= kLargestModelInMetres) return FileUnit::kMetre;
  return longest <= kLargestModelInCentimetres ? FileUnit::kCentimetre : FileUnit::kMillimetre;
}

UpAxis guess_up(MeshFormat format, const Vec3& min, const Vec3& max) {
  const bool on_y = stands_at_zero(min.y, max.y), on_z = stands_at_zero(min.z, max.z);
  if (on_y != on_z) return on_y ? UpAxis::kY : UpAxis::kZ;
  return format == MeshFormat::kStl ? UpAxis::kZ : UpAxis::kY;
}

}  // namespace

FileFrame guess_frame(MeshFormat format, const Vec3& min, const Vec3& max) {
  KERF_ASSERT(min.x <= max.x && min.y <= max.y && min.z <= max.z);
  const Vec3 size = max - min;
  return {guess_unit(format, std::max({size.x, size.y, size.z})), guess_up(format, min, max)};
}

double metres_per_unit(FileUnit unit) {
  constexpr std::array kMetres{0.001, 0.01, 1.0, 0.0254};
  return kMetres.at(static_cast<size_t>(unit));
}

std::string_view unit_symbol(FileUnit unit) {
  constexpr std::array kSymbols{"mm", "cm", "m", "in"};
  return kSymbols.at(static_cast<size_t>(unit));
}

Vec3 to_y_up(const Vec3& v, UpAxis up) { return up == UpAxis::kZ ? Vec3(v.x, v.z, -v.y) : v; }

Vec3 from_y_up(const Vec3& v, UpAxis up) { return up == UpAxis::kZ ? Vec3(v.x, -v.z, v.y) : v; }

double height_of(const Vec3& v, UpAxis up) { return up == UpAxis::kZ ? v.z : v.y; }

}  // namespace kerf
