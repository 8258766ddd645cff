#pragma once

#include <string_view>

#include "core/base/vec3.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

// The unit of the numbers in a mesh file.
enum class FileUnit { kMillimetre, kCentimetre, kMetre, kInch };

// The axis of a mesh file that points upwards. Both conventions are right-handed.
enum class UpAxis { kY, kZ };

// How the coordinates of a mesh file are to be understood. The files hold neither, so that both are guessed
// and may be changed by the user. They change only what is shown: positions stay as they were read.
struct FileFrame {
  FileUnit unit = FileUnit::kMetre;
  UpAxis up = UpAxis::kY;

  // Kerf's own convention, in which nothing is converted.
  bool is_default() const { return *this == FileFrame(); }
  friend bool operator==(const FileFrame&, const FileFrame&) = default;
};

// The unit and the upward axis that a file most probably has, from its format and the bounding box of its
// mesh in the numbers of the file. STL files usually come from CAD and 3D printing, in millimetres with +Z
// upwards; the other formats from modelling tools, games and research, in metres with +Y upwards, or in
// centimetres or millimetres where the mesh would be larger than a lorry. The format does not decide the axis
// if the mesh stands on exactly one of the planes y = 0 and z = 0: then that axis points upwards.
// Precondition: min <= max, and both are finite. Constant time.
FileFrame guess_frame(MeshFormat format, const Vec3& min, const Vec3& max);

// How many metres one unit is.
double metres_per_unit(FileUnit unit);

// "mm", "cm", "m" or "in".
std::string_view unit_symbol(FileUnit unit);

// Converts a direction or point into a frame in which +Y points upwards: (x, z, -y) for kZ. Exact.
Vec3 to_y_up(const Vec3& v, UpAxis up);
// The inverse of to_y_up().
Vec3 from_y_up(const Vec3& v, UpAxis up);
// The coordinate of v along the upward axis.
double height_of(const Vec3& v, UpAxis up);

}  // namespace kerf
