// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { AtMost } from "./at_most";
import type { Send } from "./messages";

const kPullsPerSecond = 30;

/** A point of the robot that is held, and its pull. */
export interface Hold {
  body: number;
  at_Body: THREE.Vector3;
  /** Displacement of the hand from its start. */
  by_W: THREE.Vector3;
  /** Whether the hand moves along with the robot. */
  along: boolean;
}

/** The one pull of this page. */
export class Pull {
  private held: Hold | null = null;
  private readonly say: AtMost<Hold>;

  constructor(private readonly send: Send) {
    this.say = new AtMost(kPullsPerSecond, ({ body, at_Body, by_W, along }) =>
      send({ do: "pull", body, at_m: at_Body.toArray(), by_m: by_W.toArray(), along }),
    );
  }

  get hold(): Hold | null {
    return this.held;
  }

  /** Starts or continues a pull. */
  to(hold: Hold): void {
    this.held = hold;
    this.say.put(hold);
  }

  /** If this message cannot be sent, the program ends the pull itself, as for every lost page. */
  letGo(): void {
    if (!this.held) return;
    this.held = null;
    this.say.drop();
    this.send({ do: "let_go" });
  }
}
