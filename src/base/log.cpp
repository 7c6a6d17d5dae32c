#include "base/log.h"

#include <cstdio>

#include "base/progress.h"

namespace ribalta {
namespace {
bool verboseSwitch = false;
}

void setVerbose(bool verbose) {
    verboseSwitch = verbose;
}

bool isVerbose() {
    return verboseSwitch;
}

void logWarning(const std::string& line) {
    Progress::clearLine();
    std::fprintf(stderr, "ribalta: warning: %s\n", line.c_str());
}

void logVerbose(const std::string& line) {
    if (verboseSwitch) {
        Progress::clearLine();
        std::fprintf(stderr, "%s\n", line.c_str());
    }
}

}  // namespace ribalta
