#include "process.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.h"
#include "base/temporary_file.h"

namespace ribalta {
namespace {

void openClosedStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) {
            // Takes the lowest free number, which is this one. Not for writing where the loss must
            // be seen: data on stdout.
            static_cast<void>(open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY));
        }
    }
}

extern "C" void endOnSignal(int number) {
    removeTemporaryFiles();
    // SA_RESETHAND has put the usual end back.
    raise(number);
}

}  // namespace

void prepareProcess() {
    openClosedStreams();
    std::signal(SIGXFSZ, SIG_IGN);
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        struct sigaction action {};
        sigaction(number, nullptr, &action);
        if (action.sa_handler == SIG_IGN) {
            continue;  // as nohup and shells want it
        }
        action.sa_handler = endOnSignal;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigemptyset(&action.sa_mask);
        sigaction(number, &action, nullptr);
    }
}

double processMs() {
    std::ifstream file("/proc/self/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    // The program's name, in brackets, may hold spaces; the start stands 20 words behind it
    // (proc(5)), in the kernel's ticks since the system's.
    std::istringstream words(text.substr(text.rfind(')') + 1));
    std::string word;
    for (int i = 0; i < 20; ++i) {
        words >> word;
    }
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec) -
           1e3 * std::strtod(word.c_str(), nullptr) / double(sysconf(_SC_CLK_TCK));
}

std::uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024;
}

void finishStdout() {
    const bool failedBefore = std::ferror(stdout) != 0;
    if (std::fflush(stdout) != 0 || failedBefore) {
        throw Error(ErrorKind::kJobFailed, {"standard output", ""},
                    std::string("cannot be written: ") + std::strerror(errno) +
                        "; give it a file or a pipe with room");
    }
}

}  // namespace ribalta
