// Listed sky rays: read from comma-separated values, written back with what was found for each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "reference/integrate_sky.h"

namespace ribalta {

/// The rays of a file, with the other columns that it has, to be handed on.
struct SkyPoints {
    std::vector<SkyRay> rays;
    std::string header;               ///< of the columns handed on
    std::vector<std::string> handed;  ///< a ray's cells of those columns, as they stood
};

/// Reads a first line of column names, among them alt_km, mu, mu_s and nu, and perhaps d_km (where
/// the ray ends; empty: nowhere), and a ray a line; empty lines are passed over. Columns named as
/// those that skyTable appends are dropped. Throws Error(kBadInput) with line and column.
SkyPoints parseSkyPoints(std::string_view text, const std::string& file);

/// The same table with the columns T_ (transmittance), L_ (light the air scatters in) and Lg_ (with
/// what the ground reflects straight into the ray) of r, g and b appended.
std::string skyTable(const SkyPoints& points, const std::vector<SkyLight>& lights);

}  // namespace ribalta
