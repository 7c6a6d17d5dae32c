#include "render/sky_settings.h"

#include <array>

namespace ribalta {

std::span<const Named<SkyKind>> skyKinds() {
    static constexpr std::array<Named<SkyKind>, 4> kKinds = {{{SkyKind::kAuto, "auto"},
                                                              {SkyKind::kBruneton, "bruneton"},
                                                              {SkyKind::kSingle, "single"},
                                                              {SkyKind::kChapman, "chapman"}}};
    return kKinds;
}

}  // namespace ribalta
