// What memory is said to be free.
#include "base/available_memory.h"

#include <gtest/gtest.h>
#include <sys/sysinfo.h>

namespace ribalta {
namespace {

// By another way to ask. That it shrinks by what is taken cannot be asked for: virtual machines may
// be given more meanwhile.
TEST(AvailableMemory, LiesWithinWhatTheSystemHas) {
    const std::optional<std::uint64_t> available = availableMemory();
    if (!available) {
        GTEST_SKIP() << "this system does not say";
    }
    struct sysinfo system {};
    ASSERT_EQ(sysinfo(&system), 0);
    EXPECT_GT(*available, std::uint64_t(1) << 24U);
    EXPECT_LE(*available, std::uint64_t(system.totalram) * system.mem_unit);
}

}  // namespace
}  // namespace ribalta
