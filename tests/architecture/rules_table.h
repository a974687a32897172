// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace gaitwright::architecture {

/// A folder and its rank: a file may include files of its own folder and of folders with a lower rank.
struct Layer {
  std::string_view folder;
  int rank;
};

/// The order of the rooms and of the folders inside them. Add a line for a new folder, at its place in the order.
inline const std::vector<Layer> kLayers = {
    {"kinematics/base", 9},
    {"kinematics/spatial", 10},
    {"kinematics/trajectory", 11},
    {"kinematics/description", 12},
    {"kinematics/model", 13},
    {"kinematics/dynamics", 14},
    {"kinematics/stability", 15},
    {"kinematics/collision", 16},
    {"kinematics/ik", 17},
    {"kinematics/check", 18},

    {"planning/plan", 20},
    {"planning/terrain", 21},
    {"planning/gait", 22},
    {"planning/paths", 23},
    {"planning/footsteps", 24},
    {"planning/audit", 25},
    {"planning/tasks", 26},

    {"optimisation/numerics", 30},
    {"optimisation/centroidal", 31},
    {"optimisation/swing", 32},
    {"optimisation/trajectory", 33},
    {"optimisation/whole_body", 34},
    {"optimisation/pipeline", 35},
    {"optimisation/search", 36},

    {"playback/log", 40},
    {"playback/onnx", 40},
    {"playback/engine", 41},
    {"playback/bullet", 42},
    {"playback/mjcf", 43},
    {"playback/mujoco", 44},
    {"playback/play", 45},
    {"playback/sensing", 46},
    {"playback/control", 47},
    {"playback/policy", 48},
    {"playback/score", 49},
    {"playback/trials", 50},
    {"playback/report", 51},
    {"playback/viewer", 52},

    {"workflows/walk", 55},
    {"workflows/study", 56},
    {"workflows/preflight", 57},
    {"workflows/exchange", 58},
    {"workflows/compare", 59},
    {"workflows/repair", 60},
    {"workflows/render", 61},
    {"workflows/words", 62},
    {"workflows/live", 63},
    {"workflows/cluster", 64},
    {"workflows/sandbox", 65},
    {"workflows/grade", 66},
    {"workflows/formats", 67},

    {"cli", 70},
    {"examples", 70},
    {"python", 70},
};

/// The header of a room for its users: above all folders of the room. The library itself includes no such header.
inline const std::vector<Layer> kUmbrellas = {
    {"kinematics/kinematics.h", 19}, {"planning/planning.h", 29},   {"optimisation/optimisation.h", 39},
    {"playback/playback.h", 53},     {"workflows/workflows.h", 69},
};

/// Maximum number of headers reached from the umbrellas; these are the installed headers.
inline constexpr int kMostPublicHeaders = 149;

/// A folder that may include only some of the lower folders.
struct Blinkers {
  std::string_view folder;
  std::vector<std::string_view> sees;
};

/// `playback` must not include the planners that it judges.
inline const std::vector<Blinkers> kBlinkers = {
    {"playback", {"playback", "kinematics", "planning/plan"}},
    {"planning/audit", {"planning/audit", "kinematics", "planning/plan"}},
};

/// A third party, given by the beginning of its include paths, and the folders that may include it.
/// `in_headers` also allows it in headers of those folders; otherwise it stays in .cc and *_internal.h files.
struct Owner {
  std::string_view prefix;
  std::vector<std::string_view> folders;
  bool in_headers = false;
};

inline const std::vector<std::string_view> kAnywhere = {""};

