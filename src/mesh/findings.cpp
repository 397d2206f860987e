// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/findings.h"

#include <algorithm>

namespace featuremesh {

namespace {
constexpr std::size_t most_places = 5;
}

void Findings::add(Code code, std::size_t count, const std::vector<Message>& places) {
    auto kind = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& known) { return known.code == code; });
    if (kind == kinds_.end()) kind = kinds_.insert(kind, {code, {}, 0});
    kind->count += count;
    const std::size_t room = most_places - kind->places.size(), taken = std::min(room, places.size());
    kind->places.insert(kind->places.end(), places.begin(), places.begin() + static_cast<std::ptrdiff_t>(taken));
}

void Findings::add(const Findings& others) {
    for (const Kind& other : others.kinds_) add(other.code, other.count, other.places);
}

std::vector<Message> Findings::messages() const {
    std::vector<Message> all;
    for (const Kind& kind : kinds_) {
        std::vector<Message> places = kind.places;
        if (kind.count > places.size()) places.push_back(say<Code::and_more>(kind.count - places.size()));
        all.push_back({kind.code, {std::move(places)}});
    }
    return all;
}

}  // namespace featuremesh
