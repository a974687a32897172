// SPDX-License-Identifier: BSD-3-Clause

/** An element with a class and a text. */
export function make<K extends keyof HTMLElementTagNameMap>(tag: K, className = "", text = ""): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  if (className) made.className = className;
  if (text) made.textContent = text;
  return made;
}

/** A button that does something when it is pressed. */
export function button(text: string, title: string, act: () => void, className = ""): HTMLButtonElement {
  const made = make("button", className, text);
  made.title = title;
  made.type = "button";
  made.addEventListener("click", act);
  return made;
}

/** A box to tick, with its label. */
export function tickBox(text: string, className = ""): { label: HTMLLabelElement; box: HTMLInputElement } {
  const box = Object.assign(make("input"), { type: "checkbox", checked: true });
  const label = make("label", className, ` ${text}`);
  label.prepend(box);
  return { label, box };
}

/** Whether a key is for the page: not for the browser, and not for a field or menu that takes text. */
export function isForPage(event: KeyboardEvent): boolean {
  const field = "input:not([type=checkbox]):not([type=range]), select, textarea";
  return !event.ctrlKey && !event.metaKey && !event.altKey && !(event.target as HTMLElement).closest(field);
}
