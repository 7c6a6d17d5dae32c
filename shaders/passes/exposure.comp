// Auto-exposure: one work group looks at a grid of pixels, keeps a histogram of their stops, and finds the
// EV100 that suits the brighter part of what is lit. src/measure/display_picture.cpp does the same.
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/beams.h"
#include "lib/auto_exposure.glsl"

layout(local_size_x = 256) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std430, binding = kExposureSlot) buffer Exposure { float ev100; int toneCurve; };
layout(binding = kColorUnit) uniform sampler2D colorMap;
#ifdef BEAM_LATTICE
layout(binding = kBeamLatticeUnit) uniform sampler2D latticeMap;  // beams not yet in the colour map
#endif

shared uint bins[kExposureBins];
shared uint lit;

void main() {
    int worker = int(gl_LocalInvocationIndex);
    for (int i = worker; i < kExposureBins; i += 256) {
        bins[i] = 0u;
    }
    if (worker == 0) {
        lit = 0u;
    }
    barrier();

    ivec2 size = ivec2(view.picture.xy);
    ivec2 grid = min(size, ivec2(kExposureGridAcross, kExposureGridDown));
#ifdef BEAM_LATTICE
    grid = min(grid, ivec2(80, 45));  // good enough to judge errors by
#endif
    for (int i = worker; i < grid.x * grid.y; i += 256) {
        ivec2 at = (ivec2(i % grid.x, i / grid.x) * size) / grid;
        vec3 color = texelFetch(colorMap, at, 0).rgb;
#ifdef BEAM_LATTICE
        color += texelFetch(latticeMap, at / kLatticeStep, 0).rgb;
#endif
        int bin = exposureBin(color);
        if (bin >= 0) {
            atomicAdd(bins[bin], 1u);
            atomicAdd(lit, 1u);
        }
    }
    barrier();

    if (worker == 0) {
        uint burnt = 0u;
        int top = kExposureBins - 1;
        while (top > 0 && burnt + bins[top] <= uint(kExposureBurnt * float(lit))) {
            burnt += bins[top];
            --top;
        }
        float weight = 0.0;
        float sum = 0.0;
        for (int i = max(0, top - kExposureBinsLookedAt); i < kExposureBins; ++i) {
            float share = float(bins[i]);
            weight += share;
            sum += share * (float(min(i, top)) + 0.5);
        }
        float brightest = float(top) + 1.0;
        ev100 = ev100OfStops(brightest, weight > 0.0 ? sum / weight : brightest, lit > 0u);
    }
}