inline const std::vector<Owner> kOwners = {
    {"Eigen/", kAnywhere, true},
    {"unsupported/Eigen/", kAnywhere},
    {"fmt/", kAnywhere},
    {"nlohmann/", kAnywhere},
    {"yaml-cpp/", kAnywhere},
    {"utf8cpp/", {"kinematics/base"}},
    {"urdf_parser/", {"kinematics/model"}},
    {"urdf_model/", {"kinematics/model"}},
    {"urdf_world/", {"kinematics/model"}},
    {"urdf_exception/", {"kinematics/model"}},
    {"console_bridge/", {"kinematics/model"}},
    {"tinyxml2.h", {"kinematics/description", "kinematics/model"}},
    {"fcl/", {"kinematics/collision"}},
    {"ccd/", {"kinematics/collision"}},
    {"ompl/", {"planning"}},
    {"png.h", {"planning/terrain"}},
    {"ceres/", {"optimisation"}},
    {"glog/", {"optimisation"}},
    {"bt", {"playback/bullet"}},
    {"Bullet", {"playback/bullet"}},
    {"LinearMath/", {"playback/bullet"}},
    {"mujoco/", {"playback/mujoco"}},
    {"minizip/", {"workflows/exchange"}},
    {"lz4frame.h", {"workflows/exchange"}},
    {"zstd.h", {"workflows/exchange"}},
    {"sqlite3.h", {"workflows/exchange"}},
    {"boost/", {"workflows/live"}},
    {"curl/", {"workflows/words"}},
    {"pybind11/", {"python"}, true},
    {"mpi.h", {"workflows/cluster"}},
    {"seccomp.h", {"workflows/sandbox"}},
    {"CLI/", {"cli", "examples"}},
    // Headers of the operating system: atomic writing, terminals and memory.
    {"unistd.h", kAnywhere},
    {"fcntl.h", kAnywhere},
    {"signal.h", kAnywhere},
    {"dlfcn.h", {"kinematics/base"}},
    {"link.h", {"kinematics/base"}},
    {"malloc.h", {"kinematics/base"}},
    {"poll.h", {"workflows/render", "workflows/sandbox", "workflows/grade", "examples"}},
    {"grp.h", {"workflows/sandbox"}},
    {"linux/", {"workflows/sandbox"}},
    {"asm/", {"workflows/sandbox"}},
    {"netinet/", {"examples"}},
    {"spawn.h", {"workflows/render"}},
    {"sys/", kAnywhere},
};

/// Maximum length of a file, and exemptions with their reason.
inline constexpr int kLongestFile = 400;
struct LongFile {
  std::string_view file, reason;
};
inline const std::vector<LongFile> kLongFiles = {};

/// Maximum number of lines and parameters of a function; tables of options (`...Fields`) may be longer.
inline constexpr int kLongestFunction = 60;
inline constexpr int kMostParameters = 6;

/// A function that may be longer, or have more parameters. Do not add to these lists.
struct Exempt {
  std::string_view file, name, reason;
};
inline const std::vector<Exempt> kLongFunctions = {
    {"python/bindings/playback.cc", "BindPlayback", "a row for each name of the module"},
    {"python/bindings/robot.cc", "BindRobot", "a row for each name of the module"},
    {"workflows/words/read_clause.cc", "Take", "a case for each kind of word"},
};
inline const std::vector<Exempt> kManyParameters = {
    {"playback/bullet/condensed_solver.cc", "CondensedSolver::solveGroupCacheFriendlySetup", "an override of Bullet's"},
    {"playback/bullet/condensed_solver.cc", "CondensedSolver::solveGroupCacheFriendlyIterations",
     "an override of Bullet's"},
    {"python/bindings/planning.cc", "PlanAWalk", "keyword arguments of Python"},
    {"python/bindings/policies.cc", "FitGiven", "keyword arguments of Python"},
    {"python/bindings/terrain.cc", "WithHeights", "keyword arguments of Python"},
    {"python/bindings/trials.cc", "Trials", "keyword arguments of Python"},
    {"playback/score/gates.cc", "Reported", "columns of a table"},
};

/// Minimum number of test lines per line of code, by room. The goal is 0.6 in each; never lower these numbers.
struct TestShare {
  std::string_view room;
  double least;
};
inline const std::vector<TestShare> kTestShares = {
    {"kinematics", 0.60}, {"planning", 0.60},  {"optimisation", 0.60},
    {"playback", 0.60},   {"workflows", 0.60}, {"cli", 0.60},
};

/// Sources longer than this need a test at the same path below tests/, except so many; never raise this number.
inline constexpr int kLongestUntested = 100;
inline constexpr int kMostUntested = 0;

}  // namespace gaitwright::architecture
