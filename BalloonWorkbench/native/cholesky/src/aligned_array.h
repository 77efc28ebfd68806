// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace cholesky {

// AlignedArray on cache lines of their own, not initialised.
class AlignedArray {
public:
    explicit AlignedArray(size_t count)
        : bytes_(count * sizeof(double) + kLine - 1), memory_(new char[bytes_]), data_(aligned()) {}

    double* data() { return data_; }
    size_t bytes() const { return bytes_; }

private:
    static constexpr size_t kLine = 64;

    double* aligned() {
        const auto address = reinterpret_cast<std::uintptr_t>(memory_.get());
        return reinterpret_cast<double*>(memory_.get() + (kLine - address % kLine) % kLine);
    }

    size_t bytes_;
    std::unique_ptr<char[]> memory_;
    double* data_;
};

} // namespace cholesky
