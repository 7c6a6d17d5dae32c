#include "base/log.h"

#include "base/error.h"
#include "base/progress.h"

namespace ribalta {
namespace {
bool verboseSwitch = false;
}

void setVerbose(bool verbose) {
    verboseSwitch = verbose;
}

void logWarning(const std::string& line) {
    Progress::writeLine("ribalta: warning: " + oneLine(line));
}

void logError(const std::string& line) {
    Progress::writeLine("ribalta: error: " + oneLine(line));
}

void logNote(const std::string& line) {
    Progress::writeLine(line);
}

void logVerbose(const std::string& line) {
    if (verboseSwitch) {
        Progress::writeLine(line);
    }
}

}  // namespace ribalta
