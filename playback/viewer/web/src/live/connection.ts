// SPDX-License-Identifier: BSD-3-Clause
import type { Saying } from "./messages";

const kFirstWait_ms = 500;
const kLongestWait_ms = 5000;
const kLongerEachTime = 1.6;

export interface ConnectionListener {
  told(text: string): void;
  lost(): void;
}

/** The WebSocket to the program. A lost connection is opened again after increasing delays. */
export class Connection {
  private socket: WebSocket | null = null;
  private wait_ms = kFirstWait_ms;
  private lastTold_ms = 0;

  constructor(
    private readonly url: string,
    private readonly listener: ConnectionListener,
  ) {
    this.open();
  }

  get connected(): boolean {
    return this.socket?.readyState === WebSocket.OPEN;
  }

  /** Time since the last message of the program. */
  get silent_ms(): number {
    return performance.now() - this.lastTold_ms;
  }

  /** @return whether it was sent. A message that cannot be sent is dropped, because it would arrive too late. */
  send(saying: Saying): boolean {
    if (!this.connected) return false;
    this.socket?.send(JSON.stringify(saying));
    return true;
  }

  private open(): void {
    const socket = new WebSocket(this.url);
    this.socket = socket;
    socket.addEventListener("open", () => {
      this.wait_ms = kFirstWait_ms;
      this.lastTold_ms = performance.now();
    });
    socket.addEventListener("message", (event) => {
      this.lastTold_ms = performance.now();
      this.listener.told(String(event.data));
    });
    socket.addEventListener("close", () => this.openLater());
  }

  private openLater(): void {
    this.listener.lost();
    setTimeout(() => this.open(), this.wait_ms);
    this.wait_ms = Math.min(kLongestWait_ms, kLongerEachTime * this.wait_ms);
  }
}

/** The address of a path on the host of this page. */
export function socketUrl(path: string): string {
  return `${location.protocol === "https:" ? "wss:" : "ws:"}//${location.host}${path}`;
}
