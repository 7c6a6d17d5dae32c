#include "measure/pessoa2007.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace ribalta {
namespace {

constexpr std::array kFigures = {
    ThesisFigure{"A-1", 40, 20, 0.1, 20.0, 0.1, 41.0},
    ThesisFigure{"A-2", 50, 30, 0.9, 20.0, 0.04, 28.0},
    ThesisFigure{"A-3", 40, 30, 0.5, 30.0, 0.07, 37.0},
    ThesisFigure{"A-4", 45, 20, 0.3, 25.0, 0.06, 43.0},
    ThesisFigure{"A-5", 55, 10, 0.2, 25.0, 0.05, 28.0},
    ThesisFigure{"A-6", 50, 30, 0.2, 20.0, 0.07, 28.0},
};

std::string line(const char* format, auto... values) {
    char text[160];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string measured(const SweepRecord& record) {
    if (record.status != SweepRecord::Status::kMeasured) {
        return line("  %-32s", name(record.status));
    }
    return line("  %9.2f fps %9.2f ms %6.2f %%", record.fps(), record.beamsMs(),
                record.errors.empty() ? 0.0 : record.errors.front().displayRmsePercent);
}

}  // namespace

std::span<const ThesisFigure> thesisFigures() {
    return kFigures;
}

FrameSettings thesisSettings(const ThesisFigure& figure, BeamMethod method, int width, int height) {
    FrameSettings settings;
    settings.width = width;
    settings.height = height;
    settings.haze.scatteringPerMetre = figure.scatteringPerMetre;
    settings.haze.phase.k = figure.k;
    settings.beams.method = method;
    settings.beams.planes = figure.planes;
    if (method == BeamMethod::kPlanes) {
        settings.beams.cellsAcross = figure.cells;
        settings.beams.cellsDown = figure.cells;
        settings.beams.spacingMetres = figure.spacingMetres;
    }
    return settings;
}

std::string thesisTable(const std::vector<SweepRecord>& records) {
    std::vector<std::string> methods;
    for (const SweepRecord& record : records) {
        const std::string method(name(record.point.settings.beams.method));
        if (!record.point.label.empty() &&
            std::find(methods.begin(), methods.end(), method) == methods.end()) {
            methods.push_back(method);
        }
    }
    std::string text =
        "Pessoa 2007 on a GeForce 6600 GT, and here (frames a second, GPU time of "
        "the beams, tone-mapped RMSE)\n";
    text += line("%-7s %3s  %-6s %6s %5s %6s %7s", "figure", "n", "QUADs", "sigma", "K", "dt",
                 "thesis");
    for (const std::string& method : methods) {
        text += line("  %-34s", method.c_str());
    }
    text += "\n";
    for (const ThesisFigure& figure : kFigures) {
        text += line("%-7s %3d  %-6s %6g %5g %6g %3.0f fps", figure.label, figure.planes,
                     line("%dx%d", figure.cells, figure.cells).c_str(), figure.scatteringPerMetre,
                     figure.k, figure.spacingMetres, figure.fps);
        for (const std::string& method : methods) {
            const auto found =
                std::find_if(records.begin(), records.end(), [&](const SweepRecord& record) {
                    return record.point.label == figure.label &&
                           name(record.point.settings.beams.method) == method;
                });
            text += found == records.end() ? line("  %-34s", "") : measured(*found);
        }
        text += "\n";
    }
    return text;
}

}  // namespace ribalta
