#include "image/unfilter_png.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace ribalta {
namespace {

// How many bytes a whole pixel of the usual kinds has, so that it can be had at once.
constexpr bool isUsual(std::size_t pixelBytes) {
    return pixelBytes == 3 || pixelBytes == 4;
}

std::uint32_t loadFour(const std::byte* bytes) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

template <std::size_t kPixelBytes>
void store(std::uint32_t value, std::byte* bytes) {
    std::memcpy(bytes, &value, kPixelBytes);
}

// Byte by byte, without carries between them.
std::uint32_t sum(std::uint32_t a, std::uint32_t b) {
    return ((a & 0x7F7F7F7FU) + (b & 0x7F7F7F7FU)) ^ ((a ^ b) & 0x80808080U);
}

std::uint32_t mean(std::uint32_t a, std::uint32_t b) {
    return (a & b) + (((a ^ b) & 0xFEFEFEFEU) >> 1U);
}

std::byte paeth(std::byte left, std::byte up, std::byte upLeft) {
    const int a = std::to_integer<int>(left);
    const int b = std::to_integer<int>(up);
    const int c = std::to_integer<int>(upLeft);
    const int toLeft = std::abs(b - c);
    const int toUp = std::abs(a - c);
    const int toUpLeft = std::abs(a + b - 2 * c);
    return toLeft <= toUp && toLeft <= toUpLeft ? left : toUp <= toUpLeft ? up : upLeft;
}

std::byte plus(std::byte a, unsigned b) {
    return std::byte(std::to_integer<unsigned>(a) + b);
}

// Pixels of any size.
void unfilterBytes(int filter, std::size_t pixelBytes, const std::byte* above, std::byte* row,
                   std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) {
        const std::byte left = i < pixelBytes ? std::byte(0) : row[i - pixelBytes];
        const std::byte upLeft = i < pixelBytes ? std::byte(0) : above[i - pixelBytes];
        const unsigned predicted =
            filter == 1   ? std::to_integer<unsigned>(left)
            : filter == 2 ? std::to_integer<unsigned>(above[i])
            : filter == 3
                ? (std::to_integer<unsigned>(left) + std::to_integer<unsigned>(above[i])) / 2
                : std::to_integer<unsigned>(paeth(left, above[i], upLeft));
        row[i] = plus(row[i], predicted);
    }
}

template <std::size_t kPixelBytes>
void unfilterSub(std::byte* row, std::size_t bytes) {
    std::uint32_t left = 0;
    for (std::size_t i = 0; i < bytes; i += kPixelBytes) {
        left = sum(loadFour(row + i), left);
        store<kPixelBytes>(left, row + i);
    }
}

void unfilterUp(const std::byte* above, std::byte* row, std::size_t bytes) {
    for (std::size_t i = 0; i < bytes; ++i) {
        row[i] = plus(row[i], std::to_integer<unsigned>(above[i]));
    }
}

template <std::size_t kPixelBytes>
void unfilterAverage(const std::byte* above, std::byte* row, std::size_t bytes) {
    std::uint32_t left = 0;
    for (std::size_t i = 0; i < bytes; i += kPixelBytes) {
        left = sum(loadFour(row + i), mean(left, loadFour(above + i)));
        store<kPixelBytes>(left, row + i);
    }
}

#ifdef __SSE2__
__m128i widened(const std::byte* bytes) {
    return _mm_unpacklo_epi8(_mm_cvtsi32_si128(int(loadFour(bytes))), _mm_setzero_si128());
}

__m128i absolute(__m128i value) {
    return _mm_max_epi16(value, _mm_sub_epi16(_mm_setzero_si128(), value));
}

__m128i choose(__m128i where, __m128i a, __m128i b) {
    return _mm_or_si128(_mm_and_si128(where, a), _mm_andnot_si128(where, b));
}

// As paeth(), four bytes at once, in 16 bits each.
template <std::size_t kPixelBytes>
void unfilterPaeth(const std::byte* above, std::byte* row, std::size_t bytes) {
    __m128i left = _mm_setzero_si128();
    __m128i upLeft = _mm_setzero_si128();
    const __m128i low = _mm_set1_epi16(0xFF);
    for (std::size_t i = 0; i < bytes; i += kPixelBytes) {
        const __m128i up = widened(above + i);
        const __m128i leftwards = _mm_sub_epi16(up, upLeft);
        const __m128i upwards = _mm_sub_epi16(left, upLeft);
        const __m128i toLeft = absolute(leftwards);
        const __m128i toUp = absolute(upwards);
        const __m128i toUpLeft = absolute(_mm_add_epi16(leftwards, upwards));
        const __m128i least = _mm_min_epi16(_mm_min_epi16(toLeft, toUp), toUpLeft);
        const __m128i predicted = choose(_mm_cmpeq_epi16(least, toLeft), left,
                                         choose(_mm_cmpeq_epi16(least, toUp), up, upLeft));
        left = _mm_and_si128(_mm_add_epi16(widened(row + i), predicted), low);
        upLeft = up;
        store<kPixelBytes>(std::uint32_t(_mm_cvtsi128_si32(_mm_packus_epi16(left, left))), row + i);
    }
}
#else
template <std::size_t kPixelBytes>
void unfilterPaeth(const std::byte* above, std::byte* row, std::size_t bytes) {
    unfilterBytes(4, kPixelBytes, above, row, bytes);
}
#endif

template <std::size_t kPixelBytes>
void unfilterUsual(int filter, const std::byte* above, std::byte* row, std::size_t bytes) {
    static_assert(isUsual(kPixelBytes));
    if (filter == 1) {
        unfilterSub<kPixelBytes>(row, bytes);
    } else if (filter == 3) {
        unfilterAverage<kPixelBytes>(above, row, bytes);
    } else {
        unfilterPaeth<kPixelBytes>(above, row, bytes);
    }
}

}  // namespace

bool unfilterRow(int filter, std::size_t pixelBytes, const std::byte* above, std::byte* row,
                 std::size_t bytes) {
    if (filter == 0) {
        return true;
    }
    if (filter < 0 || filter > 4) {
        return false;
    }
    if (filter == 2) {
        unfilterUp(above, row, bytes);
    } else if (pixelBytes == 3) {
        unfilterUsual<3>(filter, above, row, bytes);
    } else if (pixelBytes == 4) {
        unfilterUsual<4>(filter, above, row, bytes);
    } else {
        unfilterBytes(filter, pixelBytes, above, row, bytes);
    }
    return true;
}

}  // namespace ribalta
