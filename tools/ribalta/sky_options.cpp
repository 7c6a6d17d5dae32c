#include "sky_options.h"

#include <cmath>
#include <cstdio>
#include <variant>

#include <CLI/CLI.hpp>

#include "base/angles.h"
#include "base/log.h"
#include "look/look_settings.h"
#include "options.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr double kHighestMetres = 1e9;

// From elevation and azimuth in degrees.
SunInSky parseSun(const std::string& text) {
    const std::size_t comma = text.find(',');
    const auto elevation = parseNumber<double>(text.substr(0, comma));
    const auto azimuth =
        comma == std::string::npos ? std::nullopt : parseNumber<double>(text.substr(comma + 1));
    if (!elevation || !azimuth || std::abs(*elevation) > 90.0 || std::abs(*azimuth) > 360.0) {
        throw CLI::ValidationError(
            "--sun", "'" + text + "' is not ELEVATION,AZIMUTH in degrees, -90..90 and -360..360");
    }
    return {*elevation / kDegreesPerRadian, *azimuth / kDegreesPerRadian};
}

std::string expectAltitude(const std::string& text) {
    const double metres = parseNumber<double>(text).value_or(-1.0);
    return metres >= 0.0 && metres <= kHighestMetres
               ? ""
               : "'" + text + "' is not a height above the ground in metres, 0..1e9";
}

std::string expectOrders(const std::string& text) {
    const int orders = parseNumber<int>(text).value_or(0);
    return orders >= 1 && orders <= kMostTabulatedOrders
               ? ""
               : "'" + text + "' is not a whole number in 1.." +
                     std::to_string(kMostTabulatedOrders);
}

}  // namespace

void SkyOptions::addTo(CLI::App& command) {
    skyOption_ =
        command
            .add_option(
                "--sky", sky,
                "sky, sun and the air in front of everything, in daylight's true brightness: "
                "none; auto, the renderer's own model; or one of the literature to hold it "
                "against, with its own faults: bruneton (precomputed tables of every order, "
                "Bruneton & Neyret 2008 as described in 2017), single (their simplified "
                "variant: light scattered once), chapman (no tables: Schuler's form of "
                "Chapman's function, without haze)")
            ->type_name("none|" + listOf(skyKinds(), "|"))
            ->check(
                [](const std::string& text) {
                    return text == "none" || valueIn(skyKinds(), text)
                               ? std::string()
                               : "there is no sky '" + text + "'; there are: none, " +
                                     listOf(skyKinds());
                },
                "")
            ->capture_default_str();
    addPlaceTo(command);
    models.addDetailsTo(command);
}

void SkyOptions::addReferenceTo(CLI::App& command) {
    command
        .add_option("--sky", sky,
                    "none, or auto: sky, sun, the air in front of everything and daylight, "
                    "integrated; needs clear air, --haze 0")
        ->type_name("none|auto")
        ->check(
            [](const std::string& text) {
                return text == "none" || text == "auto"
                           ? ""
                           : "a reference has no sky '" + text + "'; it has: none, auto";
            },
            "")
        ->capture_default_str();
    addPlaceTo(command);
}

void SkyOptions::addPlaceTo(CLI::App& command) {
    command
        .add_option(
            "--sun", sun,
            "where the sun stands, in degrees: elevation above the horizon and azimuth from "
            "north (-Z) through east (+X) (default: the file's first directional lamp, or "
            "30,135)")
        ->type_name("ELEVATION,AZIMUTH");
    sunTime.addTo(command);
    command
        .add_option("--altitude", altitude,
                    "height of the scene's origin above the planet's ground in metres (default: 0)")
        ->type_name("METRES")
        ->check(expectAltitude, "");
    command
        .add_option("--sky-orders", orders,
                    "how often light may be scattered or reflected by air and ground, 1..20 "
                    "(default: as often as it happens; with bruneton 4, single and chapman 1)")
        ->type_name("COUNT")
        ->check(expectOrders, "");
    atmosphere.addTo(command);
}

void SkyOptions::fillFrom(const std::optional<SkyLook>& look) {
    if (!look) {
        return;
    }
    if (skyOption_->count() == 0) {
        sky = name(look->model);
    }
    if (sky == "none") {
        return;
    }
    if (look->sun && !sun && sunTime.given().empty()) {
        sunOfLook_ = look->sun;
    }
    altitude = altitude.value_or(look->altitudeMetres);
}

