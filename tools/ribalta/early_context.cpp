#include "early_context.h"

#include <chrono>

#include "base/error.h"
#include "base/log.h"

namespace ribalta {

EarlyContext::EarlyContext() {
    const auto start = std::chrono::steady_clock::now();
    try {
        context_.emplace();
    } catch (const Error&) {
        fault_ = std::current_exception();
    }
    ms_ =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

const Context& EarlyContext::get() const {
    if (!context_) {
        std::rethrow_exception(fault_);
    }
    logVerbose("OpenGL: " + context_->renderer() + ", " + context_->version() +
               (context_->isSoftware() ? " (software; no GPU found)" : ""));
    return *context_;
}

}  // namespace ribalta
