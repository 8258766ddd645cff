#include "core/heat/black_body.h"

#include <algorithm>
#include <array>

#include "core/base/deterministic_math.h"

namespace kerf {
namespace {

// The colour matching functions x, y and z of the CIE 1931 2-degree standard observer (CIE 018:2019, table
// 6), from 360 to 830 nm.
constexpr double kMatchedFrom = 360;  // nm, the first
constexpr double kMatchedStep = 5;    // nm
// clang-format off
constexpr std::array<std::array<double, 3>, 95> kColourMatching = {{
    {0.00013, 4e-06, 0.000606},  // 360
    {0.000232, 7e-06, 0.001086},  // 365
    {0.000415, 1.2e-05, 0.001946},  // 370
    {0.000742, 2.2e-05, 0.003486},  // 375
    {0.001368, 3.9e-05, 0.00645},  // 380
    {0.002236, 6.4e-05, 0.01055},  // 385
    {0.004243, 0.00012, 0.02005},  // 390
    {0.00765, 0.000217, 0.03621},  // 395
    {0.01431, 0.000396, 0.06785},  // 400
    {0.02319, 0.00064, 0.1102},  // 405
    {0.04351, 0.00121, 0.2074},  // 410
    {0.07763, 0.00218, 0.3713},  // 415
    {0.13438, 0.004, 0.6456},  // 420
    {0.21477, 0.0073, 1.03905},  // 425
    {0.2839, 0.0116, 1.3856},  // 430
    {0.3285, 0.01684, 1.62296},  // 435
    {0.34828, 0.023, 1.74706},  // 440
    {0.34806, 0.0298, 1.7826},  // 445
    {0.3362, 0.038, 1.77211},  // 450
    {0.3187, 0.048, 1.7441},  // 455
    {0.2908, 0.06, 1.6692},  // 460
    {0.2511, 0.0739, 1.5281},  // 465
    {0.19536, 0.09098, 1.28764},  // 470
    {0.1421, 0.1126, 1.0419},  // 475
    {0.09564, 0.13902, 0.81295},  // 480
    {0.05795, 0.1693, 0.6162},  // 485
    {0.03201, 0.20802, 0.46518},  // 490
    {0.0147, 0.2586, 0.3533},  // 495
    {0.0049, 0.323, 0.272},  // 500
    {0.0024, 0.4073, 0.2123},  // 505
    {0.0093, 0.503, 0.1582},  // 510
    {0.0291, 0.6082, 0.1117},  // 515
    {0.06327, 0.71, 0.07825},  // 520
    {0.1096, 0.7932, 0.05725},  // 525
    {0.1655, 0.862, 0.04216},  // 530
    {0.22575, 0.91485, 0.02984},  // 535
    {0.2904, 0.954, 0.0203},  // 540
    {0.3597, 0.9803, 0.0134},  // 545
    {0.43345, 0.99495, 0.00875},  // 550
    {0.51205, 1, 0.00575},  // 555
    {0.5945, 0.995, 0.0039},  // 560
    {0.6784, 0.9786, 0.00275},  // 565
    {0.7621, 0.952, 0.0021},  // 570
    {0.8425, 0.9154, 0.0018},  // 575
    {0.9163, 0.87, 0.00165},  // 580
    {0.9786, 0.8163, 0.0014},  // 585
    {1.0263, 0.757, 0.0011},  // 590
    {1.0567, 0.6949, 0.001},  // 595
    {1.0622, 0.631, 0.0008},  // 600
    {1.0456, 0.5668, 0.0006},  // 605
    {1.0026, 0.503, 0.00034},  // 610
    {0.9384, 0.4412, 0.00024},  // 615
    {0.85445, 0.381, 0.00019},  // 620
    {0.7514, 0.321, 0.0001},  // 625
    {0.6424, 0.265, 5e-05},  // 630
    {0.5419, 0.217, 3e-05},  // 635
    {0.4479, 0.175, 2e-05},  // 640
    {0.3608, 0.1382, 1e-05},  // 645
    {0.2835, 0.107, 0},  // 650
    {0.2187, 0.0816, 0},  // 655
    {0.1649, 0.061, 0},  // 660
    {0.1212, 0.04458, 0},  // 665
    {0.0874, 0.032, 0},  // 670
    {0.0636, 0.0232, 0},  // 675
    {0.04677, 0.017, 0},  // 680
    {0.0329, 0.01192, 0},  // 685
    {0.0227, 0.00821, 0},  // 690
    {0.01584, 0.005723, 0},  // 695
    {0.011359, 0.004102, 0},  // 700
    {0.008111, 0.002929, 0},  // 705
    {0.00579, 0.002091, 0},  // 710
    {0.004109, 0.001484, 0},  // 715
    {0.002899, 0.001047, 0},  // 720
    {0.002049, 0.00074, 0},  // 725
    {0.00144, 0.00052, 0},  // 730
    {0.001, 0.000361, 0},  // 735
    {0.00069, 0.000249, 0},  // 740
    {0.000476, 0.000172, 0},  // 745
    {0.000332, 0.00012, 0},  // 750
    {0.000235, 8.5e-05, 0},  // 755
    {0.000166, 6e-05, 0},  // 760
    {0.000117, 4.2e-05, 0},  // 765
    {8.3e-05, 3e-05, 0},  // 770
    {5.9e-05, 2.1e-05, 0},  // 775
    {4.2e-05, 1.5e-05, 0},  // 780
    {2.9e-05, 1.1e-05, 0},  // 785
    {2.1e-05, 7e-06, 0},  // 790
    {1.5e-05, 5e-06, 0},  // 795
    {1e-05, 4e-06, 0},  // 800
    {7e-06, 3e-06, 0},  // 805
    {5e-06, 2e-06, 0},  // 810
    {4e-06, 1e-06, 0},  // 815
    {3e-06, 1e-06, 0},  // 820
    {2e-06, 1e-06, 0},  // 825
    {1e-06, 0, 0},  // 830
}};
// clang-format on

constexpr double kSecondRadiation = 1.438776877e-2;  // m K, Planck's h c / k

// Returns the spectral radiance at a wavelength (m), up to a constant factor.
double planck(double wavelength, double temperature) {
  const double squared = wavelength * wavelength;
  return 1e-30 /
         (squared * squared * wavelength * (det::exp(kSecondRadiation / (wavelength * temperature)) - 1));
}

Vec3 tristimulus(double temperature) {
  Vec3 sum(0);
  double wavelength = kMatchedFrom;
  for (const auto& matching : kColourMatching) {
    sum += planck(1e-9 * wavelength, temperature) * Vec3(matching[0], matching[1], matching[2]);
    wavelength += kMatchedStep;
  }
  return sum;
}

// Converts CIE XYZ to linear sRGB with white D65 (IEC 61966-2-1).
Vec3 linear_srgb(const Vec3& xyz) {
  return {glm::dot(Vec3(3.2404542, -1.5371385, -0.4985314), xyz),
          glm::dot(Vec3(-0.9692660, 1.8760108, 0.0415560), xyz),
          glm::dot(Vec3(0.0556434, -0.2040259, 1.0572252), xyz)};
}

double fitted_log_luminance(double temperature) {
  const double u = 1000 / temperature;
  return 25.861105 + u * (-26.518044 + u * (1.913252 + u * -0.267061));
}

}  // namespace

Glow glow_at(double temperature) {
  const double seen = std::clamp(temperature, kGlowFrom, kGlowTo);
  if (temperature < kGlowFrom) return {Vec3(0), fitted_log_luminance(seen)};
  const Vec3 rgb = linear_srgb(tristimulus(seen));
  const double largest = std::max({rgb.x, rgb.y, rgb.z});
  return {{std::max(0.0, rgb.x / largest), std::max(0.0, rgb.y / largest), std::max(0.0, rgb.z / largest)},
          fitted_log_luminance(seen)};
}

}  // namespace kerf
