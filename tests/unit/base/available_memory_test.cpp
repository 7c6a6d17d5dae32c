// What memory is said to be free, against what can be taken of it.
#include "base/available_memory.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

TEST(AvailableMemory, ShrinksByWhatIsTaken) {
    const std::optional<std::uint64_t> before = availableMemory();
    if (!before) {
        GTEST_SKIP() << "this system does not say";
    }
    ASSERT_GT(*before, std::uint64_t(1) << 24U);
    ASSERT_LT(*before, std::uint64_t(1) << 50U);
    // Much more than others take or give back meanwhile.
    const std::size_t taken = std::size_t(std::min<std::uint64_t>(*before / 4, 1U << 29U));
    const std::vector<char> memory(taken, 'x');
    const std::optional<std::uint64_t> after = availableMemory();
    ASSERT_TRUE(after);
    EXPECT_LT(*after, *before - taken / 2) << int(memory[taken / 2]);
}

}  // namespace
}  // namespace ribalta
