// SPDX-License-Identifier: GPL-3.0-or-later
// A progress function of the caller that may throw.
#pragma once

#include <exception>
#include <functional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/run_context.h"

namespace featuremesh {

/// What the function throws cancels the work, which takes it for no failure of its own, and is thrown when that has
/// ended.
class CallersProgress {
  public:
    /// `ask` is as RunContext::on_progress; none: nobody is asked.
    CallersProgress(RunContext& context, std::function<bool(std::string_view step, double share)> ask) {
        if (!ask) return;
        context.on_progress = [this, ask = std::move(ask)](std::string_view step, double share) {
            try {
                return ask(step, share);
            } catch (...) {
                thrown_ = std::current_exception();
                return false;
            }
        };
    }
    CallersProgress(const CallersProgress&) = delete;
    CallersProgress& operator=(const CallersProgress&) = delete;

    /// Does the work. However that ends, also without having heard of the cancel, the function's exception is thrown.
    template <class Work>
    auto run(const Work& work) {
        try {
            if constexpr (std::is_void_v<decltype(work())>) {
                work();
                rethrow();
            } else {
                auto done = work();
                rethrow();
                return done;
            }
        } catch (...) {
            rethrow();
            throw;
        }
    }

  private:
    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }
    std::exception_ptr thrown_;
};

}  // namespace featuremesh
