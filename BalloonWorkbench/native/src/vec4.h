// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstring>

// Four numbers at once. The functions must take the instruction set of their caller.
#if defined(__GNUC__)
#define FILM_INLINE inline __attribute__((always_inline))
#define FILM_UNROLL _Pragma("GCC unroll 8")
#else
#define FILM_UNROLL
#define FILM_INLINE __forceinline
#endif

namespace film {

#if defined(__GNUC__)
typedef double Vec4 __attribute__((vector_size(32)));
#else
struct Vec4 {
    double lane[4];
    double& operator[](int i) { return lane[i]; }
    double operator[](int i) const { return lane[i]; }
};
FILM_INLINE Vec4 operator+(const Vec4& a, const Vec4& b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]}};
}
FILM_INLINE Vec4 operator-(const Vec4& a, const Vec4& b) {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]}};
}
FILM_INLINE Vec4 operator*(const Vec4& a, const Vec4& b) {
    return {{a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]}};
}
FILM_INLINE Vec4 operator*(const Vec4& a, double b) {
    return {{a[0] * b, a[1] * b, a[2] * b, a[3] * b}};
}
#endif

FILM_INLINE void load(Vec4& v, const double* from) {
    std::memcpy(&v, from, sizeof v);
}
FILM_INLINE void store(const Vec4& v, double* to) {
    std::memcpy(to, &v, sizeof v);
}

} // namespace film
