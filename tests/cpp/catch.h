// SPDX-License-Identifier: GPL-3.0-or-later
// Catch2 2 and 3 under one name: what is written for 2 compiles with 3.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
namespace Catch {
namespace Matchers {
// In 3, Contains is about ranges; its overload for text keeps the name that it has in 2.
inline StringContainsMatcher Contains(const char* text) { return ContainsSubstring(text); }
inline StringContainsMatcher Contains(const std::string& text) { return ContainsSubstring(text); }
}  // namespace Matchers
using Matchers::Contains;
}  // namespace Catch
#else
#include <catch2/catch.hpp>
#endif
