#include "check_sky.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/angles.h"
#include "base/parallel_for.h"
#include "reference/integrate_sky.h"
#include "render/evaluate_sky.h"
#include "render/read_frame.h"
#include "render/renderer.h"

namespace ribalta::stress {
namespace {

constexpr double kStep = 0.01 * kDegree;  // between neighbouring rays and suns

// Steps may be larger than the reference's by these shares of the brighter neighbour ...
constexpr double kRayBound = 0.02;
constexpr double kPictureBound = 0.05;
constexpr double kSunBound =
    0.01;  // of what the scene is lit with; and of a tenth of full sunlight
// ... by this share of the brightest place of the strip or picture, beside which nobody sees it ...
constexpr double kDarkRay = 1e-5;
constexpr double kDarkPixel = 1e-3;  // a quarter of a code value of an 8-bit picture
// ... and by about what a moonless night sky has, 5e-4 cd/m2 under this sun.
constexpr double kNight = 4e-9;
// A picture may have the reference's step so many pixels off: where its tables blur an edge.
constexpr int kPixelsOff = 6;

constexpr int kWidth = 24;  // of pictures
constexpr int kHeight = 64;
constexpr double kWide = 60.0 * kDegree;  // their height
constexpr double kNarrow = 1.0 * kDegree;

/// Neighbours, one after the other.
struct Strip {
    std::string name;
    std::size_t first = 0;
    std::size_t count = 0;
};

class Checker {
  public:
    explicit Checker(const SkySetUp& setUp) : setUp_(setUp) {}

    SkyFindings run() {
        makeStrips();
        checkRays();
        checkSunlight();
        checkPicture(kWide, "wide picture");
        checkPicture(kNarrow, "narrow picture");
        return std::move(findings_);
    }

  private:
    /// From the zenith at the viewer to the ground's horizon.
    double horizon() const {
        const double h = setUp_.heightMetres;
        const double radius = setUp_.air.groundRadiusMetres;
        return 0.5 * kPi + std::atan2(std::sqrt(h * (2.0 * radius + h)), radius);
    }
    SkyRay ray(double zenith, double elevation, double around) const {
        const double mu = std::cos(zenith);
        const double muS = std::sin(elevation);
        return {setUp_.heightMetres, mu, muS,
                mu * muS + std::sin(zenith) * std::cos(elevation) * std::cos(around)};
    }
    template <typename RayAt>
    void addStrip(const std::string& name, int count, const RayAt& rayAt) {
        strips_.push_back({name, rays_.size(), std::size_t(count)});
        for (int i = 0; i < count; ++i) {
            rays_.push_back(rayAt(i));
        }
    }

    void makeStrips() {
        const double sun = setUp_.sunElevation;
        const double level = horizon();
        for (const double around : {0.0, setUp_.around}) {
            addStrip("across the horizon", 101, [&](int i) {
                return ray(std::clamp(level + (i - 50) * kStep, 0.0, kPi), sun, around);
            });
        }
        const double top = setUp_.air.topMetres;
        if (setUp_.heightMetres > top) {
            const double radius = setUp_.air.groundRadiusMetres;
            const double limb = kPi - std::asin((radius + top) / (radius + setUp_.heightMetres));
            addStrip("across the air's edge", 101,
                     [&](int i) { return ray(limb + (i - 50) * kStep, sun, setUp_.around); });
        }
        // The sun's rise, as seen from the viewer and from the ground.
        for (const double rise : {0.5 * kPi - level, 0.0}) {
            for (const double above : {0.2, 30.0, 90.0}) {
                addStrip("as the sun rises", 201, [&](int i) {
                    return ray(std::max(level - above * kDegree, 0.0), rise + (i - 100) * kStep,
                               setUp_.around);
                });
            }
        }
        addStrip("the ground as the sun rises", 201,
                 [&](int i) { return ray(0.5 * (level + kPi), (i - 100) * kStep, setUp_.around); });
        for (int i = 0; i <= 180; ++i) {
            addStrip("all suns", 1, [&](int) {
                return ray(level * ((i * 7) % 19) / 18.0, (i - 90.0) * kDegree, setUp_.around);
            });
        }
    }

