#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/cut/cut_step.h"
#include "core/document/document.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {

// The sheet and its copy that is moved by `height` along +Y, with walls around: closed, normals outside.
Soup extruded(const Soup& sheet, double height);

// Ten closed soups whose faces look outside: boxes, a ball, a ring, a tube, a plate with holes, two balls
// beside each other, nested shells and a knot.
std::vector<NamedSoup> generated_solids();

// A stroke of a beam with one direction, and what it is called.
struct SolidStroke {
  std::string name;
  CutSettings settings;
  std::vector<Pose> poses;
};
// A random one: through the middle, from inside to inside, into the depth, along the silhouette, around a
// circle, over itself, or several ways through one point.
SolidStroke random_solid_stroke(const World& world, Random& random);
SolidStroke straight_stroke(const Vec3& from, const Vec3& to, const Vec3& direction, double radius,
                            Interval range);

// Cuts a world of one solid body, and looks at what is left after every stroke.
class SolidCut {
 public:
  explicit SolidCut(World world);

  // Cuts, and expects that the body is closed or told to be left open, and, where it is closed, that the
  // volumes of its pieces and what was removed sum up to the volume that there was, and that points lie
  // inside where they did and no beam was. Returns whether it is closed. Precondition: it is closed.
  bool draw(const SolidStroke& stroke, Random& random);

  Document& document() { return document_; }
  const Body& body() const { return document_.world().body(document_.world().ids().front()); }
  // The sentences that said why the body was left open.
  const std::vector<std::string>& reasons() const { return reasons_; }
  // How many closed volumes there are: connected parts without the cavities, which enclose less than nothing.
  size_t solids() const;
  // How many pieces of the last stroke enclose next to nothing.
  size_t specks() const { return specks_; }

 private:
  double distance_from_swept(const Vec3& p) const;
  void expect_points_inside_as_before(double radius, Random& random) const;

  Document document_;
  Body loaded_;
  std::vector<SweptCylinder> swept_;
  std::vector<std::string> reasons_;
  double volume_ = 0, removed_ = 0;  // m^3
  size_t specks_ = 0;
};

}  // namespace kerf::test
