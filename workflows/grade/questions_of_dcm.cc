// SPDX-License-Identifier: BSD-3-Clause
// Englsberger, Ott and Albu-Schaeffer, T-RO 31(2), 2015, doi:10.1109/TRO.2015.2405592: the DCM xi = c + c' / omega
// moves away from the ZMP, xi(t) = p + e^{omega t} (xi(0) - p), and the centre of mass follows it, c' = omega (xi - c).
#include <algorithm>
#include <cmath>

#include "kinematics/stability/zero_moment_point.h"
#include "workflows/grade/questions_internal.h"

namespace gaitwright {
namespace {

using Values = std::vector<QuestionValue>;

double OmegaOf(const QuestionValue& com_height) { return std::sqrt(kQuestionGravity / com_height.number()); }

/// The DCM at the start of each step, computed backward from its rest on the last ZMP.
std::vector<Vector2> StartsOf(const QuestionValue& zmp, double step_s, double omega) {
  const int steps = zmp.shape.front();
  std::vector<Vector2> starts(static_cast<std::size_t>(steps));
  Vector2 next = zmp.Vec2(steps - 1);
  for (int i = steps - 1; i >= 0; --i) {
    next = zmp.Vec2(i) + std::exp(-omega * step_s) * (next - zmp.Vec2(i));
    starts[static_cast<std::size_t>(i)] = next;
  }
  return starts;
}

std::vector<double> Rows(const std::vector<Vector2>& points) {
  std::vector<double> numbers;
  for (const Vector2& p : points) numbers.insert(numbers.end(), {p.x(), p.y()});
  return numbers;
}

std::vector<double> DcmAnswer(const QuestionContext&, const Values& in) {
  return Rows({DivergentComponent(in[0].Vec3(), in[1].Vec3(), OmegaOf(in[2]))});
}

std::vector<double> StepsAnswer(const QuestionContext&, const Values& in) {
  return Rows(StartsOf(in[0], in[1].number(), OmegaOf(in[2])));
}

std::vector<double> TimesAnswer(const QuestionContext&, const Values& in) {
  const double step_s = in[1].number(), omega = OmegaOf(in[2]);
  const std::vector<Vector2> starts = StartsOf(in[0], step_s, omega);
  std::vector<Vector2> at;
  for (const double time_s : in[3].numbers) {
    const int step = std::clamp(static_cast<int>(std::floor(time_s / step_s)), 0, in[0].shape.front() - 1);
    const Vector2 zmp = in[0].Vec2(step);
    at.push_back(zmp + std::exp(omega * (time_s - step * step_s)) * (starts[static_cast<std::size_t>(step)] - zmp));
  }
  return Rows(at);
}

/// Sorts times, which were drawn as shares of the total time.
void ShareTimes(const QuestionContext& context, SplitMix&, Values& in) {
  std::sort(in[3].numbers.begin(), in[3].numbers.end());
  for (double& time_s : in[3].numbers) time_s *= context.size * in[1].number();
}

/// c(t) = p + (xi0 - p) e^{wt} / 2 + (2 c0 - xi0 - p) e^{-wt} / 2, the solution of c' = w (xi - c) with xi as above.
std::vector<double> BodyAnswer(const QuestionContext&, const Values& in) {
  const double wt = OmegaOf(in[3]) * in[4].number();
  const Vector2 c = in[0].Vec2(), xi = in[1].Vec2(), p = in[2].Vec2();
  return Rows({p + 0.5 * std::exp(wt) * (xi - p) + 0.5 * std::exp(-wt) * (2.0 * c - xi - p)});
}

}  // namespace

std::vector<Question> DivergentQuestions() {
  const QuestionInput height{"com_height_m", {}, {0.2, 1.0}}, zmp{"zmp_m", {kSize, 2}, {-0.5, 0.5}},
      step{"step_s", {}, {0.3, 0.9}};
  Question times{"dcm_at",
                 "the DCM of a plan over steps at given times",
                 {zmp, step, height, {"times_s", {kSize}, {0.0, 1.0}}},
                 "n x 2"};
  times.settle = ShareTimes;
  return {Compared({"dcm",
                    "the divergent component of motion",
                    {{"com_m", {3}, {-0.5, 0.5}}, {"velocity_m_s", {3}, {-1.0, 1.0}}, height},
                    "2 numbers"},
                   {2}, DcmAnswer),
          Compared({"dcm_of_steps", "the DCM at the start of each step", {zmp, step, height}, "n x 2"}, {kSize, 2},
                   StepsAnswer),
          Compared(times, {kSize, 2}, TimesAnswer),
          Compared({"com_along_dcm",
                    "the centre of mass after a time with the ZMP held",
                    {{"com_m", {2}, {-0.2, 0.2}},
                     {"dcm_m", {2}, {-0.2, 0.2}},
                     {"zmp_m", {2}, {-0.2, 0.2}},
                     height,
                     {"time_s", {}, {0.05, 0.5}}},
                    "2 numbers"},
                   {2}, BodyAnswer)};
}

}  // namespace gaitwright
