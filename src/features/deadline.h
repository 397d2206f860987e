// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a kernel algorithm that takes too long or that the caller no longer wants.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <atomic>
#include <chrono>
#include <ctime>
#include <exception>
#include <mutex>

#include "core/run_context.h"

namespace featuremesh {

inline double processor_seconds(clockid_t clock) {
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Processor seconds that work for `context` has used: those of the calling thread, or of all threads if it may use
/// several. What is worth its time must depend neither on how busy the machine is nor on the number of threads.
inline double used_seconds(const RunContext& context) {
    return processor_seconds(context.threads > 1 ? CLOCK_PROCESS_CPUTIME_ID : CLOCK_THREAD_CPUTIME_ID);
}

/// Handed to a kernel algorithm, which asks it from all its threads: says "break" when the processor seconds are over
/// or the caller of `context` wants to stop. Throws nothing into the kernel, which would not survive it.
class Deadline : public Message_ProgressIndicator {
    DEFINE_STANDARD_RTTI_INLINE(Deadline, Message_ProgressIndicator)

  public:
    Deadline(double seconds, RunContext& context) : end_(used_seconds(context) + seconds), context_(context) {}

    Standard_Boolean UserBreak() override {
        if (broken_) return true;
        if (was_just_asked()) return false;
        try {
            context_.progress(0.5);
            if (used_seconds(context_) >= end_) broken_ = true;
        } catch (...) {
            const std::lock_guard<std::mutex> guard(thrown_mutex_);
            thrown_ = std::current_exception();
            broken_ = true;
        }
        return broken_;
    }
    /// To be asked when the algorithm has returned: was it told to end because of its time? Throws what the caller's
    /// progress function threw, Cancelled as a rule.
    bool is_over() const {
        if (thrown_) std::rethrow_exception(thrown_);
        return broken_;
    }

  protected:
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

  private:
    /// The kernel asks for every edge of a wire, and to read a thread's clock takes a call of the system.
    bool was_just_asked() {
        constexpr std::chrono::microseconds pause{500};
        const auto now = std::chrono::steady_clock::now().time_since_epoch();
        if (now - last_asked_.load() < pause) return true;
        last_asked_ = now;
        return false;
    }

    double end_;
    RunContext& context_;
    std::mutex thrown_mutex_;
    std::exception_ptr thrown_;
    std::atomic<bool> broken_{false};
    std::atomic<std::chrono::steady_clock::duration> last_asked_{std::chrono::hours(-1)};
};

}  // namespace featuremesh
