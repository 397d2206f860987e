// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/zone_distance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/ids.h"
#include "sizing/edge_cover.h"
#include "sizing/face_cover.h"
#include "sizing/size_provider.h"
#include "sizing/source_ball.h"

namespace featuremesh {
namespace {

double beyond(double x, double low, double high) { return std::max({0.0, low - x, x - high}); }

double distance_from(const BoxZone& box, const Vec3& p) {
    return length({beyond(p.x, 0, box.extent.x), beyond(p.y, 0, box.extent.y), beyond(p.z, 0, box.extent.z)});
}
double distance_from(const SphereZone& sphere, const Vec3& p) { return std::max(0.0, length(p) - sphere.radius); }
double distance_from(const CylinderZone& cylinder, const Vec3& p) {
    return std::hypot(std::max(0.0, std::hypot(p.x, p.y) - cylinder.radius), beyond(p.z, 0, cylinder.height));
}

Box box_of(const BoxZone& box) { return {{}, box.extent}; }
Box box_of(const SphereZone& sphere) { return Box{{}, {}}.grown(sphere.radius); }
Box box_of(const CylinderZone& cylinder) {
    const double r = cylinder.radius;
    return {{-r, -r, 0}, {r, r, cylinder.height}};
}

Box moved(const Box& box, const RigidMotion& motion) {
    Box out;
    for (int corner = 0; corner < 8; ++corner)
        out.add(motion.apply({corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                              corner & 4 ? box.high.z : box.low.z}));
    return out;
}

/// Balls over the entities that the part has, with pieces about twice as long as `size`.
std::vector<SourceBall> cover_entities(const Brep& brep, const std::vector<Entity>& entities, double size) {
    const std::array<std::size_t, 3> counts{brep.vertex_count(), brep.edge_count(), brep.face_count()};
    const std::array<EdgeWish, 1> on_edge{[size](double) { return size; }};
    const std::array<FaceWish, 1> on_face{FaceWish{[size](const SurfacePoint&) { return size; }}};
    std::vector<SourceBall> balls;
    for (const auto [dim, index] : entities) {
        if (dim < 0 || dim > 2 || index < 0 || static_cast<std::size_t>(index) >= counts[dim]) continue;
        if (dim == 0) balls.push_back({brep.point_of(VertexId(index)), 0, 0});
        if (dim == 1) cover_edge(brep, EdgeId(index), on_edge, no_size, balls);
        if (dim == 2) cover_face(brep, FaceId(index), on_face, no_size, balls);
    }
    for (SourceBall& ball : balls) ball.size = 0;
    return balls;
}

Box box_of(const SourceBall& ball) {
    Box box;
    box.add(ball.center);
    return box.grown(ball.radius);
}

}  // namespace

ZoneDistance::ZoneDistance(const Brep& brep, const SizeZone& zone) : to_zone_(zone.placement.inverse()) {
    const auto take = [&](const auto& shape) {
        shape_ = shape;
        box_ = moved(box_of(shape), zone.placement);
    };
    if (const auto* near = std::get_if<NearZone>(&zone.shape)) {
        SourceTree entities(cover_entities(brep, near->entities, zone.inner), 1.0, no_size);
        for (const SourceBall& ball : entities.balls()) box_.add(box_of(ball).grown(near->reach));
        shape_ = Near{std::move(entities), near->reach};
    } else if (const auto* box = std::get_if<BoxZone>(&zone.shape)) {
        take(*box);
    } else if (const auto* sphere = std::get_if<SphereZone>(&zone.shape)) {
        take(*sphere);
    } else {
        take(std::get<CylinderZone>(zone.shape));
    }
}

double ZoneDistance::at(const Vec3& p) const {
    if (const auto* near = std::get_if<Near>(&shape_)) return std::max(0.0, near->entities.at(p) - near->reach);
    const Vec3 local = to_zone_.apply(p);
    if (const auto* box = std::get_if<BoxZone>(&shape_)) return distance_from(*box, local);
    if (const auto* sphere = std::get_if<SphereZone>(&shape_)) return distance_from(*sphere, local);
    return distance_from(std::get<CylinderZone>(shape_), local);
}

std::vector<Box> where_different(const ZoneDistance& a, const ZoneDistance& b) {
    using Near = ZoneDistance::Near;
    std::vector<Box> boxes;
    const auto *near_a = std::get_if<Near>(&a.shape_), *near_b = std::get_if<Near>(&b.shape_);
    if (near_a && near_b && near_a->reach == near_b->reach) {
        for (const SourceBall& ball : balls_of_one(near_a->entities, near_b->entities))
            boxes.push_back(box_of(ball).grown(near_a->reach));
        return boxes;
    }
    const auto is_same = [&](const auto& shape) {
        const auto* other = std::get_if<std::decay_t<decltype(shape)>>(&b.shape_);
        if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Near>)
            return false;
        else
            return other && *other == shape && a.to_zone_ == b.to_zone_;
    };
    if (!std::visit(is_same, a.shape_)) boxes = {a.box_, b.box_};
    std::erase_if(boxes, [](const Box& box) { return box.is_empty(); });
    return boxes;
}

}  // namespace featuremesh
