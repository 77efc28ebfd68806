// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace cholesky {

// Numbers on cache lines of their own, not initialised. Many of them lie on large pages, where the system has
// such: small ones it gives one by one, each at its first use, and that takes nearly as long as a
// factorisation.
class AlignedArray {
public:
    explicit AlignedArray(size_t count)
        : bytes_(count * sizeof(double) + alignment(count) - 1), memory_(new char[bytes_]),
          data_(aligned(alignment(count))) {
#ifdef __linux__
        if (alignment(count) == kLargePage)
            madvise(data_, count * sizeof(double) / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
    }

    double* data() { return data_; }
    size_t bytes() const { return bytes_; }

private:
    static constexpr size_t kLine = 64, kLargePage = size_t{1} << 21;

    static constexpr size_t alignment(size_t count) {
        return count * sizeof(double) < 2 * kLargePage ? kLine : kLargePage;
    }

    double* aligned(size_t alignment) {
        const auto address = reinterpret_cast<std::uintptr_t>(memory_.get());
        return reinterpret_cast<double*>(memory_.get() + (alignment - address % alignment) % alignment);
    }

    size_t bytes_;
    std::unique_ptr<char[]> memory_;
    double* data_;
};

} // namespace cholesky
