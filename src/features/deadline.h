// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a kernel algorithm that takes too long or that the caller no longer wants.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <ctime>
#include <exception>

#include "core/run_context.h"

namespace featuremesh {

/// Processor seconds that the calling thread has used. What is worth its time must not depend on how busy the machine
/// is.
inline double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Handed to a kernel algorithm that runs in this thread, says "break" when the processor seconds are over or the
/// caller of `context` wants to stop. Throws nothing into the kernel, which would not survive it.
class Deadline : public Message_ProgressIndicator {
    DEFINE_STANDARD_RTTI_INLINE(Deadline, Message_ProgressIndicator)

  public:
    Deadline(double seconds, RunContext& context) : end_(thread_seconds() + seconds), context_(context) {}

    Standard_Boolean UserBreak() override {
        if (broken_) return true;
        try {
            context_.progress(0.5);
            broken_ = thread_seconds() >= end_;
        } catch (...) {
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
    double end_;
    RunContext& context_;
    std::exception_ptr thrown_;
    bool broken_ = false;
};

}  // namespace featuremesh
