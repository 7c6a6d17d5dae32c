// Records of a sweep, made up.
#pragma once

#include "measure/sweep_record.h"

namespace ribalta::test {

inline SweepRecord makeRecord(BeamMethod method, int planes, double beamsMs, double errorPercent) {
    SweepRecord record;
    record.key = std::string(name(method)) + std::to_string(planes);
    record.point.scene = "folder/stage.glb";
    record.point.camera = "front";
    record.point.settings.beams.method = method;
    record.point.settings.beams.planes = planes;
    record.status = SweepRecord::Status::kMeasured;
    record.warmups = 2;
    record.repeats = 7;
    record.maxPointSeconds = 60.0;
    record.frameMs = {beamsMs + 10.0, 0.25};
    record.passes = {{"forward", {0.5, 0.1}, {9.0, 0.2}}, {"beams", {1.5, 0.1}, {beamsMs, 0.3}}};
    record.samples = 123456789;
    record.peakRss = 1 << 28;
    record.peakGl = 1 << 26;
    record.ev100 = 7.25;
    record.errors = {{"shadow-map", 0.0125, errorPercent, 46.5, 0.015, 1e-6}};
    return record;
}

}  // namespace ribalta::test
