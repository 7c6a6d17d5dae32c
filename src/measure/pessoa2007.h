// The thesis's own measurements (Pessoa 2007), to be repeated.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "measure/sweep_record.h"

namespace ribalta {

/// One of its figures, drawn on a GeForce 6600 GT (128 MB) with an Athlon 64 3200+.
struct ThesisFigure {
    const char* label;
    int planes;
    int cells;  ///< across and down (QUADs)
    double scatteringPerMetre;
    double k;              ///< Gibbons' factor
    double spacingMetres;  ///< dt
    double fps;            ///< as the thesis reports it
};
std::span<const ThesisFigure> thesisFigures();

/// A figure's settings for `method`. The baseline, planes, gets all of them; other methods have
/// neither cells nor spacing.
FrameSettings thesisSettings(const ThesisFigure& figure, BeamMethod method, int width, int height);

/// The thesis's table beside what was measured: a line for each figure, fps and GPU milliseconds of
/// the beams by method, as text in columns. Points are found by their labels.
std::string thesisTable(const std::vector<SweepRecord>& records);

}  // namespace ribalta
