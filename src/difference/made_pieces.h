// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces that final shapes have of a face that a feature made, before and after an edit.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "brep/face_probe.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "difference/made_faces.h"

namespace featuremesh {

/// Where a made face may take its pieces along, by each of its two parameters: they stay where they are, or as far from
/// one of its ends as they were, or at the same share of it. A pocket that gets deeper does not take along what crosses
/// its walls, a plate that moved does.
enum class PieceAnchor { place, low_end, high_end, share };

/// References stay in use. Not for concurrent use.
class MadePieces {
  public:
    MadePieces(const MadeFaces& was, const MadeFaces& is);

    const std::vector<FaceId>& old_on(int made) const { return old_.on[std::size_t(made)]; }
    const std::vector<FaceId>& new_on(int made) const { return new_.on[std::size_t(made)]; }
    /// The share of an old piece's points that lie on the new one, or of the new one's on the old, whichever is larger,
    /// where the old made face takes them along to the one that it became.
    double in_common(FaceId old_piece, int old_made, FaceId new_piece, int new_made);

  private:
    using Anchors = std::array<PieceAnchor, 2>;
    struct Piece {
        FaceProbe probe;
        std::vector<Vec3> points;
    };
    struct State {
        const MadeFaces& made;
        std::vector<std::vector<FaceId>> on;                            ///< by made face
        std::vector<std::unique_ptr<Piece>> pieces;                     ///< by FaceId, when first asked for
        std::map<std::pair<FaceId, int>, std::vector<Vec3>> points_on;  ///< of a piece, those on a made face; likewise
    };

    static State state_of(const MadeFaces& made);
    static const Piece& piece(State& state, FaceId f);
    /// Those points of a piece that are on the made face.
    static const std::vector<Vec3>& points_on(State& state, FaceId f, int made);
    Anchors anchors_of(int old_made, int new_made);
    static double covered(State& from, int made, State& to, int made_there, const std::vector<Vec3>& carried);
    static std::vector<Vec3> carried(State& from, int made, State& to, int made_there, const Anchors& anchors);
    static double share(State& from, FaceId f, int made, State& to, FaceId g, int made_there, const Anchors& anchors);

    State old_, new_;
    std::map<std::pair<int, int>, Anchors> anchors_;
};

}  // namespace featuremesh
