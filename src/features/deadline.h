// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a kernel algorithm that takes too long or that the caller no longer wants.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <ctime>
#include <functional>
#include <utility>

namespace featuremesh {

/// Processor seconds that the calling thread has used. What is worth its time must not depend on how busy the machine
/// is.
inline double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Handed to a kernel algorithm that runs in this thread, says "break" when the processor seconds are over or `stop`
/// (may be empty) says so. Throws nothing itself: the kernel would not survive it.
class Deadline : public Message_ProgressIndicator {
    DEFINE_STANDARD_RTTI_INLINE(Deadline, Message_ProgressIndicator)

  public:
    explicit Deadline(double seconds, std::function<bool()> stop = {})
        : end_(thread_seconds() + seconds), stop_(std::move(stop)) {}

    Standard_Boolean UserBreak() override {
        broken_ = broken_ || thread_seconds() >= end_ || (stop_ && stop_());
        return broken_;
    }
    /// Has the algorithm been told to end?
    bool is_over() const { return broken_; }

  protected:
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

  private:
    double end_;
    std::function<bool()> stop_;
    bool broken_ = false;
};

}  // namespace featuremesh
