// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

constexpr double kSeconds = 1.0; // to repeat a piece of work for
constexpr size_t kRepeats = 5;   // at least, so that a median means something

// Of the calling thread: other programs do not count.
inline double processor_now() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double clock_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <typename Work>
double processor_seconds(const Work& work) {
    const double start = processor_now();
    work();
    return processor_now() - start;
}

template <typename Work>
double median_seconds(const Work& work, double (*now)()) {
    std::vector<double> times;
    for (double sum = 0.0; times.size() < kRepeats || sum < kSeconds; sum += times.back()) {
        const double start = now();
        work();
        times.push_back(now() - start);
    }
    std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
    return times[times.size() / 2];
}

template <typename Work>
double median_processor_seconds(const Work& work) {
    return median_seconds(work, processor_now);
}

template <typename Work>
double median_clock_seconds(const Work& work) {
    return median_seconds(work, clock_now);
}
