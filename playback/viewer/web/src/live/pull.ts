// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";
import { AtMost } from "./at_most";
import type { Send } from "./messages";

const kPullsPerSecond = 30;

/** A point of the robot that is held, and where it is pulled to. */
export interface Hold {
  body: number;
  at_Body: THREE.Vector3;
  to_W: THREE.Vector3;
}

/** The one pull of this page, whoever does it. */
export class Pull {
  private held: Hold | null = null;
  private readonly say: AtMost<Hold>;

  constructor(private readonly send: Send) {
    this.say = new AtMost(kPullsPerSecond, ({ body, at_Body, to_W }) => send({ do: "pull", body, at_m: at_Body.toArray(), to_m: to_W.toArray() }));
  }

  get hold(): Hold | null {
    return this.held;
  }

  /** Pulls, or goes on with it where the target is another. */
  to(hold: Hold): void {
    if (this.held?.body === hold.body && this.held.at_Body.equals(hold.at_Body) && this.held.to_W.equals(hold.to_W)) return;
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
