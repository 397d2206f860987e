// SPDX-License-Identifier: GPL-3.0-or-later
#include <BRepAdaptor_Curve.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <cmath>

#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"
#include "difference/feature_difference.h"
#include "difference/underlying_geometry.h"

namespace featuremesh {

namespace {

struct EdgeShape {
    Vec3 first, middle, last;
    double length = 0;
};

EdgeShape shape_of(const Brep& brep, EdgeId id) {
    const BRepAdaptor_Curve curve(brep.edge(id));
    const double first = curve.FirstParameter(), last = curve.LastParameter();
    return {to_vec3(curve.Value(first)), to_vec3(curve.Value(0.5 * (first + last))), to_vec3(curve.Value(last)),
            GCPnts_AbscissaPoint::Length(curve)};
}

class EdgeVerdicts {
  public:
    EdgeVerdicts(const CarriedRegion& region, const Brep& old_shape, const Brep& new_shape)
        : region_(region),
          old_shape_(old_shape),
          new_shape_(new_shape),
          same_(10 * sameness_of(old_shape.box(), new_shape.box()).length) {}

    std::vector<EdgeChange> run() const {
        std::vector<EdgeChange> changes;
        std::vector<char> has_partner(new_shape_.edge_count(), 0);
        for (std::size_t e = 0; e < old_shape_.edge_count(); ++e)
            if (!old_shape_.is_degenerated(EdgeId(e))) changes.push_back(change_of(EdgeId(e), has_partner));
        for (std::size_t e = 0; e < has_partner.size(); ++e)
            if (!has_partner[e] && !new_shape_.is_degenerated(EdgeId(e))) changes.push_back(appeared(EdgeId(e)));
        return changes;
    }

  private:
    /// The partner with the same ends, else the one with the largest share.
    EdgeChange change_of(EdgeId e, std::vector<char>& has_partner) const {
        const EdgeShape was = shape_of(old_shape_, e);
        EdgeChange change{BoundaryVerdict::vanished, e, EdgeId(), was.length, 0, false};
        for (const EdgeId partner : region_.new_edges_of[e.index()]) {
            has_partner[partner.index()] = 1;
            const EdgeShape is = shape_of(new_shape_, partner);
            const bool kept = same_trim(was, is);
            if (change.new_edge.is_valid() && !kept) continue;
            change.verdict = kept ? BoundaryVerdict::kept : BoundaryVerdict::trimmed_differently;
            change.new_edge = partner;
            change.new_length = is.length;
        }
        return change;
    }

    EdgeChange appeared(EdgeId e) const {
        return {BoundaryVerdict::appeared, EdgeId(), e, 0, shape_of(new_shape_, e).length, false};
    }

    /// Of two edges that overlap on one curve. A closed one may begin elsewhere.
    bool same_trim(const EdgeShape& a, const EdgeShape& b) const {
        if (std::abs(a.length - b.length) > same_ + 1e-6 * a.length) return false;
        const auto meet = [&](const Vec3& p, const Vec3& q) { return distance(p, q) <= same_; };
        return (meet(a.first, a.last) && meet(b.first, b.last)) || (meet(a.first, b.first) && meet(a.last, b.last)) ||
               (meet(a.first, b.last) && meet(a.last, b.first));
    }

    const CarriedRegion& region_;
    const Brep& old_shape_;
    const Brep& new_shape_;
    double same_;  // mm; a vertex lies less exactly than an underlying surface
};

}  // namespace

std::vector<EdgeChange> edge_changes(const FeatureDifference& difference, const Brep& old_shape,
                                     const Brep& new_shape) {
    return EdgeVerdicts(difference.regions.front(), old_shape, new_shape).run();
}

void tell_inner_edges(std::vector<EdgeChange>& edges, const Brep& old_shape, const Brep& new_shape) {
    const SolidProbe in_old(old_shape.shape()), in_new(new_shape.shape());
    for (EdgeChange& edge : edges) {
        if (edge.verdict == BoundaryVerdict::vanished)
            edge.inner = in_new.containment_of(shape_of(old_shape, edge.old_edge).middle) == Containment::inside;
        if (edge.verdict == BoundaryVerdict::appeared)
            edge.inner = in_old.containment_of(shape_of(new_shape, edge.new_edge).middle) == Containment::inside;
    }
}

}  // namespace featuremesh
