// Error: bad input, named by file, place and cure. Thrown anywhere, caught once, in main.
#pragma once

#include <stdexcept>
#include <string>

namespace ribalta {

/// Where in a user's file something stands. Either part may be empty.
struct Place {
    std::string file;     ///< path as the user gave it
    std::string pointer;  ///< JSON pointer (RFC 6901), e.g. /meshes/3/primitives/0; or a line

    /// "file: pointer", without the parts that are empty.
    std::string text() const;
    /// The same file, one step further into the document.
    Place at(const std::string& key) const;
    Place at(std::size_t index) const;
};

/// The text without line breaks and other control characters, whatever a file's strings hold.
std::string oneLine(std::string text);

/// What went wrong; its value is the program's exit code.
enum class ErrorKind {
    kJobFailed = 1,  ///< the work could not be completed: unwritable output, disk full
    kUsage = 2,      ///< wrong command line
    kBadInput = 3,   ///< a file that cannot be used
    kNoOpenGL = 4,   ///< no usable OpenGL 4.5
};

class Error : public std::runtime_error {
  public:
    /// `message` says what was found, what was expected and how to mend it, in one line.
    Error(ErrorKind kind, const Place& place, const std::string& message);

    ErrorKind kind() const { return kind_; }
    int exitCode() const { return static_cast<int>(kind_); }
    const Place& place() const { return place_; }

  private:
    ErrorKind kind_;
    Place place_;
};

}  // namespace ribalta
