// SPDX-License-Identifier: BSD-3-Clause
import { button, make } from "../elements";

let made = 0;

/** Panels, one of which is shown; arrow keys switch between them. */
export class Tabs {
  readonly root = make("div", "gw-tabs");
  /** Called when another panel is shown. */
  onShow: () => void = () => {};
  private readonly row = make("div", "gw-group");
  private readonly pages: { tab: HTMLButtonElement; panel: HTMLElement }[] = [];

  constructor(label: string, panels: { title: string; root: HTMLElement }[]) {
    this.row.setAttribute("role", "tablist");
    this.row.setAttribute("aria-label", label);
    this.row.addEventListener("keydown", (event) => this.press(event));
    this.root.append(this.row);
    for (const { title, root } of panels) this.add(title, root);
    this.show(0);
  }

  show(number: number): void {
    this.pages.forEach(({ tab, panel }, i) => {
      tab.setAttribute("aria-selected", String(i === number));
      tab.tabIndex = i === number ? 0 : -1;
      panel.hidden = i !== number;
    });
    this.onShow();
  }

  private add(title: string, panel: HTMLElement): void {
    const number = this.pages.length;
    const tab = button(title, "", () => this.show(number));
    panel.id = `gw-panel-${++made}`;
    tab.setAttribute("role", "tab");
    tab.setAttribute("aria-controls", panel.id);
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-label", title);
    this.pages.push({ tab, panel });
    this.row.append(tab);
    this.root.append(panel);
  }

  private press(event: KeyboardEvent): void {
    const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    const at = this.pages.findIndex(({ tab }) => tab === event.target);
    if (step === 0 || at < 0 || event.shiftKey) return;
    const next = (at + step + this.pages.length) % this.pages.length;
    this.show(next);
    this.pages[next].tab.focus();
    event.preventDefault();
    event.stopPropagation();
  }
}
