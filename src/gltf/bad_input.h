// The two ways in which this module says that a file is not as it should be.
#pragma once

#include <string>

#include "base/error.h"

namespace ribalta::gltf {

[[noreturn]] inline void badInput(const Place& place, const std::string& message) {
    throw Error(ErrorKind::kBadInput, place, message);
}

/// What an error says below its place, for use in a report line that has the same place.
inline std::string reasonOf(const Error& error) {
    const std::string text = error.what();
    const std::string prefix = error.place().text() + ": ";
    return text.compare(0, prefix.size(), prefix) == 0 ? text.substr(prefix.size()) : text;
}

}  // namespace ribalta::gltf
