#include "video_encoder.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.h"
#include "frame_files.h"

namespace ribalta {
namespace {

// Colours as screens show them. Without these, players take a film for what its size suggests.
const std::vector<std::string> kColours = {
    "-vf",
    "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
    "-colorspace",
    "bt709",
    "-color_trc",
    "iec61966-2-1",
    "-color_range",
    "tv",
    "-color_primaries",
    "bt709"};
// Of a quality at which gradients in haze show no steps.
const std::vector<std::string> kH264 = {"-c:v", "libx264", "-crf", "17", "-preset", "medium"};
const std::vector<std::string> kVp9 = {"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0"};

std::vector<std::string> commandFor(const std::filesystem::path& ffmpeg,
                                    const std::filesystem::path& output, int width, int height,
                                    double framesPerSecond) {
    char rate[32];
    std::snprintf(rate, sizeof rate, "%.10g", framesPerSecond);
    std::vector<std::string> command = {ffmpeg.string(),
                                        "-hide_banner",
                                        "-loglevel",
                                        "error",
                                        "-y",
                                        "-f",
                                        "rawvideo",
                                        "-pixel_format",
                                        "rgb24",
                                        "-video_size",
                                        std::to_string(width) + "x" + std::to_string(height),
                                        "-framerate",
                                        rate,
                                        "-i",
                                        "pipe:0"};
    const std::vector<std::string>& codec = endingOf(output) == ".webm" ? kVp9 : kH264;
    command.insert(command.end(), codec.begin(), codec.end());
    command.insert(command.end(), kColours.begin(), kColours.end());
    // A name that begins with a dash, or has a colon, is a name all the same.
    command.push_back("file:" + output.string());
    return command;
}

// Runs a program, its output thrown away. Returns an errno, or 0 and its process.
int spawn(std::vector<std::string> command, int input, int errors, pid_t& process) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, errors, STDERR_FILENO);
    // A group of its own: Ctrl-C is for this program, which ends the other in order.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int number : {SIGPIPE, SIGXFSZ, SIGINT, SIGTERM, SIGHUP}) {
        sigaddset(&usual, number);
    }
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes,
                             static_cast<short>(POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP));
    std::vector<char*> arguments;
    arguments.reserve(command.size() + 1);
    for (std::string& argument : command) {
        arguments.push_back(argument.data());
    }
    arguments.push_back(nullptr);
    const int error =
        posix_spawn(&process, arguments.front(), &files, &attributes, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
    return error;
}

std::string lastLine(int file) {
    std::string text(4096, '\0');
    const off_t size = lseek(file, 0, SEEK_END);
    const off_t from = size > off_t(text.size()) ? size - off_t(text.size()) : 0;
    const ssize_t got = pread(file, text.data(), text.size(), from);
    text.resize(got > 0 ? std::size_t(got) : 0);
    std::istringstream lines(text);
    std::string last;
    for (std::string line; std::getline(lines, line);) {
        last = line.empty() ? last : line;
    }
    return last;
}

}  // namespace

std::filesystem::path findFfmpeg(const std::filesystem::path& film) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::filesystem::path program =
            std::filesystem::path(folder.empty() ? "." : folder) / "ffmpeg";
        std::error_code missing;
        if (std::filesystem::is_regular_file(program, missing) &&
            access(program.c_str(), X_OK) == 0) {
            return program;
        }
    }
    throw Error(ErrorKind::kJobFailed, {film.string(), ""},
                "a film needs the program ffmpeg, which is not installed (not in PATH); install "
                "the package ffmpeg, or write numbered pictures: -o " +
                    film.stem().string() + "_####.png");
}

void FileDescriptor::close() {
    if (number_ >= 0) {
        ::close(std::exchange(number_, -1));
    }
}

VideoEncoder::VideoEncoder(const std::filesystem::path& film, int width, int height,
                           double framesPerSecond)
    : film_(film), output_(film), errors_(memfd_create("ffmpeg errors", MFD_CLOEXEC)) {
    const std::filesystem::path ffmpeg = findFfmpeg(film_);
    int ends[2] = {-1, -1};
    // Sockets, which unlike pipes can be written to without a signal when ffmpeg is gone.
    if (errors_.number() < 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        throw Error(ErrorKind::kJobFailed, {film_.string(), ""},
                    std::string("no connection to ffmpeg could be made: ") + std::strerror(errno) +
                        "; close other programs");
    }
    const FileDescriptor theirs(ends[0]);
    input_ = FileDescriptor(ends[1]);
    const int error = spawn(commandFor(ffmpeg, output_.path(), width, height, framesPerSecond),
                            theirs.number(), errors_.number(), process_);
    if (error != 0) {
        process_ = -1;
        throw Error(ErrorKind::kJobFailed, {film_.string(), ""},
                    ffmpeg.string() + " cannot be run: " + std::strerror(error) +
                        "; install the package ffmpeg anew");
    }
}

VideoEncoder::~VideoEncoder() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        endAndWait();
    }
}

int VideoEncoder::endAndWait() {
    input_.close();
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void VideoEncoder::fail(const std::string& why) {
    const std::string said = lastLine(errors_.number());
    throw Error(ErrorKind::kJobFailed, {film_.string(), ""},
                "ffmpeg " + why + (said.empty() ? "" : ": " + said) +
                    "; write numbered pictures instead: -o " + film_.stem().string() + "_####.png");
}

void VideoEncoder::write(std::span<const std::uint8_t> rgb) {
    while (!rgb.empty()) {
        const ssize_t written = send(input_.number(), rgb.data(), rgb.size(), MSG_NOSIGNAL);
        if (written >= 0) {
            rgb = rgb.subspan(std::size_t(written));
        } else if (errno != EINTR) {
            endAndWait();
            fail("ended early");
        }
    }
}

void VideoEncoder::finish() {
    const int code = endAndWait();
    if (code != 0) {
        fail(code < 0 ? "was ended" : "failed with exit code " + std::to_string(code));
    }
    output_.commit();
}

}  // namespace ribalta