void SkyOptions::check() const {
    if (sun) {
        parseSun(*sun);
    }
    if (sun && !sunTime.given().empty()) {
        throw CLI::ValidationError(
            "--sun", "and " + sunTime.given() + " both place the sun: give one of them");
    }
    sunTime.parsed();
    if (sky == "none" && !sunTime.given().empty()) {
        throw CLI::ValidationError(sunTime.given(), "needs a sky: give --sky auto");
    }
    const std::string ofAir = atmosphere.given();
    if (sky == "none" && (sun || altitude || orders || !ofAir.empty())) {
        throw CLI::ValidationError(sun        ? "--sun"
                                   : altitude ? "--altitude"
                                   : orders   ? "--sky-orders"
                                              : ofAir,
                                   "needs a sky: give --sky auto");
    }
    if (sky == "chapman" && !atmosphere.given(true).empty()) {
        throw CLI::ValidationError(atmosphere.given(true),
                                   "is of haze, which --sky chapman has none of; leave it out");
    }
    static_cast<void>(atmosphere.parsed());
    static_cast<void>(model());
}

DrawnSky SkyOptions::model() const {
    SkyModelOptions asked = models;
    asked.model = sky;
    asked.orders = orders;
    const SkyModel parsed = asked.parsed("--sky", "--sky-orders");
    if (const auto* settings = std::get_if<PrecomputedSkySettings>(&parsed)) {
        return *settings;
    }
    if (const auto* chapman = std::get_if<ChapmanSky>(&parsed)) {
        return *chapman;
    }
    return OwnSky();
}

std::optional<SunInSky> SkyOptions::sunAsked() const {
    if (sun) {
        return parseSun(*sun);
    }
    const std::optional<SunInSky> place = sunTime.parsed();
    return place ? place : sunOfLook_;
}

// Which sun is taken, where its place was not given as such.
void SkyOptions::tellOfSun(const Scene& scene) const {
    char line[160];
    if (const std::optional<SunInSky> place = sunTime.parsed()) {
        std::snprintf(line, sizeof line,
                      "sky: at %s the sun stands at %.2f,%.2f (elevation without refraction, "
                      "azimuth)",
                      sunTime.time->c_str(), place->elevation * kDegreesPerRadian,
                      place->azimuth * kDegreesPerRadian);
        logNote(line);
    } else if (sunAsked()) {
        return;
    } else if (!scene.directionalLights.empty()) {
        logNote("sky: the sun stands where the directional lamp '" +
                scene.directionalLights.front().name + "' shines from, in its place");
    } else {
        const SunInSky usual = sunOfNoLamp();
        std::snprintf(line, sizeof line,
                      "sky: the file has no directional lamp; the sun stands at %.4g,%.4g, give "
                      "--sun ELEVATION,AZIMUTH for another place",
                      usual.elevation * kDegreesPerRadian, usual.azimuth * kDegreesPerRadian);
        logNote(line);
    }
}

std::optional<SkyDrawing> SkyOptions::parsed(const Scene& scene) const {
    check();
    if (sky == "none") {
        return std::nullopt;
    }
    tellOfSun(scene);
    SkyLook look;
    look.sun = sunAsked();
    look.altitudeMetres = altitude.value_or(0.0);
    SkyDrawing drawing = skyDrawing(look, scene);
    drawing.model = model();
    drawing.air = atmosphere.parsed();
    // Schuler's model has no haze, whatever passes through its air.
    if (std::holds_alternative<ChapmanSky>(drawing.model)) {
        drawing.air = withoutMie(drawing.air);
    }
    if (orders) {
        drawing.orders = {*orders, false};
    }
    return drawing;
}

void warnIfBelowGround(const SkyEye& eye) {
    if (eye.belowMetres > 0.0) {
        char line[160];
        std::snprintf(line, sizeof line,
                      "sky: the camera is %.3g m below the planet's ground and looks from the "
                      "ground; give --altitude to lift the scene",
                      eye.belowMetres);
        logWarning(line);
    }
}

}  // namespace ribalta
