// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/run_context.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <utility>

#include "core/errors.h"
#include "core/messages.h"
#include "core/on_threads.h"

namespace featuremesh {

Cancelled::Cancelled() : Error(say<Code::cancelled>()) {}

namespace {
using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }
}  // namespace

RunContext::Step::Step(RunContext& context, std::string name)
    : context_(context),
      name_(std::move(name)),
      outer_(std::exchange(context.step_, name_)),
      activity_(name_),
      start_(Clock::now()) {
    context_.last_report_ = {};
    context_.share_ = 0;
}

RunContext::Step::~Step() {
    const double spent = seconds_since(start_);
    context_.seconds_[name_] += spent;
    if (!outer_.empty()) context_.seconds_[outer_] -= spent;
    context_.step_ = outer_;
}

void RunContext::progress(double share) {
    if (std::this_thread::get_id() == starter_) share_ = share;
    check_cancelled();
}

void RunContext::check_cancelled() const {
    if (outer_) outer_->check_cancelled();
    if (cancelled_) throw Cancelled();
    if (!on_progress || std::this_thread::get_id() != starter_ || seconds_since(last_report_) < 0.02) return;
    last_report_ = Clock::now();
    if (on_progress(step_, share_)) return;
    cancelled_ = true;
    throw Cancelled();
}

namespace {

/// What the lowest of the chunks that failed threw: the one that one thread would have met.
class FirstFailure {
  public:
    template <class Run>
    void note_of(std::size_t chunk, const Run& run) {
        if (chunk > lowest_) return;
        try {
            run(chunk);
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            if (chunk < lowest_) lowest_ = chunk, thrown_ = std::current_exception();
        }
    }
    void rethrow() const {
        if (thrown_) std::rethrow_exception(thrown_);
    }

  private:
    std::atomic<std::size_t> lowest_{std::numeric_limits<std::size_t>::max()};
    std::mutex mutex_;
    std::exception_ptr thrown_;
};

}  // namespace

void parallel_for(RunContext& context, std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t chunks = (count + grain - 1) / grain;
    const auto run_chunk = [&](std::size_t chunk) {
        context.check_cancelled();
        body(chunk * grain, std::min(count, (chunk + 1) * grain));
    };
    if (context.threads <= 1 || chunks <= 1) {
        for (std::size_t chunk = 0; chunk < chunks; ++chunk) run_chunk(chunk);
        return;
    }
    FirstFailure failure;
    run_on_threads(context, chunks, [&](std::size_t chunk) { failure.note_of(chunk, run_chunk); });
    failure.rethrow();
}

}  // namespace featuremesh
