// Auto-exposure: one work group looks at a grid of pixels, keeps a histogram of their brightest channel
// (a deep blue lamp burns out long before its luminance tells) in eighths of a stop, and finds the EV100
// that suits the brighter part of what is lit.
#include "shared/slots.h"
#include "shared/view.h"

layout(local_size_x = 256) in;
layout(std140, binding = kViewSlot) uniform ViewBlock { View view; };
layout(std430, binding = kExposureSlot) buffer Exposure { float ev100; };
layout(binding = kColorUnit) uniform sampler2D colorMap;

const int kBins = 384;
const float kLowestStop = -18.0;  // log2 of cd/m2
const float kBinsAStop = 8.0;
const float kBurnt = 0.03;
const float kMiddleGrey = 0.18;
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
        vec3 color = texelFetch(colorMap, at, 0).rgb;
        float stop = log2(max(max(color.r, max(color.g, color.b)), 1.0e-30));
        if (stop > kLowestStop) {
            int bin = clamp(int((stop - kLowestStop) * kBinsAStop), 0, kBins - 1);
            atomicAdd(bins[bin], 1u);
            atomicAdd(lit, 1u);
        }
    }
    barrier();

    if (worker == 0) {
        // The brightest part, kBurnt of the lit pixels, may burn out: lenses, a white floor under
        // many lamps. What is a thousand times dimmer is unlit house and says nothing of the stage.
        uint burnt = 0u;
        int top = kBins - 1;
        while (top > 0 && burnt + bins[top] <= uint(kBurnt * float(lit))) {
            burnt += bins[top];
            --top;
        }
        float weight = 0.0;
        float sum = 0.0;
        for (int i = max(0, top - int(10.0 * kBinsAStop)); i < kBins; ++i) {
            float share = float(bins[i]);
            weight += share;
            sum += share * (float(min(i, top)) + 0.5);
        }
        float brightest = kLowestStop + (float(top) + 1.0) / kBinsAStop;
        float middle = weight > 0.0 ? kLowestStop + sum / weight / kBinsAStop : brightest;
        // Middle grey for the mean stop, as a camera meters; but never more than the brightest bear.
        float white = lit > 0u ? max(middle - log2(kMiddleGrey), brightest) : 0.0;
        ev100 = white - log2(1.2);
    }
}
