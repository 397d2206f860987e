// SPDX-License-Identifier: GPL-3.0-or-later
// What long work needs to know of its caller: progress, cancel, threads, log, and where the time went.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "core/activity.h"

namespace featuremesh {

class RunContext {
  public:
    /// Called with the step's name and its done share 0..1; false cancels. Called from the thread that started the
    /// work.
    std::function<bool(std::string_view step, double share)> on_progress;
    std::function<void(std::string_view line)> on_log;
    int threads = 1;

    /// Begins a named step; its seconds are added up until the returned guard ends. It is the thread's activity, too.
    class Step {
      public:
        Step(RunContext& context, std::string name);
        ~Step();
        Step(const Step&) = delete;
        Step& operator=(const Step&) = delete;

      private:
        RunContext& context_;
        std::string name_, outer_;
        Activity activity_;
        std::chrono::steady_clock::time_point start_;
    };

    /// Tells the caller how far the current step is; throws Cancelled when the caller says stop. Cheap (throttled to 20
    /// ms). Threads other than the one that made this object only look whether to stop.
    void progress(double share);
    /// Throws Cancelled when somebody asked to stop; on the thread that made this object the caller is asked, too.
    /// Cheap enough for every thousandth round of a loop, from any thread.
    void check_cancelled() const;
    /// Work that this object stands for ends when that of `outer`, which lives longer, is cancelled.
    void end_with(const RunContext& outer) { outer_ = &outer; }
    /// Asks the work to stop, from any thread.
    void cancel() { cancelled_ = true; }
    void log(std::string_view line) const {
        if (on_log) on_log(line);
    }
    /// Seconds per step name so far; nested steps are counted in their own name only.
    const std::map<std::string, double>& seconds() const { return seconds_; }

  private:
    friend void on_threads(const RunContext& context, const std::function<void()>& work);
    struct Arena;
    std::shared_ptr<Arena> arena() const;

    std::string step_;
    std::map<std::string, double> seconds_;
    const std::thread::id starter_ = std::this_thread::get_id();
    const RunContext* outer_ = nullptr;
    double share_ = 0;
    mutable std::chrono::steady_clock::time_point last_report_{};
    mutable std::atomic<bool> cancelled_{false};
    mutable std::mutex arena_mutex_;
    mutable std::shared_ptr<Arena> arena_;  // of the threads that were asked for last
};

/// Looks whether to stop in every few thousandth round of a loop of cheap rounds.
class RoundWatch {
  public:
    explicit RoundWatch(const RunContext& context) : context_(context) {}
    void operator()() {
        if (++rounds_ % 32768 == 0) context_.check_cancelled();
    }

  private:
    const RunContext& context_;
    std::uint32_t rounds_ = 0;
};

/// Runs body(begin, end) over chunks of [0, count) on `context.threads` threads. The chunks depend on `grain` only,
/// never on the number of threads, so that a body that writes to its own indices gives the same bytes for any number of
/// threads. Where several chunks throw, what the first of them threw is thrown, as by one thread.
void parallel_for(RunContext& context, std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

}  // namespace featuremesh
