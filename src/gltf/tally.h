// Tally: the same remark at hundreds of places as one line of the report.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "base/report.h"
#include "gltf/where.h"

namespace ribalta::gltf {

/// Counts where a remark holds and keeps the first place.
class Tally {
  public:
    void add(const std::string& remark, const Where& where) {
        auto [entry, isNew] = remarks_.try_emplace(remark);
        if (isNew) {
            entry->second.first = where.place();
        }
        ++entry->second.count;
    }

    /// Reports every remark once, `ending` behind it.
    void tell(Report::Kind kind, const std::string& ending, Report& report) const;

  private:
    struct Seen {
        Place first;
        std::size_t count = 0;
    };
    std::map<std::string, Seen> remarks_;
};

/// "1 mesh", "2 meshes": a count of things that are given in the plural.
std::string counted(std::size_t count, const std::string& things);

/// Adds one line, or all of another report's, to a report.
void tell(Report::Kind kind, const Place& place, const std::string& message, Report& report);
void append(const Report& part, Report& whole);

}  // namespace ribalta::gltf
