// Expects that a call throws ribalta::Error, of one kind, with some words in its one line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"

namespace ribalta::test {

/// Fails the test unless `call` throws an Error of `kind` whose line holds all of `words`.
template <typename Call>
void expectError(ErrorKind kind, const std::vector<std::string>& words, const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        const std::string line = error.what();
        EXPECT_EQ(error.kind(), kind) << line;
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        for (const std::string& word : words) {
            EXPECT_NE(line.find(word), std::string::npos) << "no '" << word << "' in: " << line;
        }
        return;
    }
    ADD_FAILURE() << "nothing was thrown";
}

}  // namespace ribalta::test
