// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <ostream>
#include <string>

#include "planning/plan/motion_plan.h"
#include "planning/plan/terrain_scale.h"

namespace gaitwright {

/// Kind of a random ground.
enum class RandomGroundKind { kStones, kRough, kWalls };

std::string NameOf(RandomGroundKind kind);
void PrintTo(RandomGroundKind kind, std::ostream* out);

/// A random ground with sizes for a robot, and a walk of 4 to 6 leg lengths over it.
struct RandomGround {
  std::string terrain;  ///< text for `--terrain`
  WalkCommand command;
  std::string flags;  ///< command-line flags for ground and walk
};

/// The ground of a seed, equal on all machines.
///   stones   stepping stones of 2 to 3.5 leg lengths, from 0.8 to 1.3 times as large as they are by default, with gaps
///            of 0.08 to 0.4 leg lengths between them, moved by up to half of a gap and up or down by up to 0.1
///   rough    bumps from 0.5 to 1.5 times as high as they are by default, 3 leg lengths long
///   walls    2 to 5 walls as high as the body at any headings on level ground, between the start and a goal beside the
///            path and turned by multiples of 45 degrees; every sixth seed walls the goal in. Written to a file in
///            `folder`.
RandomGround MakeRandomGround(RandomGroundKind kind, std::uint64_t seed, const TerrainScale& scale,
                              const std::string& folder);

}  // namespace gaitwright
