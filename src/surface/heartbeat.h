// SPDX-License-Identifier: GPL-3.0-or-later
// Progress and cancel from within the work on one face, whichever thread does it.
#pragma once

#include <atomic>
#include <thread>

#include "core/run_context.h"

namespace featuremesh {

/// Made in the thread that started the work: only that one may call back, the others look whether somebody asked to
/// stop.
class Heartbeat {
  public:
    explicit Heartbeat(RunContext& context) : context_(context) {}

    /// What share of the step is done, 0..1.
    void set_share(double share) { share_ = share; }
    /// Cheap enough for every thousandth round of a loop. Throws Cancelled.
    void beat() const {
        if (std::this_thread::get_id() == starter_)
            context_.progress(share_);
        else
            context_.check_cancelled();
    }

  private:
    RunContext& context_;
    std::thread::id starter_ = std::this_thread::get_id();
    std::atomic<double> share_{0};
};

}  // namespace featuremesh
