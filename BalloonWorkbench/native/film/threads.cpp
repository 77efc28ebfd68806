// SPDX-License-Identifier: LGPL-2.1-or-later
#include "threads.h"

#include <algorithm>
#include <atomic>

#include "cholesky/cholesky.h"

namespace film {
namespace {

constexpr int kShared = 3000; // vertices: on fewer a second thread costs as much again and gains nothing
std::atomic<int> chosen{0};

} // namespace

void set_threads(int count) {
    chosen = count;
}

int threads_for(int vertices) {
    if (vertices < kShared)
        return 1;
    const int count = chosen, most = cholesky::default_threads();
    return count > 0 ? std::min(count, most) : most;
}

} // namespace film
