// Independent pieces of work on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace ribalta {

/// Calls body(i) for every i in [0, count), on as many threads as there are cores, or as the
/// environment's RIBALTA_THREADS says; the order is not defined. Returns when all are done. The
/// first exception a call throws ends the hand-out of further work and is rethrown here.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace ribalta
