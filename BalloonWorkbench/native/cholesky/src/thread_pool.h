// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace cholesky {

// A few threads that wait for work, led by the one that gives it. Where the system is busy elsewhere and a
// thread comes late, the others do not wait for it.
class ThreadPool {
public:
    // With its caller so many threads, or fewer when the system has no more.
    explicit ThreadPool(int count);
    ~ThreadPool();
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    // As many as find work of their own on this machine.
    static int default_count();

    int count() const { return static_cast<int>(threads_.size()) + 1; }

    // Runs work(0) on the calling thread, and work(1), work(2) ... on others as they come. Every work must
    // call close once and barrier as often as the leader, and must not throw.
    void run(const std::function<void(int)>& work);

    // Waits for all who have come; from here on nobody else joins. The number of threads at work.
    int close(int thread);

    // Waits for all at work.
    void barrier(int thread);

private:
    void wait_for_work();
    // Tries for a moment, then sleeps until another thread has called wake.
    template <typename Condition>
    void wait_until(const Condition& condition);
    void wake();

    std::vector<std::thread> threads_;
    std::mutex mutex_;
    std::condition_variable changed_, phase_changed_;
    const std::function<void(int)>* work_ = nullptr; // null while nobody may join
    unsigned round_ = 0;
    bool stopping_ = false;
    int members_ = 1; // at work
    std::atomic<int> arrived_{0};
    std::atomic<unsigned> phase_{0};
    std::atomic<int> asleep_{0};
};

} // namespace cholesky
