// SPDX-License-Identifier: LGPL-2.1-or-later
#include "workers.h"

#include <algorithm>
#include <system_error>

namespace film {
namespace {

constexpr int kTries = 2000;  // some microseconds: sleep and wake take longer
constexpr unsigned kMost = 4; // more find no work of their own

} // namespace

template <typename Condition>
void Workers::wait_until(const Condition& condition) {
    for (int tries = 0; tries < kTries; ++tries) {
        if (condition())
            return;
    }
    std::unique_lock<std::mutex> lock(mutex_);
    ++asleep_;
    met_.wait(lock, condition);
    --asleep_;
}

void Workers::wake() {
    if (asleep_ > 0) {
        const std::lock_guard<std::mutex> lock(mutex_); // whoever counts as asleep waits by now
        met_.notify_all();
    }
}

int Workers::usual_count() {
    return static_cast<int>(std::min(std::max(std::thread::hardware_concurrency(), 1u), kMost));
}

Workers::Workers(int count) {
    try {
        for (int index = 1; index < count; ++index)
            threads_.emplace_back([this] { wait_for_work(); });
    } catch (const std::system_error&) {
        // those that have started are enough
    }
}

Workers::~Workers() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void Workers::run(const std::function<void(int)>& work) {
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
    meet(0);
}

void Workers::wait_for_work() {
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
        meet(thread);
    }
}

int Workers::gather(int thread) {
    if (thread == 0 && !threads_.empty()) {
        const std::lock_guard<std::mutex> lock(mutex_);
        work_ = nullptr;
    }
    meet(thread);
    return members_;
}

// The counters are changed and read in one order for all threads: nobody falls asleep after the last call.
void Workers::meet(int thread) {
    if (thread == 0) {
        const int others = members_ - 1;
        wait_until([&] { return arrived_ == others; });
        arrived_ = 0;
        ++meeting_;
        wake();
    } else {
        const unsigned meeting = meeting_;
        ++arrived_;
        wake();
        wait_until([&] { return meeting_ != meeting; });
    }
}

} // namespace film
