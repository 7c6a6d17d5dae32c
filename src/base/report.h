// Report: what a file holds that was left out, mended or looks odd, each with its place.
#pragma once

#include <string>
#include <vector>

#include "base/error.h"

namespace ribalta {

class Report {
  public:
    enum class Kind {
        kIgnored,   ///< in the file and not drawn
        kRepaired,  ///< broken in the file, drawn all the same, with a stand-in where needed
        kHint,      ///< drawn as the file says, but probably not what was meant
    };
    struct Entry {
        Kind kind;
        Place place;
        std::string message;
    };

    void ignored(const Place& place, const std::string& message);
    void repaired(const Place& place, const std::string& message);
    void hint(const Place& place, const std::string& message);

    /// Adds what another one holds.
    void append(const Report& other);

    const std::vector<Entry>& entries() const { return entries_; }

  private:
    std::vector<Entry> entries_;
};

/// "ignored", "repaired" or "hint".
const char* name(Report::Kind kind);

}  // namespace ribalta
