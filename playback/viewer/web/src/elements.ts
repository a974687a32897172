// SPDX-License-Identifier: BSD-3-Clause

/** An element with a class and a text. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", text = ""): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** Writes a text where it is another than the one there. */
export function write(element: HTMLElement, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** An attribute likewise. */
export function tell(element: HTMLElement, attribute: string, text: string): void {
  if (element.getAttribute(attribute) !== text) element.setAttribute(attribute, text);
}

/** A button that does something when it is pressed; its title says what, where its text is a sign. */
export function button(text: string, title: string, act: () => void, className = ""): HTMLButtonElement {
  const made = make("button", className, text);
  made.title = title;
  if (!/\p{L}/u.test(text)) made.setAttribute("aria-label", title);
  made.type = "button";
  made.addEventListener("click", act);
  return made;
}

/** Takes an element out of use while there is a reason; its title says which. */
export function disable(element: HTMLButtonElement | HTMLInputElement, why: string): void {
  element.dataset.use ??= element.title;
  if (element.disabled !== (why !== "")) element.disabled = why !== "";
  const title = why || element.dataset.use;
  if (element.title !== title) element.title = title;
}

/** A box to tick, with its label. */
export function tickBox(text: string, className = ""): { label: HTMLLabelElement; box: HTMLInputElement } {
  const box = Object.assign(make("input"), { type: "checkbox", checked: true });
  const label = make("label", className, ` ${text}`);
  label.prepend(box);
  return { label, box };
}

/** A menu that gives keys back to the page once a mouse or finger has chosen from it. */
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

/** Whether a key is for the page: not for the browser, nor for the element that has the focus. */
export function isForPage(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const at = event.target as HTMLElement;
  return !at.closest(kTakesText) && !(event.key === " " && at.closest(kTakesSpace));
}
