// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "catch.h"
#include "core/errors.h"
#include "core/isolated_run.h"

using namespace featuremesh;

namespace {
using Bytes = std::vector<std::byte>;
constexpr Patience enough{60};
}  // namespace

TEST_CASE("what isolated work returns comes back, however much it is") {
    const RunContext context;
    for (const std::size_t size : {0, 1, 3'000'000}) {
        Bytes sent(size);
        for (std::size_t i = 0; i < size; ++i) sent[i] = static_cast<std::byte>(i * i % 251);
        const auto got = run_isolated([&](const RunContext&) { return sent; }, enough, context);
        REQUIRE(got.has_value());
        CHECK(*got == sent);
    }
}

TEST_CASE("isolated work that crashes or throws gives nothing, and changes nothing here") {
    const RunContext context;
    int here = 1;
    const auto crash = [&](const RunContext&) -> Bytes {
        here = 2;
        std::raise(SIGSEGV);
        return Bytes(1);
    };
    const auto fail = [&](const RunContext&) -> Bytes { throw std::runtime_error("no"); };
    CHECK_FALSE(run_isolated(crash, enough, context).has_value());
    CHECK_FALSE(run_isolated(fail, enough, context).has_value());
    CHECK(here == 1);
}

TEST_CASE("isolated work leaves no files and is not heard") {
    const auto heard = std::filesystem::temp_directory_path() / ("heard_" + std::to_string(getpid()));
    const auto left = std::filesystem::current_path() / heard.filename();
    const int to_file = open(heard.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), terminal = dup(STDERR_FILENO);
    dup2(to_file, STDERR_FILENO);
    const auto got = run_isolated(
        [&](const RunContext&) {
            std::cerr << "in trouble" << std::endl;
            std::ofstream(left.filename()) << "what is known";
            return Bytes(3);
        },
        enough, RunContext());
    dup2(terminal, STDERR_FILENO);
    close(terminal), close(to_file);
    CHECK(got == Bytes(3));
    CHECK(std::filesystem::file_size(heard) == 0);
    CHECK_FALSE(std::filesystem::exists(left));
    std::filesystem::remove(heard);
}

TEST_CASE("isolated work that somebody ends, or that has too little memory, is an error and not nothing") {
    const RunContext context;
    for (const int signal : {SIGKILL, SIGTERM}) {
        const auto end = [&](const RunContext&) -> Bytes {
            std::signal(SIGTERM, SIG_DFL);
            std::raise(signal);
            return Bytes(1);
        };
        CHECK_THROWS_WITH(run_isolated(end, enough, context), Catch::Matchers::Contains("was ended from outside"));
    }
    const auto ask_for_all = [](const RunContext&) -> Bytes { throw std::bad_alloc(); };
    CHECK_THROWS_AS(run_isolated(ask_for_all, enough, context), std::bad_alloc);
}

TEST_CASE("isolated work ends when it is cancelled") {
    RunContext context;
    context.cancel();
    const auto sleep = [](const RunContext&) -> Bytes {
        while (true) std::this_thread::sleep_for(std::chrono::seconds(60));
    };
    CHECK_THROWS_AS(run_isolated(sleep, enough, context), Cancelled);
}

TEST_CASE("isolated work that does not end is ended with an error") {
    const RunContext context;
    const auto work_on = [](const RunContext&) {
        volatile bool waiting = true;
        while (waiting) continue;
        return Bytes(1);
    };
    const auto sleep = [](const RunContext&) {
        std::this_thread::sleep_for(std::chrono::seconds(60));
        return Bytes(1);
    };
    CHECK_THROWS_AS(run_isolated(work_on, {.processor_seconds = 1}, context), MeshError);
    CHECK_THROWS_AS(run_isolated(sleep, {.processor_seconds = 60, .idle_seconds = 1}, context), MeshError);
}
