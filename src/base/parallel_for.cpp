#include "base/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ribalta {
namespace {

std::size_t threadsAtMost() {
    const char* const text = std::getenv("RIBALTA_THREADS");
    const int wanted = text != nullptr ? std::atoi(text) : 0;
    return wanted > 0 ? std::size_t(wanted) : std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next = 0;
    std::exception_ptr firstError;
    std::mutex errorMutex;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                body(i);
            } catch (...) {
                const std::scoped_lock lock(errorMutex);
                if (!firstError) {
                    firstError = std::current_exception();
                }
                next = count;
            }
        }
    };

    static const std::size_t threads = threadsAtMost();
    std::vector<std::jthread> helpers;
    try {
        for (std::size_t i = 1; i < std::min(threads, count); ++i) {
            helpers.emplace_back(work);
        }
    } catch (const std::system_error&) {
        // No more threads to be had: the ones there are do all the work, this one among them.
    }
    work();
    helpers.clear();  // joins
    if (firstError) {
        std::rethrow_exception(firstError);
    }
}

}  // namespace ribalta
