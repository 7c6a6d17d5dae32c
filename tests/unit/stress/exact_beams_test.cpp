// The stress test's own answer against closed forms, and its bounds against sums that are known.
#include "exact_beams.h"

#include <cmath>

#include <gtest/gtest.h>

#include "reference/closed_forms.h"

namespace ribalta::stress {
namespace {

/// A square beam of 90 degrees down -Z from the origin in haze that scatters alike all around.
stress::SetUp squareBeam() {
    stress::SetUp setUp;
    SpotLight lamp;
    lamp.outerConeAngle = 0.25 * 3.14159265358979;
    lamp.beamShape = BeamShape::kPyramid;
    lamp.intensityCandela = 1.0;
    setUp.lamps = {lamp};
    setUp.haze.scatteringPerMetre = 0.2;
    setUp.haze.absorptionPerMetre = 0.1;
    setUp.haze.phase.kind = PhaseFunction::Kind::kIsotropic;
    return setUp;
}

/// Across the beam, 2 m before the lamp and 5 m from the eye to the point nearest to the lamp.
const Ray kAcross{{-5.0, 0.0, -2.0}, {1.0, 0.0, 0.0}, 0.1, 100.0};

TEST(ExactBeams, AgreesWithSunsClosedForm) {
    const ExactBeams beams(squareBeam(), 0);
    const double exact = isotropicPointSource(2.0, 5.0, -2.0, 2.0, 0.2, 0.3);
    EXPECT_NEAR(beams.along(kAcross).x / exact, 1.0, 1e-7);
}

TEST(ExactBeams, AgreesWithGibbonsClosedForm) {
    stress::SetUp setUp = squareBeam();
    setUp.haze = {};
    setUp.haze.scatteringPerMetre = 1e-9;
    const ExactBeams beams(setUp, 0);
    const double exact = 1e-9 * gibbonsOverSlab(2.0, -2.0, 2.0, setUp.haze.phase.k);
    EXPECT_NEAR(beams.along(kAcross).x / exact, 1.0, 1e-7);
}

TEST(ExactBeams, ARectangleTakesItsShadow) {
    stress::SetUp setUp = squareBeam();
    // Half way to the ray; shades the side of positive x.
    setUp.rectangles = {{{0.6, 0.0, -1.0}, {0.6, 0.0, 0.0}, {0.0, 0.5, 0.0}}};
    const ExactBeams beams(setUp, 256);
    const double exact = isotropicPointSource(2.0, 5.0, -2.0, 0.0, 0.2, 0.3);
    EXPECT_NEAR(beams.along(kAcross).x / exact, 1.0, 1e-7);
    // A texel of 256 is about a 64th of a metre where the ray runs.
    EXPECT_LT(beams.along(kAcross, {0.0, 1.5}).x, exact);
    EXPECT_GT(beams.along(kAcross, {0.0, -1.5}).x, exact);
    EXPECT_NEAR(beams.along(kAcross, {0.0, 1.5}).x / exact, 1.0, 0.05);
}

TEST(ExactBeams, ARayOutsideIsDark) {
    const ExactBeams beams(squareBeam(), 0);
    EXPECT_EQ(beams.along({{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, 0.0, 100.0}).x, 0.0);
}

/// The mean of n samples at the middles of n even steps.
double midpoints(const ExactBeams& beams, int n) {
    // Even in metres: short stretches of the ray stand in for their middles.
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        Ray piece = kAcross;
        piece.first = 3.0 + 4.0 * (i + 0.5) / n - 1e-6;
        piece.last = piece.first + 2e-6;
        sum += beams.along(piece).x / 2e-6 * 4.0 / n;
    }
    return sum;
}

TEST(ExactBeams, RoughnessBoundsTheErrorOfSums) {
    const ExactBeams beams(squareBeam(), 0);
    const double exact = beams.along(kAcross).x;
    const Roughness roughness = beams.inBeams(kAcross, 4, true, 0.0, false);
    for (const int n : {1, 2, 4, 16}) {
        const double error = std::abs(midpoints(beams, n) - exact);
        EXPECT_LT(error, roughness.variation / (2.0 * n));
        EXPECT_LT(error, roughness.slopeVariation / (8.0 * n * n));
        // Not so much that anything would pass.
        EXPECT_GT(error, 0.01 * roughness.slopeVariation / (8.0 * n * n)) << n;
    }
}

}  // namespace
}  // namespace ribalta::stress
