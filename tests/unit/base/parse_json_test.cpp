// parseJson against nlohmann's own parser: the same tree, and the same texts refused.
#include "base/parse_json.h"

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace ribalta {
namespace {

using nlohmann::json;

const Place kFile{"some.json", ""};
const JsonKind kKind{"an object", "mend it"};

std::optional<json> ours(const std::string& text) {
    try {
        return parseJson(text, kFile, kKind);
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::optional<json> theirs(const std::string& text) {
    try {
        return json::parse(text);
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

// The dump tells 1 from 1.0 and 0.0 from -0.0, which are equal.
void expectSame(const std::string& text) {
    const std::optional<json> tree = ours(text);
    const std::optional<json> expected = theirs(text);
    ASSERT_EQ(tree.has_value(), expected.has_value()) << text;
    if (tree) {
        EXPECT_EQ(*tree, *expected) << text;
        EXPECT_EQ(tree->dump(), expected->dump()) << text;
    }
}

// One of the words, by chance.
template <typename Random, std::size_t kCount>
std::string any(Random& random, const char* const (&words)[kCount]) {
    return words[random() % kCount];
}

using Random = std::mt19937;

std::string anyString(Random& random) {
    static const char* const kPieces[] = {
        "a",        "name", "\\n",  "\\u0000", "\\u00e9",          "\\ud83d\\ude00", "\\/", "\\\"",
        "\xc3\xa9", "",     "\\\\", "\x7f",    "\xf0\x9f\x98\x80", "node_17",        "~/x", "  "};
    std::string text = "\"";
    for (std::size_t i = random() % 4; i-- > 0;) {
        text += any(random, kPieces);
    }
    return text + "\"";
}

std::string anyValue(Random& random, int depth) {
    static const char* const kPlain[] = {"0",
                                         "1",
                                         "-1",
                                         "4294967296",
                                         "9223372036854775807",
                                         "9223372036854775808",
                                         "true",
                                         "null",
                                         "0.1",
                                         "-0.0",
                                         "18446744073709551615",
                                         "-9223372036854775808",
                                         "1e-400",
                                         "false",
                                         "1E5",
                                         "2.5e+3",
                                         "18446744073709551616",
                                         "4.9406564584124654e-324",
                                         "3.0",
                                         "-0",
                                         "1e22",
                                         "0.30000000000000004",
                                         "-9223372036854775809",
                                         "1.7976931348623157e308"};
    static const char* const kSpace[] = {"", "", " ", "\n", "\t\r\n "};
    const auto kind = depth > 4 ? 0 : random() % 5;
    if (kind < 2) {
        return any(random, kPlain);
    }
    if (kind == 2) {
        return anyString(random);
    }
    std::string text = kind == 3 ? "[" : "{";
    const std::size_t count = random() % 5;
    for (std::size_t i = 0; i < count; ++i) {
        text += (i == 0 ? "" : ",") + any(random, kSpace);
        text += kind == 3 ? "" : anyString(random) + any(random, kSpace) + ":";
        text += anyValue(random, depth + 1) + any(random, kSpace);
    }
    return text + (kind == 3 ? "]" : "}");
}

std::string anyObject(Random& random) {
    return "{\"a\":" + anyValue(random, 0) + ",\"b\":" + anyValue(random, 0) + "}";
}

TEST(ParseJson, MakesTheTreesOfTheOtherParser) {
    Random random(7);
    for (int i = 0; i < 20'000; ++i) {
        expectSame(anyObject(random));
        ASSERT_FALSE(HasFailure());
    }
}

TEST(ParseJson, RefusesWhatTheOtherParserDoes) {
    Random random(11);
    for (int i = 0; i < 50'000; ++i) {
        std::string text = anyObject(random);
        const std::size_t at = random() % text.size();
        switch (random() % 3) {
            case 0:
                text[at] = char(random() % 256);
                break;
            case 1:
                text.erase(at, 1 + random() % 3);
                break;
            default:
                text.insert(at, 1, "\"\\{}[],:0-.eE\xef\x80\x1f"[random() % 16]);
                break;
        }
        // A text that is no object is refused here, and a number is one for the other parser.
        if (const auto tree = theirs(text); !tree || tree->is_object()) {
            expectSame(text);
            ASSERT_FALSE(HasFailure());
        }
    }
}

TEST(ParseJson, AgreesOnOddTexts) {
    using namespace std::string_literals;
    for (const std::string& text : {
             ""s,
             " "s,
             "{}"s,
             "{} "s,
             "{} x"s,
             "{}\0garbage"s,
             "\xef\xbb\xbf{\"a\":1}"s,
             "\xef\xbb{}"s,
             "{\"\":1}"s,
             "{\"a\":1,\"a\":[2],\"b\":3,\"a\":{\"c\":4}}"s,
             "{\"a\":1e400}"s,
             "{\"a\":-1e400}"s,
             "{\"a\":01}"s,
             "{\"a\":1.}"s,
             "{\"a\":.5}"s,
             "{\"a\":+1}"s,
             "{\"a\":-}"s,
             "{\"a\":NaN}"s,
             "{\"a\":\"\\ud800\"}"s,
             "{\"a\":\"\\udc00\"}"s,
             "{\"a\":\"\\ud800\\ud800\"}"s,
             "{\"a\":\"\\ud800x\"}"s,
             "{\"a\":\"\\u12g4\"}"s,
             "{\"a\":\"\xed\xa0\x80\"}"s,
             "{\"a\":\"\xc0\x80\"}"s,
             "{\"a\":\"\xf4\x90\x80\x80\"}"s,
             "{\"a\":\"a\0b\"}"s,
             "{\"a\":\"\n\"}"s,
             "{\"a\":[1,]}"s,
             "{\"a\":1,}"s,
             "{\"a\":/**/1}"s,
             "{\"a\":123456789012345678901234567890}"s,
             "{\"a\":0.1234567890123456789012345678901234567890}"s,
             "{\"a\":2.2250738585072011e-308}"s,
             "{\"a\":1"s + std::string(400, '0') + ".5e-400}",
         }) {
        expectSame(text);
    }
}

TEST(ParseJson, RefusesNoText) {
    EXPECT_THROW(parseJson(std::string_view(), kFile, kKind), Error);
}

TEST(ParseJson, SaysBeforehandWhatATextTakes) {
    std::uint64_t told = 0;
    JsonLimits limits;
    limits.takeMemory = [&](std::uint64_t kept, std::uint64_t peak) {
        EXPECT_GT(peak, kept);
        told = kept;
    };
    std::string list = "[0";
    for (int i = 0; i < 999; ++i) {
        list += ",0";
    }
    parseJson("{\"a\":" + list + "]}", kFile, kKind, limits);
    EXPECT_GE(told, 1000 * sizeof(json));
    limits.memory = told;
    EXPECT_THROW(parseJson("{\"a\":" + list + "]}", kFile, kKind, limits), Error);
}

TEST(ParseJson, SaysWhereATextIsWrong) {
    try {
        parseJson("{\"a\": 1,\n  \"b\": tru }", kFile, kKind);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.place().pointer, "line 2, column 11");
        EXPECT_NE(std::string(error.what()).find("is not valid JSON"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("mend it"), std::string::npos);
    }
}

}  // namespace
}  // namespace ribalta
