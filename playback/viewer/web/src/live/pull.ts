// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { AtMost } from "./at_most";
import type { Send } from "./messages";

const kPullsPerSecond = 30;

/** A point of the robot that is held, and how it is pulled. */
export interface Hold {
  body: number;
  at_Body: THREE.Vector3;
  /** How far the hand is from where it took hold. */
  by_W: THREE.Vector3;
  /** Whether it walks along with the robot. */
  along: boolean;
}

/** The one pull of this page, whoever does it. */
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

  /** Takes hold, or goes on with it. */
  to(hold: Hold): void {
    this.held = hold;
    this.say.put(hold);
  }

  /** Where this cannot be said the program knows: it lets go for a page that is lost. */
  letGo(): void {
    if (!this.held) return;
    this.held = null;
    this.say.drop();
    this.send({ do: "let_go" });
  }
}
