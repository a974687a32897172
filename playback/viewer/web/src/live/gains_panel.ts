// SPDX-License-Identifier: BSD-3-Clause
import { button, make } from "../elements";
import type { Frame, OptionFile, Send } from "./messages";
import { OptionRow } from "./option_row";

/** Known groups of options, in the order in which they are shown. */
const kGroups: Record<string, string> = { gains: "Gains of the joints", stabilised: "Balance", recovering: "Steps and falls" };

/** All options of the controller, in groups that can be collapsed. */
export class GainsPanel {
  readonly root = make("section", "gw-section gw-gains");
  private readonly rows: OptionRow[];
  private readonly meaning = make("p", "gw-note gw-meaning", "The meaning of an option is shown here.");
  private readonly refusal = make("p", "gw-refused");

  constructor(
    options: Record<string, OptionFile>,
    private readonly send: Send,
  ) {
    this.rows = Object.entries(options).map(([key, option]) => new OptionRow(key, option));
    const head = make("div", "gw-beside");
    head.append(make("h2", "", "Gains"), button("Reset to defaults", "sets all options to their initial values", () => this.backToUsual()));
    this.root.append(head);
    const prefixes = [...new Set([...Object.keys(kGroups), ...this.rows.map((row) => prefixOf(row))])];
    for (const prefix of prefixes) this.addGroup(prefix);
    this.refusal.setAttribute("role", "alert");
    const foot = make("div", "gw-told");
    foot.append(this.refusal, this.meaning);
    this.root.append(foot);
  }

  show(frame: Frame): void {
    this.rows.forEach((row, i) => row.follow(frame.options[i]));
  }

  private addGroup(prefix: string): void {
    const rows = this.rows.filter((row) => prefixOf(row) === prefix);
    if (rows.length === 0) return;
    const group = Object.assign(make("details"), { open: true });
    group.append(make("summary", "", kGroups[prefix] ?? prefix));
    for (const row of rows) {
      row.onSet = (value) => this.ask({ [row.key]: value });
      row.onRefuse = (why) => (this.refusal.textContent = why);
      for (const look of ["focusin", "pointerenter"]) row.root.addEventListener(look, () => (this.meaning.textContent = row.option.meaning));
      group.append(row.root);
    }
    this.root.append(group);
  }

  private backToUsual(): void {
    const changed = this.rows.filter((row) => !row.isUsual);
    if (changed.length === 0) return;
    for (const row of changed) row.show(row.option.value);
    this.ask(Object.fromEntries(changed.map((row) => [row.key, row.option.value])));
  }

  private ask(options: Record<string, number>): void {
    this.refusal.textContent = "";
    this.send({ do: "options", options });
  }
}

function prefixOf(row: OptionRow): string {
  return row.key.slice(0, Math.max(row.key.indexOf("."), 0));
}
