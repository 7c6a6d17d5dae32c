// What a peer of bench_load.py made of a file: kept, as a program would that draws it, and counted.
#pragma once

#include <cstdint>
#include <cstdio>
#include <vector>

struct Loaded {
    std::vector<std::vector<float>> floats;
    std::vector<std::vector<std::uint32_t>> indices;
    std::size_t geometryBytes = 0;
    std::size_t pixelBytes = 0;

    void keep(std::vector<float> values) {
        geometryBytes += values.size() * sizeof(float);
        floats.push_back(std::move(values));
    }
    void keep(std::vector<std::uint32_t> values) {
        geometryBytes += values.size() * sizeof(std::uint32_t);
        indices.push_back(std::move(values));
    }
    void print(std::size_t nodes) const {
        std::printf("%zu nodes, %zu bytes of geometry, %zu of pixels\n", nodes, geometryBytes,
                    pixelBytes);
    }
};
