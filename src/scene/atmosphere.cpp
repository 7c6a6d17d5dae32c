// What an atmosphere's numbers may be.
#include "scene/atmosphere.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "base/error.h"

namespace ribalta {
namespace {

std::string text(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.6g", value);
    return digits;
}

/// Keeps the first fault that it finds.
class Checker {
  public:
    void refuse(const std::string& name, double value, const std::string& expected) {
        if (!fault_) {
            fault_ = AtmosphereFault{name, "is " + text(value) + "; " + expected};
        }
    }
    // Refuses what is no number too.
    void expectWithin(const std::string& name, double value, double low, double high,
                      const std::string& unit) {
        if (!(value >= low && value <= high)) {
            refuse(name, value, "give a number in " + text(low) + ".." + text(high) + unit);
        }
    }
    void expectWithin(const std::string& name, const glm::dvec3& value, double low, double high,
                      const std::string& unit) {
        for (int i = 0; i < 3; ++i) {
            expectWithin(name + "/" + "rgb"[i], value[i], low, high, unit);
        }
    }
    const std::optional<AtmosphereFault>& fault() const { return fault_; }

  private:
    std::optional<AtmosphereFault> fault_;
};

}  // namespace

std::optional<AtmosphereFault> faultOf(const Atmosphere& air) {
    constexpr double kLargestCoefficient = 1.0;  // a metre of it is opaque
    constexpr double kBrightestLux = 1e12;
    Checker check;
    check.expectWithin("groundRadius", air.groundRadiusMetres, 1e3, 1e9, " m");
    if (!(air.topMetres > 0.0)) {
        check.refuse("top", air.topMetres,
                     "the air must end above the ground; give its height over the ground in m");
    }
    check.expectWithin("top", air.topMetres, 1.0, 10.0 * air.groundRadiusMetres,
                       " m over the ground");
    check.expectWithin("rayleighScaleHeight", air.rayleighScaleHeightMetres, 1.0, 1e6, " m");
    check.expectWithin("mieScaleHeight", air.mieScaleHeightMetres, 1.0, 1e6, " m");
    check.expectWithin("rayleighScattering", air.rayleighScatteringPerMetre, 0.0,
                       kLargestCoefficient, " 1/m");
    check.expectWithin("mieScattering", air.mieScatteringPerMetre, 0.0, kLargestCoefficient,
                       " 1/m");
    check.expectWithin("mieExtinction", air.mieExtinctionPerMetre, 0.0, kLargestCoefficient,
                       " 1/m");
    for (int i = 0; i < 3; ++i) {
        if (air.mieScatteringPerMetre[i] > air.mieExtinctionPerMetre[i]) {
            check.refuse(std::string("mieScattering/") + "rgb"[i], air.mieScatteringPerMetre[i],
                         "extinction, " + text(air.mieExtinctionPerMetre[i]) +
                             ", holds scattering and absorption; give no more than that");
        }
    }
    check.expectWithin("mieG", air.mieG, -0.9999, 0.9999, "");
    check.expectWithin("groundAlbedo", air.groundAlbedo, 0.0, 1.0, "");
    check.expectWithin("sunIlluminance", air.sunIlluminanceLux, 0.0, kBrightestLux, " lux");
    check.expectWithin("sunAngularRadius", air.sunAngularRadius, 0.0, 0.5 * std::numbers::pi,
                       " radians");
    return check.fault();
}

Atmosphere checked(const Atmosphere& air) {
    if (const std::optional<AtmosphereFault> fault = faultOf(air)) {
        throw Error(ErrorKind::kUsage, {"atmosphere", fault->name}, fault->message);
    }
    return air;
}

Atmosphere withoutMie(const Atmosphere& air) {
    Atmosphere clean = air;
    clean.mieScatteringPerMetre = glm::dvec3(0.0);
    clean.mieExtinctionPerMetre = glm::dvec3(0.0);
    return clean;
}

}  // namespace ribalta
