// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/on_threads.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <memory>
#include <mutex>

#include "core/handoff.h"

namespace featuremesh {

/// Threads that wait for the next loop: to gather them anew takes longer than many a loop.
struct RunContext::Arena {
    explicit Arena(int of) : count(of), threads(of) {}
    int count;
    tbb::task_arena threads;
};

std::shared_ptr<RunContext::Arena> RunContext::arena() const {
    const std::scoped_lock lock(arena_mutex_);
    if (!arena_ || arena_->count != threads) arena_ = std::make_shared<Arena>(threads);
    return arena_;
}

void on_threads(const RunContext& context, const std::function<void()>& work) {
    const std::shared_ptr<RunContext::Arena> arena = context.arena();
    arena->threads.execute(work);
}

void run_on_threads(const RunContext& context, std::size_t count, const std::function<void(std::size_t)>& work) {
    Handoff begin, end;  // two, so that no part of the work takes what another gives
    begin.give();
    const auto run = [&](std::size_t index) {
        begin.take();
        work(index);
        end.give();
    };
    on_threads(context, [&] {
        // a thread that waits for its part of this loop must not begin with a part of an outer one
        tbb::this_task_arena::isolate([&] { tbb::parallel_for(std::size_t{0}, count, run); });
    });
    end.take();
}

}  // namespace featuremesh
