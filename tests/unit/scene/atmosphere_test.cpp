// What makes an atmosphere nonsense, one value at a time.
#include "scene/atmosphere.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "support/expect_error.h"

namespace ribalta {
namespace {

struct Fault {
    const char* name;
    std::function<void(Atmosphere&)> make;
    std::vector<std::string> words;
};

TEST(Atmosphere, EarthsIsTakenAsItIs) {
    const Atmosphere earth;
    EXPECT_EQ(checked(earth), earth);
    EXPECT_EQ(checked(withoutMie(earth)).mieExtinctionPerMetre, glm::dvec3(0.0));
}

TEST(Atmosphere, ThickThinAndTinyOnesAreTaken) {
    for (const double scaleHeight : {100.0, 50e3}) {
        Atmosphere air;
        air.groundRadiusMetres = 400e3;
        air.rayleighScaleHeightMetres = scaleHeight;
        air.mieScaleHeightMetres = scaleHeight;
        air.mieScatteringPerMetre *= 50.0;
        air.mieExtinctionPerMetre *= 50.0;
        EXPECT_EQ(checked(air), air);
    }
}

TEST(Atmosphere, NamesWhatIsNonsense) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Fault faults[] = {
        {"top below ground", [](Atmosphere& a) { a.topMetres = -10.0; }, {"top", "-10", "above"}},
        {"top at the ground", [](Atmosphere& a) { a.topMetres = 0.0; }, {"top", "above"}},
        {"top far out", [](Atmosphere& a) { a.topMetres = 1e9; }, {"top", "6.36e+07 m"}},
        {"no planet", [](Atmosphere& a) { a.groundRadiusMetres = 0.0; }, {"groundRadius", "1000"}},
        {"NaN", [=](Atmosphere& a) { a.groundRadiusMetres = nan; }, {"groundRadius", "nan"}},
        {"no scale height",
         [](Atmosphere& a) { a.rayleighScaleHeightMetres = 0.0; },
         {"rayleighScaleHeight", "1..1e+06 m"}},
        {"endless scale height",
         [](Atmosphere& a) { a.mieScaleHeightMetres = INFINITY; },
         {"mieScaleHeight", "inf"}},
        {"negative Rayleigh",
         [](Atmosphere& a) { a.rayleighScatteringPerMetre.y = -1e-6; },
         {"rayleighScattering/g", "-1e-06", "0..1 1/m"}},
        {"negative Mie",
         [](Atmosphere& a) { a.mieScatteringPerMetre.z = -1e-6; },
         {"mieScattering/b", "-1e-06"}},
        {"more scattering than extinction",
         [](Atmosphere& a) { a.mieScatteringPerMetre.x = 5e-6; },
         {"mieScattering/r", "5e-06", "4.44e-06", "absorption"}},
        {"g of one", [](Atmosphere& a) { a.mieG = 1.0; }, {"mieG", "1", "0.9999"}},
        {"g of less than -1", [](Atmosphere& a) { a.mieG = -1.5; }, {"mieG", "-1.5"}},
        {"glowing ground", [](Atmosphere& a) { a.groundAlbedo.x = 1.1; }, {"groundAlbedo/r"}},
        {"black sun", [](Atmosphere& a) { a.sunIlluminanceLux.y = -1.0; }, {"sunIlluminance/g"}},
        {"wide sun", [](Atmosphere& a) { a.sunAngularRadius = 3.0; }, {"sunAngularRadius", "3"}},
    };
    for (const Fault& fault : faults) {
        SCOPED_TRACE(fault.name);
        Atmosphere air;
        fault.make(air);
        test::expectError(ErrorKind::kUsage, fault.words, [&] { checked(air); });
    }
}

}  // namespace
}  // namespace ribalta
