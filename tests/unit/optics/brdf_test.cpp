// The surface model by its laws: reciprocity, conservation of energy, Lambert's limit, no
// infinities.
#include <cmath>

#include <gtest/gtest.h>

#include "base/angles.h"
#include "directions.h"
#include "optics/shader_lib.h"
#include "quadrature.h"
#include "shader_lib_float.h"

namespace ribalta {
namespace {

using test::direction;

struct Surface {
    glm::dvec3 baseColor{1.0};
    double metallic = 0.0;
    double roughness = 1.0;

    glm::dvec3 operator()(const glm::dvec3& light, const glm::dvec3& view) const {
        const glm::dvec3 half = glm::normalize(light + view);
        return shader::metallicRoughnessBrdf(baseColor, metallic, roughness, light.z, view.z,
                                             half.z, glm::dot(view, half));
    }
};

/// The share of the light from one direction that is reflected anywhere, by plain quadrature; for
/// roughness of 0.3 and up. Sees one half of the azimuths, the other is its mirror image.
double albedo(const Surface& surface, double nDotV) {
    const glm::dvec3 view = direction(nDotV, 0.0);
    double sum = 0.0;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 8; ++j) {
            sum += integratePanel(
                [&](double azimuth) {
                    return integratePanel(
                        [&](double cosine) {
                            return surface(direction(cosine, azimuth), view).y * cosine;
                        },
                        j / 8.0, (j + 1) / 8.0);
                },
                kPi * i / 6.0, kPi * (i + 1) / 6.0);
        }
    }
    return 2.0 * sum;
}

/// The same for smooth surfaces without a diffuse part: half vectors spread as the facets are.
double specularAlbedo(const Surface& surface, double nDotV) {
    const glm::dvec3 view = direction(nDotV, 0.0);
    const double alpha = shader::alphaFromRoughness(surface.roughness);
    constexpr int kSteps = 300;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double u = (i + 0.5) / kSteps;
            const double cosine = std::sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u));
            const glm::dvec3 half = direction(cosine, 2.0 * kPi * (j + 0.5) / kSteps);
            const double vDotH = glm::dot(view, half);
            const glm::dvec3 light = 2.0 * vDotH * half - view;
            if (vDotH <= 0.0 || light.z <= 0.0) {
                continue;
            }
            const double density = shader::ggxDistribution(half.z, alpha) * half.z / (4.0 * vDotH);
            sum += surface(light, view).y * light.z / density;
        }
    }
    return sum / (kSteps * kSteps);
}

TEST(Brdf, IsReciprocal) {
    for (const double roughness : {0.0, 0.2, 0.7, 1.0}) {
        const Surface surface{{0.8, 0.5, 0.1}, 0.3, roughness};
        const glm::dvec3 a = direction(0.3, 0.4);
        const glm::dvec3 b = direction(0.8, 2.9);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(surface(a, b)[c], surface(b, a)[c], 1e-12);
        }
    }
}

TEST(Brdf, FacetsCoverTheSurface) {
    for (const double roughness : {0.2, 0.5, 1.0}) {
        const double alpha = shader::alphaFromRoughness(roughness);
        double area = 0.0;
        for (int i = 0; i < 200; ++i) {
            area += integratePanel(
                [&](double mu) { return 2.0 * kPi * mu * shader::ggxDistribution(mu, alpha); },
                i / 200.0, (i + 1) / 200.0);
        }
        EXPECT_NEAR(area, 1.0, 1e-9) << "roughness " << roughness;
    }
}

TEST(Brdf, HighlightsReflectNoMoreThanTheyGet) {
    for (const double nDotV : {0.05, 0.3, 0.7, 1.0}) {
        for (const double roughness : {0.0, 0.1, 0.3, 0.6, 1.0}) {
            const double metal = specularAlbedo({glm::dvec3(1.0), 1.0, roughness}, nDotV);
            EXPECT_LE(metal, 1.001) << "roughness " << roughness << ", N.V " << nDotV;
            EXPECT_GT(metal, 0.25) << "roughness " << roughness << ", N.V " << nDotV;
            const double varnish = specularAlbedo({glm::dvec3(0.0), 0.0, roughness}, nDotV);
            EXPECT_LE(varnish, metal) << "roughness " << roughness << ", N.V " << nDotV;
            EXPECT_GT(varnish, 0.04 * metal) << "roughness " << roughness << ", N.V " << nDotV;
        }
    }
}

// glTF mixes by V.H, which at grazing angles gives more than there is; brdf.glsl says how much.
TEST(Brdf, WhitePlasticStaysWithinTheStatedBounds) {
    for (const double roughness : {0.3, 0.6, 1.0}) {
        constexpr int kViews = 10;
        double mean = 0.0;
        for (int i = 0; i < kViews; ++i) {
            const double nDotV = (i + 0.5) / kViews;
            const double share = albedo({glm::dvec3(1.0), 0.0, roughness}, nDotV);
            EXPECT_LE(share, nDotV > 0.5 ? 1.02 : 1.36) << roughness << ", N.V " << nDotV;
            EXPECT_GT(share, 0.95) << roughness << ", N.V " << nDotV;
            mean += 2.0 * nDotV * share / kViews;
        }
        EXPECT_LE(mean, 1.05) << roughness;
    }
}

TEST(Brdf, SmoothMetalIsAWhiteMirror) {
    for (const double nDotV : {0.3, 0.7, 1.0}) {
        EXPECT_NEAR(specularAlbedo({glm::dvec3(1.0), 1.0, 0.1}, nDotV), 1.0, 0.01);
    }
}

TEST(Brdf, DiffusePartIsLambertUnderFresnel) {
    // Far from the highlight and at V.H = 1 the diffuse part is 0.96 / pi, the highlight 0.04 D V.
    const glm::dvec3 normal(0.0, 0.0, 1.0);
    const Surface surface{{0.5, 0.25, 1.0}, 0.0, 1.0};
    const glm::dvec3 value = surface(normal, normal);
    const double highlight = 0.04 / (4.0 * kPi);
    EXPECT_NEAR(value.x, 0.5 * 0.96 / kPi + highlight, 1e-12);
    EXPECT_NEAR(value.z, 0.96 / kPi + highlight, 1e-12);
    // Metals have none: the value is the highlight alone, tinted.
    const glm::dvec3 metal = Surface{{0.5, 0.25, 1.0}, 1.0, 1.0}(normal, normal);
    EXPECT_NEAR(metal.x, 0.5 / (4.0 * kPi), 1e-12);
    EXPECT_NEAR(metal.y, 0.25 / (4.0 * kPi), 1e-12);
}

TEST(Brdf, IsFiniteAtAllExtremesInFloat) {
    const float cosines[] = {-1.0F, -1e-7F, 0.0F, 1e-38F, 1e-7F, 1e-3F, 0.5F, 1.0F, 1.0000002F};
    for (const float roughness : {-1.0F, 0.0F, 1e-4F, 0.5F, 1.0F, 2.0F}) {
        for (const float l : cosines) {
            for (const float v : cosines) {
                for (const float h : cosines) {
                    const glm::vec3 value = shader_float::metallicRoughnessBrdf(
                        glm::vec3(1.0F, 0.5F, 0.0F), 0.5F, roughness, l, v, h, h);
                    for (int c = 0; c < 3; ++c) {
                        EXPECT_TRUE(std::isfinite(value[c]) && value[c] >= 0.0F)
                            << roughness << ": " << l << ", " << v << ", " << h;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace ribalta
