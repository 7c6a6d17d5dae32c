// Random numbers that are the same on every machine and with every library: SplitMix64 (Steele, Lea
// & Flood 2014). The standard's distributions are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/glm.hpp>

namespace ribalta::stress {

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31U);
    }

    /// 0 <= x < 1.
    double unit() { return double(next() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// Even in the logarithm; low > 0.
    double decades(double low, double high) { return low * std::pow(high / low, unit()); }
    /// 0..count - 1.
    int below(int count) { return int(unit() * count); }
    bool chance(double probability) { return unit() < probability; }

    /// A unit vector, all directions alike.
    glm::dvec3 direction() {
        const double z = between(-1.0, 1.0);
        const double turn = between(0.0, 2.0 * std::numbers::pi);
        const double radius = std::sqrt(1.0 - z * z);
        return {radius * std::cos(turn), radius * std::sin(turn), z};
    }

  private:
    std::uint64_t state_;
};

}  // namespace ribalta::stress