    void fail(const std::string& what, const SkyRay& at, const glm::dvec3& got,
              const glm::dvec3& expected) {
        char text[400];
        std::snprintf(text, sizeof text,
                      "%s: height %.9g, zenith angle %.6f, sun %.6f degrees, nu %.9f: %.6g %.6g "
                      "%.6g, reference %.6g %.6g %.6g",
                      what.c_str(), at.heightMetres, std::acos(at.mu) / kDegree,
                      std::asin(at.muS) / kDegree, at.nu, got.x, got.y, got.z, expected.x,
                      expected.y, expected.z);
        findings_.faults.emplace_back(text);
    }

    static bool isLight(const glm::dvec3& value) {
        return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z) &&
               std::min({value.x, value.y, value.z}) >= 0.0;
    }

    void checkRays() {
        const SkyOrders seamOrders{setUp_.fourOrders ? 4 : 1, false};
        for (const SkyOrders& orders : {SkyOrders{4, true}, seamOrders}) {
            lights_ = evaluateSky(setUp_.air, orders, rays_);
            for (std::size_t i = 0; i < rays_.size(); ++i) {
                const SkyLight& light = lights_[i];
                if (!isLight(light.air) || !isLight(light.ground) ||
                    !isLight(light.transmittance) ||
                    std::max({light.transmittance.x, light.transmittance.y,
                              light.transmittance.z}) > 1.0 + 1e-6) {
                    fail("not finite, negative or brighter than the sun", rays_[i],
                         light.air + light.ground, light.transmittance);
                }
            }
        }
        findings_.rays += long(rays_.size());
        SkySettings settings;
        settings.orders = seamOrders.count;
        settings.exactSecondOrder = false;
        settings.tables = coarseSkyTables();
        // The reference makes the tables that these need, and no others.
        const SkyRay overhead[] = {
            ray(0.0, setUp_.sunElevation, 0.0),
            ray(std::max(horizon() - 2.0 * kDegree, 0.0), setUp_.sunElevation, 0.5 * kPi)};
        std::vector<SkyRay> needed(std::begin(overhead), std::end(overhead));
        needed.insert(needed.end(), rays_.begin(), rays_.end());
        for (const double fov : {kWide, kNarrow}) {
            const std::vector<SkyRay> more = pictureRays(pictureCamera(fov));
            needed.insert(needed.end(), more.begin(), more.end());
        }
        exact_.emplace(setUp_.air, settings, needed);
        std::vector<glm::dvec3> expected(rays_.size());
        parallelFor(rays_.size(),
                    [&](std::size_t i) { expected[i] = total(exact_->along(rays_[i])); });
        // What lights a scene under that sky, be the picture turned away from it.
        overhead_ = glm::max(total(exact_->along(overhead[0])), total(exact_->along(overhead[1])));
        for (const Strip& strip : strips_) {
            glm::dvec3 brightest(0.0);
            for (std::size_t i = strip.first; i < strip.first + strip.count; ++i) {
                brightest = glm::max(brightest, expected[i]);
            }
            for (std::size_t i = strip.first + 1; i < strip.first + strip.count; ++i) {
                checkStep(strip.name, rays_[i], {total(lights_[i - 1]), total(lights_[i])},
                          {expected[i - 1], expected[i]}, kRayBound, kDarkRay, brightest,
                          findings_.worstRays);
            }
        }
    }

    static glm::dvec3 total(const SkyLight& light) { return light.air + light.ground; }

    struct Pair {
        glm::dvec3 first;
        glm::dvec3 second;
    };
    void checkStep(const std::string& name, const SkyRay& at, const Pair& got, const Pair& expected,
                   double bound, double dark, const glm::dvec3& brightest, double& worst) {
        for (int c = 0; c < 3; ++c) {
            const double step = std::abs(got.second[c] - got.first[c]);
            const double right = std::abs(expected.second[c] - expected.first[c]);
            const double allowed = bound * std::max(expected.first[c], expected.second[c]) +
                                   dark * std::max({brightest.x, brightest.y, brightest.z}) +
                                   kNight;
            if (step <= right || allowed <= 0.0) {
                continue;
            }
            worst = std::max(worst, (step - right) / allowed);
            if (step - right > allowed) {
                char what[160];
                std::snprintf(what, sizeof what,
                              "seam %s, channel %d, step %.3g not %.3g, %.3g times what is allowed",
                              name.c_str(), c, step, right, (step - right) / allowed);
                fail(what, at, got.second, expected.second);
                return;
            }
        }
    }

    /// How much of the sun's disc is above a line that its centre is so many radii above.
    static double discAbove(double radii) {
        const double x = std::clamp(radii, -1.0, 1.0);
        return 0.5 + (x * std::sqrt(1.0 - x * x) + std::asin(x)) / kPi;
    }

