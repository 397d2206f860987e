// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>

#include "catch.h"
#include "core/errors.h"
#include "core/messages.h"

using namespace featuremesh;

namespace {

template <class... Values>
constexpr bool takes_these(std::string_view english) {
    return takes(english, std::array<std::size_t, sizeof...(Values)>{kind_of<Values>()...});
}

/// A brace too many, no name, two of one name, an unknown kind, a choice of words for what is no count before it.
bool is_broken(std::string_view english) {
    std::map<std::string_view, std::string_view> kinds;
    while (!english.empty()) {
        const bool begins = english.find('{') != std::string_view::npos;
        const Placeholder found = next_placeholder(english);
        if (found.before.find('}') != std::string_view::npos || begins == found.name.empty()) return true;
        if (!begins) continue;
        if (found.is_choice() ? kinds[found.name] != "count" : !kinds.emplace(found.name, found.kind).second)
            return true;
        const auto end = std::end(kinds_of_parameters);
        if (!found.is_choice() && std::find(std::begin(kinds_of_parameters), end, found.kind) == end) return true;
    }
    return false;
}

std::string_view broken_template() {
    for (const MessageTemplate& words : message_templates)
        if (is_broken(words.english)) return words.name;
    return {};
}

}  // namespace

TEST_CASE("every message has words, with named parameters of known kinds") {
    CHECK(broken_template() == "");
    for (const std::string_view broken : {"a}", "{}", "{:count}", "{a}", "{a:weight}", "{a:count}{a:count}",
                                          "{a:one|many}", "{a:length}{a:one|many}", "{a:one|many}{a:count}"})
        CHECK(is_broken(broken));
    CHECK_FALSE(is_broken("{a:count} {a:one|many} {b:text}"));
    for (const MessageTemplate& words : message_templates) {
        INFO(words.name);
        CHECK(words.english.empty() == (words.name == "none"));
    }
}

TEST_CASE("a message takes the parameters of its template and no others") {
    constexpr std::string_view words = "The refinement {zone:text} has a radius of {radius:length}.";
    STATIC_REQUIRE(takes_these<std::string, Length>(words));
    STATIC_REQUIRE(takes_these<const char*, Length>(words));
    STATIC_REQUIRE_FALSE(takes_these<Length, std::string>(words));
    STATIC_REQUIRE_FALSE(takes_these<std::string, double>(words));
    STATIC_REQUIRE_FALSE(takes_these<std::string>(words));
    STATIC_REQUIRE_FALSE(takes_these<std::string, Length, Length>(words));
    STATIC_REQUIRE(takes_these<>("no parameter"));
    STATIC_REQUIRE(takes_these<FaceId, std::vector<EdgeId>>("{face:entities}{edges:entities}"));
    STATIC_REQUIRE(takes_these<int, std::size_t>("{a:count}{b:count}"));
    STATIC_REQUIRE(takes_these<Message, std::vector<Message>>("{a:messages}{b:messages}"));
    STATIC_REQUIRE(takes_these<int, double>("{a:count} {a:node is|nodes are} {b:number} {a:|s}"));
    STATIC_REQUIRE_FALSE(takes_these<int, int>("{a:count} {a:node|nodes}"));
}

TEST_CASE("a message in English") {
    CHECK(say<Code::size_larger_than_part>(Length{254}, Extent{{40, 10, 2.5}}).in_english() ==
          "The mesh size of 254 mm is larger than the part, which is 40 x 10 x 2.5 mm. Ask for a smaller size.");
    CHECK(say<Code::growth_below_one>(0.5).in_english() ==
          "The growth rate is 0.5; it must be at least 1 (1.3 is usual).");
    CHECK(say<Code::moved_by>(Vec3{5, 0, -1e-12}).in_english() == "moved by (5, 0, 0) mm");
    CHECK(say<Code::volume_changed>(Volume{8}, Volume{9.5}).in_english() == "volume 8 mm^3 -> 9.5 mm^3");
    CHECK(say<Code::volume_changed>(Volume{1.25e-10}, Volume{0}).in_english() == "volume 1.25e-10 mm^3 -> 0 mm^3");
    CHECK(say<Code::with_itself>(FaceId(2)).in_english() == "Face3 and itself");
    CHECK(Message().empty());
    CHECK(Message().in_english().empty());
}

TEST_CASE("a message of one is in the singular") {
    const auto anew = [](int count) {
        return say<Code::elements_made_anew>(count, 9, say<Code::other_faces>()).in_english();
    };
    CHECK(anew(1) == "1 of 9 elements does not fit the part and was made anew: other faces");
    CHECK(anew(2) == "2 of 9 elements do not fit the part and were made anew: other faces");
    CHECK(anew(0) == "0 of 9 elements do not fit the part and were made anew: other faces");
    CHECK(say<Code::misfit_nodes>(1).in_english() == "1 boundary node is off the surface");
    CHECK(say<Code::values_misfit>(1, 3).in_english() == "1 value does not fit the 3 nodes of the old mesh.");
}

TEST_CASE("of many faces six are named") {
    const auto named = [](std::size_t count) {
        std::vector<FaceId> faces;
        for (std::size_t f = 0; f < count; ++f) faces.emplace_back(f);
        return say<Code::faces_too_narrow>(faces).in_english();
    };
    CHECK(named(6) == "Too narrow for elements of their own: Face1, Face2, Face3, Face4, Face5, Face6.");
    CHECK(named(8) == "Too narrow for elements of their own: Face1, Face2, Face3, Face4, Face5, Face6 and 2 more.");
    CHECK(named(0) == "Too narrow for elements of their own: the inside.");
}

TEST_CASE("messages inside others, and several as one") {
    const Message nothing = say<Code::nothing_kept>(), moved = say<Code::other_faces>();
    CHECK(say<Code::full_mesh>(nothing).in_english() == "full mesh: nothing could be kept");
    CHECK(several({}).empty());
    CHECK(several({moved}) == moved);
    CHECK(several({nothing, moved}).in_english() == "nothing could be kept; other faces");
    CHECK(several({nothing, moved}) != moved);
}

TEST_CASE("an error carries its message and says it") {
    const InputError error(say<Code::no_solid>());
    CHECK(error.message.code() == Code::no_solid);
    CHECK(error.what() == error.message.in_english());
    CHECK(Cancelled().message.code() == Code::cancelled);
}
