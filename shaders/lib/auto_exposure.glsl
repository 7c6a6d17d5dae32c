// Auto-exposure: which pixels count, in which bin of a histogram of stops, and the exposure that the
// histogram's two figures ask for. Not the counting, which the GPU and the CPU do in their own ways.
// A pixel counts by its brightest channel: a deep blue lamp burns out long before its luminance tells.

const int kExposureBins = 384;
const float kExposureBinsAStop = 8.0;
/// The lower edge of bin 0, log2 of cd/m2; what is darker does not count.
const float kExposureLowestStop = -18.0;
/// The brightest part of the lit pixels that may burn out: lenses, a white floor under many lamps.
const float kExposureBurnt = 0.03;
/// Ten stops below the brightest: what is a thousand times dimmer is unlit house and says nothing of
/// the stage.
const int kExposureBinsLookedAt = 80;
/// The exposed value of the mean stop.
const float kExposureMiddleGrey = 0.18;
/// At most so many pixels are looked at, evenly spread.
const int kExposureGridAcross = 320;
const int kExposureGridDown = 180;

/// The bin of a linear colour in cd/m2, 0..kExposureBins - 1, or -1: too dark to count.
int exposureBin(vec3 linear) {
    float peak = max(linear.x, max(linear.y, linear.z));
    float stop = log2(max(peak, 1.0e-30));
    if (!(stop > kExposureLowestStop)) {
        return -1;
    }
    return min(int((stop - kExposureLowestStop) * kExposureBinsAStop), kExposureBins - 1);
}

/// EV100 from the upper edge of the brightest bin that may not burn and the mean bin, both counted
/// in bins from the lowest stop. Middle grey for the mean, as a camera meters, but never more than
/// the brightest bear. A picture without a lit pixel has one fixed exposure.
float ev100OfStops(float brightestBin, float meanBin, bool anyLit) {
    float white = 0.0;
    if (anyLit) {
        white = kExposureLowestStop + max(meanBin / kExposureBinsAStop - log2(kExposureMiddleGrey),
                                          brightestBin / kExposureBinsAStop);
    }
    return white - log2(1.2);
}