    /// What the scene is lit with.
    void checkSunlight() {
        const SkyTables tables(setUp_.air, {setUp_.fourOrders ? 4 : 1, setUp_.fourOrders});
        const double rise = 0.5 * kPi - horizon();
        for (int i = -100; i <= 100; ++i) {
            const double elevation = rise + i * kStep;
            const glm::dvec3 light = tables.sunlight(setUp_.heightMetres, std::sin(elevation));
            // Where the disc's centre is down, by its upper edge.
            SkyRay way = ray(0.0, elevation, 0.0);
            way.mu = way.muS = std::sin(std::max(elevation, rise + 1e-6));
            way.nu = 1.0;
            const glm::dvec3 expected = discAbove(i * kStep / setUp_.air.sunAngularRadius) *
                                        exact_->transmittanceAlong(way);
            for (int c = 0; c < 3; ++c) {
                const double share =
                    std::abs(light[c] - expected[c]) / (kSunBound * (std::abs(expected[c]) + 0.1));
                findings_.worstSun = std::max(findings_.worstSun, share);
                if (!isLight(light) || !(share <= 1.0)) {
                    fail("sunlight as the sun rises", way, light, expected);
                    break;
                }
            }
        }
        std::vector<SkyIrradiance> irradiance(7);
        parallelFor(irradiance.size(), [&](std::size_t i) {
            irradiance[i] =
                tables.irradianceAt(setUp_.heightMetres, std::sin((double(i) - 3.0) * kStep));
        });
        glm::dvec3 brightest(0.0);
        for (const SkyIrradiance& light : irradiance) {
            brightest =
                glm::max(brightest, glm::max(glm::max(light.up, light.down), light.towardsSun));
        }
        for (std::size_t i = 0; i < irradiance.size(); ++i) {
            const SkyIrradiance& now = irradiance[i];
            const SkyIrradiance& last = irradiance[i == 0 ? 0 : i - 1];
            const SkyRay at = ray(0.0, (double(i) - 3.0) * kStep, 0.0);
            const Pair sides[] = {{last.up, now.up},
                                  {last.down, now.down},
                                  {last.towardsSun, now.towardsSun},
                                  {last.awayFromSun, now.awayFromSun},
                                  {last.across, now.across}};
            for (const Pair& side : sides) {
                if (!isLight(side.second)) {
                    fail("irradiance", at, side.second, side.first);
                }
                checkStep("irradiance as the sun rises", at, side, {brightest, brightest}, 0.05,
                          0.0, brightest, findings_.worstSun);
            }
        }
    }

