#include "scene/environment.h"

#include <cmath>
#include <numbers>

#include "optics/shader_lib.h"

namespace ribalta {
namespace {

using std::numbers::pi;

glm::dmat4 formOf(const std::array<double, 9>& c) {
    const double y0 = std::sqrt(1.0 / (4.0 * pi));
    const double y1 = std::sqrt(3.0 / (4.0 * pi));
    const double y2 = std::sqrt(15.0 / (4.0 * pi));   // of xy, yz, xz
    const double y20 = std::sqrt(5.0 / (16.0 * pi));  // of 3 z^2 - 1
    const double y22 = 0.5 * y2;                      // of x^2 - y^2
    glm::dmat4 form(0.0);
    const auto set = [&](int row, int column, double value) {
        form[column][row] = value;
        form[row][column] = value;
    };
    set(0, 0, y22 * c[8]);
    set(1, 1, -y22 * c[8]);
    set(2, 2, 3.0 * y20 * c[6]);
    set(0, 1, 0.5 * y2 * c[4]);
    set(1, 2, 0.5 * y2 * c[5]);
    set(0, 2, 0.5 * y2 * c[7]);
    set(1, 3, 0.5 * y1 * c[1]);
    set(2, 3, 0.5 * y1 * c[2]);
    set(0, 3, 0.5 * y1 * c[3]);
    set(3, 3, y0 * c[0] - y20 * c[6]);
    return form;
}

}  // namespace

glm::dvec3 irradiance(const Environment& environment, const glm::dvec3& normal) {
    const std::array<glm::dmat4, 3>& lux = environment.lux;
    return shader::environmentLux(normal, lux[0], lux[1], lux[2]);
}

glm::dmat4 inOtherAxes(const glm::dmat4& form, const glm::dmat3& worldFromOther) {
    const glm::dmat4 turn(worldFromOther);
    return glm::transpose(turn) * form * turn;
}

std::array<glm::dmat4, 3> irradianceForm(const IrradianceCoefficients& coefficients,
                                         const glm::dmat3& rotation) {
    std::array<glm::dmat4, 3> forms{};
    for (int channel = 0; channel < 3; ++channel) {
        std::array<double, 9> own{};
        for (std::size_t i = 0; i < own.size(); ++i) {
            own[i] = coefficients[i][channel];
        }
        forms[std::size_t(channel)] = inOtherAxes(formOf(own), glm::transpose(rotation));
    }
    return forms;
}

}  // namespace ribalta
