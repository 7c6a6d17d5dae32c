// Auto-exposure: one work group looks at a grid of pixels, keeps a histogram of their luminance in
// eighths of a stop and finds the EV100 that suits the brighter part of what is lit.
#include "shared/slots.h"
#include "shared/view.h"

layout(local_size_x = 256) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std430, binding = kExposureSlot) buffer Exposure { float ev100; };
layout(binding = kColorUnit) uniform sampler2D colorMap;

const int kBins = 384;
const float kLowestStop = -18.0;  // log2 of cd/m2
const float kBinsAStop = 8.0;
shared uint bins[kBins];
shared uint lit;

void main() {
    int worker = int(gl_LocalInvocationIndex);
    for (int i = worker; i < kBins; i += 256) {
        bins[i] = 0u;
    }
    if (worker == 0) {
        lit = 0u;
    }
    barrier();

    ivec2 size = ivec2(view.picture.xy);
    ivec2 grid = min(size, ivec2(320, 180));
    for (int i = worker; i < grid.x * grid.y; i += 256) {
        ivec2 at = (ivec2(i % grid.x, i / grid.x) * size) / grid;
        float luminance = dot(texelFetch(colorMap, at, 0).rgb, vec3(0.2126, 0.7152, 0.0722));
        float stop = log2(max(luminance, 1.0e-30));
        if (stop > kLowestStop) {
            int bin = clamp(int((stop - kLowestStop) * kBinsAStop), 0, kBins - 1);
            atomicAdd(bins[bin], 1u);
            atomicAdd(lit, 1u);
        }
    }
    barrier();

    if (worker == 0) {
        // The darkest pixels of a stage are unlit house: what is a thousand times dimmer than the
        // brightest percent says nothing about the light on stage.
        uint counted = 0u;
        int top = kBins - 1;
        while (top > 0 && counted + bins[top] < max(lit / 100u, 1u)) {
            counted += bins[top];
            --top;
        }
        int bottom = max(0, top - int(10.0 * kBinsAStop));
        float weight = 0.0;
        float sum = 0.0;
        for (int i = bottom; i < kBins; ++i) {
            float share = float(bins[i]);
            weight += share;
            sum += share * (float(min(i, top)) + 0.5);
        }
        float brightest = kLowestStop + (float(top) + 0.5) / kBinsAStop;
        float middle = weight > 0.0 ? kLowestStop + sum / weight / kBinsAStop : brightest;
        // Middle grey for the mean stop, but the brightest percent at most a stop and a half over
        // white: highlights of a stage may burn, the beams must not.
        float byMiddle = middle - log2(0.18);
        float byBrightest = brightest - 1.5;
        float white = lit > 0u ? max(byMiddle, byBrightest) : 0.0;
        ev100 = white - log2(1.2);
    }
}
