// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/findings.h"

namespace featuremesh {

Findings::Kind& Findings::kind(const std::string& name) {
    for (Kind& known : kinds_)
        if (known.name == name) return known;
    kinds_.push_back({name, {}, 0});
    return kinds_.back();
}

void Findings::add(const std::string& name, const std::string& detail) {
    Kind& entry = kind(name);
    ++entry.count;
    if (entry.details.size() < most_details) entry.details.push_back(detail);
}

void Findings::add(const Findings& others) {
    for (const Kind& other : others.kinds_) {
        Kind& entry = kind(other.name);
        entry.count += other.count;
        for (const std::string& detail : other.details)
            if (entry.details.size() < most_details) entry.details.push_back(detail);
    }
}

std::vector<std::string> Findings::messages() const {
    std::vector<std::string> lines;
    for (const Kind& entry : kinds_) {
        std::string line = entry.name + ": ";
        for (std::size_t i = 0; i < entry.details.size(); ++i) line += (i ? "; " : "") + entry.details[i];
        if (entry.count > entry.details.size())
            line += "; and " + std::to_string(entry.count - entry.details.size()) + " more";
        lines.push_back(std::move(line));
    }
    return lines;
}

}  // namespace featuremesh
