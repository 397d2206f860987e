// SPDX-License-Identifier: GPL-3.0-or-later
// Ends a kernel algorithm that takes too much work or that the caller no longer wants.
#pragma once

#include <Message_ProgressIndicator.hxx>
#include <atomic>
#include <exception>
#include <mutex>

#include "core/run_context.h"
#include "core/work.h"

namespace featuremesh {

/// Handed to a kernel algorithm, which asks it from all its threads: says "break" when the work is over the limit or
/// the caller of `context` wants to stop. Each question is some work, and fillers pay for their intersections
/// besides (counted_filler.h). Throws nothing into the kernel, which would not survive it.
class WorkLimit : public Message_ProgressIndicator {
    DEFINE_STANDARD_RTTI_INLINE(WorkLimit, Message_ProgressIndicator)

  public:
    WorkLimit(Work most, RunContext& context) : most_(most), context_(context) {}

    Standard_Boolean UserBreak() override;
    void spend(Work work) { spent_ += work; }

    /// To be asked when the algorithm has returned: was it told to end because of its work? Throws what the caller's
    /// progress function threw, Cancelled as a rule.
    bool is_over() const;
    /// No more than the limit: the same for any number of threads.
    Work spent() const;

  protected:
    void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

  private:
    Work most_;
    std::atomic<Work> spent_{0};
    RunContext& context_;
    std::mutex thrown_mutex_;
    std::exception_ptr thrown_;
    std::atomic<bool> is_stopped_{false};
};

}  // namespace featuremesh
