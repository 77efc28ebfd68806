// SPDX-License-Identifier: LGPL-2.1-or-later
// What the processor can do beyond its family: kernels are compiled for it too and chosen when it can.
#pragma once

#if defined(__GNUC__) && defined(__x86_64__)
#define FILM_HAS_AVX2
#define FILM_AVX2 __attribute__((target("avx2,fma")))
#endif

namespace film {

#ifdef FILM_HAS_AVX2
inline bool has_avx2() {
    static const bool has = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return has;
}
#endif

} // namespace film
