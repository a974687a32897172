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
                 {"liftoff_s", Number(), "The log's end where it still stands."},
                 {"touchdown_m", Numbers(3)},
                 {"touchdown_speed_m_s", Number(), "Just before."},
                 {"slip_m", Number()},
                 {"peak_normal_n", Number()},
                 {"penetration_m", Number()},
                 {"friction_use_max", Number(), "Tangential over friction times normal force."}});
}

DataShape BodyContactShape() { return Object({{"time_s", Number()}, {"link", Text()}}); }

DataShape LogGateShape() {
  return Object({{"phase", Text()}, {"at_s", Number()}, {"waited_s", Number()}, {"met", Truth()}});
}

DataShape LogPushShape() {
  return Object({{"at_s", Number()}, {"for_s", Number()}, {"force_n", Numbers(3)}, {"on", Text()}});
}

DataShape LogShape() {
  return Object({{"format", Text({kLogFormat})},
                 {"schema", Whole(PlaybackLog::kSchema, PlaybackLog::kSchema)},
                 {"program_version", Text()},
                 {"robot", Text()},
                 {"robot_hash", Text()},
                 {"plan_hash", Text(), "Of all of the plan that a playback depends on."},
                 {"controller", Text()},
                 {"start_s", In(kLogStart)},
                 {"log_rate_hz", In(kLogRate)},
                 {"step_s", In(kLogStep), "Of the physics."},
                 {"total_mass_kg", In(kLogMass)},
                 {"friction", In(kLogFriction), "Under the start."},
                 {"options", MapOf(Text()), "Every option of the playback."},
                 {"saturated_s", Numbers(), "By motor: time at its effort limit."},
                 {"stances", List(StanceShape())},
                 {"body_contacts", List(BodyContactShape()), "First contact of each link that is no foot."},
                 Optional("gates", List(LogGateShape())),
                 Optional("pushes", List(LogPushShape())),
                 Optional("broke_off", Text(), "Why the playback could not go on."),
                 {"time_s", List(Numbers(1)), "The end of each sample's interval."},
                 {"q", RowsShape()},
                 {"v", RowsShape()},
                 {"tau_nm", RowsShape(), "Means over the interval, by joint."},
                 {"tau_peak_nm", RowsShape(), "Largest magnitude in the interval, by motor."},
                 {"effort_use", RowsShape(), "Largest share of the effort limit in force, by motor."},
                 {"contact_wrenches", RowsShape(), "Force and moment of each foot, means over the interval."},
                 Optional("estimate", List(Numbers(13)), "What the controller took for the base."),
                 {"contact", List(Whole()), "By sample: bit i is set when foot i touches."}});
}

}  // namespace gaitwright
