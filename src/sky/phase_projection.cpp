// Sums of light times phase function by modes of the azimuth.
#include "sky/phase_projection.h"

#include <cmath>

#include "base/angles.h"
#include "base/check.h"
#include "base/parallel_for.h"
#include "sky/sky_air.h"

namespace ribalta {
namespace {

constexpr int kTurns = 96;  // azimuths over half a turn that a phase function is looked at

}  // namespace

// p(psi) = sum of p_m cos(m psi), psi the azimuth between the two directions.
PhaseProjection::PhaseProjection(const SkyDirections& directions, double mieG, int zenithAngles,
                                 int azimuths)
    : directions_(directions), zenithAngles_(zenithAngles), azimuths_(azimuths) {
    const std::size_t in = directions.mu.size();
    const auto out = std::size_t(zenithAngles);
    kernels_.resize(kModes * out * in);
    std::vector<double> cosines;
    for (int k = 0; k <= 2 * kTurns; ++k) {
        cosines.push_back(std::cos(kPi * k / kTurns));
    }
    parallelFor(out, [&](std::size_t o) {
        const double angle = kPi * double(o) / (zenithAngles - 1);
        for (std::size_t i = 0; i < in; ++i) {
            const double mu = directions.mu[i];
            const double sines = std::sin(angle) * std::sqrt(1.0 - mu * mu);
            for (int k = 0; k <= kTurns; ++k) {
                const double nu = std::cos(angle) * mu + sines * cosines[std::size_t(k)];
                const glm::dvec2 phases(shader::phaseRayleigh(nu),
                                        shader::phaseCornetteShanks(nu, mieG));
                const glm::dvec2 weighted = (k == 0 || k == kTurns ? 0.5 : 1.0) / kTurns * phases;
                for (int m = 0; m < kModes; ++m) {
                    kernels_[(std::size_t(m) * out + o) * in + i] +=
                        (m == 0 ? 1.0 : 2.0) * cosines[std::size_t(m * k) % (2 * kTurns)] *
                        weighted;
                }
            }
        }
    });
}

void PhaseProjection::apply(std::span<const glm::dvec3> field, std::span<float> out) const {
    const std::size_t in = directions_.mu.size();
    const std::size_t turns = directions_.cosAzimuths.size();
    CHECK(field.size() == in * turns);
    CHECK(out.size() == std::size_t(zenithAngles_) * std::size_t(azimuths_) * 6);
    std::vector<double> sums(out.size(), 0.0);
    std::vector<glm::dvec3> mode(in);
    for (int m = 0; m < kModes && m < int(turns); ++m) {
        std::vector<double> cosines(turns);
        for (std::size_t j = 0; j < turns; ++j) {
            cosines[j] =
                directions_.azimuthWeights[j] * std::cos(m * kPi * double(j) / double(turns - 1));
        }
        for (std::size_t i = 0; i < in; ++i) {
            mode[i] = glm::dvec3(0.0);
            for (std::size_t j = 0; j < turns; ++j) {
                mode[i] += cosines[j] * field[i * turns + j];
            }
            mode[i] *= directions_.weights[i];
        }
        for (int o = 0; o < zenithAngles_; ++o) {
            glm::dvec3 rayleigh(0.0);
            glm::dvec3 mie(0.0);
            const glm::dvec2* kernel =
                &kernels_[(std::size_t(m) * std::size_t(zenithAngles_) + std::size_t(o)) * in];
            for (std::size_t i = 0; i < in; ++i) {
                rayleigh += kernel[i].x * mode[i];
                mie += kernel[i].y * mode[i];
            }
            for (int a = 0; a < azimuths_; ++a) {
                const double cosine = std::cos(m * kPi * a / (azimuths_ - 1));
                double* const sum =
                    &sums[(std::size_t(o) * std::size_t(azimuths_) + std::size_t(a)) * 6];
                for (int c = 0; c < 3; ++c) {
                    sum[c] += cosine * rayleigh[c];
                    sum[3 + c] += cosine * mie[c];
                }
            }
        }
    }
    for (std::size_t i = 0; i < out.size(); ++i) {
        out[i] = float(std::max(sums[i], 0.0));
    }
}

}  // namespace ribalta
