#include "gltf/tally.h"

namespace ribalta::gltf {

void Tally::tell(Report::Kind kind, const std::string& ending, Report& report) const {
    for (const auto& [remark, seen] : remarks_) {
        std::string message = remark + ending;
        if (seen.count > 1) {
            message.append(" (")
                .append(counted(seen.count, "places"))
                .append(", this is the first)");
        }
        gltf::tell(kind, seen.first, message, report);
    }
}

std::string counted(std::size_t count, const std::string& things) {
    const std::size_t plural = things.ends_with("shes") ? 2 : 1;
    return std::to_string(count) + " " +
           (count == 1 ? things.substr(0, things.size() - plural) : things);
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
