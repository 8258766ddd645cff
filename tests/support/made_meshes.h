#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/mesh/build_mesh.h"

namespace kerf::test {

// Soups made for tests, by class.
Soup plate(double size);                             // a square of two triangles in y = 0
Soup grid(int cells, double size);                   // an open sheet in y = 0
Soup sphere(int rings, int sectors, double radius);  // closed, genus 0
Soup torus(int rings, int sectors, double major, double minor);
Soup tube(int rings, int sectors, double radius, double length);    // two boundaries
Soup brick(const Vec3& size);                                       // closed, one corner at the origin
Soup pipe(int sectors, double inner, double outer, double length);  // closed, around the y axis
Soup moebius(int cells);                                            // one side
Soup book(int sheets);                                              // so many sheets on one edge
Soup random_soup(int triangles, Random& random);  // anything in the unit cube, some on a lattice
Soup pillow();                                    // the same triangle twice
Soup both(const Soup& a, const Soup& b);          // two soups, beside each other as they stand
Soup moved(Soup soup, const Vec3& by, double scale);
Soup inside_out(Soup soup);

struct NamedSoup {
  std::string name;
  Soup soup;
};
// One or more of every class: closed, open, several components, non-manifold, one-sided, thin, far, tiny.
std::vector<NamedSoup> mesh_classes();

// build_mesh, which must succeed.
BuiltMesh build(const Soup& soup);

}  // namespace kerf::test
