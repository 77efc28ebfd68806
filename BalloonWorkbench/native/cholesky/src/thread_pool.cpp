// SPDX-License-Identifier: LGPL-2.1-or-later
#include "thread_pool.h"

#include <algorithm>
#include <system_error>

namespace cholesky {
namespace {

constexpr int kTries = 2000;  // some microseconds: sleep and wake take longer
constexpr unsigned kMost = 4; // more find no work of their own

} // namespace

template <typename Condition>
void ThreadPool::wait_until(const Condition& condition) {
    for (int tries = 0; tries < kTries; ++tries) {
        if (condition())
            return;
    }
    std::unique_lock<std::mutex> lock(mutex_);
    ++asleep_;
    phase_changed_.wait(lock, condition);
    --asleep_;
}

void ThreadPool::wake() {
    if (asleep_ > 0) {
        const std::lock_guard<std::mutex> lock(mutex_); // whoever counts as asleep waits by now
        phase_changed_.notify_all();
    }
}

int ThreadPool::default_count() {
    return static_cast<int>(std::min(std::max(std::thread::hardware_concurrency(), 1u), kMost));
}

ThreadPool::ThreadPool(int count) {
    try {
        for (int index = 1; index < count; ++index)
            threads_.emplace_back([this] { wait_for_work(); });
    } catch (const std::system_error&) {
        // those that have started are enough
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void ThreadPool::run(const std::function<void(int)>& work) {
    if (!threads_.empty()) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            work_ = &work;
            members_ = 1;
            ++round_;
        }
        changed_.notify_all();
    }
    work(0);
    barrier(0);
}

void ThreadPool::wait_for_work() {
    for (unsigned round = 0;;) {
        const std::function<void(int)>* work = nullptr;
        int thread = 0;
        {
            std::unique_lock<std::mutex> lock(mutex_);
            changed_.wait(lock, [&] { return stopping_ || (work_ != nullptr && round_ != round); });
            if (stopping_)
                return;
            work = work_;
            round = round_;
            thread = members_++;
        }
        (*work)(thread);
        barrier(thread);
    }
}

int ThreadPool::close(int thread) {
    if (thread == 0 && !threads_.empty()) {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = nullptr;
    }
    barrier(thread);
    return members_;
}

// The counters are changed and read in one order for all threads: nobody falls asleep after the last call.
void ThreadPool::barrier(int thread) {
    if (thread == 0) {
        const int others = members_ - 1;
        wait_until([&] { return arrived_ == others; });
        arrived_ = 0;
        ++phase_;
        wake();
    } else {
        const unsigned meeting = phase_;
        ++arrived_;
        wake();
        wait_until([&] { return phase_ != meeting; });
    }
}

} // namespace cholesky
