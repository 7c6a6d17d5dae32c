// Interval: a stretch of a line.
#pragma once

namespace ribalta {

struct Interval {
    double first = 0.0;
    double last = 0.0;  ///< >= first

    double length() const { return last - first; }
};

}  // namespace ribalta
