#include "base/error.h"

#include <cstdio>
#include <cstdlib>

#include "base/check.h"

namespace ribalta {
std::string oneLine(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            c = ' ';
        }
    }
    return text;
}

void checkFailed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "%s:%d: internal error: %s does not hold\n", file, line, condition);
    std::abort();
}

std::string Place::text() const {
    return file.empty() || pointer.empty() ? file + pointer : file + ": " + pointer;
}

Place Place::at(const std::string& key) const {
    std::string escaped;
    for (const char c : key) {
        escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    }
    return {file, pointer + "/" + escaped};
}

Place Place::at(std::size_t index) const {
    return {file, pointer + "/" + std::to_string(index)};
}

Error::Error(ErrorKind kind, const Place& place, const std::string& message)
    : std::runtime_error(oneLine(place.text().empty() ? message : place.text() + ": " + message)),
      kind_(kind),
      place_(place) {}

}  // namespace ribalta
