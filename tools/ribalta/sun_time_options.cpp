#include "sun_time_options.h"

#include <array>
#include <cmath>

#include <CLI/CLI.hpp>

#include "base/angles.h"
#include "parse_number.h"

namespace ribalta {
namespace {

constexpr int kFirstYear = 1900;  // as far as the sun's place is good to 0.01 degree
constexpr int kLastYear = 2100;

/// Reads a text from left to right; once something is not as expected all that follows fails too.
class TimeReader {
  public:
    explicit TimeReader(const std::string& text) : rest_(text) {}

    /// Just so many digits.
    int digits(std::size_t count) {
        int value = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const char next = i < rest_.size() ? rest_[i] : '?';
            good_ = good_ && next >= '0' && next <= '9';
            value = 10 * value + (next - '0');
        }
        rest_.remove_prefix(std::min(count, rest_.size()));
        return good_ ? value : 0;
    }
    bool take(char wanted) {
        if (!rest_.starts_with(wanted)) {
            return false;
        }
        rest_.remove_prefix(1);
        return true;
    }
    void expect(char wanted) { good_ = take(wanted) && good_; }
    void fail() { good_ = false; }
    bool atEnd() const { return rest_.empty(); }
    bool good() const { return good_; }
    /// Digits after a decimal point.
    double fraction() {
        double value = 0.0;
        double place = 0.1;
        const std::size_t before = rest_.size();
        while (!rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9') {
            value += place * (rest_.front() - '0');
            place *= 0.1;
            rest_.remove_prefix(1);
        }
        good_ = good_ && rest_.size() < before;
        return value;
    }

  private:
    std::string_view rest_;
    bool good_ = true;
};

int daysOf(int year, int month) {
    constexpr std::array<int, 12> kDays{31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return kDays[std::size_t(month - 1)] + (leap && month == 2 ? 1 : 0);
}

/// Hours of the zone that the text ends with, east positive.
double readZone(TimeReader& reader) {
    if (reader.take('Z')) {
        return 0.0;
    }
    const bool east = reader.take('+');
    if (!east) {
        reader.expect('-');
    }
    const int hours = reader.digits(2);
    reader.take(':');
    const int minutes = reader.digits(2);
    if (hours > 14 || minutes > 59) {
        reader.fail();
    }
    return (east ? 1.0 : -1.0) * (hours + minutes / 60.0);
}

/// The Julian day of an ISO 8601 time, YYYY-MM-DDThh:mm[:ss[.s]] and a zone.
double parseTime(const std::string& text) {
    const auto refuse = [&](const std::string& why) -> double {
        throw CLI::ValidationError("--sun-time", "'" + text + "' " + why);
    };
    TimeReader reader(text);
    const int year = reader.digits(4);
    reader.expect('-');
    const int month = reader.digits(2);
    reader.expect('-');
    const int day = reader.digits(2);
    reader.expect('T');
    const int hour = reader.digits(2);
    reader.expect(':');
    const int minute = reader.digits(2);
    double second = 0.0;
    if (reader.take(':')) {
        second = reader.digits(2);
        if (reader.take('.')) {
            second += reader.fraction();
        }
    }
    if (reader.good() && reader.atEnd()) {
        refuse("has no time zone: end it with Z, or with +hh:mm or -hh:mm");
    }
    const double zone = readZone(reader);
    if (!reader.good() || !reader.atEnd()) {
        refuse("is not a time such as 2026-06-21T21:30:00+02:00 or 2026-06-21T19:30Z");
    }
    if (month < 1 || month > 12 || day < 1 || day > daysOf(year, month) || hour > 23 ||
        minute > 59 || !(second < 60.0)) {
        refuse("is no time of the calendar");
    }
    if (year < kFirstYear || year > kLastYear) {
        refuse("is not in the years " + std::to_string(kFirstYear) + ".." +
               std::to_string(kLastYear));
    }
    return julianDay(year, month, day + (hour - zone + minute / 60.0 + second / 3600.0) / 24.0);
}

double parseDegrees(const char* option, const std::optional<std::string>& text, double most,
                    const char* meaning) {
    if (!text) {
        throw CLI::ValidationError(
            "--sun-time", std::string("needs a place on Earth: give ") + option + " DEGREES too");
    }
    const auto degrees = parseNumber<double>(*text);
    if (!degrees || std::abs(*degrees) > most) {
        throw CLI::ValidationError(option, "'" + *text + "' is not a number of degrees " + meaning);
    }
    return *degrees * kDegree;
}

}  // namespace

void SunTimeOptions::addTo(CLI::App& command) {
    command
        .add_option("--sun-time", time,
                    "where the sun stands at this time, ISO 8601 with its zone, such as "
                    "2026-06-21T21:30+02:00; needs --latitude and --longitude; north is -Z")
        ->type_name("TIME");
    command.add_option("--latitude", latitude, "with --sun-time: degrees north, -90..90")
        ->type_name("DEGREES");
    command
        .add_option("--longitude", longitude,
                    "with --sun-time: degrees east of Greenwich, -180..180")
        ->type_name("DEGREES");
}

std::string SunTimeOptions::given() const {
    return time ? "--sun-time" : latitude ? "--latitude" : longitude ? "--longitude" : "";
}

std::optional<SunInSky> SunTimeOptions::parsed() const {
    if (given().empty()) {
        return std::nullopt;
    }
    if (!time) {
        throw CLI::ValidationError(given(), "needs a time: give --sun-time TIME too");
    }
    const double day = parseTime(*time);
    const double north = parseDegrees("--latitude", latitude, 90.0, "north, -90..90");
    const double east =
        parseDegrees("--longitude", longitude, 180.0, "east of Greenwich, -180..180");
    return sunInSky(day, north, east);
}

}  // namespace ribalta
