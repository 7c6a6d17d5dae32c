// The way of a ray through the air, by the shaders' own geometry.
#include "sky/sky_ray.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sky/sky_air.h"

namespace ribalta {
namespace {

double possibleNu(double mu, double muS, double nu) {
    const double sines = std::sqrt((1.0 - mu * mu) * (1.0 - muS * muS));
    return std::clamp(nu, mu * muS - sines, mu * muS + sines);
}

void endPath(const shader::Air& air, AirPath& path, double distance) {
    path.ground = shader::hitsGround(air, path.height, path.mu);
    const double whole = shader::distanceInAir(air, path.height, path.mu, path.ground);
    path.length = std::min(whole, distance);
    path.endsOnGround = path.ground && distance >= whole;
}

}  // namespace

std::optional<AirPath> airPath(const Atmosphere& atmosphere, const SkyRay& ray) {
    const shader::Air air = airOf(atmosphere);
    AirPath path;
    path.height = std::max(ray.heightMetres, 0.0);
    path.mu = std::clamp(ray.mu, -1.0, 1.0);
    path.muS = std::clamp(ray.muS, -1.0, 1.0);
    path.nu = possibleNu(path.mu, path.muS, std::clamp(ray.nu, -1.0, 1.0));
    double distance = ray.distanceMetres;
    if (path.height > air.top) {
        const AirPath start = path;
        double entry = 0.0;
        const double sine = std::sqrt((1.0 - start.mu) * (1.0 + start.mu));
        if (!shader::enterAir(air, start.height, start.mu, sine, start.muS, start.nu, entry,
                              path.mu, path.muS) ||
            entry >= distance) {
            return std::nullopt;
        }
        path.height = air.top;
        distance -= entry;
    }
    endPath(air, path, distance);
    return path;
}

AirPath airPathTowards(const Atmosphere& atmosphere, double height, double mu, double muS,
                       double cosAzimuth) {
    AirPath path;
    path.height = height;
    path.mu = mu;
    path.muS = muS;
    const double sines = std::sqrt(std::max((1.0 - mu * mu) * (1.0 - muS * muS), 0.0));
    path.nu = std::clamp(mu * muS + sines * cosAzimuth, -1.0, 1.0);
    endPath(airOf(atmosphere), path, std::numeric_limits<double>::infinity());
    return path;
}

std::vector<PathPiece> piecesOf(const Atmosphere& atmosphere, const AirPath& path) {
    const shader::Air air = airOf(atmosphere);
    const double turn = std::min(shader::distanceToLowest(air, path.height, path.mu), path.length);
    double entry = 0.0;
    double exit = 0.0;
    shader::planetShadow(air, path.height, path.mu, path.muS, path.nu, entry, exit);
    std::array<double, 5> cuts = {0.0, turn, std::min(entry, path.length),
                                  std::min(exit, path.length), path.length};
    std::sort(cuts.begin(), cuts.end());
    std::vector<PathPiece> pieces;
    for (std::size_t i = 1; i < cuts.size(); ++i) {
        if (cuts[i] > cuts[i - 1]) {
            const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
            pieces.push_back(
                {cuts[i - 1], cuts[i], middle >= turn, middle <= entry || middle >= exit});
        }
    }
    return pieces;
}

}  // namespace ribalta
