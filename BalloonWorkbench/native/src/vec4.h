// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
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

// In each lane the first where the test is positive, else the second.
FILM_INLINE void select(const Vec4& test, const Vec4& first, const Vec4& second, Vec4& result) {
    result = test > 0.0 ? first : second;
}
#else
struct Vec4 {
    double lane[4];
    double& operator[](int i) { return lane[i]; }
    double operator[](int i) const { return lane[i]; }
};
#define FILM_OPERATOR(SIGN)                                                                                  \
    FILM_INLINE Vec4 operator SIGN(const Vec4& a, const Vec4& b) {                                           \
        return {{a[0] SIGN b[0], a[1] SIGN b[1], a[2] SIGN b[2], a[3] SIGN b[3]}};                           \
    }                                                                                                        \
    FILM_INLINE Vec4 operator SIGN(const Vec4& a, double b) {                                                \
        return {{a[0] SIGN b, a[1] SIGN b, a[2] SIGN b, a[3] SIGN b}};                                       \
    }                                                                                                        \
    FILM_INLINE Vec4 operator SIGN(double a, const Vec4& b) {                                                \
        return {{a SIGN b[0], a SIGN b[1], a SIGN b[2], a SIGN b[3]}};                                       \
    }
FILM_OPERATOR(+)
FILM_OPERATOR(-)
FILM_OPERATOR(*)
FILM_OPERATOR(/)
#undef FILM_OPERATOR
FILM_INLINE Vec4 operator-(const Vec4& a) {
    return 0.0 - a;
}

FILM_INLINE void select(const Vec4& test, const Vec4& first, const Vec4& second, Vec4& result) {
    for (int i = 0; i < 4; ++i)
        result[i] = test[i] > 0.0 ? first[i] : second[i];
}
#endif

FILM_INLINE void load(Vec4& v, const double* from) {
    std::memcpy(&v, from, sizeof v);
}
FILM_INLINE void store(const Vec4& v, double* to) {
    std::memcpy(to, &v, sizeof v);
}
FILM_INLINE void square_root(Vec4& v) {
    for (int i = 0; i < 4; ++i)
        v[i] = std::sqrt(v[i]);
}
FILM_INLINE double sum_of(const Vec4& v) {
    return (v[0] + v[2]) + (v[1] + v[3]);
}

} // namespace film
