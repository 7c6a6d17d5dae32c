#include "gltf/parse_ies.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "gltf/bad_input.h"

namespace ribalta::gltf {
namespace {

// Brighter than any luminaire by far, and products with it still fit single precision.
constexpr double kMaxCandela = 1e12;
constexpr const char* kGetAgain = "; get the luminaire's file again";

// Goes through a text and knows the line it is at.
class IesReader {
  public:
    IesReader(std::string_view text, const Place& place) : rest_(text), place_(place) {}

    [[noreturn]] void refuse(const std::string& message) const {
        badInput(place_, "line " + std::to_string(line_) + ": " + message + kGetAgain);
    }

    /// What is left of the present line; lines end in CR, LF or both.
    std::string_view line() {
        const std::string_view whole = rest_.substr(0, rest_.find_first_of("\r\n"));
        rest_.remove_prefix(whole.size());
        skipLineEnd();
        return whole;
    }

    bool isAtEnd() const { return rest_.empty(); }
    std::size_t bytesLeft() const { return rest_.size(); }

    double number(const char* what) {
        skipSpace();
        // from_chars knows no plus sign.
        std::string_view text = rest_;
        if (text.starts_with('+')) {
            text.remove_prefix(1);
        }
        double value = 0.0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error != std::errc() || !std::isfinite(value)) {
            refuse(rest_.empty()
                       ? std::string("the file ends before its ").append(what)
                       : std::string(rest_.substr(0, wordLength())).append(" is no ").append(what));
        }
        rest_.remove_prefix(std::size_t(stop - rest_.data()));
        return value;
    }

    /// A number that is whole and within 1..most.
    std::size_t count(const char* what, std::size_t most) {
        const double value = number(what);
        if (!(value >= 1.0 && value <= double(most)) || value != std::floor(value)) {
            refuse(std::string(what) + " is " + std::to_string(value) + ", expected 1 to " +
                   std::to_string(most));
        }
        return std::size_t(value);
    }

  private:
    std::size_t wordLength() const {
        return std::min<std::size_t>(rest_.find_first_of(" \t\r\n,"), 20);
    }

    void skipLineEnd() {
        if (rest_.starts_with("\r\n")) {
            rest_.remove_prefix(2);
        } else if (!rest_.empty()) {
            rest_.remove_prefix(1);
        } else {
            return;
        }
        ++line_;
    }

    // Commas part numbers in some programs' files.
    void skipSpace() {
        while (!rest_.empty()) {
            const char c = rest_.front();
            if (c == '\r' || c == '\n') {
                skipLineEnd();
            } else if (c == ' ' || c == '\t' || c == ',') {
                rest_.remove_prefix(1);
            } else {
                return;
            }
        }
    }

