// Numbers that JSON has no word for.
#pragma once

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

namespace ribalta {

/// JSON has no infinity; the only one is the PSNR of equal pictures.
inline nlohmann::json finiteOrNull(double value) {
    return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

/// The way back.
inline double infiniteIfNull(const nlohmann::json& json) {
    return json.is_null() ? std::numeric_limits<double>::infinity() : json.get<double>();
}

}  // namespace ribalta
