// The sources that a renderer's sky is made from, kept as a file from one run to the next.
#pragma once

#include "base/file_cache.h"
#include "sky/sky_sources.h"

namespace ribalta {

/// For all suns, the ground lighting the air; out of `files` where they were made before for the
/// same atmosphere, orders and sizes, otherwise made now on all cores and kept there. `files` may
/// be null. `table` must outlive them.
SkySources obtainSkySources(const OpticalLengthTable& table, int orders, const SkyTableSizes& sizes,
                            const FileCache* files);

/// Changes whenever the code changes that sources are made by.
const char* skyRevision();

}  // namespace ribalta