    std::string_view rest_;
    const Place& place_;
    std::size_t line_ = 1;
};

// "IESNA91", "IESNA:LM-63-1995", "IES:LM-63-2019"; before those there was no such line.
int yearOf(std::string_view firstLine) {
    if (!firstLine.starts_with("IES")) {
        return 1986;
    }
    const std::size_t digits = firstLine.find_last_not_of(" \t") + 1;
    int year = 0;
    const std::size_t start = firstLine.substr(0, digits).find_last_not_of("0123456789") + 1;
    std::from_chars(firstLine.data() + start, firstLine.data() + digits, year);
    return year < 100 ? 1900 + year : year;
}

// Up to the line TILT=, and what that one says.
void skipHeader(IesReader& reader, const Place& place, IesProfile& profile) {
    while (!reader.isAtEnd()) {
        const std::string_view line = reader.line();
        if (!line.starts_with("TILT=")) {
            continue;
        }
        const std::string_view tilt = line.substr(5, line.find_last_not_of(" \t") - 4);
        if (tilt == "NONE") {
            return;
        }
        profile.remarks.emplace_back(
            "says how light changes with the lamp's tilt, which is not used");
        if (tilt == "INCLUDE") {
            reader.number("geometry of the lamp");
            const std::size_t pairs = reader.count("number of tilt angles", 10000);
            for (std::size_t i = 0; i < 2 * pairs; ++i) {
                reader.number("number of the tilt");
            }
        }
        return;
    }
    badInput(place, "is no IES file: none of its lines begins with TILT=; expected IES LM-63");
}

PhotometricWeb::Type typeOf(std::size_t number) {
    return number == 1   ? PhotometricWeb::Type::kC
           : number == 2 ? PhotometricWeb::Type::kB
                         : PhotometricWeb::Type::kA;
}

std::vector<double> readAngles(IesReader& reader, std::size_t count, double low, double high,
                               const char* what) {
    std::vector<double> angles;
    angles.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = reader.number(what);
        if (angle < low || angle > high) {
            reader.refuse(std::string(what) + " " + std::to_string(angle) + " is not within " +
                          std::to_string(low) + " to " + std::to_string(high));
        }
        if (!angles.empty() && angle <= angles.back()) {
            reader.refuse(std::string(what) + " " + std::to_string(angle) +
                          " does not come after " + std::to_string(angles.back()));
        }
        angles.push_back(angle);
    }
    return angles;
}

}  // namespace

IesProfile parseIes(std::string_view text, const Place& place) {
    IesProfile profile;
    PhotometricWeb& web = profile.web;
    const int year = yearOf(text.substr(0, text.find_first_of("\r\n")));
    IesReader reader(text, place);
    skipHeader(reader, place, profile);

    reader.number("number of lamps");
    reader.number("lumens of a lamp");
    double scale = reader.number("candela multiplier");
    const std::size_t verticals = reader.count("number of vertical angles", 100000);
    const std::size_t horizontals = reader.count("number of horizontal angles", 100000);
    const std::size_t type = reader.count("photometric type", 3);
    for (const char* what : {"type of units", "width", "length", "height"}) {
        reader.number(what);
    }
    scale *= reader.number("ballast factor");
    // Later versions keep other things in this place.
    const double ballastLampFactor = reader.number("ballast-lamp factor");
    scale *= year <= 1995 ? ballastLampFactor : 1.0;
    reader.number("input watts");
    if (!(scale >= 0.0)) {
        reader.refuse("multiplier and ballast factors make " + std::to_string(scale) +
                      ", expected no less than 0");
    }
    if (verticals < 2) {
        reader.refuse("there is one vertical angle, expected two or more");
    }
    // A number takes two bytes with what parts it from the next.
    if (verticals * horizontals > reader.bytesLeft()) {
        reader.refuse("there are to be " + std::to_string(verticals) + " x " +
                      std::to_string(horizontals) + " values, in " +
                      std::to_string(reader.bytesLeft()) + " bytes");
    }
    web.type = typeOf(type);
    const bool isC = web.type == PhotometricWeb::Type::kC;
    web.vertical =
        readAngles(reader, verticals, isC ? 0.0 : -90.0, isC ? 180.0 : 90.0, "vertical angle");
    web.horizontal = readAngles(reader, horizontals, isC ? 0.0 : -180.0, isC ? 360.0 : 180.0,
                                "horizontal angle");
    web.candela.reserve(verticals * horizontals);
    std::size_t negative = 0;
    for (std::size_t i = 0; i < verticals * horizontals; ++i) {
        const double candela = scale * reader.number("candela");
        if (!(candela <= kMaxCandela)) {
            reader.refuse("there are " + std::to_string(candela) + " candela, more than any lamp");
        }
        negative += candela < 0.0 ? 1 : 0;
        web.candela.push_back(std::max(candela, 0.0));
    }
    if (negative > 0) {
        profile.remarks.push_back("has " + std::to_string(negative) +
                                  " values below 0 candela, which are taken for 0");
    }
    return profile;
}

}  // namespace ribalta::gltf
