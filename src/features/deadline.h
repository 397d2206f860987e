// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a kernel algorithm that takes too long or that the caller no longer wants.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <chrono>
#include <functional>

namespace featuremesh {

/// Handed to a kernel algorithm, says "break" when the seconds are over or `stop` (may be empty) says so. Throws nothing itself: the kernel
/// would not survive it.
class Deadline : public Message_ProgressIndicator {
    DEFINE_STANDARD_RTTI_INLINE(Deadline, Message_ProgressIndicator)

  public:
    explicit Deadline(double seconds, std::function<bool()> stop = {})
        : end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds))),
          stop_(std::move(stop)) {}

    Standard_Boolean UserBreak() override {
        broken_ = broken_ || Clock::now() >= end_ || (stop_ && stop_());
        return broken_;
    }
    /// Has the algorithm been told to end?
    bool is_over() const { return broken_; }

  protected:
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point end_;
    std::function<bool()> stop_;
    bool broken_ = false;
};

}  // namespace featuremesh
