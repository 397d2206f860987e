// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/volumes/period_shifts.h"

#include <BRepAdaptor_Surface.hxx>
#include <cmath>
#include <cstddef>
#include <utility>

namespace featuremesh {

namespace {

constexpr double close = 1e-3;  // of a period: what lies that near whole periods away belongs here

double whole_periods(double distance, double period) {
    return period == 0 ? 0 : period * std::round(distance / period);
}

/// Of a parameter that has no period nothing is asked.
bool is_close(double rest, double period) { return period == 0 || std::abs(rest) <= close * period; }

Parameters operator-(const Parameters& a, const Parameters& b) { return {a.u - b.u, a.v - b.v}; }
Parameters operator+(const Parameters& a, const Parameters& b) { return {a.u + b.u, a.v + b.v}; }
bool is_none(const Parameters& shift) { return shift.u == 0 && shift.v == 0; }

class Joining {
  public:
    Joining(const std::vector<BorderStep>& border, const Parameters& period)
        : border_(border), period_(period), shifts_(border.size()), is_joined_(border.size(), 0) {}

    std::vector<Parameters> shifts() {
        for (std::size_t start = 0; start < border_.size(); ++start)
            for (std::size_t last = start; last < border_.size() && !is_joined_[last];) {
                is_joined_[last] = 1;
                last = next_of(last);
            }
        return std::move(shifts_);
    }

  private:
    /// The only step that goes on from `last`, brought to its end; none: the number of steps.
    std::size_t next_of(std::size_t last) {
        std::vector<std::size_t> beside, apart;
        for (std::size_t i = 0; i < border_.size(); ++i) {
            if (border_[i].from != border_[last].to) continue;
            const Parameters way = way_between(last, i), shift = featuremesh::whole_periods(way, period_);
            if (is_none(shift))
                beside.push_back(i);
            else if (is_close(way.u - shift.u, period_.u) && is_close(way.v - shift.v, period_.v))
                apart.push_back(i);
        }
        if (beside.empty() && apart.size() == 1 && !is_joined_[apart.front()]) {
            shifts_[apart.front()] = featuremesh::whole_periods(way_between(last, apart.front()), period_);
            return apart.front();
        }
        return beside.size() == 1 ? beside.front() : border_.size();
    }

    Parameters way_between(std::size_t last, std::size_t next) const {
        return border_[last].end + shifts_[last] - (border_[next].begin + shifts_[next]);
    }

    const std::vector<BorderStep>& border_;
    Parameters period_;
    std::vector<Parameters> shifts_;
    std::vector<char> is_joined_;
};

}  // namespace

Parameters period_of(const BRepAdaptor_Surface& surface) {
    return {surface.IsUPeriodic() ? surface.UPeriod() : 0, surface.IsVPeriodic() ? surface.VPeriod() : 0};
}

Parameters whole_periods(const Parameters& distance, const Parameters& period) {
    return {whole_periods(distance.u, period.u), whole_periods(distance.v, period.v)};
}

std::vector<Parameters> period_shifts(const std::vector<BorderStep>& border, const Parameters& period) {
    return Joining(border, period).shifts();
}

}  // namespace featuremesh
