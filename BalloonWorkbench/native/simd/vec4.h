// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cmath>
#include <cstring>

// Four numbers at once. The functions must take the instruction set of their caller: kernels are compiled for
// every processor of a family and once more for what most of them can do beyond it.
#if defined(__GNUC__)
#define SIMD_INLINE inline __attribute__((always_inline))
#define SIMD_UNROLL _Pragma("GCC unroll 8")
#else
#define SIMD_UNROLL
#define SIMD_INLINE __forceinline
#endif

#if defined(__GNUC__) && defined(__x86_64__)
#define SIMD_HAS_AVX2
#define SIMD_AVX2 __attribute__((target("avx2,fma")))
#endif

namespace simd {

#ifdef SIMD_HAS_AVX2
inline bool has_avx2() {
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return has;
}
#endif

#if defined(__GNUC__)
typedef double Vec4 __attribute__((vector_size(32)));

// In each lane the first where the test is positive, else the second.
SIMD_INLINE void select(const Vec4& test, const Vec4& first, const Vec4& second, Vec4& result) {
    result = test > 0.0 ? first : second;
}
#else
struct Vec4 {
    double lane[4];
    double& operator[](int i) { return lane[i]; }
    double operator[](int i) const { return lane[i]; }
};
#define SIMD_OPERATOR(SIGN)                                                                                  \
    SIMD_INLINE Vec4 operator SIGN(const Vec4& a, const Vec4& b) {                                           \
        return {{a[0] SIGN b[0], a[1] SIGN b[1], a[2] SIGN b[2], a[3] SIGN b[3]}};                           \
    }                                                                                                        \
    SIMD_INLINE Vec4 operator SIGN(const Vec4& a, double b) {                                                \
        return {{a[0] SIGN b, a[1] SIGN b, a[2] SIGN b, a[3] SIGN b}};                                       \
    }                                                                                                        \
    SIMD_INLINE Vec4 operator SIGN(double a, const Vec4& b) {                                                \
        return {{a SIGN b[0], a SIGN b[1], a SIGN b[2], a SIGN b[3]}};                                       \
    }
SIMD_OPERATOR(+)
SIMD_OPERATOR(-)
SIMD_OPERATOR(*)
SIMD_OPERATOR(/)
#undef SIMD_OPERATOR
SIMD_INLINE Vec4 operator-(const Vec4& a) {
    return 0.0 - a;
}

SIMD_INLINE void select(const Vec4& test, const Vec4& first, const Vec4& second, Vec4& result) {
    for (int i = 0; i < 4; ++i)
        result[i] = test[i] > 0.0 ? first[i] : second[i];
}
#endif

SIMD_INLINE void load(Vec4& v, const double* from) {
    std::memcpy(&v, from, sizeof v);
}
SIMD_INLINE void store(const Vec4& v, double* to) {
    std::memcpy(to, &v, sizeof v);
}
SIMD_INLINE void square_root(Vec4& v) {
    for (int i = 0; i < 4; ++i)
        v[i] = std::sqrt(v[i]);
}
SIMD_INLINE double sum_of(const Vec4& v) {
    return (v[0] + v[2]) + (v[1] + v[3]);
}

} // namespace simd
