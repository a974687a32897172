// SPDX-License-Identifier: BSD-3-Clause
#include "playback/log/log_shape.h"

#include "playback/log/log_shape_internal.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

using namespace shapes;

namespace {

DataShape In(const LogRange& range) { return Number(range.lowest, range.highest); }

DataShape RowsShape() { return List(Numbers()); }

}  // namespace

DataShape StanceShape() {
  return Object({{"foot", Whole(0, 63)},
                 {"touchdown_s", Number()},
                 {"liftoff_s", Number(), "Time of lift-off; the end of the log if the foot still stands."},
                 {"touchdown_m", Numbers(3)},
                 {"touchdown_speed_m_s", Number(), "Just before."},
                 {"slip_m", Number()},
                 {"peak_normal_n", Number()},
                 {"penetration_m", Number()},
                 {"friction_use_max", Number(), "Tangential force divided by friction times normal force."}});
}

DataShape BodyContactShape() { return Object({{"time_s", Number()}, {"link", Text()}}); }

DataShape PenetrationShape() { return Object({{"depth_m", Number()}, {"link", Text()}, {"solid", Text()}}); }

DataShape LogGateShape() {
  return Object({{"phase", Text()}, {"at_s", Number()}, {"waited_s", Number()}, {"met", Truth()}});
}

DataShape LogPushShape() {
  return Object({{"at_s", Number()}, {"for_s", Number()}, {"force_n", Numbers(3)}, {"on", Text()}});
}

DataShape LogShape() {
  return Object(
      {{"format", Text({kLogFormat})},
       {"schema", Whole(PlaybackLog::kSchema, PlaybackLog::kSchema)},
       {"program_version", Text()},
       {"robot", Text()},
       {"robot_hash", Text()},
       {"plan_hash", Text(), "Hash of all parts of the plan that affect a playback."},
       {"controller", Text()},
       {"start_s", In(kLogStart)},
       {"log_rate_hz", In(kLogRate)},
       {"step_s", In(kLogStep), "Time step of the physics engine."},
       {"total_mass_kg", In(kLogMass)},
       {"friction", In(kLogFriction), "Friction coefficient of the ground under the start."},
       {"options", MapOf(Text()), "Every option of the playback."},
       {"saturated_s", Numbers(), "Time at its effort limit, for each motor."},
       {"stances", List(StanceShape())},
       {"body_contacts", List(BodyContactShape()), "First contact of each link that is not a foot."},
       Optional("gates", List(LogGateShape())),
       Optional("pushes", List(LogPushShape())),
       Optional("start_penetration", PenetrationShape(), "Deepest contact of the first posture, if over 1 mm."),
       Optional("broke_off", Text(), "Reason for an early end of the playback."),
       Optional("broke_off_by", Text({"physics", "controller"}), "What ended it early."),
       {"time_s", List(Numbers(1)), "Time of the end of each sample's interval."},
       {"q", RowsShape()},
       {"v", RowsShape()},
       {"tau_nm", RowsShape(), "Mean over the interval, for each joint."},
       {"tau_peak_nm", RowsShape(), "Largest magnitude in the interval, for each motor."},
       {"effort_use", RowsShape(), "Largest share of the current effort limit, for each motor."},
       {"contact_wrenches", RowsShape(), "Force and moment of each foot, mean over the interval."},
       Optional("estimate", List(Numbers(13)), "Base state that the controller used."),
       {"contact", List(Whole()), "For each sample, bit i is set if foot i is in contact."}});
}

}  // namespace gaitwright
