// VideoEncoder: frames into a film, by the program ffmpeg, which is run beside this one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>

#include <sys/types.h>

#include "base/temporary_file.h"

namespace ribalta {

/// Where the program ffmpeg is, by PATH. Throws Error(kJobFailed) that names `film` and says how to
/// get it.
std::filesystem::path findFfmpeg(const std::filesystem::path& film);

/// Closes what it holds.
class FileDescriptor {
  public:
    explicit FileDescriptor(int number = -1) : number_(number) {}
    FileDescriptor(FileDescriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    ~FileDescriptor() { close(); }

    int number() const { return number_; }
    void close();

  private:
    int number_;
};

/// The film appears whole, by finish(), or not at all. Throws Error(kJobFailed) with what ffmpeg
/// said where it fails.
class VideoEncoder {
  public:
    /// Pixels; both sides even, as the films' colours are held for squares of 2 x 2.
    VideoEncoder(const std::filesystem::path& film, int width, int height, double framesPerSecond);
    ~VideoEncoder();
    VideoEncoder(const VideoEncoder&) = delete;
    VideoEncoder& operator=(const VideoEncoder&) = delete;

    /// The next frame: sRGB-encoded R, G, B, rows from the top, width * height * 3.
    void write(std::span<const std::uint8_t> rgb);
    void finish();

  private:
    int endAndWait();  ///< ffmpeg's exit code; -1 where it did not exit by itself
    [[noreturn]] void fail(const std::string& why);

    std::filesystem::path film_;
    TemporaryFile output_;
    pid_t process_ = -1;
    FileDescriptor input_;   ///< the other end of ffmpeg's standard input
    FileDescriptor errors_;  ///< a file in memory that it writes its errors to
};

}  // namespace ribalta
