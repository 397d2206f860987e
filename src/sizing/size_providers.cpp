// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/size_providers.h"

#include <algorithm>
#include <string>

#include "core/ids.h"
#include "core/message.h"
#include "sizing/curvature.h"
#include "sizing/edge_cover.h"
#include "sizing/face_cover.h"
#include "sizing/girth.h"
#include "sizing/local_sizes.h"
#include "sizing/lost_sizes.h"
#include "sizing/narrow_faces.h"
#include "sizing/source_ball.h"
#include "sizing/thin_walls.h"
#include "sizing/zones.h"

namespace featuremesh {

std::vector<std::unique_ptr<SizeProvider>> size_providers(const Brep& brep, const SizingOptions& options) {
    std::vector<std::unique_ptr<SizeProvider>> all;
    all.push_back(local_size_provider(brep, options));
    all.push_back(curvature_provider(brep, options));
    all.push_back(rod_provider(brep, options));
    all.push_back(thin_wall_provider(brep, options));
    all.push_back(narrow_face_provider(brep, options));
    all.push_back(zone_provider(brep, options));
    return all;
}

SizePlaces cover_shape(const Brep& brep, const SizingOptions& options, RunContext& context) {
    for (const Message& line : lost_sizes(brep, options)) context.log(line.in_english());
    const auto providers = size_providers(brep, options);
    SizePlaces places;
    std::vector<SourceBall>& balls = places.balls;
    for (std::size_t v = 0; v < brep.vertex_count(); ++v) {
        double size = no_size;
        for (const auto& provider : providers) size = std::min(size, provider->on(VertexId(v)));
        if (size < options.size) balls.push_back({brep.point_of(VertexId(v)), 0.5 * size, size});
    }
    for (std::size_t e = 0; e < brep.edge_count(); ++e) {
        std::vector<EdgeWish> wishes;
        for (const auto& provider : providers)
            if (EdgeWish wish = provider->on(EdgeId(e))) wishes.push_back(std::move(wish));
        cover_edge(brep, EdgeId(e), wishes, options.size, balls);
    }
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        context.check_cancelled();
        std::vector<FaceWish> wishes;
        for (const auto& provider : providers)
            if (FaceWish wish = provider->on(FaceId(f)); wish.size) wishes.push_back(std::move(wish));
        cover_face(brep, FaceId(f), wishes, options.size, balls);
    }
    for (const auto& provider : providers) provider->cover(places, context);
    for (const SourceBall& ball : options.balls)
        if (ball.size < options.size) balls.push_back(ball);
    return places;
}

}  // namespace featuremesh
