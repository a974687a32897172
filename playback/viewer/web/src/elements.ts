// SPDX-License-Identifier: BSD-3-Clause

/** An element with a class and a text. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", text = ""): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** Writes a text if it differs from the present one. */
export function write(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Sets an attribute if it differs from the present one. */
export function tell(element: HTMLElement, attribute: string, text: string): void {
  if (element.getAttribute(attribute) !== text) element.setAttribute(attribute, text);
}

/** A button with an action; its title describes the action, for buttons whose text is a symbol. */
export function button(text: string, title: string, act: () => void, className = ""): HTMLButtonElement {
  const made = make("button", className, text);
  made.title = title;
  if (!/\p{L}/u.test(text)) made.setAttribute("aria-label", title);
  made.type = "button";
  made.addEventListener("click", act);
  return made;
}

/** Disables an element while there is a reason; its title shows the reason. */
export function disable(element: HTMLButtonElement | HTMLInputElement, why: string): void {
  element.dataset.use ??= element.title;
  if (element.disabled !== (why !== "")) element.disabled = why !== "";
  const title = why || element.dataset.use;
  if (element.title !== title) element.title = title;
}

/** A check box with its label. */
export function tickBox(text: string, className = ""): { label: HTMLLabelElement; box: HTMLInputElement } {
  const box = Object.assign(make("input"), { type: "checkbox", checked: true });
  const label = make("label", className, ` ${text}`);
  label.prepend(box);
  return { label, box };
}

/** A menu that returns the keyboard focus to the page after a choice with mouse or finger. */
export function menu(label: string): HTMLSelectElement {
  const made = make("select");
  let pointed = false;
  made.setAttribute("aria-label", label);
  made.addEventListener("pointerdown", () => (pointed = true));
  made.addEventListener("keydown", () => (pointed = false));
  made.addEventListener("change", () => {
    if (pointed) made.blur();
    pointed = false;
  });
  return made;
}

const kTakesText = "input:not([type=checkbox], [type=range]), select, textarea";
const kTakesSpace = "button, summary, a, input[type=checkbox]";

/** Whether a key is meant for the page, not for the browser or the focused element. */
export function isForPage(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const at = event.target as HTMLElement;
  return !at.closest(kTakesText) && !(event.key === " " && at.closest(kTakesSpace));
}
