// SPDX-License-Identifier: BSD-3-Clause
import type { RobotFile } from "../scene";

/** The spring of a pull, as the program has it: weights of the robot by length of its legs, and at most so many weights. */
const kWeightsPerLeg = 2;
export const kMostWeights = 2;

/** How far off a pull must be to be of a force [m]. */
export function reachOf(robot: RobotFile, force_n: number): number {
  return (force_n * robot.leg_length_m) / (kWeightsPerLeg * robot.weight_n);
}
