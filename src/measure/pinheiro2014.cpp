#include "measure/pinheiro2014.h"

#include <array>
#include <cmath>

#include "base/angles.h"

namespace ribalta {
namespace {

constexpr SkyOrders kAll{4, true};
constexpr SkyOrders kOnce{1, false};

constexpr std::array kViewpoints = {
    SkyViewpoint{"space-far", "from space, 12,000 km up", 12e6, -88.0, 90.0, 50.0, 35.0, 14.0},
    SkyViewpoint{"space-near", "from space, 400 km up", 400e3, -22.0, 60.0, 45.0, 30.0, 14.0},
    SkyViewpoint{"entering", "entering the atmosphere, 55 km up", 55e3, -6.0, 60.0, 50.0, 20.0,
                 14.0},
    SkyViewpoint{"inside", "inside the atmosphere, 1 km up", 1e3, 8.0, 75.0, 60.0, 40.0, 14.0},
    SkyViewpoint{"sunset", "sunset, from 2 m", 2.0, 6.0, 8.0, 50.0, 1.0, 11.0},
    SkyViewpoint{"night-limb", "the limb from the night side, 400 km up", 400e3, -19.0, 0.0, 12.0,
                 -22.5, 10.0},
};

PrecomputedSkySettings tables(int orders) {
    PrecomputedSkySettings settings;
    settings.orders = orders;
    return settings;
}

PrecomputedSkySettings simplified(bool exactTexels) {
    PrecomputedSkySettings settings = simplifiedSky();
    settings.exactTexels = exactTexels;
    return settings;
}

}  // namespace

std::span<const SkyViewpoint> skyViewpoints() {
    return kViewpoints;
}

const std::vector<SkyRow>& skyRows() {
    static const std::vector<SkyRow> rows = {
        {"auto", "the renderer's own model, every order", OwnSky(), kAll, false, {}},
        {"auto-once", "the same, light scattered once", OwnSky(), kOnce, false, {}},
        {"bruneton", "tables of four orders, half floats", tables(4), {4, false}, false, {}},
        {"bruneton-once", "the same, light scattered once", tables(1), kOnce, false, {}},
        {"bruneton-rayleigh", "the same, Rayleigh alone: the thesis's full tables", tables(1),
         kOnce, true, ThesisSkyFigure{14444.0, 14.53}},
        {"single", "the thesis's simplification, texels exact", simplified(true), kOnce, false, {}},
        {"single-2008", "the same, texels as the code of 2008 makes them", simplified(false), kOnce,
         false, ThesisSkyFigure{6240.0, 14.08}},
        {"single-rayleigh", "the same, Rayleigh alone", simplified(false), kOnce, true, {}},
        {"chapman", "no tables: Schuler's code", ChapmanSky(), kOnce, true,
         ThesisSkyFigure{0.0, 0.0014}},
        {"chapman-better",
         "the same with the better form of Chapman's function",
         ChapmanSky{true},
         kOnce,
         true,
         {}},
    };
    return rows;
}

Camera cameraOf(const SkyViewpoint& view) {
    const double pitch = view.pitch * kDegree;
    const double azimuth = view.azimuth * kDegree;
    Camera camera;
    camera.name = view.name;
    camera.frame = lookAt(glm::dvec3(0.0), {std::cos(pitch) * std::cos(azimuth), std::sin(pitch),
                                            std::cos(pitch) * std::sin(azimuth)});
    camera.lens = PerspectiveLens{view.verticalFov * kDegree, std::nullopt};
    return camera;
}

SkyDrawing drawingOf(const SkyViewpoint& view, const SkyRow& row) {
    SkyDrawing drawing;
    drawing.model = row.model;
    drawing.orders = row.orders;
    drawing.air = row.rayleighOnly ? withoutMie(Atmosphere()) : Atmosphere();
    drawing.altitudeMetres = view.altitudeMetres;
    const double elevation = view.sunElevation * kDegree;
    drawing.towardsSun = {std::cos(elevation), std::sin(elevation), 0.0};
    return drawing;
}

SkyOverScene truthOf(const SkyViewpoint& view, const SkyRow& row, bool whole) {
    const SkyDrawing drawing = drawingOf(view, row);
    return {whole ? Atmosphere() : drawing.air, whole ? kAll : row.orders, drawing.towardsSun,
            drawing.altitudeMetres, -1};
}

}  // namespace ribalta