    /// Looks at the horizon.
    Camera pictureCamera(double verticalFov) const {
        Camera camera;
        const double down = 0.5 * kPi - horizon();
        const glm::dvec3 ahead(std::cos(down) * std::cos(setUp_.around), std::sin(down),
                               std::cos(down) * std::sin(setUp_.around));
        const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
        camera.frame.worldFromLocal = glm::dmat3(right, glm::cross(right, ahead), -ahead);
        camera.lens = PerspectiveLens{verticalFov, std::nullopt};
        return camera;
    }
    /// Through the pixels' centres, rows from the top.
    std::vector<SkyRay> pictureRays(const Camera& camera) const {
        const glm::dvec2 half = viewHalfExtent(camera, kWidth, kHeight);
        const glm::dvec3 towardsSun(std::cos(setUp_.sunElevation), std::sin(setUp_.sunElevation),
                                    0.0);
        std::vector<SkyRay> rays;
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const glm::dvec3 direction = glm::normalize(
                    camera.frame.forward() +
                    ((2.0 * x + 1.0) / kWidth - 1.0) * half.x * camera.frame.right() +
                    (1.0 - (2.0 * y + 1.0) / kHeight) * half.y * camera.frame.up());
                rays.push_back({setUp_.heightMetres, direction.y, towardsSun.y,
                                glm::dot(direction, towardsSun)});
            }
        }
        return rays;
    }

    void checkPicture(double verticalFov, const std::string& name) {
        FrameSettings settings;
        settings.width = kWidth;
        settings.height = kHeight;
        settings.haze.scatteringPerMetre = 0.0;
        settings.ambientLux = 0.0;
        settings.display = false;
        SkyDrawing& sky = settings.sky.emplace();
        sky.air = setUp_.air;
        sky.orders = {setUp_.fourOrders ? 4 : 1, false};
        sky.altitudeMetres = setUp_.heightMetres;
        const double elevation = setUp_.sunElevation;
        sky.towardsSun = {std::cos(elevation), std::sin(elevation), 0.0};
        const Camera camera = pictureCamera(verticalFov);
        const Scene empty;
        Renderer renderer(empty);
        const FramePlan& plan = renderer.draw(camera, settings);
        const FloatImage image = readFrame(plan, renderer.targets(), {});
        comparePicture(image, camera, sky, name);
    }

    void comparePicture(const FloatImage& image, const Camera& camera, const SkyDrawing& sky,
                        const std::string& name) {
        const glm::dvec2 half = viewHalfExtent(camera, kWidth, kHeight);
        const std::vector<SkyRay> rays = pictureRays(camera);
        const auto lux = sky.air.sunIlluminanceLux;
        std::vector<glm::dvec3> got;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const int x = int(i) % image.width;
            const int y = int(i) / image.width;
            got.push_back(glm::dvec3(image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)) /
                          lux);
            if (!isLight(got.back())) {
                fail(name + ": not finite or negative", rays[i], got.back(), glm::dvec3(0.0));
                return;
            }
        }
        findings_.rays += long(rays.size());
        // Columns in the middle and at a side.
        const int columns[] = {0, image.width / 2};
        const auto at = [&](int column, int y) {
            return std::size_t(y) * std::size_t(image.width) + std::size_t(columns[column]);
        };
        std::vector<glm::dvec3> expected(2 * std::size_t(image.height));
        parallelFor(expected.size(), [&](std::size_t i) {
            expected[i] = total(exact_->along(rays[at(int(i) % 2, int(i) / 2)]));
        });
        // And places all over, for what is bright in the picture.
        constexpr int kEvery = 4;
        std::vector<glm::dvec3> all(std::size_t((image.width / kEvery) * (image.height / kEvery)));
        parallelFor(all.size(), [&](std::size_t i) {
            const int x = kEvery * (int(i) % (image.width / kEvery));
            const int y = kEvery * (int(i) / (image.width / kEvery));
            all[i] = total(
                exact_->along(rays[std::size_t(y) * std::size_t(image.width) + std::size_t(x)]));
        });
        all.insert(all.end(), expected.begin(), expected.end());
        glm::dvec3 brightest = overhead_;
        for (const glm::dvec3& value : all) {
            brightest = glm::max(brightest, value);
        }
        // The disc's light is not the reference's.
        const double pixel = 2.0 * half.y / image.height;
        const double sun = std::cos(sky.air.sunAngularRadius + 2.0 * pixel);
        for (int i = 2; i < int(expected.size()); ++i) {
            const std::size_t here = at(i % 2, i / 2);
            const std::size_t above = at(i % 2, i / 2 - 1);
            if (std::max(rays[here].nu, rays[above].nu) < sun) {
                checkStep(name, rays[here], {got[above], got[here]}, largestStep(expected, i),
                          kPictureBound, kDarkPixel, brightest, findings_.worstPicture);
            }
        }
    }

    /// By channel, of neighbours in a column (every second entry) near one.
    static Pair largestStep(const std::vector<glm::dvec3>& values, int place) {
        Pair largest{values[std::size_t(place - 2)], values[std::size_t(place)]};
        for (int i = std::max(place - 2 * kPixelsOff, place % 2 + 2);
             i <= place + 2 * kPixelsOff && i < int(values.size()); i += 2) {
            const glm::dvec3& first = values[std::size_t(i - 2)];
            const glm::dvec3& second = values[std::size_t(i)];
            for (int c = 0; c < 3; ++c) {
                if (std::abs(second[c] - first[c]) >
                    std::abs(largest.second[c] - largest.first[c])) {
                    largest.first[c] = first[c];
                    largest.second[c] = second[c];
                }
            }
        }
        return largest;
    }

    const SkySetUp& setUp_;
    SkyFindings findings_;
    std::vector<SkyRay> rays_;
    std::vector<Strip> strips_;
    std::vector<SkyLight> lights_;
    std::optional<SkyIntegrator> exact_;
    glm::dvec3 overhead_{0.0};  ///< light from the zenith, and from level across the sun
};

}  // namespace

SkyFindings checkSky(const SkySetUp& setUp) {
    return Checker(setUp).run();
}

}  // namespace ribalta::stress
