// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Physics: playing a motion plan by a controller, scoring the log, and the report.
// The headers that this header includes are installed. All other headers are internal and may change without notice.

#include "playback/control/controller.h"
#include "playback/control/gains.h"
#include "playback/control/joint_pd.h"
#include "playback/control/stabilised.h"
#include "playback/engine/world.h"
#include "playback/log/log_json.h"
#include "playback/log/playback_log.h"
#include "playback/play/make_world.h"
#include "playback/play/play.h"
#include "playback/report/plot_grid.h"
#include "playback/report/plot_style.h"
#include "playback/report/plots.h"
#include "playback/report/svg_plot.h"
#include "playback/score/motion_series.h"
#include "playback/score/report_text.h"
#include "playback/score/stability_report.h"
#include "playback/sensing/sensing_options.h"
#include "playback/trials/disturbances.h"
#include "playback/trials/robustness_report.h"
