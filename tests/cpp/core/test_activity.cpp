// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <thread>

#include "catch.h"
#include "core/activity.h"

using namespace featuremesh;

TEST_CASE("activities nest, and each thread has its own") {
    CHECK(current_activity().empty());
    const Activity outer("surface");
    {
        const Activity inner("Face12");
        CHECK(current_activity() == "surface, Face12");
        std::string elsewhere = "?";
        std::thread([&] { elsewhere = current_activity(); }).join();
        CHECK(elsewhere.empty());
    }
    CHECK(current_activity() == "surface");
}

TEST_CASE("an activity that is too long is cut, and ends where it began") {
    const Activity outer("surface");
    {
        const Activity inner(std::string(1000, 'x'));
        CHECK(current_activity().size() == 200);
        const Activity innermost("more");
        CHECK(current_activity().size() == 200);
    }
    CHECK(current_activity() == "surface");
}

TEST_CASE("a crash says what its thread was working on, and stays that crash") {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = fork();
    if (child == 0) {
        write_activity_of_crash_to(ends[1]);
        const Activity outer("surface");
        const Activity inner("Face7");
        raise(SIGSEGV);
        _exit(0);
    }
    close(ends[1]);
    char said[100];
    const ssize_t count = read(ends[0], said, sizeof said);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGSEGV);
    REQUIRE(count > 0);
    CHECK(std::string(said, std::size_t(count)) == "surface, Face7");
}
