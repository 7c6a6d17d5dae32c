// Lines for people, on stderr; data goes to stdout and never passes through here.
#pragma once

#include <string>

namespace ribalta {

/// Switches logVerbose on or off; off at start.
void setVerbose(bool verbose);

/// "ribalta: warning: ..." always.
void logWarning(const std::string& line);
/// "ribalta: error: ..." always: one of several, before the Error that ends the program.
void logError(const std::string& line);
/// The line as it is, always.
void logNote(const std::string& line);
/// The line as it is, only with --verbose.
void logVerbose(const std::string& line);

}  // namespace ribalta
