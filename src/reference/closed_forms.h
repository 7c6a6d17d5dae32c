// Closed forms of light scattered once along a straight ray: what integrals are checked against.
// Geometry: the lamp's distance h to the ray's line in metres, h > 0, and positions s along the ray
// in metres from the point nearest to the lamp, growing the way the eye looks.
#pragma once

namespace ribalta {

/// Luminance in cd/m2 that an eye at s = -eyeToNearest gets from s0..s1 (s0 <= s1), lit by a point
/// source of one candela in even haze that scatters isotropically; scattering and extinction in
/// 1/m. Sun, Ramamoorthi, Narasimhan & Nayar 2005, equation 10, over a segment. Good to about
/// 1e-13.
double isotropicPointSource(double h, double eyeToNearest, double s0, double s1,
                            double scatteringPerMetre, double extinctionPerMetre);

/// The integral of Gibbons' phase function over r^2 along s0..s1 (s0 <= s1), in 1/(m sr), without
/// extinction; `k` is Gibbons' factor.
double gibbonsOverSlab(double h, double s0, double s1, double k);

}  // namespace ribalta
