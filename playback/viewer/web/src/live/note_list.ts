// SPDX-License-Identifier: BSD-3-Clause
import { make } from "../elements";

const kMostNotes = 30;

/** Events, newest first. */
export class NoteList {
  readonly root = make("section", "gw-section gw-notes");
  private readonly list = make("ol");
  private last = 0;

  constructor() {
    this.list.setAttribute("aria-live", "polite");
    this.list.setAttribute("aria-label", "events");
    this.list.tabIndex = 0;
    this.root.append(make("h2", "", "Notes"), this.list);
  }

  /** Adds the program's new notes, by their numbers. */
  show(notes: [number, string][]): void {
    for (const [number, text] of notes) {
      if (number <= this.last) continue;
      this.last = number;
      this.add(text);
    }
  }

  add(text: string, className = ""): void {
    this.list.prepend(make("li", className, text));
    while (this.list.childElementCount > kMostNotes) this.list.lastElementChild?.remove();
  }

  /** A restarted program counts from the beginning. */
  clear(): void {
    this.last = 0;
    this.list.replaceChildren();
  }
}
