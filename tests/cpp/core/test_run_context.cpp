// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "catch.h"
#include "core/callers_progress.h"
#include "core/errors.h"
#include "core/run_context.h"

using namespace featuremesh;

TEST_CASE("parallel_for visits every index once, for any number of threads") {
    for (int threads : {1, 2, 5}) {
        RunContext context;
        context.threads = threads;
        std::vector<int> visits(1003, 0);
        parallel_for(context, visits.size(), 10, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        CHECK(visits == std::vector<int>(1003, 1));
    }
}

TEST_CASE("cancel ends the work") {
    RunContext context;
    context.on_progress = [](std::string_view, double) { return false; };
    RunContext::Step step(context, "work");
    CHECK_THROWS_AS(context.progress(0.5), Cancelled);
    CHECK_THROWS_AS(parallel_for(context, 10, 1, [](std::size_t, std::size_t) {}), Cancelled);
}

namespace {

/// Asks the caller's function, which throws, and ends as `end` says.
template <class End>
std::string thrown_by_work(const End& end) {
    RunContext context;
    CallersProgress asked(context, [](std::string_view, double) -> bool { throw std::runtime_error("the caller's"); });
    try {
        asked.run([&] {
            RunContext::Step step(context, "work");
            return end([&] { context.progress(0.5); });
        });
    } catch (const std::exception& thrown) {
        return thrown.what();
    }
    return "nothing";
}

}  // namespace

TEST_CASE("what the caller's progress function throws is thrown, however the work ends") {
    CHECK(thrown_by_work([](const auto& ask) { ask(); }) == "the caller's");
    const auto swallow = [](const auto& ask) {
        try {
            ask();
        } catch (const Cancelled&) {  // as a library's callback does
        }
    };
    CHECK(thrown_by_work(swallow) == "the caller's");
    CHECK(thrown_by_work([&](const auto& ask) { return swallow(ask), 5; }) == "the caller's");
    CHECK(thrown_by_work([&](const auto& ask) {
              swallow(ask);
              throw std::logic_error("what came of that");
          }) == "the caller's");
}

TEST_CASE("work whose caller goes on gives its answer, or its own failure") {
    RunContext context;
    CallersProgress asked(context, [](std::string_view, double) { return true; });
    CHECK(asked.run([&] { return context.progress(0.5), 5; }) == 5);
    CHECK_THROWS_AS(asked.run([] { throw std::logic_error("its own"); }), std::logic_error);
}

TEST_CASE("a nested step is not counted in the outer one") {
    RunContext context;
    {
        RunContext::Step outer(context, "outer");
        RunContext::Step inner(context, "inner");
    }
    CHECK(context.seconds().at("outer") >= 0);
    CHECK(context.seconds().at("inner") >= 0);
    CHECK(context.seconds().size() == 2);
}

TEST_CASE("of chunks that fail the first one tells why, for any number of threads") {
    for (int threads : {1, 2, 5})
        for (int repeat = 0; repeat < 50; ++repeat) {
            RunContext context;
            context.threads = threads;
            std::string told;
            try {
                parallel_for(context, 64, 1, [](std::size_t chunk, std::size_t) {
                    if (chunk >= 7) throw std::runtime_error(std::to_string(chunk));
                    std::this_thread::sleep_for(std::chrono::microseconds(50));
                });
            } catch (const std::runtime_error& failure) {
                told = failure.what();
            }
            CHECK(told == "7");
        }
}
