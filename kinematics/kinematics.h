// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Robot models from their descriptions; kinematics, dynamics, collision checks and inverse kinematics of robots.
// The headers included here are installed. All other headers are internal and may change without notice.

#include "kinematics/base/file.h"
#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/base/version.h"
#include "kinematics/check/check_robot.h"
#include "kinematics/collision/collision_checker.h"
#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/dynamics_derivatives.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/dynamics/forward_dynamics.h"
#include "kinematics/ik/leg_ik.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "kinematics/stability/zero_moment_point.h"
