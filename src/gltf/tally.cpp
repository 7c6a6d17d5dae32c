#include "gltf/tally.h"

namespace ribalta::gltf {

void Tally::tell(Report::Kind kind, const std::string& ending, Report& report) const {
    for (const auto& [remark, seen] : remarks_) {
        const std::string more =
            seen.count > 1 ? " (" + std::to_string(seen.count) + " places, this is the first)"
                           : std::string();
        gltf::tell(kind, seen.first, remark + ending + more, report);
    }
}

void tell(Report::Kind kind, const Place& place, const std::string& message, Report& report) {
    switch (kind) {
        case Report::Kind::kIgnored:
            return report.ignored(place, message);
        case Report::Kind::kRepaired:
            return report.repaired(place, message);
        case Report::Kind::kHint:
            return report.hint(place, message);
    }
}

void append(const Report& part, Report& whole) {
    for (const Report::Entry& entry : part.entries()) {
        tell(entry.kind, entry.place, entry.message, whole);
    }
}

}  // namespace ribalta::gltf
