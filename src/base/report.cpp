#include "base/report.h"

namespace ribalta {

void Report::ignored(const Place& place, const std::string& message) {
    entries_.push_back({Kind::kIgnored, place, message});
}

void Report::repaired(const Place& place, const std::string& message) {
    entries_.push_back({Kind::kRepaired, place, message});
}

void Report::hint(const Place& place, const std::string& message) {
    entries_.push_back({Kind::kHint, place, message});
}

void Report::append(const Report& other) {
    entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
}

const char* name(Report::Kind kind) {
    switch (kind) {
        case Report::Kind::kIgnored:
            return "ignored";
        case Report::Kind::kRepaired:
            return "repaired";
        case Report::Kind::kHint:
            return "hint";
    }
    return "";
}

}  // namespace ribalta
