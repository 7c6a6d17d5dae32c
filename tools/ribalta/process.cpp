#include "process.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include <fcntl.h>
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

void finishStdout() {
    const bool failedBefore = std::ferror(stdout) != 0;
    if (std::fflush(stdout) != 0 || failedBefore) {
        throw Error(ErrorKind::kJobFailed, {"standard output", ""},
                    std::string("cannot be written: ") + std::strerror(errno) +
                        "; give it a file or a pipe with room");
    }
}

}  // namespace ribalta
