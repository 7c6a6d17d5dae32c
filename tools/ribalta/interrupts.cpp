#include "interrupts.h"

namespace ribalta {
namespace {

volatile std::sig_atomic_t notedSignal = 0;

// What each signal did before the watch; read by the handler.
struct sigaction actionsBefore[NSIG];

extern "C" void noteSignal(int number) {
    notedSignal = number;
    sigaction(number, &actionsBefore[number], nullptr);
}

}  // namespace

InterruptWatch::InterruptWatch() {
    notedSignal = 0;
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], nullptr, &before_[i]);
        actionsBefore[kSignals[i]] = before_[i];
        if (before_[i].sa_handler == SIG_IGN) {
            continue;  // as nohup and shells want it
        }
        struct sigaction action {};
        action.sa_handler = noteSignal;
        sigemptyset(&action.sa_mask);
        sigaction(kSignals[i], &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (std::size_t i = 0; i < kSignals.size(); ++i) {
        sigaction(kSignals[i], &before_[i], nullptr);
    }
}

int InterruptWatch::noted() {
    return notedSignal;
}

}  // namespace ribalta
