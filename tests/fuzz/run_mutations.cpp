// A main for the targets where there is no libFuzzer: every seed as it is, then mutations of them,
// the same ones in every run, for some seconds. It follows no coverage; tools/fuzz.sh does.
// Usage: fuzz_TARGET SECONDS WORDS.dict FOLDER
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "fuzz/scratch_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using Random = std::mt19937;

constexpr std::size_t kLongest = 16384;

std::string read(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// The words of a dictionary as libFuzzer has them: one a line, in quotes, with \xAB and \".
std::vector<std::string> readWords(const std::filesystem::path& path) {
    std::vector<std::string> words;
    std::ifstream stream(path);
    for (std::string line; std::getline(stream, line);) {
        const std::size_t first = line.find('"');
        const std::size_t last = line.rfind('"');
        if (line.starts_with('#') || first == last) {
            continue;
        }
        std::string word;
        for (std::size_t i = first + 1; i < last; ++i) {
            if (line[i] == '\\' && line[i + 1] == 'x') {
                word += char(std::stoi(line.substr(i + 2, 2), nullptr, 16));
                i += 3;
            } else {
                i += line[i] == '\\' ? 1 : 0;
                word += line[i];
            }
        }
        words.push_back(word);
    }
    return words;
}

std::vector<std::string> readSeeds(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> seeds;
    for (const auto& path : paths) {
        seeds.push_back(read(path));
    }
    return seeds;
}

const std::string& oneOf(const std::vector<std::string>& list, Random& random) {
    return list[random() % list.size()];
}

void mutate(std::string& input, const std::vector<std::string>& words,
            const std::vector<std::string>& seeds, Random& random) {
    const std::size_t at = input.empty() ? 0 : random() % input.size();
    const std::size_t length = std::min<std::size_t>(1 + random() % 16, input.size() - at);
    switch (random() % 7) {
        case 0:
            if (!input.empty()) {
                input[at] = char(std::uint8_t(input[at]) ^ (1U << random() % 8));
            }
            break;
        case 1:
            if (!input.empty()) {
                constexpr char kOdd[] = "\0\xff\x7f\x80\x01 0-\"[]{},:";
                input[at] = kOdd[random() % (sizeof kOdd - 1)];
            }
            break;
        case 2:
            input.insert(at, oneOf(words, random));
            break;
        case 3:
            input.replace(at, length, oneOf(words, random));
            break;
        case 4:
            input.erase(at, length);
            break;
        case 5:
            input.insert(at, input.substr(at, length));
            break;
        default: {
            const std::string& other = oneOf(seeds, random);
            const std::size_t from = other.empty() ? 0 : random() % other.size();
            input.replace(at, length, other.substr(from, 1 + random() % 64));
        }
    }
    input.resize(std::min(input.size(), kLongest));
}

void run(const std::string& input) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

int fuzz(double seconds, const std::filesystem::path& dictionary,
         const std::filesystem::path& folder) {
    const std::vector<std::string> words = readWords(dictionary);
    const std::vector<std::string> seeds = readSeeds(folder);
    if (words.empty() || seeds.empty()) {
        std::fprintf(stderr, "no words or no seeds\n");
        return 2;
    }
    for (const std::string& seed : seeds) {
        run(seed);
    }
    // What ends the program is found here.
    const ribalta::fuzz::ScratchFile last(".input");
    std::printf("the last input is in %s, and stays there if it ends the program\n",
                last.path().c_str());
    std::fflush(stdout);
    Random random(1);  // NOLINT(cert-msc51-cpp): the same files in every run
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    std::size_t count = 0;
    for (; std::chrono::steady_clock::now() < end; ++count) {
        std::string input = oneOf(seeds, random);
        for (std::size_t i = 1 + random() % 6; i > 0; --i) {
            mutate(input, words, seeds, random);
        }
        last.write({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
        run(input);
    }
    std::printf("%zu seeds, %zu mutations\n", seeds.size(), count);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: %s SECONDS WORDS.dict FOLDER\n", argv[0]);
        return 2;
    }
    try {
        return fuzz(std::stod(argv[1]), argv[2], argv[3]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "finding: an exception left the target: %s\n", error.what());
        return 1;
    }
}
