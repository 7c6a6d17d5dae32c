// Comma-separated values of sky rays.
#include "sky_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/check.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr std::array<const char*, 9> kAppended = {"T_r", "T_g",  "T_b",  "L_r", "L_g",
                                                  "L_b", "Lg_r", "Lg_g", "Lg_b"};
constexpr double kMetresPerKilometre = 1000.0;
// Values are often given with few digits; nu then fits the others only about.
constexpr double kSlack = 1e-6;
constexpr double kNuSlack = 1e-3;

/// Cells as they stand, quotes and all: a comma within quotes ends none.
std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
        quoted = quoted != (c == '"');
        if (c == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

/// What a cell says: without its quotes and the spaces around it.
std::string_view content(std::string_view cell) {
    const auto strip = [&](std::string_view ends) {
        const std::size_t first = cell.find_first_not_of(ends);
        const std::size_t last = cell.find_last_not_of(ends);
        cell = first == std::string_view::npos ? std::string_view()
                                               : cell.substr(first, last - first + 1);
    };
    strip(" \t");
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
        cell = cell.substr(1, cell.size() - 2);
    }
    return cell;
}

class LineReader {
  public:
    LineReader(std::string file, const std::string& header) : file_(std::move(file)) {
        for (const std::string& cell : split(header)) {
            names_.emplace_back(content(cell));
        }
        for (const char* name : {"alt_km", "mu", "mu_s", "nu"}) {
            find(name);
        }
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (std::find(kAppended.begin(), kAppended.end(), names_[i]) == kAppended.end()) {
                handed_.push_back(i);
            }
        }
    }

    SkyRay read(const std::string& line, int number) {
        number_ = number;
        cells_ = split(line);
        if (cells_.size() != names_.size()) {
            fail("", "has " + std::to_string(cells_.size()) + " values; the first line names " +
                         std::to_string(names_.size()) + " columns; give one value for each");
        }
        SkyRay ray;
        ray.heightMetres =
            kMetresPerKilometre * value("alt_km", 0.0, 1e9, "0 or above, in km over the ground");
        ray.mu = cosine("mu");
        ray.muS = cosine("mu_s");
        ray.nu = cosine("nu");
        const double sines = std::sqrt((1.0 - ray.mu * ray.mu) * (1.0 - ray.muS * ray.muS));
        const double product = ray.mu * ray.muS;
        if (ray.nu < product - sines - kNuSlack || ray.nu > product + sines + kNuSlack) {
            char range[96];
            std::snprintf(range, sizeof range,
                          "; with this mu and mu_s it must be in %.9g..%.9g, mend one of the three",
                          product - sines, product + sines);
            fail("nu", "is " + std::string(cell("nu")) + range);
        }
        if (has("d_km") && !cell("d_km").empty() && cell("d_km") != "inf") {
            ray.distanceMetres =
                kMetresPerKilometre *
                value("d_km", 0.0, 1e9, "0 or above, in km, or nothing for a ray without end");
        }
        return ray;
    }

    /// The cells of the line read last that are handed on.
    std::string handed() const { return join(cells_); }
    std::string handedNames() const { return join(names_); }

  private:
    bool has(const std::string& name) const {
        return std::find(names_.begin(), names_.end(), name) != names_.end();
    }
    std::size_t find(const std::string& name) const {
        const auto count = std::count(names_.begin(), names_.end(), name);
        if (count != 1) {
            throw Error(ErrorKind::kBadInput, {file_, "line 1"},
                        (count == 0 ? "has no column " : "has more than one column ") + name +
                            "; name the columns alt_km,mu,mu_s,nu, and d_km for rays that end");
        }
        return std::size_t(std::find(names_.begin(), names_.end(), name) - names_.begin());
    }
    std::string_view cell(const std::string& name) const { return content(cells_[find(name)]); }

    double value(const std::string& name, double low, double high, const std::string& what) const {
        const std::optional<double> number = parseNumber<double>(cell(name));
        if (!number || *number < low || *number > high) {
            fail(name, "is '" + std::string(cell(name)) + "'; give a number " + what);
        }
        return *number;
    }
    double cosine(const std::string& name) const {
        return std::clamp(value(name, -1.0 - kSlack, 1.0 + kSlack, "in -1..1, a cosine"), -1.0,
                          1.0);
    }
    std::string join(const std::vector<std::string>& cells) const {
        std::string line;
        for (const std::size_t i : handed_) {
            line += cells[i] + ",";
        }
        return line;
    }
    [[noreturn]] void fail(const std::string& column, const std::string& message) const {
        const std::string line = "line " + std::to_string(number_);
        throw Error(ErrorKind::kBadInput,
                    {file_, column.empty() ? line : line + ", column " + column}, message);
    }

    std::string file_;
    std::vector<std::string> names_;
    std::vector<std::size_t> handed_;
    std::vector<std::string> cells_;
    int number_ = 1;
};

}  // namespace

SkyPoints parseSkyPoints(std::string_view text, const std::string& file) {
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    SkyPoints points;
    std::optional<LineReader> reader;
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) {
            line.pop_back();
        }
        if (!reader) {
            reader.emplace(file, line);
            points.header = reader->handedNames();
        } else if (line.find_first_not_of(" \t") != std::string::npos) {
            points.rays.push_back(reader->read(line, number));
            points.handed.push_back(reader->handed());
        }
    }
    if (points.rays.empty()) {
        throw Error(ErrorKind::kBadInput, {file, ""},
                    "holds no rays; give a line of names, alt_km,mu,mu_s,nu, and a line for each "
                    "ray");
    }
    return points;
}

std::string skyTable(const SkyPoints& points, const std::vector<SkyLight>& lights) {
    CHECK(lights.size() == points.rays.size());
    std::string table = points.header;
    for (const char* name : kAppended) {
        table += name;
        table += name == kAppended.back() ? "\n" : ",";
    }
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const glm::dvec3 values[] = {lights[i].transmittance, lights[i].air,
                                     lights[i].air + lights[i].ground};
        table += points.handed[i];
        for (const glm::dvec3& value : values) {
            char text[96];
            std::snprintf(text, sizeof text, "%.12e,%.12e,%.12e", value.x, value.y, value.z);
            table += text;
            table += &value == std::end(values) - 1 ? "\n" : ",";
        }
    }
    return table;
}

}  // namespace ribalta
